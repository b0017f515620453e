// Control nets of the scheme stpn with linear normals on quads.
#include "schemes/stpn_quad.h"

#define NET_KERNEL control_net_stpn_linear_quad
#define NET_SCHEME 4
#define NET_NORMALS 1
#include "schemes/control_net_quad_kernel.h"
