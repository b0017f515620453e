#include "cli/output_words.hpp"

#include "base/error.hpp"

#include <fmt/format.h>
#include <filesystem>

namespace tessera::cli {
namespace {

bool is_animation(const OutputWords& words) {
    return words.apng || std::filesystem::path(words.output).extension() == ".apng";
}

}  // namespace

void add_output_options(CLI::App& command, OutputWords& words) {
    command.add_option("-o,--output", words.output,
                       "The PNG to write; with --turntable turn.png stands for turn-000.png, turn-001.png, ..., "
                       "frame%03d.png for frame000.png, ..., and an .apng is an animation");
    command.add_option("--turntable", words.turntable, "Write this many pictures, once around the model")
        ->check(CLI::Range(1, 10000));
    command.add_option("--frames", words.frames,
                       "Write each picture of a turntable as FOLDER/0000.png, ..., or by a pattern as of -o, besides "
                       "an .apng or without -o");
    command.add_flag("--apng", words.apng, "Write one animated PNG, whatever its name");
    command.add_option("--fps", words.frames_per_second, "Frames per second of an animated PNG")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
}

PictureOutput resolve_output(const OutputWords& words) {
    using Kind = PictureOutput::Kind;
    if (words.output.empty() && words.frames.empty()) {
        throw Error(ErrorKind::usage,
                    "Nothing says where the picture goes; give -o FILE.png, or --turntable N with --frames FOLDER.");
    }
    if (!words.frames.empty() && words.turntable == 0) {
        throw Error(ErrorKind::usage,
                    "--frames writes the pictures of a turntable; say how many of them with --turntable N.");
    }
    Kind kind = words.turntable > 0 ? Kind::sequence : Kind::single;
    if (is_animation(words)) kind = Kind::animation;
    if (words.output.empty()) kind = Kind::none;
    if (kind == Kind::sequence && !words.frames.empty()) {
        throw Error(ErrorKind::usage,
                    fmt::format("{} and --frames {} are the same pictures twice; leave one out, or write an animation "
                                "with -o NAME.apng.",
                                words.output, words.frames));
    }
    return {words.output, kind, words.count(), words.frames_per_second,
            words.frames.empty() ? "" : sequence_pattern(words.frames)};
}

}  // namespace tessera::cli
