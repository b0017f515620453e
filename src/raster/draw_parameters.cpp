#include "raster/draw_parameters.hpp"

#include <cmath>

namespace tessera::raster {
namespace {

/// Denormals are zero before any device sees them.
float sound(double value) {
    const auto x = static_cast<float>(value);
    return std::isnormal(x) ? x : 0.0f;
}

/// Sets a row of an affine map.
void set_row(const glm::dmat4& m, int row, float& x, float& y, float& z, float& t) {
    x = sound(m[0][row]);
    y = sound(m[1][row]);
    z = sound(m[2][row]);
    t = sound(m[3][row]);
}

}  // namespace

kernels::DrawParams frame_parameters(const render::Frame& frame) {
    kernels::DrawParams p{};
    const glm::dmat4 view(frame.camera.view);
    const glm::dmat4 clip = glm::dmat4(frame.camera.projection) * view;
    set_row(clip, 0, p.xx, p.xy, p.xz, p.xt);
    set_row(clip, 1, p.yx, p.yy, p.yz, p.yt);
    set_row(clip, 2, p.zx, p.zy, p.zz, p.zt);
    set_row(clip, 3, p.wx, p.wy, p.wz, p.wt);
    set_row(view, 0, p.rx, p.ry, p.rz, p.rt);
    set_row(view, 1, p.ux, p.uy, p.uz, p.ut);
    set_row(view, 2, p.bx, p.by, p.bz, p.bt);
    p.unscale = sound(1.0 / glm::length(glm::dvec3(view[0])));

    p.half_width = static_cast<float>(frame.width) * (RASTER_SUBPIXELS / 2);
    p.half_height = static_cast<float>(frame.height) * (RASTER_SUBPIXELS / 2);
    p.guard_x = RASTER_GUARD_FLOAT / p.half_width;
    p.guard_y = RASTER_GUARD_FLOAT / p.half_height;
    p.pixel_x = 2.0f / static_cast<float>(frame.width);
    p.pixel_y = 2.0f / static_cast<float>(frame.height);
    p.axis_log2 = frame.samples == 4 ? 2 : 0;
    p.column_of_row = frame.samples == 4 ? RASTER_COLUMNS_OF_4 : 0;
    p.columns = frame.width << p.axis_log2;
    p.rows = frame.height << p.axis_log2;
    switch (frame.shading) {
        case render::Shading::phong:
            p.shading = SHADING_PHONG;
            break;
        case render::Shading::normals:
            p.shading = SHADING_NORMALS;
            break;
        case render::Shading::wireframe:
            p.shading = SHADING_WIREFRAME;
            break;
        case render::Shading::reflection:
            p.shading = SHADING_REFLECTION;
            break;
        case render::Shading::pbr:
            p.shading = SHADING_PBR;
            break;
        case render::Shading::depth:
            p.shading = SHADING_DEPTH;
            break;
        case render::Shading::uv:
            p.shading = SHADING_UV;
            break;
    }
    p.wires = frame.wires ? 1 : 0;
    return p;
}

void set_material(kernels::DrawParams& params, const scene::Material& material, const TexelBuffer& texture) {
    params.cull = material.double_sided ? 0 : 1;
    const bool shows_data =
        params.shading == SHADING_WIREFRAME || params.shading == SHADING_DEPTH || params.shading == SHADING_UV;
    params.keeps_alpha = material.alpha_mode == scene::AlphaMode::blend && !shows_data ? 1 : 0;
    params.cutoff = material.alpha_mode == scene::AlphaMode::mask ? material.alpha_cutoff : 0.0f;
    params.red = sound(material.base_color.r);
    params.green = sound(material.base_color.g);
    params.blue = sound(material.base_color.b);
    params.alpha = sound(material.base_color.a);
    params.texture_width = texture.width;
    params.texture_height = texture.height;
    params.texture_levels = texture.levels;
}

bool is_drawn_in_order(const kernels::DrawParams& params) {
    return params.keeps_alpha != 0 || params.cutoff > 0.0f;
}

}  // namespace tessera::raster
