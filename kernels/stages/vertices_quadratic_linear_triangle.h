// Vertices of quadratic surfaces with linear normals on triangles.
#include "emission.h"
#include "schemes/basis.h"
#include "schemes/surface_vertex.h"
#include "tessellator/triangle.h"

#define VERTICES_KERNEL vertices_quadratic_linear_triangle
#define VERTICES_DEGREE 2
#define VERTICES_NORMALS 1
#define VERTICES_NET QuadraticLinearNet
#define VERTEX_AT quadratic_linear_vertex
#include "schemes/vertices_kernel.h"
