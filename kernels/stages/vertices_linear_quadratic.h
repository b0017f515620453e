// Vertices of linear surfaces with quadratic normals.
#include "emission.h"
#include "schemes/basis.h"
#include "tessellator/triangle.h"

#define VERTICES_KERNEL vertices_linear_quadratic
#define VERTICES_DEGREE 1
#define VERTICES_NORMALS 2
#include "schemes/vertices_kernel.h"
