// Vertices of linear surfaces with quadratic normals on triangles.
#include "emission.h"
#include "schemes/basis.h"
#include "tessellator/triangle.h"

#define VERTICES_KERNEL vertices_linear_quadratic_triangle
#define VERTICES_DEGREE 1
#define VERTICES_NORMALS 2
#include "schemes/vertices_kernel.h"
