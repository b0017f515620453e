// The kernels of the portable rasteriser, recorded in order: for each batch of triangles transform, setup and clip; for
// each window of the picture then bins, and coverage and shading, or both in order.
#pragma once

#include "raster/draw_parameters.hpp"
#include "raster/launch.hpp"
#include "raster/raster_window.hpp"
#include "render/device_draw.hpp"
#include "tessellate/stage.hpp"

#include <map>
#include <tuple>

namespace tessera::raster {

/// Memory beside that of the windows: about 140 MiB; `visible`, a word per sample of the largest window; and 16 bytes
/// per vertex of the largest draw.
class RasterPipeline {
public:
    /// Words of all lists of one binning; batches that need more are cut.
    static constexpr std::uint64_t max_list_words = std::uint64_t{1} << 24;

    explicit RasterPipeline(const gpu::Device& device);

    /// Begins a picture of these windows: all samples show `background` (a code as kernels/raster/srgb.h packs it), at
    /// depth 1. The windows must outlive the picture.
    void begin(std::vector<RasterWindow>& windows, std::uint32_t samples, std::uint32_t background);

    /// Draws, some triangles at a time.
    void draw(const render::DeviceDraw& draw, kernels::DrawParams params, const TexelBuffer& texture);

    /// Resolves a window: R, G, B, A of each pixel, rows from the top.
    void resolve(const RasterWindow& window, const TexelBuffer& tables, std::span<std::byte> picture);

private:
    /// Items for this many vertices, triangles or pixels.
    std::uint64_t items_of(std::uint64_t elements) const {
        return (elements + launch_.elements - 1) / launch_.elements;
    }
    gpu::Buffer storage(const char* label, std::uint64_t bytes);
    /// Makes stages read the buffers of a draw.
    void bind(const render::DeviceDraw& draw);
    void draw_window(std::size_t window, kernels::DrawParams params, const TexelBuffer& texture);
    /// Sets up the batch, the first time, counts triangles per tile into tile_totals_ and returns their sum.
    std::uint64_t count(const kernels::DrawParams& params, const kernels::BinParams& bin);
    /// Writes where the lists begin, and which tiles have one; returns how many have.
    std::uint32_t upload_starts();
    void reserve_lists(std::uint32_t tiles, std::uint64_t words);
    void create_tile_buffers(std::uint32_t tiles);
    const Stage& cover_stage(std::size_t window);
    const Stage& shade_stage(std::size_t window, std::string_view kernel, const TexelBuffer& texture);
    template <typename Record>
    void submit(const Record& record);

    gpu::Device device_;
    Launch launch_;
    ParameterRing parameters_;
    std::uint32_t samples_ = 4;
    bool is_transformed_ = false;    // the draw has screen vertices
    bool is_set_up_ = false;         // the batch has bounds and records
    bool is_visible_clear_ = false;  // all of visible_ is VISIBLE_NONE: shading leaves it so
    std::vector<RasterWindow>* windows_ = nullptr;
    std::vector<std::uint32_t> tile_totals_, bin_heads_;
    gpu::Buffer vertices_, indices_, attributes_;  // of the present draw
    gpu::Buffer no_attributes_, screen_, triangles_;
    gpu::Buffer counts_, totals_, bins_, visible_, picture_;
    std::uint32_t tile_capacity_ = 0;
    Stage transform_, setup_, clip_, count_, columns_, fill_;
    // Stages bound to a window, a texture and the present draw's buffers, made at their first use.
    std::map<std::tuple<std::size_t, const void*, std::string_view>, Stage> draw_stages_;
};

}  // namespace tessera::raster
