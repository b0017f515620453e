// The cheapest shading that uses what the evaluation shader made.
#version 450

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 texture_coordinate;
layout(location = 0) out vec4 colour;

void main() {
    colour = vec4(normal * 0.5 + 0.5, texture_coordinate.x + position.z);
}
