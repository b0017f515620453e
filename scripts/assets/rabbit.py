"""A sitting rabbit, looking along +z, about 1.8 units high."""

from .glb import png
from .implicit import Body, capsule, ellipsoid, mirrored

BOX = ((0.0, -0.12, -1.04), (0.68, 2.2, 0.95))
SIZE = 256
# The texture is a side view: u runs from the tail to the nose, v downwards, for both sides alike.
LEFT, TOP, SPAN = -1.3, 2.2, 2.4


def body():
    rabbit = Body()
    rabbit.add(ellipsoid((0.0, 0.42, -0.25), (0.38, 0.42, 0.46), up=(0.0, 1.0, 0.25)), 0.1)  # back
    rabbit.add(ellipsoid((0.0, 0.58, 0.14), (0.28, 0.40, 0.27), up=(0.0, 1.0, 0.3)), 0.2)  # chest
    rabbit.add(mirrored(ellipsoid, (0.29, 0.31, -0.20), (0.16, 0.29, 0.32)), 0.1)  # thighs
    rabbit.add(ellipsoid((0.0, 1.07, 0.34), (0.25, 0.25, 0.29)), 0.14)  # head
    rabbit.add(mirrored(ellipsoid, (0.10, 0.98, 0.47), (0.13, 0.12, 0.14)), 0.1)  # cheeks
    rabbit.add(ellipsoid((0.0, 1.03, 0.56), (0.12, 0.105, 0.17)), 0.08)  # nose
    rabbit.add(mirrored(ellipsoid, (0.18, 1.62, 0.17), (0.135, 0.46, 0.105),
                        up=(0.26, 1.0, -0.25), front=(0.35, 0.2, 1.0)), 0.08)  # ears
    rabbit.add(mirrored(capsule, (0.15, 0.55, 0.26), (0.14, 0.10, 0.38), 0.11, 0.07), 0.07)  # forelegs
    rabbit.add(mirrored(ellipsoid, (0.145, 0.06, 0.43), (0.10, 0.085, 0.16)), 0.05)  # forepaws
    rabbit.add(mirrored(capsule, (0.33, 0.08, -0.30), (0.36, 0.07, 0.20), 0.11, 0.10), 0.05)  # hind feet
    rabbit.add(ellipsoid((0.0, 0.36, -0.75), (0.17, 0.17, 0.16)), 0.06)  # tail
    return rabbit


def weight(p):
    """How fine the mesh is: head, ears and paws have small features; the nose has the smallest."""
    if p[2] > 0.62 and p[1] > 0.9:
        return 60.0
    return 20.0 if p[1] > 1.3 else 3.0 if p[1] > 0.85 else 10.0 if p[1] < 0.2 else 2.0 if p[2] > 0.2 else 1.0


def uv(p):
    return ((p[2] - LEFT) / SPAN, (TOP - p[1]) / SPAN)


def mix(a, b, t):
    t = min(1.0, max(0.0, t))
    return tuple(x + (y - x) * t for x, y in zip(a, b))


def spot(z, y, centre, radii, softness):
    """1 inside an ellipse of the side view, 0 outside."""
    a, b = (z - centre[0]) / radii[0], (y - centre[1]) / radii[1]
    return min(1.0, max(0.0, (1.0 - a * a - b * b) / softness))


def colour(z, y):
    brown, dark, cream = (.62, .45, .31), (.47, .33, .23), (.95, .90, .82)
    pink, black = (.93, .66, .62), (.06, .05, .06)
    c = mix(brown, dark, spot(z, y, (-0.45, 0.85), (0.55, 0.45), 1.2) * 0.5)
    c = mix(c, cream, spot(z, y, (0.52, 0.42), (0.30, 0.45), 0.6))  # bib
    c = mix(c, cream, spot(z, y, (0.62, 0.93), (0.24, 0.13), 0.5))  # muzzle
    c = mix(c, cream, spot(z, y, (-0.82, 0.36), (0.19, 0.20), 0.4))  # tail
    c = mix(c, cream, (0.13 - y) / 0.08)  # feet
    if y > 1.3:
        axis = 0.17 - 0.25 * (y - 1.62)
        inner = min(1.0, max(0.0, (z - axis - 0.035) / 0.025)) * min(1.0, max(0.0, (1.98 - y) / 0.1))
        c = mix(c, pink, inner * min(1.0, (y - 1.3) / 0.08))
    c = mix(c, cream, spot(z, y, (0.47, 1.13), (0.085, 0.085), 0.5))  # around the eye
    c = mix(c, black, spot(z, y, (0.475, 1.13), (0.055, 0.06), 0.25))
    c = mix(c, (1.0, 1.0, 1.0), spot(z, y, (0.49, 1.152), (0.016, 0.016), 0.5))
    return mix(c, pink, spot(z, y, (0.75, 1.075), (0.11, 0.055), 0.3))


def texture():
    return png(SIZE, SIZE, lambda i, j: colour(LEFT + SPAN * (i + 0.5) / SIZE, TOP - SPAN * (j + 0.5) / SIZE))
