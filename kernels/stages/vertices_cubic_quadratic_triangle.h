// Vertices of cubic surfaces with quadratic normals on triangles.
#include "emission.h"
#include "schemes/basis.h"
#include "schemes/surface_vertex.h"
#include "tessellator/triangle.h"

#define VERTICES_KERNEL vertices_cubic_quadratic_triangle
#define VERTICES_DEGREE 3
#define VERTICES_NORMALS 2
#define VERTICES_NET CubicQuadraticNet
#define VERTEX_AT cubic_quadratic_vertex
#include "schemes/vertices_kernel.h"
