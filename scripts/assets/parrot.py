"""A parrot on a perch, about 1.9 units high, looking along +z. Its colours are those of its vertices."""

from math import sqrt

from .implicit import Body, capsule, ellipsoid, mirrored

BOX = ((0.0, -0.65, -0.95), (0.78, 1.70, 0.70))
EYE = (0.190, 1.38, 0.25)
FACE = (0.200, 1.34, 0.27)
WING = (0.275, 0.74, -0.09)
WING_UP = (-0.10, 1.0, 0.38)
SHARPNESS = 0.012  # of a part's paint where the next part begins: a distance


def mix(a, b, t):
    t = min(1.0, max(0.0, t))
    t = t * t * (3.0 - 2.0 * t)
    return tuple(s + t * (r - s) for s, r in zip(a, b))


def ramp(stops, t):
    """The colour at `t` between stops (place, colour) in rising order."""
    for (low, a), (high, b) in zip(stops, stops[1:]):
        if t < high:
            return mix(a, b, (t - low) / (high - low))
    return stops[-1][1]


def distance(p, q):
    return sqrt(sum((a - b) * (a - b) for a, b in zip(p, q)))


def parts():
    """(shapes, width of the fillet to the parts before, paint): a paint gives a point's colour, red to blue in [0, 1]
    as screens have them."""
    red, dark_red, orange = (0.90, 0.10, 0.09), (0.62, 0.04, 0.10), (0.98, 0.46, 0.12)
    yellow, green, blue, navy = (1.0, 0.82, 0.13), (0.13, 0.62, 0.32), (0.10, 0.36, 0.82), (0.10, 0.14, 0.46)
    white, ivory, slate = (0.98, 0.95, 0.90), (0.97, 0.90, 0.74), (0.16, 0.15, 0.17)
    bark, wood, grey = (0.38, 0.24, 0.14), (0.86, 0.70, 0.46), (0.50, 0.47, 0.47)

    def body(p):
        return mix(mix(dark_red, red, (p[1] - 0.2) / 0.5), orange, 2.2 * p[2] - 0.5 * abs(p[0]) - 0.15)

    def head(p):
        left = (abs(p[0]), p[1], p[2])
        bare = mix(slate, white, (distance(left, EYE) - 0.063) / 0.015)  # all of the eye's vertices are dark
        return mix(bare, red, (distance(left, FACE) - 0.115) / 0.06)

    def wing(p):
        along = p[1] - WING[1] + 0.38 * (p[2] - WING[2])
        return ramp([(-0.62, navy), (-0.34, blue), (-0.10, green), (0.10, yellow), (0.26, orange), (0.40, red)], along)

    def tail(p):
        return ramp([(-0.60, navy), (-0.36, blue), (-0.10, orange), (0.15, red)], p[1])

    def beak(p):
        return mix(slate, ivory, (p[1] - 1.13) / 0.13)

    def perch(p):
        return mix(bark, wood, (abs(p[0]) - 0.60) / 0.05)

    return [
        ([ellipsoid((0.0, 0.76, 0.0), (0.29, 0.48, 0.27), up=(0.0, 1.0, 0.22))], 0.1, body),
        ([ellipsoid((0.0, 1.32, 0.13), (0.235, 0.235, 0.25))], 0.16, head),
        ([capsule((0.0, 0.42, -0.16), (0.0, -0.44, -0.60), 0.14, 0.075)], 0.10, tail),
        (mirrored(ellipsoid, WING, (0.085, 0.53, 0.19), up=WING_UP), 0.035, wing),
        ([ellipsoid((0.0, 0.33, 0.08), (0.17, 0.13, 0.11))], 0.06, body),  # closes the gap between the feet
        ([capsule((-0.62, 0.22, 0.10), (0.62, 0.22, 0.10), 0.085, 0.085)], 0.03, perch),
        (mirrored(ellipsoid, (0.13, 0.29, 0.14), (0.075, 0.065, 0.11)), 0.03, lambda p: grey),
        ([capsule((0.0, 1.35, 0.34), (0.0, 1.23, 0.50), 0.100, 0.062)], 0.03, beak),
        ([capsule((0.0, 1.23, 0.50), (0.0, 1.11, 0.49), 0.062, 0.028)], 0.03, beak),
        (mirrored(ellipsoid, EYE, (0.045, 0.058, 0.058)), 0.012, lambda p: slate),
    ]


def body():
    parrot = Body()
    for shapes, blend, _ in parts():
        parrot.add(shapes, blend)
    return parrot


def weight(p):
    """Face, beak and the ends of the perch are finer than the rest; wings and feet a little."""
    if distance(p, FACE) < 0.24:
        return 60.0 if distance(p, EYE) < 0.11 else 30.0
    if p[1] > 1.0 and p[2] > 0.36:
        return 12.0
    if p[0] > 0.56:
        return 8.0
    return 2.0 if p[1] > 1.1 or p[1] < 0.38 or p[0] > 0.22 else 1.0


def painter():
    """A function from a point of the surface to its linear colour. A part's paint is mixed with those of the parts
    nearby."""
    paints = parts()

    def colour(p):
        total, sums = 0.0, [0.0, 0.0, 0.0]
        for shapes, _, paint in paints:
            near = SHARPNESS / (SHARPNESS + max(0.0, min(shape(*p) for shape in shapes)))
            share = near * near * near * near
            total += share
            sums = [s + share * c for s, c in zip(sums, paint(p))]
        return tuple((s / total) * (s / total) for s in sums)  # the square is near the curve of screens

    return colour
