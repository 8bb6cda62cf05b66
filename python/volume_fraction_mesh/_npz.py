"""Writes and reads a whole mesh as a NumPy archive, .npz."""

from __future__ import annotations

import json
from typing import IO, Any, Dict

import numpy as np

from ._call import Run
from ._data import MeshData
from ._geometry import Curves, Geometry, Surfaces, Vertices

FORMAT = "volume_fraction_mesh 1"  # value of the key "format"
ARRAYS = ("points", "cells", "material", "fragment", "point_ids", "cell_ids")
OPTIONAL = ("quality", "partner", "original_ids", "mids", "layer")
PARTS = {
    "geometry": ("dimension", "id"),
    "surfaces": ("cells", "surface_id", "material_pair", "domain_side", "fields"),
    "curves": ("cells", "curve_id", "fields"),
    "vertices": ("points", "vertex_id", "fields"),
}
TABLES = ("state", "point_state", "materials", "fields", "roles", "particles")


def write(mesh: MeshData, file: IO[bytes], compress: bool = False) -> None:
    """Writes all arrays of a mesh by key: an attribute, or attribute/name."""
    arrays: Dict[str, Any] = {"format": FORMAT}
    arrays.update((name, getattr(mesh, name)) for name in ARRAYS)
    arrays.update((name, getattr(mesh, name)) for name in OPTIONAL
                  if getattr(mesh, name) is not None)
    for part, names in PARTS.items():
        for name in names:
            _add(arrays, "%s/%s" % (part, name), getattr(getattr(mesh, part), name))
    for name in TABLES:
        _add(arrays, name, getattr(mesh, name))
    arrays["run"] = json.dumps(vars(mesh.run), default=str)
    (np.savez_compressed if compress else np.savez)(file, **arrays)


def _add(arrays: Dict[str, Any], key: str, values: Any) -> None:
    if isinstance(values, dict):
        for name, column in values.items():
            _add(arrays, "%s/%s" % (key, name), column)
    else:
        arrays[key] = np.array(values, dtype=str) if isinstance(values, list) else values


def read(path: Any) -> Dict[str, Any]:
    """Implements load(): returns the arguments of MeshData, by name."""
    try:
        with np.load(path, allow_pickle=False) as archive:
            arrays = {name: archive[name] for name in archive.files}
        if str(arrays.pop("format")) != FORMAT:
            raise KeyError("format")
        return _data_of(arrays)
    except (KeyError, AttributeError, ValueError, EOFError) as problem:
        raise ValueError("%s is not a mesh that Mesh.save wrote as .npz (%s)."
                         % (path, problem)) from None


def _data_of(arrays: Dict[str, Any]) -> Dict[str, Any]:
    parts = {name: {own: _take(arrays, "%s/%s/" % (name, own)) if own == "fields"
                    else arrays["%s/%s" % (name, own)] for own in names}
             for name, names in PARTS.items()}
    return dict(
        **{name: arrays[name] for name in ARRAYS},
        **{name: arrays.get(name) for name in OPTIONAL},
        geometry=Geometry(**parts["geometry"]),
        surfaces=Surfaces(**parts["surfaces"]),
        curves=Curves(**parts["curves"]),
        vertices=Vertices(**parts["vertices"]),
        run=Run(**json.loads(str(arrays["run"]))),
        **{name: _take(arrays, name + "/") for name in TABLES},
    )


def _take(arrays: Dict[str, Any], prefix: str) -> Dict[str, Any]:
    """Returns the arrays whose key begins with a prefix; texts as lists, a single text as str."""
    return {key[len(prefix):]: values.tolist() if values.dtype.kind == "U" else values
            for key, values in arrays.items() if key.startswith(prefix)}
