// Vertices of linear surfaces with quadratic normals on quads.
#include "emission.h"
#include "schemes/quad_basis.h"
#include "schemes/surface_vertex.h"
#include "tessellator/quad.h"

#define VERTICES_KERNEL vertices_linear_quadratic_quad
#define VERTICES_DEGREE 1
#define VERTICES_NORMALS 2
#include "schemes/vertices_quad_kernel.h"
