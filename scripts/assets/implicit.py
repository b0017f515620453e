"""Implicit surfaces: smooth unions of ellipsoids and tapered capsules. Negative inside, roughly a distance.

Only + - * / and square roots are used, which round alike everywhere, so the models come out the same on any machine.
"""

from math import sqrt


def unit(v):
    length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2])
    return (v[0] / length, v[1] / length, v[2] / length)


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def ellipsoid(centre, radii, up=(0.0, 1.0, 0.0), front=(0.0, 0.0, 1.0)):
    """An ellipsoid with its radii along its own side, up and front directions; `front` is made orthogonal to `up`."""
    y = unit(up)
    x = unit(cross(y, front))
    z = cross(x, y)
    cx, cy, cz = centre
    (xx, xy, xz), (yx, yy, yz), (zx, zy, zz) = x, y, z
    rx, ry, rz = radii

    def distance(px, py, pz):
        dx, dy, dz = px - cx, py - cy, pz - cz
        a = (dx * xx + dy * xy + dz * xz) / rx
        b = (dx * yx + dy * yy + dz * yz) / ry
        c = (dx * zx + dy * zy + dz * zz) / rz
        k = sqrt(a * a + b * b + c * c)
        if k < 1e-9:
            return -min(radii)
        a, b, c = a / rx, b / ry, c / rz
        return k * (k - 1.0) / sqrt(a * a + b * b + c * c)

    return distance


def capsule(start, end, start_radius, end_radius):
    """A thick line from `start` to `end` whose radius changes evenly."""
    sx, sy, sz = start
    ex, ey, ez = end[0] - sx, end[1] - sy, end[2] - sz
    squared = ex * ex + ey * ey + ez * ez

    def distance(px, py, pz):
        dx, dy, dz = px - sx, py - sy, pz - sz
        t = (dx * ex + dy * ey + dz * ez) / squared
        t = 0.0 if t < 0.0 else 1.0 if t > 1.0 else t
        dx, dy, dz = dx - t * ex, dy - t * ey, dz - t * ez
        return sqrt(dx * dx + dy * dy + dz * dz) - (start_radius + t * (end_radius - start_radius))

    return distance


def mirrored(shape, *points, **directions):
    """The shape with these arguments, and its mirror image at x = 0."""

    def flip(p):
        return (-p[0], p[1], p[2])

    if shape is ellipsoid:
        image = (flip(points[0]),) + points[1:]
    else:
        image = (flip(points[0]), flip(points[1])) + points[2:]
    return [shape(*points, **directions), shape(*image, **{k: flip(v) for k, v in directions.items()})]


class Body:
    """A smooth union of parts: each part is (distance function, blend), where blend is the width of the fillet between
    the part and all parts before it."""

    def __init__(self):
        self.parts = []

    def add(self, shapes, blend):
        self.parts += [(shape, blend) for shape in (shapes if isinstance(shapes, list) else [shapes])]

    def value(self, x, y, z):
        total = 1e9
        for distance, blend in self.parts:
            d = distance(x, y, z)
            h = blend - abs(total - d)
            total = min(total, d)
            if h > 0.0:
                total -= h * h / (4.0 * blend)
        return total

    def gradient(self, p):
        x, y, z = p
        e = 1e-4
        f = self.value
        gx = 0.0 if x == 0.0 else f(x + e, y, z) - f(x - e, y, z)  # the bodies are symmetric
        return (gx / (2 * e), (f(x, y + e, z) - f(x, y - e, z)) / (2 * e), (f(x, y, z + e) - f(x, y, z - e)) / (2 * e))

    def normal(self, p):
        return unit(self.gradient(p))

    def project(self, p):
        """The surface point reached from `p` along the gradient; x = 0 is kept."""
        for _ in range(8):
            d = self.value(*p)
            if abs(d) < 1e-7:
                break
            g = self.gradient(p)
            s = d / max(0.25, g[0] * g[0] + g[1] * g[1] + g[2] * g[2])
            p = (p[0] - s * g[0], p[1] - s * g[1], p[2] - s * g[2])
        return p
