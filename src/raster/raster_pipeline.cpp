#include "raster/raster_pipeline.hpp"

#include "layout.h"

#include <algorithm>
#include <numeric>

namespace tessera::raster {
namespace {

constexpr std::uint64_t most_triangles = render::TriangleBatch::max_triangles;
constexpr std::uint64_t most_vertices = 3 * most_triangles;
// `vertices` holds vertices, their attributes, and one record of attributes for vertices that have none.
constexpr std::uint64_t attributes_at = most_vertices * sizeof(Vertex);
constexpr std::uint64_t no_attributes_at = attributes_at + most_vertices * sizeof(VertexAttributes);
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
      vertices_(storage("vertices to draw", no_attributes_at + sizeof(VertexAttributes))),
      indices_(storage("indices to draw", most_triangles * 3 * 4)),
      screen_(storage("screen vertices", most_vertices * SCREEN_VERTEX_WORDS * 4)),
      records_(storage("triangle records", most_triangles * (TRIANGLE_WORDS + POLYGON_WORDS) * 4)),
      bounds_(storage("triangle bounds", most_triangles * BOUNDS_WORDS * 4)) {
    const VertexAttributes no_attributes{};
    device_.queue().write_buffer(vertices_, no_attributes_at, std::as_bytes(std::span(&no_attributes, 1)));
    transform_ = Stage(device_, "raster_transform", {vertices_, screen_}, parameters_);
    setup_ = Stage(device_, "raster_setup", {screen_, indices_, records_, bounds_}, parameters_);
    clip_ = Stage(device_, "raster_clip", {vertices_, indices_, records_, bounds_}, parameters_);
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
        const std::uint64_t blocks = (most_triangles + launch_.block - 1) / launch_.block;
        counts_ = storage("triangles per block and tile", blocks * tiles * 4);
        totals_ = storage("triangles per tile", std::uint64_t{tiles} * 4);
        count_ = Stage(device_, "raster_count", {bounds_, counts_}, parameters_);
        columns_ = Stage(device_, "raster_columns", {counts_, totals_}, parameters_);
        bins_ = {};
    }
    reserve_lists(tiles, first_list_words);
}

void RasterPipeline::reserve_lists(std::uint32_t tiles, std::uint64_t words) {
    const std::uint64_t bytes = (2 * std::uint64_t{tiles} + 1 + words) * 4;
    if (bins_ && bins_.size() >= bytes) return;
    bins_ = storage("lists of tiles", bytes);
    fill_ = Stage(device_, "raster_fill", {bounds_, counts_, bins_}, parameters_);
    draw_stages_.clear();
}

const Stage& RasterPipeline::cover_stage(std::size_t window) {
    const auto [found, is_new] = draw_stages_.try_emplace({window, nullptr, "raster_cover"});
    if (is_new) {
        found->second = Stage(device_, "raster_cover", {bins_, bounds_, records_, (*windows_)[window].depths, visible_},
                              parameters_);
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
                        {bins_, bounds_, records_, vertices_, indices_, texture.buffer, w.depths, w.colours},
                        parameters_)
                : Stage(device_, kernel, {bins_, visible_, w.colours, vertices_, indices_, texture.buffer},
                        parameters_);
    }
    return found->second;
}

void RasterPipeline::draw(const render::TriangleBatch& batch, const render::Draw& draw, kernels::DrawParams params,
                          const TexelBuffer& texture) {
    upload(batch, draw);
    params.attributes_at = static_cast<std::uint32_t>((draw.attributes.empty() ? no_attributes_at : attributes_at) / 4);
    params.attribute_stride = draw.attributes.empty() ? 0 : ATTRIBUTE_FLOATS;
    params.triangle_count = static_cast<std::uint32_t>(batch.indices.size() / 3);
    params.vertex_count = static_cast<std::uint32_t>(batch.is_local() ? batch.vertex_count : batch.indices.size());
    params.polygons_at = static_cast<std::uint32_t>(most_triangles * TRIANGLE_WORDS);
    params.entry_count = launch_.elements;
    is_set_up_ = false;
    for (std::size_t window = 0; window < windows_->size(); ++window) {
        draw_window(window, params, texture);
    }
}

template <typename Element>
void RasterPipeline::upload(const render::TriangleBatch& batch, std::span<const Element> of_vertices,
                            std::uint64_t at) {
    if (batch.is_local()) {
        const auto used = of_vertices.subspan(batch.first_vertex, batch.vertex_count);
        device_.queue().write_buffer(vertices_, at, std::as_bytes(used));
        return;
    }
    corners_.resize(batch.indices.size() * sizeof(Element));
    render::write_corners(batch, of_vertices, reinterpret_cast<Element*>(corners_.data()));
    device_.queue().write_buffer(vertices_, at, corners_);
}

void RasterPipeline::upload(const render::TriangleBatch& batch, const render::Draw& draw) {
    // The device may still be busy with the batch before: it is waited for as late as possible, by the first write.
    local_indices_.resize(batch.indices.size());
    if (batch.is_local()) {
        render::write_local_indices(batch, local_indices_.data());
    } else {
        std::iota(local_indices_.begin(), local_indices_.end(), 0u);
    }
    upload(batch, draw.vertices, 0);
    if (!draw.attributes.empty()) upload(batch, draw.attributes, attributes_at);
    device_.queue().write_buffer(indices_, 0, std::as_bytes(std::span(local_indices_)));
}

std::uint64_t RasterPipeline::count(const kernels::DrawParams& params, const kernels::BinParams& bin) {
    const std::uint32_t tiles = bin.tiles_x * bin.tiles_y;
    submit([&](gpu::ComputePass& pass) {
        if (!is_set_up_) {
            const std::uint32_t at = parameters_.push(params);
            transform_.record(pass, at, items_of(params.vertex_count));
            setup_.record(pass, at, items_of(params.triangle_count));
            clip_.record(pass, at, items_of(params.triangle_count));
        }
        const std::uint32_t at = parameters_.push(bin);
        count_.record(pass, at, std::uint64_t{bin.blocks} << bin.spread_log2);
        columns_.record(pass, at, tiles);
    });
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
