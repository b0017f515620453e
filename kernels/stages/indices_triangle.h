// Stage 6 for triangle patches.
#include "emission.h"
#include "tessellator/triangle_domain.h"

#define INDICES_KERNEL indices_triangle
#include "tessellator/indices_kernel.h"
