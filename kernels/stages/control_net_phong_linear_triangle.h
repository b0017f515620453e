// Control nets of the scheme phong with linear normals on triangles.
#include "schemes/phong.h"

#define NET_KERNEL control_net_phong_linear_triangle
#define NET_SCHEME 2
#define NET_NORMALS 1
#include "schemes/control_net_kernel.h"
