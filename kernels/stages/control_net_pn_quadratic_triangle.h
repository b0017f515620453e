// Control nets of the scheme pn with quadratic normals on triangles.
#include "schemes/pn.h"

#define NET_KERNEL control_net_pn_quadratic_triangle
#define NET_SCHEME 3
#define NET_NORMALS 2
#include "schemes/control_net_kernel.h"
