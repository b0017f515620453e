// Stage 6 for quad patches.
#include "emission.h"
#include "tessellator/quad_domain.h"

#define INDICES_KERNEL indices_quad
#include "tessellator/indices_kernel.h"
