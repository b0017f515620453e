#!/usr/bin/env python3
"""Makes the project's own models: assets/*.glb. Needs nothing but Python 3; takes one or two minutes.

    scripts/make_assets.py [FOLDER]
"""

import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent))

from assets import figure, furball, parrot, rabbit, turned  # noqa: E402
from assets.glb import Model, write_glb  # noqa: E402
from assets.surface import coarse_mesh  # noqa: E402

STEP = 0.04  # of the grid that first finds the surface


def make_rabbit(path):
    shape = rabbit.body()
    positions, faces = coarse_mesh(shape, *rabbit.BOX, STEP, 620, rabbit.weight)
    vertices = [(p, shape.normal(p), rabbit.uv(p)) for p in positions]
    write_glb(path, "rabbit", vertices, faces, image=rabbit.texture())
    return faces


def make_figure(path):
    shape = figure.body()
    positions, faces = coarse_mesh(shape, *figure.BOX, STEP, 400, figure.weight)
    vertices = [(p, shape.normal(p), (0.0, 0.0)) for p in positions]
    write_glb(path, "figure", vertices, faces, colour=figure.COLOUR)
    return faces


def make_parrot(path):
    shape = parrot.body()
    positions, faces = coarse_mesh(shape, *parrot.BOX, STEP, 680, parrot.weight)
    colour = parrot.painter()
    vertices = [(p, shape.normal(p), (0.0, 0.0), colour(p)) for p in positions]
    write_glb(path, "parrot", vertices, faces)
    return faces


def make_pawn(path):
    vertices, faces = turned.pawn()
    write_glb(path, "pawn", vertices, faces, colour=turned.PAWN_COLOUR)
    return faces


def make_ball(path):
    vertices, faces = turned.ball()
    write_glb(path, "ball", vertices, faces, image=turned.ball_texture())
    return faces


def make_furball(path):
    model = Model("furball")
    for name, vertices, faces, colour in furball.parts():
        model.triangles([p for p, _ in vertices], [n for _, n in vertices], faces, model.material(name, colour))
    positions, normals = furball.guides()
    hair = model.material("hair", image=furball.hair_texture(), doubleSided=True)
    model.line_strips(positions, normals, [furball.WIDTH] * len(positions), furball.POINTS, hair)
    model.write(path)
    return [f for _, _, faces, _ in furball.parts() for f in faces]


def main():
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parent.parent / "assets"
    folder.mkdir(parents=True, exist_ok=True)
    for name, make in (("rabbit", make_rabbit), ("figure", make_figure), ("pawn", make_pawn), ("ball", make_ball),
                       ("furball", make_furball), ("parrot", make_parrot)):
        path = folder / f"{name}.glb"
        print(f"{path}: {len(make(path))} triangles")


if __name__ == "__main__":
    main()
