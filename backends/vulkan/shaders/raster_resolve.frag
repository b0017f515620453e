// Averages the samples of a pixel. Vulkan leaves open whether its own resolve averages light or sRGB codes; here it is
// light. The result is not multiplied by alpha any more, as PNG wants it.
#version 450

layout(set = 0, binding = 0) uniform sampler2DMS samples;

layout(location = 0) out vec4 colour;

void main() {
    vec4 sum = vec4(0.0);
    for (int i = 0; i < 4; ++i) sum += texelFetch(samples, ivec2(gl_FragCoord.xy), i);
    vec4 mean = sum * 0.25;
    colour = mean.a > 0.0 ? vec4(mean.rgb / mean.a, mean.a) : vec4(0.0);
}
