"""Reads arrays of NumPy."""

from __future__ import annotations

from typing import Dict, Optional, Sequence

import numpy as np


def read(path: str) -> Dict[str, np.ndarray]:
    """Returns the arrays of a .npz by their names, or the array of a .npy: "Material 1", and with
    four axes one per material, the first axis."""
    loaded = np.load(path, mmap_mode="r", allow_pickle=False)
    if isinstance(loaded, np.ndarray):
        if loaded.ndim != 4:
            return {"Material 1": loaded}
        return {"Material %d" % (m + 1): volume for m, volume in enumerate(loaded)}
    with loaded:
        return {name: loaded[name] for name in loaded.files}


def select(arrays: Dict[str, np.ndarray], names: Optional[Sequence[str]]) -> Dict[str, np.ndarray]:
    """Returns the arrays with the shape of the grid: that of the first selected array, or of the
    first with three axes. Selected arrays stay, whatever their shapes."""
    chosen = list(names or [])
    volumes = [name for name in chosen if name in arrays] or [
        name for name, array in arrays.items() if array.ndim == 3] or list(arrays)
    if not volumes:
        raise ValueError("it has no arrays.")
    cells = arrays[volumes[0]].shape[:3]
    return {name: array for name, array in arrays.items()
            if name in chosen or array.shape[:3] == cells}
