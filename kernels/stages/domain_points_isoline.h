// The domain points of isoline patches, u and v in 16.16 per vertex: what `tessera pattern` shows and checks.
#include "emission.h"
#include "tessellator/isoline.h"

#define POINTS_KERNEL domain_points_isoline
#define PATCH_TYPE IsolinePatch
#define LOAD_PATCH LOAD_ISOLINE_PATCH
#define POINT_AT isoline_point
#include "tessellator/domain_points_kernel.h"
