#include "raster/raster_pipeline.hpp"

#include "layout.h"

#include <algorithm>
#include <numeric>

namespace tessera::raster {
namespace {

/// Where `triangles` has the records and the polygons of a batch of this many triangles, and its end, in words.
constexpr std::uint64_t records_at(std::uint64_t triangles) {
    return triangles * BOUNDS_WORDS;
}
constexpr std::uint64_t polygons_at(std::uint64_t triangles) {
    return records_at(triangles) + triangles * TRIANGLE_WORDS;
}
constexpr std::uint64_t triangle_words(std::uint64_t triangles) {
    return polygons_at(triangles) + triangles * POLYGON_WORDS;
}
constexpr std::uint64_t screen_vertex_bytes = SCREEN_VERTEX_WORDS * 4;
constexpr std::uint64_t whole_run = 16;  // the longest run of vertices that a kernel stores at once
constexpr std::uint32_t depth_one = 0x3f800000u;
constexpr std::uint32_t nothing_visible = 0xffffffffu;  // VISIBLE_NONE
constexpr std::uint32_t first_list_words = 1u << 20;

std::string_view shade_kernel(const kernels::DrawParams& params) {
    if (params.shading == SHADING_NORMALS) return "raster_shade_normals";
    if (params.shading == SHADING_WIREFRAME) return "raster_shade_wireframe";
    if (params.shading == SHADING_REFLECTION) return "raster_shade_reflection";
    if (params.shading == SHADING_PBR) return "raster_shade_pbr";
    if (params.shading == SHADING_DEPTH) return "raster_shade_depth";
    if (params.shading == SHADING_UV) return "raster_shade_uv";
    if (params.attribute_stride != 0) return "raster_shade_coloured";
    return params.texture_levels != 0 ? "raster_shade_textured" : "raster_shade_plain";
}

static_assert(sizeof(kernels::DrawParams) <= ParameterRing::slot_bytes);

}  // namespace

RasterPipeline::RasterPipeline(const gpu::Device& device)
    : device_(device),
      launch_(choose_launch(device.info())),
      parameters_(device_, 8),
      no_attributes_(storage("attributes of vertices without", sizeof(VertexAttributes))),
      triangles_(storage("bounds, records and polygons of triangles", triangle_words(launch_.triangles) * 4)) {
    const VertexAttributes no_attributes{};
    device_.queue().write_buffer(no_attributes_, 0, std::as_bytes(std::span(&no_attributes, 1)));
}

gpu::Buffer RasterPipeline::storage(const char* label, std::uint64_t bytes) {
    using gpu::BufferUsage;
    return device_.create_buffer(
        {label, bytes, BufferUsage::storage | BufferUsage::copy_source | BufferUsage::copy_destination});
}

/// Records into one compute pass, with parameters pushed meanwhile, and submits.
template <typename Record>
void RasterPipeline::submit(const Record& record) {
    parameters_.reset();
    gpu::CommandEncoder encoder = device_.create_command_encoder();
    gpu::ComputePass pass = encoder.begin_compute_pass();
    record(pass);
    pass.end();
    parameters_.upload(device_);
    device_.queue().submit(encoder.finish());
}

void RasterPipeline::begin(std::vector<RasterWindow>& windows, std::uint32_t samples, std::uint32_t background) {
    windows_ = &windows;
    samples_ = samples;
    draw_stages_.clear();
    vertices_ = indices_ = attributes_ = {};  // those of the last picture may be gone
    transform_ = setup_ = clip_ = {};
    std::uint32_t tiles = 0;
    for (const RasterWindow& window : windows) {
        tiles = std::max(tiles, window.tiles());
    }
    const std::uint64_t visible_bytes = std::uint64_t{tiles} * RASTER_TILE_PIXELS * samples * 4;
    if (!visible_ || visible_.size() < visible_bytes) {
        visible_ = storage("visible triangles", visible_bytes);
        is_visible_clear_ = false;
    }
    create_tile_buffers(tiles);
    gpu::CommandEncoder encoder = device_.create_command_encoder();
    if (!is_visible_clear_) encoder.fill_buffer(visible_, 0, visible_.size(), nothing_visible);
    for (const RasterWindow& window : windows) {
        encoder.fill_buffer(window.depths, 0, window.depths.size(), depth_one);
        encoder.fill_buffer(window.colours, 0, window.colours.size(), background);
    }
    device_.queue().submit(encoder.finish());
    is_visible_clear_ = true;
}

void RasterPipeline::create_tile_buffers(std::uint32_t tiles) {
    if (tiles > tile_capacity_) {
        tile_capacity_ = tiles;
        const std::uint64_t blocks = (std::uint64_t{launch_.triangles} + launch_.block - 1) / launch_.block;
        counts_ = storage("triangles per block and tile", blocks * tiles * 4);
        totals_ = storage("triangles per tile", std::uint64_t{tiles} * 4);
        count_ = Stage(device_, "raster_count", {triangles_, counts_}, parameters_);
        columns_ = Stage(device_, "raster_columns", {counts_, totals_}, parameters_);
        bins_ = {};
    }
    reserve_lists(tiles, first_list_words);
}

void RasterPipeline::reserve_lists(std::uint32_t tiles, std::uint64_t words) {
    const std::uint64_t bytes = (2 * std::uint64_t{tiles} + 1 + words) * 4;
    if (bins_ && bins_.size() >= bytes) return;
    bins_ = storage("lists of tiles", bytes);
    fill_ = Stage(device_, "raster_fill", {triangles_, counts_, bins_}, parameters_);
    draw_stages_.clear();
}

const Stage& RasterPipeline::cover_stage(std::size_t window) {
    const auto [found, is_new] = draw_stages_.try_emplace({window, nullptr, "raster_cover"});
    if (is_new) {
        found->second =
            Stage(device_, "raster_cover", {bins_, triangles_, (*windows_)[window].depths, visible_}, parameters_);
    }
    return found->second;
}

const Stage& RasterPipeline::shade_stage(std::size_t window, std::string_view kernel, const TexelBuffer& texture) {
    const auto [found, is_new] = draw_stages_.try_emplace({window, texture.buffer.state_.get(), kernel});
    if (is_new) {
        const RasterWindow& w = (*windows_)[window];
        found->second =
            kernel.starts_with("raster_forward")
                ? Stage(device_, kernel,
                        {bins_, triangles_, vertices_, indices_, attributes_, texture.buffer, w.depths, w.colours},
                        parameters_)
                : Stage(device_, kernel, {bins_, visible_, w.colours, vertices_, indices_, attributes_, texture.buffer},
                        parameters_);
    }
    return found->second;
}

void RasterPipeline::bind(const render::DeviceDraw& draw) {
    const gpu::Buffer& attributes = draw.attributes ? draw.attributes : no_attributes_;
    const std::uint64_t screen_bytes =
        (draw.vertex_count + whole_run - 1) / whole_run * whole_run * screen_vertex_bytes;
    const bool more_screen = !screen_ || screen_.size() < screen_bytes;
    if (!more_screen && vertices_ == draw.vertices && indices_ == draw.indices && attributes_ == attributes) return;
    if (more_screen) screen_ = storage("screen vertices", screen_bytes);
    vertices_ = draw.vertices;
    indices_ = draw.indices;
    attributes_ = attributes;
    transform_ = Stage(device_, "raster_transform", {vertices_, screen_}, parameters_);
    setup_ = Stage(device_, "raster_setup", {screen_, indices_, triangles_}, parameters_);
    clip_ = Stage(device_, "raster_clip", {vertices_, indices_, triangles_}, parameters_);
    draw_stages_.clear();
}

void RasterPipeline::draw(const render::DeviceDraw& draw, kernels::DrawParams params, const TexelBuffer& texture) {
    if (draw.index_count == 0 || draw.vertex_count == 0) return;
    bind(draw);
    params.vertex_count = static_cast<std::uint32_t>(draw.vertex_count);
    params.first_vertex = static_cast<std::uint32_t>(draw.first_vertex);
    params.index_base = draw.index_base;
    params.attribute_stride = draw.attributes ? ATTRIBUTE_FLOATS : 0;
    params.records_at = static_cast<std::uint32_t>(records_at(launch_.triangles));
    params.polygons_at = static_cast<std::uint32_t>(polygons_at(launch_.triangles));
    params.entry_count = launch_.elements;
    is_transformed_ = false;
    const std::uint64_t most_indices = std::uint64_t{3} * launch_.triangles;
    for (std::uint64_t first = 0; first < draw.index_count; first += most_indices) {
        params.index_at = static_cast<std::uint32_t>(draw.first_index + first);
        params.triangle_count = static_cast<std::uint32_t>(std::min(draw.index_count - first, most_indices) / 3);
        is_set_up_ = false;
        for (std::size_t window = 0; window < windows_->size(); ++window) {
            draw_window(window, params, texture);
        }
    }
}

std::uint64_t RasterPipeline::count(const kernels::DrawParams& params, const kernels::BinParams& bin) {
    const std::uint32_t tiles = bin.tiles_x * bin.tiles_y;
    submit([&](gpu::ComputePass& pass) {
        if (!is_set_up_) {
            const std::uint32_t at = parameters_.push(params);
            if (!is_transformed_) transform_.record(pass, at, items_of(params.vertex_count));
            setup_.record(pass, at, items_of(params.triangle_count));
            clip_.record(pass, at, items_of(params.triangle_count));
        }
        const std::uint32_t at = parameters_.push(bin);
        count_.record(pass, at, std::uint64_t{bin.blocks} << bin.spread_log2);
        columns_.record(pass, at, tiles);
    });
    is_transformed_ = true;
    is_set_up_ = true;
    tile_totals_.resize(tiles);
    device_.queue().read_buffer(totals_, 0, std::as_writable_bytes(std::span(tile_totals_)));
    return std::accumulate(tile_totals_.begin(), tile_totals_.end(), std::uint64_t{0});
}

std::uint32_t RasterPipeline::upload_starts() {
    const std::size_t tiles = tile_totals_.size();
    bin_heads_.resize(tiles + 1);
    bin_heads_[0] = 0;
    std::partial_sum(tile_totals_.begin(), tile_totals_.end(), bin_heads_.begin() + 1);
    for (std::uint32_t tile = 0; tile < tiles; ++tile) {
        if (tile_totals_[tile] != 0) bin_heads_.push_back(tile);
    }
    device_.queue().write_buffer(bins_, 0, std::as_bytes(std::span(bin_heads_)));
    return static_cast<std::uint32_t>(bin_heads_.size() - tiles - 1);
}

void RasterPipeline::draw_window(std::size_t number, kernels::DrawParams params, const TexelBuffer& texture) {
    const RasterWindow& window = (*windows_)[number];
    params.tile_x = window.x / RASTER_TILE;
    params.tile_y = window.y / RASTER_TILE;
    params.tiles_x = window.tiles_x;
    params.tiles_y = window.tiles_y;
    params.list_at = 2 * window.tiles() + 1;
    params.spread_log2 = launch_.tile_spread;
    params.parts_log2 = launch_.tile_parts;
    kernels::BinParams bin{};
    bin.block = launch_.block;
    bin.spread_log2 = launch_.block_spread;
    bin.tile_x = params.tile_x;
    bin.tile_y = params.tile_y;
    bin.tiles_x = params.tiles_x;
    bin.tiles_y = params.tiles_y;
    bin.tile_shift = RASTER_TILE_LOG2 + params.axis_log2;
    bin.list_at = params.list_at;

    for (std::uint32_t first = 0; first < params.triangle_count; first += bin.triangle_count) {
        bin.first_triangle = first;
        bin.triangle_count = params.triangle_count - first;
        std::uint64_t listed = 0;
        while (true) {  // a single triangle always fits
            bin.blocks = (bin.triangle_count + bin.block - 1) / bin.block;
            listed = count(params, bin);
            if (listed <= max_list_words) break;
            bin.triangle_count = (bin.triangle_count + 1) / 2;
        }
        if (listed == 0) continue;
        reserve_lists(window.tiles(), listed);
        params.tile_count = upload_starts();
        const bool in_order = is_drawn_in_order(params);
        const std::string_view forward = params.shading == SHADING_PBR ? "raster_forward_pbr" : "raster_forward";
        const Stage& raster = in_order ? shade_stage(number, forward, texture) : cover_stage(number);
        const std::uint64_t items = std::uint64_t{params.tile_count} << (params.spread_log2 + params.parts_log2);
        const std::uint32_t longest = *std::ranges::max_element(tile_totals_);
        is_visible_clear_ = in_order && is_visible_clear_;  // until shading is on its way
        params.first_entry = 0;
        do {
            submit([&](gpu::ComputePass& pass) {
                if (params.first_entry == 0) {
                    fill_.record(pass, parameters_.push(bin), std::uint64_t{bin.blocks} << bin.spread_log2);
                }
                params.entry_count = launch_.entries;
                raster.record(pass, parameters_.push(params), items);
                params.first_entry += launch_.entries;
                if (params.first_entry >= longest && !in_order) {
                    kernels::DrawParams shade = params;
                    shade.entry_count = launch_.shaded;
                    shade.spread_log2 = launch_.shade_spread;
                    shade_stage(number, shade_kernel(params), texture)
                        .record(pass, parameters_.push(shade),
                                (std::uint64_t{params.tile_count} * RASTER_TILE_PIXELS / launch_.shaded)
                                    << launch_.shade_spread);
                }
            });
        } while (params.first_entry < longest);
        is_visible_clear_ = true;
        params.entry_count = launch_.elements;
    }
}

void RasterPipeline::resolve(const RasterWindow& window, const TexelBuffer& tables, std::span<std::byte> picture) {
    if (!picture_ || picture_.size() < picture.size()) {
        picture_ = storage("picture", picture.size());
    }
    const Stage stage(device_, "raster_resolve", {window.colours, tables.buffer, picture_}, parameters_);
    submit([&](gpu::ComputePass& pass) {
        const kernels::ResolveParams params{window.tiles_x, window.width, window.height, samples_, launch_.elements};
        stage.record(pass, parameters_.push(params), items_of(std::uint64_t{window.tiles()} * RASTER_TILE_PIXELS));
    });
    device_.queue().read_buffer(picture_, 0, picture);
}

}  // namespace tessera::raster
