"""A furry creature, about 2.6 units high, looking along +z: a ball with guide curves of hair, two eyes and two feet."""

from .glb import png
from .implicit import unit
from .turned import directions, strips

GUIDES = 440
POINTS = 6  # of a guide
RADIUS = 0.85
WIDTH = 0.013
SKIN = (0.10, 0.05, 0.03, 1.0)
EYE = (0.92, 0.91, 0.86, 1.0)
PUPIL = (0.012, 0.012, 0.016, 1.0)
FOOT = (0.83, 0.31, 0.06, 1.0)
FACE = unit((0.0, 0.16, 1.0))
GOLDEN = (-0.7373688780783197, 0.6754902942615238)  # cosine and sine of the golden angle


def add(a, b, scale=1.0):
    return tuple(x + scale * y for x, y in zip(a, b))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def spread(count):
    """Unit vectors spread evenly over the sphere: a spiral by the golden angle (Vogel; Saff and Kuijlaars)."""
    c, s = 1.0, 0.0
    points = []
    for i in range(count):
        y = 1.0 - (2 * i + 1) / count
        points.append(unit((c * (1.0 - y * y) ** 0.5, y, s * (1.0 - y * y) ** 0.5)))
        c, s = unit((c * GOLDEN[0] - s * GOLDEN[1], c * GOLDEN[1] + s * GOLDEN[0], 0.0))[:2]
    return points


class Noise:
    """Numbers in [-1, 1), the same every time."""

    def __init__(self, seed):
        self.state = seed

    def __call__(self):
        self.state = (self.state * 1664525 + 1013904223) % 2**32
        return self.state / 2**31 - 1.0


def guide(normal, noise):
    """The points of one guide from its root outward: it leaves the skin, is combed away from the face and falls."""
    facing = dot(normal, FACE)
    front = min(1.0, max(0.0, (facing - 0.55) / 0.4))  # 1 amid the face, 0 behind the cheeks
    crown = max(0.0, dot(normal, (0.0, 1.0, 0.0))) ** 6
    below = max(0.0, -normal[1]) ** 2
    length = (0.48 + 0.08 * noise()) * (1.0 - 0.66 * front) * (1.0 - 0.6 * below) + 0.36 * crown
    away = unit(add(normal, FACE, -facing)) if facing < 0.999 else (0.0, 1.0, 0.0)
    direction = unit(add(normal, away, 0.25 + 0.5 * front))
    curl = (0.22 * noise(), 0.10 * noise(), 0.22 * noise())
    point = tuple(RADIUS * 0.97 * c for c in normal)
    points = [point]
    for k in range(POINTS - 1):
        point = add(point, direction, length / (POINTS - 1))
        points.append(point)
        fall = (0.0, -0.30 * (1.0 - 0.75 * crown) * (1.0 - 0.6 * front), 0.0)
        direction = unit(add(add(direction, fall), curl, 0.5 + 0.5 * crown))
        # Hair lies on the skin rather than in it.
        inward = dot(direction, unit(point))
        if inward < 0.12:
            direction = unit(add(direction, unit(point), 0.12 - inward))
    return points


def guides():
    """Points and normals, POINTS per guide. The normals are those of the skin at the root: hair is shaded like it."""
    noise = Noise(7)
    positions, normals = [], []
    for normal in spread(GUIDES):
        positions += guide(normal, noise)
        normals += [normal] * POINTS
    return positions, normals


def ball(centre, radii, meridians=8):
    """A closed ball: vertices (position, normal) and triangles."""
    columns = directions(meridians)
    rows = directions(8)
    profile = [(rows[k][1], -rows[k][0]) for k in range(5)]
    vertices, rings = [], []
    for radius, height in profile:
        pole = radius < 1e-9
        ring = []
        for k in range(1 if pole else meridians):
            c, s = columns[k]
            n = (0.0, height, 0.0) if pole else (radius * s, height, radius * c)
            ring.append(len(vertices))
            vertices.append((tuple(m + r * x for m, r, x in zip(centre, radii, n)),
                             unit(tuple(x / r for x, r in zip(n, radii)))))
        rings.append(ring * (meridians + 1) if pole else ring + ring[:1])
    return vertices, strips(rings)


def parts():
    """The balls: (name, vertices, triangles, colour)."""
    result = [("skin", *ball((0.0, 0.0, 0.0), (RADIUS, RADIUS, RADIUS)), SKIN)]
    for side, name in ((-1.0, "right"), (1.0, "left")):
        result.append((f"{name} eye", *ball((0.27 * side, 0.28, 0.80), (0.20, 0.23, 0.20)), EYE))
        result.append((f"{name} pupil", *ball((0.245 * side, 0.29, 0.935), (0.085, 0.105, 0.085)), PUPIL))
        result.append((f"{name} foot", *ball((0.38 * side, -1.06, 0.42), (0.26, 0.12, 0.40)), FOOT))
    return result


def hair_texture():
    """Colour along a hair: dark at the root, light at the tip; across, nothing changes."""
    stops = [(.20, .07, .05), (.55, .20, .07), (.88, .46, .14), (.99, .80, .50)]

    def pixel(_, row):
        t = 3.0 * row / 63
        k = min(2, int(t))
        return tuple(a + (t - k) * (b - a) for a, b in zip(stops[k], stops[k + 1]))

    return png(4, 64, pixel)
