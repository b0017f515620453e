// The options of render about how many pictures there are and where they go.
#pragma once

#include "cli/picture_output.hpp"

#include <CLI/CLI.hpp>
#include <string>

namespace tessera::cli {

/// Raw words of the command line.
struct OutputWords {
    std::string output;           // empty: not given
    std::uint32_t turntable = 0;  // frames, or 0 for one picture
    std::string frames;           // empty: not given
    std::uint32_t frames_per_second = 25;
    bool apng = false;

    std::uint32_t count() const { return turntable > 0 ? turntable : 1; }
};

void add_output_options(CLI::App& command, OutputWords& words);

/// Throws Error(usage) where the words name no place for the pictures, or two for the same.
PictureOutput resolve_output(const OutputWords& words);

}  // namespace tessera::cli
