// Control nets of the scheme linear with linear normals on quads.
#include "schemes/quad_corners.h"

#define NET_KERNEL control_net_linear_linear_quad
#define NET_SCHEME 1
#define NET_NORMALS 1
#include "schemes/control_net_quad_kernel.h"
