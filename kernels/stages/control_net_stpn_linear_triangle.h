// Control nets of the scheme stpn with linear normals on triangles.
#include "schemes/stpn.h"

#define NET_KERNEL control_net_stpn_linear_triangle
#define NET_SCHEME 4
#define NET_NORMALS 1
#include "schemes/control_net_kernel.h"
