// The whole vertex of a PN triangle, as a renderer's evaluation shader makes it: position, unit normal, texture
// coordinates. Spacing and order are those of SPIR-V modules that fixed_function_modes.cpp derives from this one.
#version 450

layout(triangles, equal_spacing, cw) in;

layout(location = 0) patch in vec3 points[10];
layout(location = 10) patch in vec3 normals[6];
layout(location = 16) patch in vec2 texture_coordinates[3];

layout(xfb_buffer = 0, xfb_stride = 32) out;
layout(location = 0, xfb_offset = 0) out vec3 position;
layout(location = 1, xfb_offset = 12) out vec3 normal;
layout(location = 2, xfb_offset = 24) out vec2 texture_coordinate;

void main() {
    float w = gl_TessCoord.x, u = gl_TessCoord.y, v = gl_TessCoord.z;
    position = points[0] * w * w * w + points[1] * u * u * u + points[2] * v * v * v +
               points[3] * 3.0 * w * w * u + points[4] * 3.0 * w * u * u + points[8] * 3.0 * w * w * v +
               points[5] * 3.0 * u * u * v + points[7] * 3.0 * w * v * v + points[6] * 3.0 * u * v * v +
               points[9] * 6.0 * w * u * v;
    normal = normalize(normals[0] * w * w + normals[1] * u * u + normals[2] * v * v + normals[3] * w * u +
                       normals[4] * u * v + normals[5] * w * v);
    texture_coordinate =
        texture_coordinates[0] * w + texture_coordinates[1] * u + texture_coordinates[2] * v;
    gl_Position = vec4(position.xy * 0.45, position.z * 0.25 + 0.5, 1.0);
}
