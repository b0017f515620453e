// Vertices of linear surfaces with quadratic normals on triangles.
#include "emission.h"
#include "schemes/basis.h"
#include "schemes/surface_vertex.h"
#include "tessellator/triangle.h"

#define VERTICES_KERNEL vertices_linear_quadratic_triangle
#define VERTICES_DEGREE 1
#define VERTICES_NORMALS 2
#define VERTICES_NET LinearQuadraticNet
#define VERTEX_AT linear_quadratic_vertex
#include "schemes/vertices_kernel.h"
