// The flat scheme: the triangle itself, degree 1.
#ifndef TESSERA_SCHEMES_LINEAR_H
#define TESSERA_SCHEMES_LINEAR_H

#include "schemes/corners.h"

KERNELS_BEGIN

STRUCT(LinearNet) {
    Vector c0;
    Vector c1;
    Vector c2;
};

FUNCTION LinearNet linear_net(Corners corners) {
    LinearNet net;
    net.c0 = corners.p0;
    net.c1 = corners.p1;
    net.c2 = corners.p2;
    return net;
}

KERNELS_END

#endif
