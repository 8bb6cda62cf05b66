"""Defines meshes that must be bitwise identical in the package and in the ParaView filters.

Inputs are made with only +, -, *, / and sqrt, so that they are equal on every machine. A case does
not depend on the front end: `settings(case)` returns keyword arguments of hexes() and tets(), and
Testing/Package/TestSameBits.py converts a case to properties of the filters.
"""

import hashlib
import os
import sys
from typing import Any, Dict, List, NamedTuple, Optional, Sequence, Tuple

import numpy as np

ENDINGS = ("exo", "inp", "msh", "k", "rad", "bdf", "foam")
SPACING, ORIGIN = (0.25, 0.25, 0.5), (-1.0, 0.5, 2.0)
TURNED = ((0.6, 0.8, 0.0), (0.8, -0.6, 0.0), (0.0, 0.0, 1.0))  # rotates and mirrors


class Case(NamedTuple):
    """Input and options of a mesh.

    Arrays are in Fortran order, [i, j, k] or [i, j, k, component] with i along x. Either fractions
    holds their names, one per material, or labels holds one name. Nodes replace SPACING and ORIGIN.
    Options have the names and values of Python.
    """

    arrays: Dict[str, np.ndarray]
    options: Dict[str, Any] = {}
    fractions: Sequence[str] = ()
    labels: str = ""
    tets: bool = False
    nodes: Optional[Tuple[np.ndarray, ...]] = None
    direction: Optional[Tuple[Tuple[float, ...], ...]] = None
    state: Sequence[str] = ()
    density: str = ""
    velocity: str = ""
    energy: str = ""


def centres(n: int, parts: int = 1) -> List[np.ndarray]:
    """Returns the centres of the parts of n cells along x, y and z, in cells, for broadcasting."""
    at = (np.arange(n * parts) + 0.5) / parts
    return [at[:, None, None], at[None, :, None], at[None, None, :]]


def averaged(inside: np.ndarray, parts: int) -> np.ndarray:
    """Returns the average over parts^3 points in each cell."""
    n = inside.shape[0] // parts
    counts = inside.reshape(n, parts, n, parts, n, parts).sum(axis=(1, 3, 5))
    return np.asfortranarray(counts / parts**3)


def ball_and_plate(n: int = 12, parts: int = 4) -> Dict[str, np.ndarray]:
    x, y, z = centres(n, parts)
    ball = ((x - n / 2) * (x - n / 2) + (y - n / 2) * (y - n / 2)
            + (z - 0.55 * n) * (z - 0.55 * n)) < 0.09 * n * n
    plate = np.broadcast_to(z < 0.33 * n, ball.shape) & ~ball
    return {"ball": averaged(ball, parts), "plate": averaged(plate, parts)}


def grains(n: int = 12, count: int = 9) -> np.ndarray:
    """Returns the label of the nearest of some points."""
    x, y, z = centres(n)
    distances = []
    for g in range(count):
        a, b, c = ((7 * g + 3) % 11 / 11 * n, (5 * g + 2) % 13 / 13 * n, (3 * g + 1) % 7 / 7 * n)
        distances.append((x - a) * (x - a) + (y - b) * (y - b) + (z - c) * (z - c))
    return np.asfortranarray(np.argmin(distances, axis=0).astype(np.int32) * 2 + 1)


def turned_box(n: int = 14, parts: int = 4) -> np.ndarray:
    """Returns a box whose axes are (2, 2, 1) / 3, (1, -2, 2) / 3 and (2, -1, -2) / 3."""
    x, y, z = (axis - n / 2 for axis in centres(n, parts))
    along = ((2 * x + 2 * y + z) / 3, (x - 2 * y + 2 * z) / 3, (2 * x - y - 2 * z) / 3)
    return averaged((abs(along[0]) < 4.2) & (abs(along[1]) < 3.3) & (abs(along[2]) < 3.7), parts)


def film(n: int = 12, parts: int = 4) -> np.ndarray:
    """Returns an oblique film, thinner than two cells."""
    x, y, z = (axis - n / 2 for axis in centres(n, parts))
    return averaged(abs((x + 2 * y + 2 * z) / 3 - 0.1) < 0.7, parts)


def graded(n: int = 12) -> Tuple[np.ndarray, ...]:
    steps = np.arange(n + 1.0)
    return (steps * 0.25, steps * 0.2 + steps * steps * 0.01, steps * 0.5 - steps * steps * 0.015)


def state_of(n: int = 12) -> Dict[str, np.ndarray]:
    x, y, z = centres(n)
    zero = 0 * (x + y + z)
    velocity = np.stack([x - y + zero, 0.5 * z + zero, 3 - x + zero], axis=-1)
    return {
        "density": np.asfortranarray(1 + 0.1 * x + 0.05 * y + zero),
        "temperature": np.asfortranarray(300 + x * y + z + zero),
        "velocity": np.ascontiguousarray(velocity.transpose(2, 1, 0, 3)).transpose(2, 1, 0, 3),
        "energy": np.asfortranarray(2 + 0.01 * x * z + zero),
        "code": np.asfortranarray((x + 100 * y + zero).astype(np.int16)),
    }


BOTH = ("ball", "plate")
CASES = {
    "hexes of a turned box with sharp edges": lambda: Case({"box": turned_box()},
                                                           {"sharp_edges": "on"}, ["box"]),
    "hexes of two materials, the void meshed": lambda: Case(ball_and_plate(), {"mesh_void": True},
                                                            BOTH),
    "hexes of labels": lambda: Case({"grain": grains()}, labels="grain"),
    "hexes of labels smoothed, small regions removed": lambda: Case(
        {"grain": grains()}, {"label_smoothing": 3, "minimum_region_cells": 4}, labels="grain"
    ),
    "hexes in turned axes": lambda: Case(ball_and_plate(), {}, BOTH, direction=TURNED),
    "hexes on graded coordinates, long cells cut": lambda: Case(
        ball_and_plate(), {"maximum_aspect_ratio": 1.5}, BOTH, nodes=graded()
    ),
    "hexes of a film, refined where it is thin": lambda: Case(
        {"film": film()}, {"refinement": "automatic", "fine_interfaces": False}, ["film"]
    ),
    "tets by the lattice, coarse away from surfaces": lambda: Case(
        ball_and_plate(16), {"refinement": "coarsen", "method": "lattice", "mesh_void": True}, BOTH,
        tets=True
    ),
    "tets by cells, state copied": lambda: Case(
        {**ball_and_plate(), **state_of()},
        {"method": "cells", "state_transfer": "copy"},
        BOTH,
        tets=True,
        state=["temperature", "velocity", "code"],
    ),
    "hexes, state conserved": lambda: Case(
        {**ball_and_plate(), **state_of()},
        {"nodal_velocity": True, "lost_kinetic_energy": "internal_energy"},
        BOTH,
        state=["temperature", "code"],
        density="density",
        velocity="velocity",
        energy="energy",
    ),
}


def digest(arrays: Dict[str, Any]) -> str:
    """Returns the SHA-256 of a mesh.

    arrays: points, cells, point_ids, cell_ids, material, fragment, quality, and the dicts state and
    point_state.
    """
    sha = hashlib.sha256()
    kinds = {
        "points": "f8",
        "cells": "i8",
        "point_ids": "i8",
        "cell_ids": "i8",
        "material": "i4",
        "fragment": "i4",
        "quality": "f4",
    }
    for name, kind in kinds.items():
        assert arrays[name].size, name
        sha.update(np.ascontiguousarray(arrays[name], dtype="<" + kind).tobytes())
    for group in ("state", "point_state"):
        for name in sorted(arrays[group]):
            values = np.asarray(arrays[group][name])
            sha.update(("%s %s %d" % (name, values.dtype.str, values.ndim)).encode())
            sha.update(np.ascontiguousarray(values).tobytes())
    return sha.hexdigest()


def settings(case: Case) -> Dict[str, Any]:
    """Returns the keyword arguments of hexes() or tets()."""
    given: Dict[str, Any] = dict(case.options)
    if case.labels:
        given["labels"] = case.arrays[case.labels]
    else:
        given["fractions"] = {name: case.arrays[name] for name in case.fractions}
    if case.nodes is None:
        given.update(spacing=SPACING, origin=ORIGIN)
    else:
        given["coordinates"] = case.nodes
    given["direction"] = case.direction
    given["state"] = {name: case.arrays[name] for name in case.state}
    for role in ("density", "velocity", "energy"):
        if getattr(case, role):
            given[role] = case.arrays[getattr(case, role)]
    return given


def mesh_of(case: Case, **more: Any) -> Any:
    """Makes the mesh with the package."""
    import volume_fraction_mesh as vfm

    return (vfm.tets if case.tets else vfm.hexes)(**settings(case), **more)


def path_of(folder: str, name: str, ending: str) -> str:
    """Returns the path of a file of a mesh, in a folder of its own for formats of several files."""
    return os.path.join(folder, name, ending, "mesh." + ending)


def main(folder: str = "") -> None:
    """Prints a line `case sha256` per case. folder: for files of the meshes; "" writes none."""
    for name, make in CASES.items():
        mesh = mesh_of(make())
        print(name, digest(vars(mesh)), flush=True)
        for ending in ENDINGS if folder else ():
            path = path_of(folder, name, ending)
            os.makedirs(os.path.dirname(path), exist_ok=True)
            mesh.save(path)


if __name__ == "__main__":
    main(*sys.argv[1:])
