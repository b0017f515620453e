// Vertices of quadratic surfaces with quadratic normals on triangles.
#include "emission.h"
#include "schemes/basis.h"
#include "schemes/surface_vertex.h"
#include "tessellator/triangle.h"

#define VERTICES_KERNEL vertices_quadratic_quadratic_triangle
#define VERTICES_DEGREE 2
#define VERTICES_NORMALS 2
#define VERTICES_NET QuadraticQuadraticNet
#define VERTEX_AT quadratic_quadratic_vertex
#include "schemes/vertices_kernel.h"
