// The domain points of triangle patches, u and v in 16.16: what `tessera pattern` shows and checks, and what patches
// that are all alike share.
#include "emission.h"
#include "tessellator/triangle_domain.h"

#define POINTS_KERNEL domain_points_triangle
#define POINT_AT triangle_point
#include "tessellator/domain_points_kernel.h"
