// Shades a pixel of a refined mesh, in linear light; the target encodes to sRGB. Colours leave multiplied by alpha.
#version 450

layout(constant_id = 0) const uint shading = 0;  // render::Shading
const uint phong = 0, normals = 1, wireframe = 2;

layout(location = 0) in vec3 camera_position;
layout(location = 1) in vec3 model_normal;
layout(location = 2) in vec2 texture_uv;
layout(location = 3) in vec3 barycentric;
layout(location = 4) in vec4 vertex_colour;

layout(set = 0, binding = 0) uniform Frame {
    mat4 view;
    mat4 projection;
    mat4 rotation;
} frame;
layout(set = 1, binding = 0) uniform sampler2D base_color_texture;

layout(push_constant) uniform Material {
    vec4 base_color;
    float alpha_cutoff;  // below it a pixel is dropped; 0 for none
    uint keeps_alpha;    // 0: drawn opaque
} material;

layout(location = 0) out vec4 colour;

// Reflection constants of van Veen and Baakman, "Curved PN triangles on the GPU", figure 14, and their white light
// to the upper left of the viewer, here fixed to the camera. Their exponent 150 is of Phong's reflected ray; Blinn's
// half vector turns half as fast, and four times the exponent gives the same highlight.
const float ambient = 0.4, diffuse = 0.5, specular = 0.3, shininess = 4.0 * 150.0;
const vec3 to_light = normalize(vec3(-0.5, 0.7, 1.0));

const vec3 wire_fill = vec3(0.80, 0.82, 0.85);
const vec3 wire_edge = vec3(0.02, 0.05, 0.12);
const float wire_half_width = 0.75;  // pixels

vec3 decode_srgb(vec3 encoded) {
    return mix(encoded / 12.92, pow((encoded + 0.055) / 1.055, vec3(2.4)), greaterThan(encoded, vec3(0.04045)));
}

// The unit normal on the visible side, in the model's axes. A normal without length faces the viewer.
vec3 facing_normal() {
    float squared = dot(model_normal, model_normal);
    vec3 towards_viewer = vec3(frame.rotation[0].z, frame.rotation[1].z, frame.rotation[2].z);
    if (!(squared > 0.0)) return towards_viewer;
    return model_normal * inversesqrt(squared) * (gl_FrontFacing ? 1.0 : -1.0);
}

vec3 blinn_phong(vec3 base) {
    vec3 n = mat3(frame.rotation) * facing_normal();
    vec3 to_eye = normalize(-camera_position);
    vec3 halfway = normalize(to_light + to_eye);
    float lit = max(dot(n, to_light), 0.0);
    float shine = lit > 0.0 ? pow(max(dot(n, halfway), 0.0), shininess) : 0.0;
    return base * (ambient + diffuse * lit) + vec3(specular * shine);
}

// The distance to the nearest edge in pixels is the barycentric coordinate over its slope on the screen.
vec3 wire(vec3 barycentric) {
    vec3 across = dFdx(barycentric), down = dFdy(barycentric);
    vec3 pixels = barycentric * inversesqrt(max(across * across + down * down, vec3(1e-20)));
    float nearest = min(min(pixels.x, pixels.y), pixels.z);
    return mix(wire_edge, wire_fill, smoothstep(wire_half_width - 0.5, wire_half_width + 0.5, nearest));
}

// Trilinear filtering as Vulkan defines it without anisotropy. The shader picks the two levels and the sampler filters
// within them, for drivers come to their own levels: llvmpipe, for one, takes the longer component of a step for its
// length, and blends levels near the middle between them only.
vec4 sample_base_color() {
    vec2 size = vec2(textureSize(base_color_texture, 0));
    vec2 across = dFdx(texture_uv) * size, down = dFdy(texture_uv) * size;
    float longest = max(max(dot(across, across), dot(down, down)), 1.0);
    float level = min(0.5 * log2(longest), float(textureQueryLevels(base_color_texture) - 1));
    float finer = floor(level);
    return mix(textureLod(base_color_texture, texture_uv, finer),
               textureLod(base_color_texture, texture_uv, finer + 1.0), level - finer);
}

void main() {
    vec4 base = material.base_color * vertex_colour * sample_base_color();
    vec3 edges = wire(barycentric);  // derivatives come before any discard
    if (base.a < material.alpha_cutoff) discard;
    float alpha = material.keeps_alpha != 0 ? base.a : 1.0;
    vec3 shaded;
    if (shading == normals) {
        shaded = decode_srgb(facing_normal() * 0.5 + 0.5);  // the bytes of the picture are the normal
    } else if (shading == wireframe) {
        shaded = edges;
    } else {
        shaded = blinn_phong(base.rgb);
    }
    colour = vec4(shaded * alpha, alpha);
}
