// Stage 6 for quad patches: records and offsets -> triangles, three indices each.
#include "emission.h"
#include "tessellator/quad.h"

#define INDICES_KERNEL indices_quad
#define PATCH_TYPE QuadPatch
#define LOAD_PATCH LOAD_QUAD_PATCH
#define TRIANGLE_COUNT quad_triangle_count
#define TRIANGLE_AT quad_triangle
#include "tessellator/indices_kernel.h"
