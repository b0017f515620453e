// The kernels of the portable rasteriser, recorded in order: for each batch of triangles transform, setup and clip; for
// each window of the picture then bins, and coverage and shading, or both in order.
#pragma once

#include "raster/draw_parameters.hpp"
#include "raster/launch.hpp"
#include "raster/raster_window.hpp"
#include "render/triangle_batches.hpp"
#include "tessellate/stage.hpp"

#include <map>
#include <tuple>

namespace tessera::raster {

/// Memory beside that of the windows does not depend on what is drawn: about 130 MiB, and `visible`, a word per sample
/// of the largest window.
class RasterPipeline {
public:
    /// Words of all lists of one binning; batches that need more are cut.
    static constexpr std::uint64_t max_list_words = std::uint64_t{1} << 24;

    explicit RasterPipeline(const gpu::Device& device);

    /// Begins a picture of these windows: all samples show `background` (a code as kernels/raster/srgb.h packs it), at
    /// depth 1. The windows must outlive the picture.
    void begin(std::vector<RasterWindow>& windows, std::uint32_t samples, std::uint32_t background);

    /// Draws a batch of `draw`.
    void draw(const render::TriangleBatch& batch, const render::Draw& draw, kernels::DrawParams params,
              const TexelBuffer& texture);

    /// Resolves a window: R, G, B, A of each pixel, rows from the top.
    void resolve(const RasterWindow& window, const TexelBuffer& tables, std::span<std::byte> picture);

private:
    /// Items for this many vertices, triangles or pixels.
    std::uint64_t items_of(std::uint64_t elements) const {
        return (elements + launch_.elements - 1) / launch_.elements;
    }
    gpu::Buffer storage(const char* label, std::uint64_t bytes);
    void upload(const render::TriangleBatch& batch, const render::Draw& draw);
    /// Writes what belongs to the vertices of a batch to word `at` of the vertex buffer.
    template <typename Element>
    void upload(const render::TriangleBatch& batch, std::span<const Element> of_vertices, std::uint64_t at);
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
    bool is_set_up_ = false;         // the batch has records and bounds
    bool is_visible_clear_ = false;  // all of visible_ is VISIBLE_NONE: shading leaves it so
    std::vector<RasterWindow>* windows_ = nullptr;
    std::vector<std::byte> corners_;
    std::vector<std::uint32_t> local_indices_, tile_totals_, bin_heads_;
    gpu::Buffer vertices_, indices_, screen_, records_, bounds_;
    gpu::Buffer counts_, totals_, bins_, visible_, picture_;
    std::uint32_t tile_capacity_ = 0;
    Stage transform_, setup_, clip_, count_, columns_, fill_;
    // Stages bound to a window and a texture, made at their first use.
    std::map<std::tuple<std::size_t, const void*, std::string_view>, Stage> draw_stages_;
};

}  // namespace tessera::raster
