// Control nets of the scheme linear with quadratic normals on quads.
#include "schemes/quad_corners.h"

#define NET_KERNEL control_net_linear_quadratic_quad
#define NET_SCHEME 1
#define NET_NORMALS 2
#include "schemes/control_net_quad_kernel.h"
