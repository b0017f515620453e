// Vertices of quadratic surfaces with quadratic normals on triangles.
#include "emission.h"
#include "schemes/basis.h"
#include "tessellator/triangle.h"

#define VERTICES_KERNEL vertices_quadratic_quadratic_triangle
#define VERTICES_DEGREE 2
#define VERTICES_NORMALS 2
#include "schemes/vertices_kernel.h"
