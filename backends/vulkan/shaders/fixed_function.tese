// Writes where the fixed-function tessellator placed a vertex, and of which patch. Compiled once per DOMAIN, and with
// SURFACE once more to evaluate the surface of fixed_function.tesc there. Spacing and order are those of SPIR-V modules
// that fixed_function_modes.cpp derives from this one.
#version 450

layout(DOMAIN, equal_spacing, cw) in;

layout(push_constant) uniform Draw {
    uint first_patch;
    uint first_inner;
    float alpha;  // shape factor of Phong tessellation
} draw;

#ifdef SURFACE
layout(constant_id = 0) const uint scheme = 0;          // 0 linear, 1 phong, 2 pn
layout(constant_id = 1) const bool quadratic = false;  // normals with a coefficient per edge

layout(location = 0) patch in vec3 points[10];
layout(location = 10) patch in vec3 normals[6];

layout(xfb_buffer = 0, xfb_stride = 40) out;
layout(location = 2, xfb_offset = 16) out vec3 position;
layout(location = 3, xfb_offset = 28) out vec3 normal;
#else
layout(xfb_buffer = 0, xfb_stride = 16) out;
#endif
layout(location = 0, xfb_offset = 0) out vec3 coordinate;
layout(location = 1, xfb_offset = 12) out uint patch_number;

#ifdef SURFACE
// Vlachos et al. 2001, equation 2; w, u, v are the weights of corners 1, 2, 3.
vec3 pn_point(float w, float u, float v) {
    return points[0] * w * w * w + points[1] * u * u * u + points[2] * v * v * v +
           points[3] * 3.0 * w * w * u + points[4] * 3.0 * w * u * u + points[8] * 3.0 * w * w * v +
           points[5] * 3.0 * u * u * v + points[7] * 3.0 * w * v * v + points[6] * 3.0 * u * v * v +
           points[9] * 6.0 * w * u * v;
}

vec3 project(vec3 q, int corner) {
    return q - dot(q - points[corner], normals[corner]) * normals[corner];
}

vec3 flat_point(float w, float u, float v) {
    return w * points[0] + u * points[1] + v * points[2];
}

// Boubekeur and Alexa: Phong Tessellation, 2008, section 3: the flat point is projected onto each tangent plane.
vec3 phong_point(float w, float u, float v) {
    vec3 p = flat_point(w, u, v);
    return (1.0 - draw.alpha) * p + draw.alpha * (w * project(p, 0) + u * project(p, 1) + v * project(p, 2));
}
#endif

void main() {
    coordinate = gl_TessCoord;
    patch_number = draw.first_patch + gl_PrimitiveID;
#ifdef SURFACE
    float w = gl_TessCoord.x, u = gl_TessCoord.y, v = gl_TessCoord.z;
    position = scheme == 0 ? flat_point(w, u, v) : scheme == 1 ? phong_point(w, u, v) : pn_point(w, u, v);
    // Not made unit: whoever compares needs its length to know how well it is conditioned.
    normal = quadratic ? normals[0] * w * w + normals[1] * u * u + normals[2] * v * v + normals[3] * w * u +
                             normals[4] * u * v + normals[5] * w * v
                       : normals[0] * w + normals[1] * u + normals[2] * v;
#endif
}
