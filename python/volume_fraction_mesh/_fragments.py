"""Tabulates the fragments of a mesh."""

from __future__ import annotations

from typing import Any, Dict, Optional

import numpy as np

from . import _core
from ._data import MeshData
from ._tables import material_names


def fragments(mesh: MeshData, density: Optional[str] = None,
              velocity: Optional[str] = None) -> Dict[str, Any]:
    """Tabulate the fragments of a mesh: the face-connected pieces of each material.

    Parameters
    ----------
    mesh : Mesh
        Mesh made by `hexes` or `tets`.
    density, velocity : str, optional
        Arrays in ``mesh.state``: mass per volume, shape (elements,), and velocity, shape
        (elements, 3). Default: the arrays that `hexes` or `tets` received as `density` and
        `velocity`.

    Returns
    -------
    dict
        Columns with one entry per fragment, of n fragments:

        - ``id``, ``material``: int32, shape (n,).
        - ``name``: list of str, names of the materials.
        - ``elements``: int64, shape (n,), number of elements.
        - ``fraction_volume``, ``volume``: float64, shape (n,), in length**3: volume of the
          fractions in the cells, and of the elements.
        - ``centroid``: float64, shape (n, 3).
        - ``bounds``: float64, shape (n, 6): xmin, xmax, ymin, ymax, zmin, zmax.
        - ``mass``: float64, shape (n,), with a density; ``momentum``: shape (n, 3), with a velocity
          too. Both are in the units of the input.
        - ``neighbours``: list of int32 arrays, ids of the fragments that share faces with it.

    Raises
    ------
    KeyError
        If ``mesh.state`` has no array named `density` or `velocity`.

    See Also
    --------
    Mesh : Attributes ``fragment`` and ``materials``.

    Examples
    --------
    >>> text = "sphere radius=0.5; halfspace point=0,0,-0.6 normal=0,0,1 material=2"
    >>> mesh = vfm.hexes(vfm.shapes(text, 12, bounds=[-1, 1] * 3))
    >>> table = vfm.fragments(mesh)
    >>> table["name"], table["elements"].tolist()
    (['Material2', 'Material1'], [432, 328])
    >>> table["volume"].round(3)
    array([1.6  , 0.524])
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
    ids, material, elements = (columns.pop(name) for name in ("id", "material", "elements"))
    names = material_names(mesh)
    return {
        "id": ids,
        "material": material,
        "name": [names[int(m)] for m in material],
        "elements": elements,
        "fraction_volume": np.asarray(mesh.fields["FragmentTargetVolume"])[ids - 1],
        **columns,
    }


def _numbers(values: Any, kind: Any) -> np.ndarray:
    return np.ascontiguousarray(values, dtype=kind)


def _state(mesh: MeshData, name: str) -> np.ndarray:
    if name not in mesh.state:
        raise KeyError("The mesh has no array %r. Its state: %s."
                       % (name, ", ".join(map(repr, mesh.state)) or "none"))
    return mesh.state[name]
