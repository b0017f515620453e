// Where pictures go: a PNG, a numbered sequence of them, or an animated PNG.
#pragma once

#include "image/apng.hpp"

#include <memory>
#include <string>

namespace tessera::cli {

/// The name of frame `index` of `count`: the one %d or %03d of `pattern` is replaced (%% stands for %), else "-000" is
/// put before the extension, with at least three digits. Throws Error(usage) for any other use of %.
std::string frame_name(const std::string& pattern, std::uint32_t index, std::uint32_t count);

/// The pattern for pictures of a sequence that `words` stand for: a pattern as it is, NAME.png likewise, and of a
/// folder, FOLDER/%04d.png.
std::string sequence_pattern(const std::string& words);

class PictureOutput {
public:
    enum class Kind { none, single, sequence, animation };

    /// `frames` at least 1. A single picture takes the name as it is. `each`, where it is not empty, is the pattern of
    /// a sequence that is written besides; its folder is made with the first picture.
    PictureOutput(std::string name, Kind kind, std::uint32_t frames, std::uint32_t frames_per_second, std::string each);

    /// Takes the next picture. All of an animation have the same size. Throws Error(output).
    void add(const image::Image& picture);

    /// After the last one: an animation gets its name only now. Returns what was written, for people.
    std::string finish();

private:
    std::string name_, each_;
    Kind kind_;
    std::uint32_t frames_, frames_per_second_;
    std::uint32_t next_ = 0;
    std::unique_ptr<image::ApngWriter> animation_;
};

}  // namespace tessera::cli
