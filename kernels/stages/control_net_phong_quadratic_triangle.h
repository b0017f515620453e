// Control nets of the scheme phong with quadratic normals on triangles.
#include "schemes/phong.h"

#define NET_KERNEL control_net_phong_quadratic_triangle
#define NET_SCHEME 2
#define NET_NORMALS 2
#include "schemes/control_net_kernel.h"
