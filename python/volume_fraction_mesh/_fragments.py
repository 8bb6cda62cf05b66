"""What each fragment of a mesh is."""

from __future__ import annotations

from typing import Any, Dict, Optional

import numpy as np

from . import _core
from .mesh import Mesh


def fragments(mesh: Mesh, density: Optional[str] = None,
              velocity: Optional[str] = None) -> Dict[str, Any]:
    """A table of the fragments, the pieces of one material whose elements are connected over faces.

    Parameters
    ----------
    mesh : Mesh
    density : str
        The array of Mesh.state that is mass per volume; else that which hexes() was given as
        density.
    velocity : str
        The array of Mesh.state that is the velocity; else that which hexes() was given.

    Returns
    -------
    dict
        Columns with a row a fragment: id, material (int32), name (list of str), elements (int64),
        fraction_volume (of the cells' fractions), volume (of the mesh; length units cubed),
        centroid (n, 3), bounds (n, 6: minimum and maximum of x, y, z), with a density mass, with a
        velocity too momentum (n, 3), and neighbours (list of arrays of ids that it shares faces
        with).

    Raises
    ------
    KeyError
        Where the mesh has no such array.
    """
    density, velocity = density or mesh.roles.get("density"), velocity or mesh.roles.get("velocity")
    columns = _core.fragments(
        _numbers(mesh.points, np.float64),
        _numbers(mesh.cells, np.int64),
        _numbers(mesh.point_ids, np.int64),
        _numbers(mesh.geometry.dimension, np.int32),
        _numbers(mesh.material, np.int32),
        _numbers(mesh.fragment, np.int32),
        None if density is None else _numbers(_state(mesh, density), np.float64),
        None if density is None or velocity is None
        else _numbers(_state(mesh, velocity), np.float64),
    )
    material, elements = columns.pop("material"), columns.pop("elements")
    names = dict(zip((int(i) for i in mesh.materials["MaterialId"]), mesh.materials["Name"]))
    return {
        "id": np.arange(1, len(material) + 1, dtype=np.int32),
        "material": material,
        "name": [names[int(m)] for m in material],
        "elements": elements,
        "fraction_volume": np.array(mesh.fields["FragmentTargetVolume"][: len(material)]),
        **columns,
    }


def _numbers(values: Any, kind: Any) -> np.ndarray:
    return np.ascontiguousarray(values, dtype=kind)


def _state(mesh: Mesh, name: str) -> np.ndarray:
    if name not in mesh.state:
        raise KeyError("The mesh has no array %r. Its state: %s."
                       % (name, ", ".join(map(repr, mesh.state)) or "none"))
    return mesh.state[name]
