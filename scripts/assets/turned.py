"""Solids of revolution around the y axis: a chess pawn with hard edges, and a striped ball."""

from math import sqrt

from .glb import png
from .implicit import unit

SEGMENTS = 12
# Around the pawn from the centre of its foot to its top: runs of (radius, height); between runs lies a hard edge.
PAWN = [
    [(0.0, 0.0), (0.42, 0.0)],
    [(0.42, 0.0), (0.42, 0.14)],
    [(0.42, 0.14), (0.36, 0.20), (0.25, 0.34), (0.17, 0.52), (0.14, 0.72), (0.14, 0.84)],
    [(0.14, 0.84), (0.25, 0.86)],
    [(0.25, 0.86), (0.25, 0.91)],
    [(0.25, 0.91), (0.13, 0.95)],
    [(0.13, 0.95), (0.20, 1.02), (0.235, 1.14), (0.20, 1.26), (0.12, 1.35), (0.0, 1.38)],
]
PAWN_COLOUR = (0.10, 0.16, 0.24, 1.0)


def directions(count):
    """`count` unit vectors around a circle: 12, or a power of two from 4 on; made with square roots alone."""
    if count == 12:
        quarter = [(1.0, 0.0), (sqrt(3.0) / 2, 0.5), (0.5, sqrt(3.0) / 2)]
        return [p for s in ((1, 0, 0, 1), (0, -1, 1, 0), (-1, 0, 0, -1), (0, 1, -1, 0))
                for p in [(s[0] * c + s[1] * d, s[2] * c + s[3] * d) for c, d in quarter]]
    if count == 4:
        return [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)]
    half = directions(count // 2)
    result = []
    for a, b in zip(half, half[1:] + half[:1]):
        m = unit((a[0] + b[0], a[1] + b[1], 0.0))
        result += [a, m[:2]]
    return result


def profile_normals(run, smooth_end):
    """Normals (radial, up) of a run's points: outward, averaged where two pieces meet; at the axis straight up or
    down when `smooth_end`."""
    pieces = [unit((b[1] - a[1], a[0] - b[0], 0.0))[:2] for a, b in zip(run, run[1:])]
    normals = [pieces[0]]
    normals += [unit((a[0] + b[0], a[1] + b[1], 0.0))[:2] for a, b in zip(pieces, pieces[1:])]
    normals.append(pieces[-1])
    if smooth_end and run[-1][0] == 0.0:
        normals[-1] = (0.0, 1.0)
    return normals


def pawn():
    """Vertices (position, normal, uv) and triangles. Hard edges have two vertices at each position."""
    circle = directions(SEGMENTS)
    vertices, faces = [], []
    length = 0.0
    for run in PAWN:
        normals = profile_normals(run, len(run) > 2)
        rings = []
        for n, ((radius, height), (out, up)) in enumerate(zip(run, normals)):
            if n > 0:
                dx, dy = radius - run[n - 1][0], height - run[n - 1][1]
                length += sqrt(dx * dx + dy * dy)
            ring = []
            if radius == 0.0:
                ring = [len(vertices)] * (SEGMENTS + 1)
                vertices.append(((0.0, height, 0.0), (0.0, 1.0 if up > 0 else -1.0, 0.0), (0.5, length / 3.0)))
            else:
                for k in range(SEGMENTS + 1):  # the last column repeats the first with u = 1
                    c, s = circle[k % SEGMENTS]
                    ring.append(len(vertices))
                    vertices.append(((radius * s, height, radius * c), (out * s, up, out * c),
                                     (k / SEGMENTS, length / 3.0)))
            rings.append(ring)
        faces += strips(rings)
    return vertices, faces


def strips(rings):
    """Triangles between rings of vertex numbers, lower ring first; a ring of one number is a pole."""
    faces = []
    for low, high in zip(rings, rings[1:]):
        for k in range(len(low) - 1):
            if low[k] != low[k + 1]:
                faces.append((low[k], low[k + 1], high[k + 1]))
            if high[k] != high[k + 1]:
                faces.append((low[k], high[k + 1], high[k]))
    return faces


def ball():
    """A unit ball of 8 by 4 quads halved, with a texture seam: positions and normals are equal there, uvs are not."""
    columns = directions(8)
    rows = directions(8)  # from the south pole over the equator to the north pole: four steps
    profile = [(rows[k][1], -rows[k][0]) for k in range(5)]
    vertices, rings = [], []
    for n, (radius, height) in enumerate(profile):
        ring = []
        for k in range(9):
            c, s = columns[k % 8]
            pole = n in (0, 4)
            p = (0.0, height, 0.0) if pole else (radius * s, height, radius * c)
            ring.append(len(vertices))
            vertices.append((p, p, ((k + 0.5 * pole) / 8, 1.0 - n / 4)))
        rings.append(ring)
    faces = []
    for f in strips(rings):
        if len({vertices[v][0] for v in f}) == 3:
            faces.append(f)
    return vertices, faces


def ball_texture():
    """Red, cream and blue gores, and yellow caps."""
    colours = [(.86, .20, .18), (.97, .93, .85), (.16, .38, .66), (.97, .93, .85)]

    def pixel(i, j):
        if j < 10 or j >= 118:
            return (.97, .76, .22)
        return colours[i // 32 % 4]

    return png(256, 128, pixel)
