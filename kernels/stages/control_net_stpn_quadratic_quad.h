// Control nets of the scheme stpn with quadratic normals on quads.
#include "schemes/stpn_quad.h"

#define NET_KERNEL control_net_stpn_quadratic_quad
#define NET_SCHEME 4
#define NET_NORMALS 2
#include "schemes/control_net_quad_kernel.h"
