// Vertices of linear surfaces with linear normals on triangles.
#include "emission.h"
#include "schemes/basis.h"
#include "schemes/surface_vertex.h"
#include "tessellator/triangle.h"

#define VERTICES_KERNEL vertices_linear_linear_triangle
#define VERTICES_DEGREE 1
#define VERTICES_NORMALS 1
#define VERTICES_NET LinearLinearNet
#define VERTEX_AT linear_linear_vertex
#include "schemes/vertices_kernel.h"
