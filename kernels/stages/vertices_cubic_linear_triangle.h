// Vertices of cubic surfaces with linear normals on triangles.
#include "emission.h"
#include "schemes/basis.h"
#include "schemes/surface_vertex.h"
#include "tessellator/triangle.h"

#define VERTICES_KERNEL vertices_cubic_linear_triangle
#define VERTICES_DEGREE 3
#define VERTICES_NORMALS 1
#define VERTICES_NET CubicLinearNet
#define VERTEX_AT cubic_linear_vertex
#include "schemes/vertices_kernel.h"
