"""Writes small .glb files and the PNG images in them."""

import json
import struct
import zlib


def png(width, height, pixel):
    """An RGB image; pixel(column, row) gives three numbers in [0, 1], row 0 on top."""
    rows = bytearray()
    for row in range(height):
        rows.append(0)
        for column in range(width):
            rows += bytes(int(255 * min(1.0, max(0.0, c)) + 0.5) for c in pixel(column, row))

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(bytes(rows), 9)) +
            chunk(b"IEND", b""))


def single(values):
    """The numbers as 32-bit floats hold them."""
    return struct.unpack("<%df" % len(values), struct.pack("<%df" % len(values), *values))


def only_used(vertices, faces):
    """The vertices that faces use, in their order, and the faces in terms of them."""
    used = sorted({v for face in faces for v in face})
    place = {v: i for i, v in enumerate(used)}
    return [vertices[v] for v in used], [tuple(place[v] for v in face) for face in faces]


def write_glb(path, name, vertices, faces, image=None, colour=(1.0, 1.0, 1.0, 1.0)):
    """One mesh of one primitive; each vertex is (position, unit normal, uv), and all may have a fourth: a linear colour.
    Those that no face uses are left out."""
    vertices, faces = only_used(vertices, faces)
    assert len(vertices) < 65536
    flat = [single(tuple(p) + tuple(n) + tuple(t)) for p, n, t, *_ in vertices]
    data = b"".join(struct.pack("<8f", *v) for v in flat)
    views = [{"buffer": 0, "byteLength": len(data), "byteStride": 32, "target": 34962}]

    def view(more, **properties):
        nonlocal data
        views.append({"buffer": 0, "byteOffset": len(data), "byteLength": len(more), **properties})
        data += more + b"\0" * (-len(more) % 4)
        return len(views) - 1

    view(b"".join(struct.pack("<3H", *f) for f in faces), target=34963)
    attributes = [("POSITION", "VEC3", 0), ("NORMAL", "VEC3", 12), ("TEXCOORD_0", "VEC2", 24)]
    accessors = [{"bufferView": 0, "byteOffset": offset, "componentType": 5126, "count": len(vertices), "type": kind}
                 for _, kind, offset in attributes]
    accessors[0]["min"] = [min(v[i] for v in flat) for i in range(3)]
    accessors[0]["max"] = [max(v[i] for v in flat) for i in range(3)]
    accessors.append({"bufferView": 1, "componentType": 5123, "count": 3 * len(faces), "type": "SCALAR"})
    surface = {"baseColorFactor": colour, "metallicFactor": 0.0, "roughnessFactor": 0.7}
    primitive = {"attributes": {a[0]: i for i, a in enumerate(attributes)}, "indices": 3, "material": 0}
    if len(vertices[0]) > 3:
        colours = b"".join(struct.pack("<4H", *(int(65535 * c + 0.5) for c in v[3]), 65535) for v in vertices)
        primitive["attributes"]["COLOR_0"] = len(accessors)
        accessors.append({"bufferView": view(colours, target=34962), "componentType": 5123, "normalized": True,
                          "count": len(vertices), "type": "VEC4"})
    document = {
        "asset": {"version": "2.0", "generator": "Tessera make_assets.py", "copyright": "the Tessera authors, MIT"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"name": name, "mesh": 0}],
        "meshes": [{"name": name, "primitives": [primitive]}],
        "materials": [{"name": name, "pbrMetallicRoughness": surface}],
        "accessors": accessors,
        "bufferViews": views,
    }
    if image is not None:
        surface["baseColorTexture"] = {"index": 0}
        document["textures"] = [{"source": 0}]
        document["images"] = [{"name": name, "mimeType": "image/png", "bufferView": view(image)}]
    document["buffers"] = [{"byteLength": len(data)}]
    write_container(path, document, data)


def write_container(path, document, data):
    """A .glb of a JSON document and its buffer."""
    text = json.dumps(document, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    with open(path, "wb") as file:
        file.write(struct.pack("<III", 0x46546C67, 2, 28 + len(text) + len(data)))
        file.write(struct.pack("<II", len(text), 0x4E4F534A) + text)
        file.write(struct.pack("<II", len(data), 0x004E4942) + data)


class Model:
    """A model of several primitives in one mesh, some of them line strips: add parts, then write."""

    def __init__(self, name):
        self.name = name
        self.data = b""
        self.views, self.accessors, self.materials, self.images, self.primitives = [], [], [], [], []

    def view(self, data, **properties):
        self.views.append({"buffer": 0, "byteOffset": len(self.data), "byteLength": len(data), **properties})
        self.data += data + b"\0" * (-len(data) % 4)
        return len(self.views) - 1

    def accessor(self, view, component, count, kind, **properties):
        self.accessors.append({"bufferView": view, "componentType": component, "count": count, "type": kind,
                               **properties})
        return len(self.accessors) - 1

    def vectors(self, values, bounds=False):
        flat = [single(v) for v in values]
        view = self.view(b"".join(struct.pack("<3f", *v) for v in flat), target=34962)
        limits = {"min": [min(v[i] for v in flat) for i in range(3)],
                  "max": [max(v[i] for v in flat) for i in range(3)]} if bounds else {}
        return self.accessor(view, 5126, len(flat), "VEC3", **limits)

    def material(self, name, colour=(1.0, 1.0, 1.0, 1.0), image=None, **properties):
        surface = {"baseColorFactor": colour, "metallicFactor": 0.0, "roughnessFactor": 0.7}
        if image is not None:
            self.images.append({"name": name, "mimeType": "image/png", "bufferView": self.view(image)})
            surface["baseColorTexture"] = {"index": len(self.images) - 1}
        self.materials.append({"name": name, "pbrMetallicRoughness": surface, **properties})
        return len(self.materials) - 1

    def triangles(self, positions, normals, faces, material):
        indices = self.view(b"".join(struct.pack("<3H", *f) for f in faces), target=34963)
        self.primitives.append({
            "attributes": {"POSITION": self.vectors(positions, True), "NORMAL": self.vectors(normals)},
            "indices": self.accessor(indices, 5123, 3 * len(faces), "SCALAR"), "material": material})

    def line_strips(self, positions, normals, widths, points, material):
        """A strip for every `points` vertices; all share the vertices."""
        attributes = {"POSITION": self.vectors(positions, True), "NORMAL": self.vectors(normals)}
        width_view = self.view(struct.pack("<%df" % len(widths), *widths), target=34962)
        attributes["_WIDTH"] = self.accessor(width_view, 5126, len(widths), "SCALAR")
        indices = self.view(struct.pack("<%dH" % len(positions), *range(len(positions))), target=34963)
        for first in range(0, len(positions), points):
            self.primitives.append({"attributes": attributes, "mode": 3, "material": material,
                                    "indices": self.accessor(indices, 5123, points, "SCALAR", byteOffset=2 * first)})

    def write(self, path):
        document = {
            "asset": {"version": "2.0", "generator": "Tessera make_assets.py",
                      "copyright": "the Tessera authors, MIT"},
            "scene": 0,
            "scenes": [{"nodes": [0]}],
            "nodes": [{"name": self.name, "mesh": 0}],
            "meshes": [{"name": self.name, "primitives": self.primitives}],
            "materials": self.materials,
            "accessors": self.accessors,
            "bufferViews": self.views,
            "textures": [{"source": i} for i in range(len(self.images))],
            "images": self.images,
            "buffers": [{"byteLength": len(self.data)}],
        }
        write_container(path, document, self.data)
