"""Reads the input files of the command vfmesh: NumPy arrays, images, surfaces and blocks."""

from __future__ import annotations

import os
from typing import Any, Dict, List, NamedTuple, Optional, Sequence

import numpy as np

from ._arrays import as_numbers
from ._blocks import Blocks, is_block_file, read
from ._images import read_image

NIBABEL = (".nii", ".nii.gz", ".mgz", ".mgh", ".img", ".hdr")
PYVISTA = (".vti", ".vtr", ".vtk")
SURFACES = (".stl", ".obj", ".ply", ".off")


class Source(NamedTuple):
    """Content of an input file.

    materials: an image, or arrays by name. others: further arrays of the same file.
    """

    materials: Any
    others: Dict[str, np.ndarray]
    is_image: bool


def read_source(path: str, names: Optional[Sequence[str]], cells: int, step: int) -> Source:
    """Reads a file.

    names: arrays that hold materials. cells: number along the longest side of a surface. step:
    index of the time step.
    """
    low = path.lower()
    if is_block_file(path):
        return Source(read(path, step=step), {}, True)
    if low.endswith((".npy", ".npz")):
        return _read_numpy(path, names)
    if low.endswith(SURFACES):
        from ._shapes import surface

        return Source(surface(path, cells), {}, True)
    return Source(_read_image(path, low), {}, True)


def _read_image(path: str, low: str) -> Any:
    if not os.path.exists(path):
        raise FileNotFoundError("There is no file %s." % path)
    if low.endswith(NIBABEL):
        return _import("nibabel", path).load(path)
    if low.endswith(PYVISTA):
        return _import("pyvista", path).read(path)
    return _import("SimpleITK", path).ReadImage(path)


def _import(name: str, path: str) -> Any:
    from importlib import import_module

    try:
        return import_module(name)
    except ImportError:
        raise ImportError("Reading %s requires %s: pip install %s" % (path, name, name)) from None


def _read_numpy(path: str, names: Optional[Sequence[str]]) -> Source:
    loaded = np.load(path, mmap_mode="r", allow_pickle=False)
    if isinstance(loaded, np.ndarray):
        if names is not None:
            raise ValueError("%s holds one array without a name: omit --array." % path)
        return Source({"Material 1": loaded}, {}, False)
    arrays = {name: loaded[name] for name in loaded.files}
    chosen = list(arrays) if names is None else list(names)
    missing = [name for name in chosen if name not in arrays]
    if missing:
        raise ValueError(
            "%s has no array %r. Its arrays: %s." % (path, missing[0],
                                                     ", ".join(map(repr, arrays)) or "none")
        )
    return Source({name: arrays.pop(name) for name in chosen}, arrays, False)


def are_labels(source: Source, names: Optional[List[str]]) -> bool:
    """Returns whether the source is a single array of integers, or of values above 1."""
    arrays = source.materials
    if isinstance(arrays, Blocks):
        return False
    if source.is_image:
        image = read_image(source.materials, names)
        assert image is not None
        arrays = {name: image.arrays[name] for name in image.chosen if name in image.arrays}
    if len(arrays) != 1:
        return False
    array = as_numbers(next(iter(arrays.values())), next(iter(arrays)))
    return array.dtype.kind != "f" or bool(array.size and array.max() > 1 + 1e-6)
