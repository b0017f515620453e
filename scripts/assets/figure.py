"""A clay figure with raised arms, about 1.8 units high, looking along +z."""

from .implicit import Body, capsule, ellipsoid, mirrored

BOX = ((0.0, -0.1, -0.45), (0.95, 2.0, 0.55))
COLOUR = (0.72, 0.40, 0.18, 1.0)


def body():
    figure = Body()
    figure.add(ellipsoid((0.0, 0.80, 0.0), (0.32, 0.42, 0.26)), 0.1)  # trunk
    figure.add(ellipsoid((0.0, 1.43, 0.02), (0.30, 0.31, 0.29)), 0.10)  # head
    figure.add(mirrored(capsule, (0.17, 0.50, 0.0), (0.20, 0.12, 0.02), 0.17, 0.13), 0.08)  # legs
    figure.add(mirrored(ellipsoid, (0.21, 0.09, 0.10), (0.14, 0.10, 0.22)), 0.06)  # feet
    figure.add(mirrored(capsule, (0.26, 1.00, 0.0), (0.62, 1.22, 0.06), 0.13, 0.105), 0.08)  # arms
    figure.add(mirrored(ellipsoid, (0.68, 1.27, 0.07), (0.13, 0.13, 0.12)), 0.06)  # hands
    return figure


def weight(p):
    """Hands and feet are smaller and finer than the rest."""
    return 15.0 if p[0] > 0.5 else 6.0 if p[1] < 0.3 else 1.0
