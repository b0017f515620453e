// Control nets of the scheme stpn with quadratic normals on triangles.
#include "schemes/stpn.h"

#define NET_KERNEL control_net_stpn_quadratic_triangle
#define NET_SCHEME 4
#define NET_NORMALS 2
#include "schemes/control_net_kernel.h"
