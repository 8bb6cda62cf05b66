"""Reads the orientations and phases of grains from files of DREAM.3D 6 and DREAM3D-NX by h5py."""

from __future__ import annotations

from typing import Any, Dict, Iterator, List, NamedTuple, Optional

import numpy as np

from .dream3d_files import DEEPEST, DEFAULT, find_geometries, list_arrays, open_member
from .report import load_library

EULER = ("AvgEulerAngles", "EulerAngles")
QUATERNIONS = ("AvgQuats", "Quats")
PHASE_NAMES = ("PhaseName", "MaterialName")


class GrainData(NamedTuple):
    """Rows of the grains from 1. Angles are in radians, quaternions as x, y, z, w."""

    euler: Optional[np.ndarray]
    quaternions: Optional[np.ndarray]
    phases: Optional[np.ndarray]
    phase_names: Dict[int, str]


def read(path: str, is_trusted: bool) -> GrainData:
    """Reads the table of the grains of the image geometry that has FeatureIds."""
    h5py = load_library("h5py", path)
    with h5py.File(path, "r") as file:
        fitting = [(group, grid) for group, grid in find_geometries(h5py, file, DEEPEST)
                   if DEFAULT in dict(list_arrays(h5py, group, grid, is_trusted))]
        if len(fitting) != 1:
            raise ValueError("%d of its image geometries have the array %r; one is required."
                             % (len(fitting), DEFAULT))
        group, grid = fitting[0]
        matrices = list(_list_matrices(h5py, group, grid, is_trusted))
        euler, quaternions = _find(matrices, EULER, 3), _find(matrices, QUATERNIONS, 4)
        if euler is None and quaternions is None:
            raise ValueError("it has no orientations of grains (%s). Compute them in DREAM.3D by "
                             "Find Feature Average Orientations."
                             % ", ".join((*EULER, *QUATERNIONS)))
        phases = _find(matrices, ("Phases",), 1)
        names = _read_names(matrices)
    return GrainData(euler, quaternions, None if phases is None else phases[:, 0], names)


def _list_matrices(h5py: Any, group: Any, grid: Any, is_trusted: bool) -> Iterator[Dict[str, Any]]:
    """Yields the data sets of each attribute matrix that has no arrays of cells."""
    cells = set(dict(_by_path(list_arrays(h5py, group, grid, is_trusted))))
    for name in group:
        inner = open_member(h5py, group, name, is_trusted)
        if not isinstance(inner, h5py.Group):
            continue
        members = (open_member(h5py, inner, member, is_trusted) for member in inner)
        arrays = {data.name.rsplit("/", 1)[-1]: data for data in members
                  if isinstance(data, h5py.Dataset)}
        if not cells & {data.name for data in arrays.values()}:
            yield arrays


def _by_path(arrays: Iterator[Any]) -> Iterator[Any]:
    for _, data in arrays:
        yield data.name, data


def _find(matrices: List[Dict[str, Any]], names: Any, width: int) -> Optional[np.ndarray]:
    """Returns the rows of the grains from 1 of the first array with one of the names."""
    for name in names:
        found = [arrays[name] for arrays in matrices if name in arrays]
        if len(found) > 1:
            raise ValueError("%d of its tables have the array %r." % (len(found), name))
        for data in found:
            if data.dtype.kind not in "iuf" or data.size != len(data) * width:
                raise ValueError("%s does not have %d numbers per grain." % (data.name, width))
            return np.asarray(data[()]).reshape(len(data), width)[1:]
    return None


def _read_names(matrices: List[Dict[str, Any]]) -> Dict[int, str]:
    """Returns the names of the phases from 1."""
    for name in PHASE_NAMES:
        for arrays in matrices:
            if name in arrays:
                texts = np.ravel(arrays[name][()])
                return {number: text.decode("utf-8", "replace") if isinstance(text, bytes)
                        else str(text) for number, text in enumerate(texts) if number}
    return {}
