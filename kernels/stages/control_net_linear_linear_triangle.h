// Control nets of the scheme linear with linear normals on triangles.
#include "schemes/linear.h"

#define NET_KERNEL control_net_linear_linear_triangle
#define NET_SCHEME 1
#define NET_NORMALS 1
#include "schemes/control_net_kernel.h"
