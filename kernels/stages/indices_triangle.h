// Stage 6 for triangle patches: records and offsets -> triangles, three indices each.
#include "emission.h"
#include "tessellator/triangle.h"

#define INDICES_KERNEL indices_triangle
#define PATCH_TYPE TrianglePatch
#define LOAD_PATCH LOAD_TRIANGLE_PATCH
#define TRIANGLE_COUNT triangle_triangle_count
#define TRIANGLE_AT triangle_triangle
#include "tessellator/indices_kernel.h"
