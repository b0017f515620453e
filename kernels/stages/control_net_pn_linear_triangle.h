// Control nets of the scheme pn with linear normals on triangles.
#include "schemes/pn.h"

#define NET_KERNEL control_net_pn_linear_triangle
#define NET_SCHEME 3
#define NET_NORMALS 1
#include "schemes/control_net_kernel.h"
