// Control nets of the scheme phong with quadratic normals on quads.
#include "schemes/phong_quad.h"

#define NET_KERNEL control_net_phong_quadratic_quad
#define NET_SCHEME 2
#define NET_NORMALS 2
#include "schemes/control_net_quad_kernel.h"
