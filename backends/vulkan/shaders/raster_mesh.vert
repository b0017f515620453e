// Places a vertex of a refined mesh. Also gives each corner of a triangle its barycentric unit vector, which is right
// where a draw is not indexed (the wireframe) and unused elsewhere.
#version 450

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 uv;
layout(location = 3) in vec4 colour;  // linear

layout(set = 0, binding = 0) uniform Frame {
    mat4 view;        // to camera space; holds a uniform scale
    mat4 projection;
    mat4 rotation;    // view without scale and translation
} frame;

layout(location = 0) out vec3 camera_position;
layout(location = 1) out vec3 model_normal;
layout(location = 2) out vec2 texture_uv;
layout(location = 3) out vec3 barycentric;
layout(location = 4) out vec4 vertex_colour;

void main() {
    vec4 place = frame.view * vec4(position, 1.0);
    camera_position = place.xyz;
    model_normal = normal;
    texture_uv = uv;
    vertex_colour = colour;
    int corner = gl_VertexIndex % 3;
    barycentric = vec3(corner == 0, corner == 1, corner == 2);
    gl_Position = frame.projection * place;
}
