"""Half meshes of symmetric implicit surfaces: marching tetrahedra, simplification, mirroring.

A half mesh lies at x >= 0; its border runs at x = 0 exactly, where the mirrored half is joined.
"""

import heapq
from math import sqrt

CORNERS = [(i & 1, i >> 1 & 1, i >> 2) for i in range(8)]
# The six tetrahedra around the diagonal 0-7 of a cube; all cubes are cut alike, so their faces match.
TETRAHEDRA = [(0, 1, 3, 7), (0, 3, 2, 7), (0, 2, 6, 7), (0, 6, 4, 7), (0, 4, 5, 7), (0, 5, 1, 7)]


def sub(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def area_normal(a, b, c):
    return cross(sub(b, a), sub(c, a))


def march(body, low, high, step):
    """Vertices and triangles of the half x >= 0 of `body` within the box; low[0] must be 0."""
    counts = [int((high[i] - low[i]) / step) + 1 for i in range(3)]
    at = [[low[i] + step * j for j in range(counts[i] + 1)] for i in range(3)]
    value = {}
    for i, x in enumerate(at[0]):
        for j, y in enumerate(at[1]):
            for k, z in enumerate(at[2]):
                value[i, j, k] = body.value(x, y, z)
    vertices, faces, numbers = [], [], {}

    def crossing(a, b):
        key = (a, b) if a < b else (b, a)
        if key not in numbers:
            a, b = key
            t = value[a] / (value[a] - value[b])
            p = [at[n][a[n]] + t * (at[n][b[n]] - at[n][a[n]]) for n in range(3)]
            numbers[key] = len(vertices)
            vertices.append(body.project(tuple(p)))
        return numbers[key]

    for i in range(counts[0]):
        for j in range(counts[1]):
            for k in range(counts[2]):
                cube = [(i + x, j + y, k + z) for x, y, z in CORNERS]
                signs = [value[c] < 0.0 for c in cube]
                if all(signs) or not any(signs):
                    continue
                for tetrahedron in TETRAHEDRA:
                    inside = [cube[n] for n in tetrahedron if signs[n]]
                    outside = [cube[n] for n in tetrahedron if not signs[n]]
                    if len(inside) == 1:
                        new = [[crossing(inside[0], o) for o in outside]]
                    elif len(inside) == 3:
                        new = [[crossing(n, outside[0]) for n in inside]]
                    elif len(inside) == 2:
                        a, b, c, d = (crossing(n, o) for n in inside for o in outside)
                        new = [[a, b, d], [a, d, c]]
                    else:
                        continue
                    out = sub(average(at, outside), average(at, inside))
                    turn = dot(area_normal(*(grid_crossing(at, value, inside, outside))), out) < 0.0
                    for face in new:
                        faces.append(tuple(reversed(face)) if turn else tuple(face))
    return vertices, faces


def average(at, points):
    return tuple(sum(at[n][p[n]] for p in points) / len(points) for n in range(3))


def grid_crossing(at, value, inside, outside):
    """Middles of three crossed edges, in the order march() uses them: they give the side, whatever the rounding."""
    pairs = [(n, o) for n in inside for o in outside][:3] if len(inside) != 2 else \
        [(inside[0], outside[0]), (inside[0], outside[1]), (inside[1], outside[1])]
    return [average(at, pair) for pair in pairs]


class HalfMesh:
    """A half mesh that is simplified on its surface."""

    def __init__(self, body, vertices, faces, weight):
        self.body = body
        self.position = list(vertices)
        self.weight = weight  # how much finer than elsewhere, by position
        self.faces = {n: f for n, f in enumerate(faces)}
        self.normals = {}  # by position: asked for again and again
        self.around = [set() for _ in vertices]
        for n, face in self.faces.items():
            for v in face:
                self.around[v].add(n)

    def neighbours(self, v):
        return {w for n in self.around[v] for w in self.faces[n]} - {v}

    def on_border(self, v):
        return self.position[v][0] == 0.0

    def faces_with(self, u, v):
        return self.around[u] & self.around[v]

    def quadric(self, v):
        """Sum of squared distances to the planes around v, weighted by area; at the border, of both halves."""
        q = [0.0] * 10
        for n in self.around[v]:
            a, b, c = (self.position[w] for w in self.faces[n])
            m = area_normal(a, b, c)
            length = sqrt(dot(m, m))
            if length < 1e-14:
                continue
            for side in (1.0, -1.0) if self.on_border(v) else (1.0,):
                x, y, z = side * m[0] / length, m[1] / length, m[2] / length
                d = -dot(m, a) / length
                plane = (x * x, x * y, x * z, x * d, y * y, y * z, y * d, z * z, z * d, d * d)
                q = [s + length * t for s, t in zip(q, plane)]
        return q

    def simplify(self, triangles):
        """Collapses edges, the least visible first, until at most `triangles` are left or no edge may go."""
        self.quadrics = [self.quadric(v) for v in range(len(self.position))]
        self.version = [0] * len(self.position)
        heap = []
        for u in range(len(self.position)):
            for v in self.neighbours(u):
                if u < v:
                    self.push(heap, u, v)
        heapq.heapify(heap)
        while heap and len(self.faces) > triangles:
            _, u, v, p, version = heapq.heappop(heap)
            if version == (self.version[u], self.version[v]) and self.collapse(u, v, p):
                for w in sorted(self.neighbours(u)):
                    self.push(heap, min(u, w), max(u, w), heapq.heappush)

    def push(self, heap, u, v, push=list.append):
        a, b = self.position[u], self.position[v]
        middle = tuple((s + t) / 2 for s, t in zip(a, b))
        if self.on_border(u) != self.on_border(v):
            candidates = [a if self.on_border(u) else b]
        else:
            candidates = [self.body.project(middle), a, b]
        q = [s + t for s, t in zip(self.quadrics[u], self.quadrics[v])]
        edge = sub(a, b)
        scale = self.weight(middle)
        best = min((quadric_error(q, p), n) for n, p in enumerate(candidates))
        cost = (best[0] + 0.0004 * dot(edge, edge) * dot(edge, edge)) * scale
        push(heap, (cost, u, v, candidates[best[1]], (self.version[u], self.version[v])))

    def collapse(self, u, v, p):
        """Moves u to p and merges v into it, if the surface stays a surface and no triangle turns over."""
        shared = self.faces_with(u, v)
        if not shared or len(self.neighbours(u) & self.neighbours(v)) != len(shared):
            return False
        if self.on_border(u) and self.on_border(v) and len(shared) != 1:
            return False
        if len(self.neighbours(u) | self.neighbours(v)) > 11:
            return False
        for w in (u, v):
            for n in self.around[w] - shared:
                old = [self.position[x] for x in self.faces[n]]
                new = [p if x == w else self.position[x] for x in self.faces[n]]
                if not similar(area_normal(*old), area_normal(*new)) or \
                        quality(*new) < min(0.15, quality(*old)) or not self.fits(*new):
                    return False
        for n in shared:
            for w in self.faces[n]:
                self.around[w].discard(n)
            del self.faces[n]
        for n in sorted(self.around[v]):
            self.faces[n] = tuple(u if w == v else w for w in self.faces[n])
            self.around[u].add(n)
        self.around[v] = set()
        self.position[u] = p
        self.quadrics[u] = [s + t for s, t in zip(self.quadrics[u], self.quadrics[v])]
        self.version[u] += 1
        self.version[v] += 1
        return True

    def fits(self, a, b, c):
        """Whether a triangle lies along the surface: roughly at its middle, and on the right side at its corners."""
        m = area_normal(a, b, c)
        length = sqrt(dot(m, m))
        middle = tuple((s + t + r) / 3 for s, t, r in zip(a, b, c))
        return dot(m, self.body.normal(middle)) >= 0.6 * length and all(
            dot(m, self.corner_normal(p)) >= 0.1 * length for p in (a, b, c))

    def corner_normal(self, p):
        if p not in self.normals:
            self.normals[p] = self.body.normal(p)
        return self.normals[p]

    def depth(self, a, b):
        """How far the middle of an edge is from the surface."""
        return abs(self.body.value(*((s + t) / 2 for s, t in zip(a, b))))

    def flip_edges(self):
        """Exchanges diagonals where that makes the smallest angles larger without folding the surface."""
        edges = sorted({(min(u, v), max(u, v)) for f in self.faces.values() for u, v in zip(f, f[1:] + f[:1])})
        for u, v in edges:
            shared = sorted(self.faces_with(u, v))
            if len(shared) != 2:
                continue
            one, two = (self.faces[n] for n in shared)
            if (u, v) not in zip(one, one[1:] + one[:1]):
                one, two = two, one
            c = next(w for w in one if w not in (u, v))
            d = next(w for w in two if w not in (u, v))
            if c == d or d in self.neighbours(c) or len(self.around[u]) < 4 or len(self.around[v]) < 4:
                continue
            a, b, p, q = (self.position[w] for w in (u, v, c, d))
            before = min(quality(a, b, p), quality(b, a, q))
            after = min(quality(p, q, b), quality(q, p, a))
            if after > 1.1 * before and self.fits(q, b, p) and self.fits(p, a, q) and \
                    self.depth(p, q) < self.depth(a, b) + 0.03 * sqrt(dot(sub(p, q), sub(p, q))):
                for f in shared:
                    for w in self.faces[f]:
                        self.around[w].discard(f)
                for f, face in zip(shared, ((d, v, c), (c, u, d))):
                    self.faces[f] = face
                    for w in face:
                        self.around[w].add(f)

    def relax(self, amount):
        """Moves every vertex towards the middle of its neighbours, along the surface."""
        for v in range(len(self.position)):
            near = sorted(self.neighbours(v))
            if self.on_border(v):
                near = [w for w in near if self.on_border(w) and len(self.faces_with(v, w)) == 1]
            if not near:
                continue
            p = self.position[v]
            middle = [sum(self.position[w][n] for w in near) / len(near) for n in range(3)]
            move = tuple(amount * (middle[n] - p[n]) for n in range(3))
            normal = self.body.normal(p)
            along = dot(move, normal)
            q = self.body.project(tuple(p[n] + move[n] - along * normal[n] for n in range(3)))
            faces = [self.faces[n] for n in self.around[v]]
            new = [[q if w == v else self.position[w] for w in f] for f in faces]
            old = [[self.position[w] for w in f] for f in faces]
            if all(similar(area_normal(*o), area_normal(*n)) and (self.fits(*n) or not self.fits(*o))
                   for o, n in zip(old, new)):
                self.position[v] = q

    def whole(self):
        """Vertices and triangles of both halves."""
        used = sorted({v for f in self.faces.values() for v in f})
        vertices = [self.position[v] for v in used]
        left, right = {v: n for n, v in enumerate(used)}, {}
        for v in used:
            right[v] = left[v]
            if not self.on_border(v):
                right[v] = len(vertices)
                x, y, z = self.position[v]
                vertices.append((-x, y, z))
        faces = [tuple(left[v] for v in f) for f in self.faces.values()]
        return vertices, faces + [tuple(right[v] for v in reversed(f)) for f in self.faces.values()]


def quadric_error(q, p):
    x, y, z = p
    return (q[0] * x * x + q[4] * y * y + q[7] * z * z + q[9] +
            2 * (q[1] * x * y + q[2] * x * z + q[3] * x + q[5] * y * z + q[6] * y + q[8] * z))


def similar(m, n):
    """Whether a triangle of area normal m may become one of n: not where it turns over, and flat ones always may."""
    return dot(m, m) < 1e-12 or dot(m, n) > 0.3 * sqrt(dot(m, m) * dot(n, n))


def quality(a, b, c):
    """1 for an equilateral triangle, 0 for a flat one."""
    m = area_normal(a, b, c)
    sides = sum(dot(s, s) for s in (sub(a, b), sub(b, c), sub(c, a)))
    return 2 * sqrt(3.0) * sqrt(dot(m, m)) / max(sides, 1e-30)


def coarse_mesh(body, low, high, step, triangles, weight):
    """A closed symmetric mesh of about `triangles` triangles on `body`."""
    vertices, faces = march(body, low, high, step)
    half = HalfMesh(body, vertices, faces, weight)
    before = 0
    while len(half.faces) > triangles // 2 and len(half.faces) != before:
        before = len(half.faces)
        # In small steps: better shaped triangles free edges that could not go, before others that should stay go.
        half.simplify(max(triangles // 2, before * 3 // 4))
        half.flip_edges()
        half.relax(0.3)
    for _ in range(5):
        half.flip_edges()
        half.relax(0.2)
    half.flip_edges()
    return half.whole()
