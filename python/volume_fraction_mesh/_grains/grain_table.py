"""Defines the data of grains, which the writers of files take."""

from __future__ import annotations

from typing import Dict

import numpy as np

from .orientations import to_axes


class GrainTable:
    """Rows of grains. `Grains` documents them."""

    ids: np.ndarray
    phases: np.ndarray
    euler_angles: np.ndarray
    quaternions: np.ndarray
    phase_names: Dict[int, str]

    def __len__(self) -> int:
        return len(self.ids)

    def axes(self) -> np.ndarray:
        """Compute the axes of the crystals.

        Returns
        -------
        ndarray of float64, shape (n, 3, 3)
            ``axes[g, i]`` is axis i of grain g, in the coordinates of the sample.

        Examples
        --------
        >>> vfm.Grains([[90, 0, 0]], degrees=True).axes().round(3)[0].tolist()
        [[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]
        """
        return to_axes(self.quaternions)
