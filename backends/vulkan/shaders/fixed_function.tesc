// Hands the factors of one patch to the fixed-function tessellator. Compiled twice: with SURFACE it also makes what
// fixed_function.tese evaluates (with TEXTURE_COORDINATES: timed_draw.tese), a PN triangle as in Vlachos, Peters, Boyd, Mitchell: Curved PN Triangles, 2001.
// Written from the paper, in its notation, so that it shares nothing with the kernels that it judges.
#version 450

layout(vertices = 1) out;

layout(push_constant) uniform Draw {
    uint first_patch;  // of this draw
    uint first_inner;  // place of the first inside factor: 3 for triangles, 4 for quads
} draw;

layout(std430, set = 0, binding = 0) readonly buffer Factors { float factors[]; };  // six per patch

#ifdef SURFACE
layout(std430, set = 0, binding = 1) readonly buffer Corners { float corners[]; };  // three per patch, of eight floats

layout(location = 0) patch out vec3 points[10];  // P1 P2 P3 b210 b120 b021 b012 b102 b201 b111
layout(location = 10) patch out vec3 normals[6];  // N1 N2 N3 n110 n011 n101

#ifdef TEXTURE_COORDINATES
layout(location = 16) patch out vec2 texture_coordinates[3];
#endif

vec3 load(uint at) {
    return vec3(corners[at], corners[at + 1], corners[at + 2]);
}

// Section 3.2, tangent coefficients: b210 for corners 1 and 2.
vec3 edge_point(vec3 p1, vec3 n1, vec3 p2) {
    float w12 = dot(p2 - p1, n1);
    return (2.0 * p1 + p2 - w12 * n1) / 3.0;
}

// Section 3.3: n110 for corners 1 and 2. The edge is scaled first, lest its square underflow.
vec3 edge_normal(vec3 p1, vec3 n1, vec3 p2, vec3 n2) {
    vec3 edge = p2 - p1;
    float largest = max(abs(edge.x), max(abs(edge.y), abs(edge.z)));
    vec3 d = largest > 0.0 ? edge / largest : vec3(0.0);
    float v12 = largest > 0.0 ? 2.0 * dot(d, n1 + n2) / dot(d, d) : 0.0;
    vec3 h110 = n1 + n2 - v12 * d;
    return length(h110) > 0.0 ? normalize(h110) : vec3(0.0);
}

void make_surface(uint patch_number) {
    uint at = 24 * patch_number;
    vec3 p1 = load(at), p2 = load(at + 8), p3 = load(at + 16);
    vec3 n1 = load(at + 3), n2 = load(at + 11), n3 = load(at + 19);
    vec3 b210 = edge_point(p1, n1, p2), b120 = edge_point(p2, n2, p1);
    vec3 b021 = edge_point(p2, n2, p3), b012 = edge_point(p3, n3, p2);
    vec3 b102 = edge_point(p3, n3, p1), b201 = edge_point(p1, n1, p3);
    vec3 e = (b210 + b120 + b021 + b012 + b102 + b201) / 6.0;
    vec3 v = (p1 + p2 + p3) / 3.0;
    vec3 b111 = e + (e - v) / 2.0;
    points = vec3[](p1, p2, p3, b210, b120, b021, b012, b102, b201, b111);
    normals = vec3[](n1, n2, n3, edge_normal(p1, n1, p2, n2), edge_normal(p2, n2, p3, n3),
                     edge_normal(p3, n3, p1, n1));
#ifdef TEXTURE_COORDINATES
    texture_coordinates = vec2[](vec2(corners[at + 6], corners[at + 7]), vec2(corners[at + 14], corners[at + 15]),
                                 vec2(corners[at + 22], corners[at + 23]));
#endif
}
#endif

void main() {
    uint patch_number = draw.first_patch + gl_PrimitiveID;
    uint at = 6 * patch_number;
    gl_TessLevelOuter[0] = factors[at];
    gl_TessLevelOuter[1] = factors[at + 1];
    gl_TessLevelOuter[2] = factors[at + 2];
    gl_TessLevelOuter[3] = factors[at + 3];
    gl_TessLevelInner[0] = factors[at + draw.first_inner];
    gl_TessLevelInner[1] = factors[at + 5];
#ifdef SURFACE
    make_surface(patch_number);
#endif
}
