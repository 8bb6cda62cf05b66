"""Makes small fields for several tests."""

import numpy as np

from digest_cases import averaged, ball_and_plate, centres, graded, grains, state_of

__all__ = [
    "N",
    "BALL",
    "PLATE",
    "GRAINS",
    "LABELS",
    "STATE",
    "averaged",
    "ball",
    "centres",
    "check_valid",
    "graded",
    "same",
]
N = 12
BALL, PLATE = (ball_and_plate(N)[name] for name in ("ball", "plate"))
GRAINS, STATE = grains(N), state_of(N)
LABELS = np.where(BALL + PLATE < 0.5, 0, np.where(BALL >= PLATE, 1, 2))
HEX_EDGES = np.array(
    [[1, 3, 4], [2, 0, 5], [3, 1, 6], [0, 2, 7], [7, 5, 0], [4, 6, 1], [5, 7, 2], [6, 4, 3]]
)  # at each corner, the ends of its edges


def ball(n, radius=0.3):
    """Returns the fractions of a ball in the middle. radius: in widths of the domain."""
    x, y, z = (axis - n / 2 for axis in centres(n, 4))
    return averaged(x * x + y * y + z * z < (radius * n) ** 2, 4)


def same(mesh, other):
    """Returns whether two meshes are bitwise identical."""
    names = ("points", "cells", "material", "fragment", "point_ids", "cell_ids", "quality")
    return all(np.array_equal(getattr(mesh, name), getattr(other, name)) for name in names)


def check_valid(mesh):
    """Checks that every corner is positive, and that the volumes of linear elements match the table
    of materials."""
    corner = mesh.points[mesh.cells]
    if mesh.cells.shape[1] == 8:
        edges = corner[:, HEX_EDGES] - corner[:, :, None]
    else:
        edges = (corner[:, 1:] - corner[:, :1])[:, None]
    assert (np.einsum("hci,hci->hc", edges[:, :, 0],
                      np.cross(edges[:, :, 1], edges[:, :, 2])) > 0).all()
    if mesh.mids is not None:
        return
    volumes = mesh.volumes()
    for label, volume in zip(mesh.materials["MaterialId"], mesh.materials["MeshVolume"]):
        assert np.isclose(volumes[mesh.material == label].sum(), volume, rtol=1e-9)
