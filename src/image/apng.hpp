// Animated PNG.
#pragma once

#include "base/output_file.hpp"
#include "image/image.hpp"

namespace tessera::image {

/// Writes an animated PNG frame by frame (APNG 1.0, now PNG third edition, 11.3.2): it plays for ever, and what knows
/// no animation shows the first frame. The file takes its name in publish(), after as many frames as were announced.
class ApngWriter {
public:
    /// Sizes as for write_png; `frame_count` at least 1, each shown for 1 / `frames_per_second` s, 1 to 1000. Throws
    /// Error(output) for others, and where the file cannot be written.
    ApngWriter(const std::filesystem::path& path, std::uint32_t width, std::uint32_t height, std::uint32_t frame_count,
               std::uint32_t frames_per_second);

    /// Throws Error(output) for a frame of another size or one too many.
    void add(const Image& frame);

    /// Throws Error(output) where frames are missing.
    void publish();

private:
    void write(const std::vector<std::byte>& bytes);

    OutputFile file_;
    std::uint64_t written_ = 0;
    std::uint32_t width_, height_, frame_count_, frames_per_second_;
    std::uint32_t frames_ = 0;
    std::uint32_t sequence_ = 0;  // of fcTL and fdAT chunks
};

}  // namespace tessera::image
