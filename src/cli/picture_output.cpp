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

PictureOutput::PictureOutput(std::string name, Kind kind, std::uint32_t frames, std::uint32_t frames_per_second)
    : name_(std::move(name)), kind_(kind), frames_(frames), frames_per_second_(frames_per_second) {
    if (kind_ == Kind::sequence) frame_name(name_, 0, frames_);  // refuses before the work
}

void PictureOutput::add(const image::Image& picture) {
    if (kind_ == Kind::animation) {
        if (!animation_) {
            animation_ =
                std::make_unique<image::ApngWriter>(name_, picture.width, picture.height, frames_, frames_per_second_);
        }
        animation_->add(picture);
    } else {
        image::write_png(picture, kind_ == Kind::single ? name_ : frame_name(name_, next_, frames_));
    }
    ++next_;
}

std::string PictureOutput::finish() {
    if (kind_ == Kind::animation) {
        animation_->publish();
        return fmt::format("{}, {} frames", name_, frames_);
    }
    if (kind_ == Kind::single) return name_;
    return fmt::format("{} to {}", frame_name(name_, 0, frames_), frame_name(name_, frames_ - 1, frames_));
}

}  // namespace tessera::cli
