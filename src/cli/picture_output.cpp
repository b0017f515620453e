#include "cli/picture_output.hpp"

#include "base/error.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <filesystem>

namespace tessera::cli {
namespace {

Error bad_pattern(const std::string& pattern) {
    return {ErrorKind::usage,
            fmt::format("The name {} for pictures of a sequence is not understood; write %d or, for three "
                        "digits, %03d once, and %% for a percent sign.",
                        pattern)};
}

void make_folder_of(const std::string& path) {
    const std::filesystem::path folder = std::filesystem::path(path).parent_path();
    std::error_code error;
    if (!folder.empty()) std::filesystem::create_directories(folder, error);
    if (error) {
        throw Error(ErrorKind::output,
                    fmt::format("The folder {} for pictures cannot be made: {}.", folder.string(), error.message()));
    }
}

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

}  // namespace

std::string frame_name(const std::string& pattern, std::uint32_t index, std::uint32_t count) {
    if (pattern.find('%') == std::string::npos) {
        const std::size_t digits = std::max<std::size_t>(fmt::formatted_size("{}", count - 1), 3);
        const std::filesystem::path path(pattern);
        const std::string name =
            fmt::format("{}-{:0{}}{}", path.stem().string(), index, digits, path.extension().string());
        return (path.parent_path() / name).string();
    }
    std::string name;
    bool numbered = false;
    for (std::size_t i = 0; i < pattern.size(); ++i) {
        if (pattern[i] != '%') {
            name += pattern[i];
            continue;
        }
        ++i;
        if (i < pattern.size() && pattern[i] == '%') {
            name += '%';
            continue;
        }
        std::size_t digits = 1;
        if (i + 1 < pattern.size() && pattern[i] == '0' && is_digit(pattern[i + 1])) {
            digits = static_cast<std::size_t>(pattern[i + 1] - '0');
            i += 2;
        }
        if (i >= pattern.size() || pattern[i] != 'd' || numbered) throw bad_pattern(pattern);
        numbered = true;
        name += fmt::format("{:0{}}", index, std::max<std::size_t>(digits, 1));
    }
    if (!numbered) throw bad_pattern(pattern);
    return name;
}

std::string sequence_pattern(const std::string& words) {
    const std::filesystem::path path(words);
    if (words.find('%') != std::string::npos || path.extension() == ".png") return words;
    return (path / "%04d.png").string();
}

PictureOutput::PictureOutput(std::string name, Kind kind, std::uint32_t frames, std::uint32_t frames_per_second,
                             std::string each)
    : name_(std::move(name)),
      each_(std::move(each)),
      kind_(kind),
      frames_(frames),
      frames_per_second_(frames_per_second) {
    // Bad patterns are refused before the work.
    if (kind_ == Kind::sequence) frame_name(name_, 0, frames_);
    if (!each_.empty()) frame_name(each_, 0, frames_);
}

void PictureOutput::add(const image::Image& picture) {
    if (kind_ == Kind::animation) {
        if (!animation_) {
            animation_ =
                std::make_unique<image::ApngWriter>(name_, picture.width, picture.height, frames_, frames_per_second_);
        }
        animation_->add(picture);
    } else if (kind_ != Kind::none) {
        image::write_png(picture, kind_ == Kind::single ? name_ : frame_name(name_, next_, frames_));
    }
    if (!each_.empty()) {
        const std::string path = frame_name(each_, next_, frames_);
        if (next_ == 0) make_folder_of(path);
        image::write_png(picture, path);
    }
    ++next_;
}

std::string PictureOutput::finish() {
    if (kind_ == Kind::animation) animation_->publish();
    const auto range = [&](const std::string& pattern) {
        return fmt::format("{} to {}", frame_name(pattern, 0, frames_), frame_name(pattern, frames_ - 1, frames_));
    };
    const auto what = [&]() -> std::string {
        if (kind_ == Kind::animation) return fmt::format("{}, {} frames", name_, frames_);
        return kind_ == Kind::sequence ? range(name_) : name_;
    };
    if (each_.empty()) return what();
    return kind_ == Kind::none ? range(each_) : fmt::format("{} and {}", what(), range(each_));
}

}  // namespace tessera::cli
