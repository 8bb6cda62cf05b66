"""What each fragment of a mesh is."""

from __future__ import annotations

from typing import Any, Dict, Optional

import numpy as np

from ._moments import element_moments
from .mesh import Mesh


def fragments(mesh: Mesh, density: Optional[str] = None, velocity: Optional[str] = None) -> Dict[str, Any]:
    """A table of the fragments, the pieces of one material whose elements are connected over faces.

    Parameters
    ----------
    mesh : Mesh
    density : str
        The array of Mesh.state that is mass per volume; else that which hexes() was given as density.
    velocity : str
        The array of Mesh.state that is the velocity; else that which hexes() was given.

    Returns
    -------
    dict
        Columns with a row a fragment: id, material (int32), name (list of str), elements (int64), fraction_volume (of
        the cells' fractions), volume (of the mesh; length units cubed), centroid (n, 3), bounds (n, 6: minimum and
        maximum of x, y, z), with a density mass, with a velocity too momentum (n, 3), and neighbours (list of arrays
        of ids that it shares faces with).

    Raises
    ------
    KeyError
        Where the mesh has no such array.
    """
    count = int(mesh.fragment.max(initial=0))
    place = mesh.fragment - 1
    material = np.zeros(count, np.int32)
    material[place] = mesh.material
    names = dict(zip((int(i) for i in mesh.materials["MaterialId"]), mesh.materials["Name"]))
    volumes, moments = element_moments(mesh.points, mesh.cells)
    volume = _sums(place, volumes, count)
    table = {
        "id": np.arange(1, count + 1, dtype=np.int32),
        "material": material,
        "name": [names[int(m)] for m in material],
        "elements": np.bincount(place, minlength=count).astype(np.int64),
        "fraction_volume": np.array(mesh.fields["FragmentTargetVolume"][:count]),
        "volume": volume,
        "centroid": _centroids(mesh, place, volumes, moments, volume),
        "bounds": _bounds(mesh, place, count),
    }
    table.update(
        _masses(
            mesh, place, count, volumes, density or mesh.roles.get("density"), velocity or mesh.roles.get("velocity")
        )
    )
    table["neighbours"] = _neighbours(mesh, count)
    return table


def _sums(place: np.ndarray, values: np.ndarray, count: int) -> np.ndarray:
    """Over the elements of each fragment."""
    if values.ndim == 1:
        return np.bincount(place, weights=values, minlength=count)
    return np.stack([np.bincount(place, weights=column, minlength=count) for column in values.T], axis=1)


def _centroids(
    mesh: Mesh, place: np.ndarray, volumes: np.ndarray, moments: np.ndarray, volume: np.ndarray
) -> np.ndarray:
    """About the middle of the mesh: sums of meshes far from the origin are as exact."""
    if not len(volume):
        return np.empty((0, 3))
    middle = mesh.points.mean(axis=0)
    return middle + _sums(place, moments - volumes[:, None] * middle, len(volume)) / volume[:, None]


def _bounds(mesh: Mesh, place: np.ndarray, count: int) -> np.ndarray:
    low, high = np.full((count, 3), np.inf), np.full((count, 3), -np.inf)
    for corner in mesh.cells.T:
        np.minimum.at(low, place, mesh.points[corner])
        np.maximum.at(high, place, mesh.points[corner])
    return np.stack([low, high], axis=2).reshape(count, 6)


def _masses(
    mesh: Mesh, place: np.ndarray, count: int, volumes: np.ndarray, density: Optional[str], velocity: Optional[str]
) -> Dict[str, np.ndarray]:
    if density is None:
        return {}
    masses = volumes * _state(mesh, density)
    found = {"mass": _sums(place, masses, count)}
    if velocity is not None:
        found["momentum"] = _sums(place, masses[:, None] * _state(mesh, velocity), count)
    return found


def _state(mesh: Mesh, name: str) -> np.ndarray:
    if name not in mesh.state:
        raise KeyError("The mesh has no array %r. Its state: %s." % (name, ", ".join(map(repr, mesh.state)) or "none"))
    return mesh.state[name]


def _neighbours(mesh: Mesh, count: int) -> Any:
    """Of the volumes on the two sides of each surface."""
    pairs = np.reshape(mesh.surfaces.fields["SurfaceVolumes"], (-1, 2))
    pairs = pairs[(pairs > 0).all(axis=1)]
    pairs = np.unique(np.concatenate([pairs, pairs[:, ::-1]]), axis=0)
    return [pairs[pairs[:, 0] == f, 1] for f in range(1, count + 1)]
