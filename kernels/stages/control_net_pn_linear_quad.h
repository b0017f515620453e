// Control nets of the scheme pn with linear normals on quads.
#include "schemes/pn_quad.h"

#define NET_KERNEL control_net_pn_linear_quad
#define NET_SCHEME 3
#define NET_NORMALS 1
#include "schemes/control_net_quad_kernel.h"
