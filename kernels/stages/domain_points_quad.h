// The domain points of quad patches, u and v in 16.16: what `tessera pattern` shows and checks, and what patches that
// are all alike share.
#include "emission.h"
#include "tessellator/quad_domain.h"

#define POINTS_KERNEL domain_points_quad
#define POINT_AT quad_point
#include "tessellator/domain_points_kernel.h"
