"""Orientations of crystals: Euler angles of Bunge, quaternions, and axes.

A quaternion (w, x, y, z) is the rotation that turns the axes of the sample to those of the crystal,
with w >= 0; it is also the quaternion of DAMASK. Formulas: Rowenhorst et al., Modelling Simul.
Mater. Sci. Eng. 23 (2015) 083501, with P = -1.
"""

from __future__ import annotations

import numpy as np

TURN = 2 * np.pi


def to_quaternions(euler: np.ndarray) -> np.ndarray:
    """Returns (n, 4) unit quaternions of (n, 3) Euler angles of Bunge in radians."""
    first, middle, last = (0.5 * euler).T
    total, difference = first + last, first - last
    found = np.stack([np.cos(middle) * np.cos(total), np.sin(middle) * np.cos(difference),
                      np.sin(middle) * np.sin(difference), np.cos(middle) * np.sin(total)], axis=1)
    return _with_positive_scalar(found)


def to_euler(quaternions: np.ndarray) -> np.ndarray:
    """Returns (n, 3) Euler angles of Bunge in radians, in [0, 2 pi), [0, pi], [0, 2 pi).

    Where the middle angle is 0 or pi, the last angle is 0."""
    w, x, y, z = quaternions.T
    along, across = np.hypot(w, z), np.hypot(x, y)
    middle = 2 * np.arctan2(across, along)
    total, difference = np.arctan2(z, w), np.arctan2(y, x)
    first, last = total + difference, total - difference
    flat, turned = across < 1e-12, along < 1e-12
    first = np.where(flat, 2 * total, np.where(turned, 2 * difference, first))
    last = np.where(flat | turned, 0.0, last)
    return np.stack([_wrapped(first), middle, _wrapped(last)], axis=1)


def to_axes(quaternions: np.ndarray) -> np.ndarray:
    """Returns (n, 3, 3): row i is axis i of the crystal in the coordinates of the sample."""
    w, x, y, z = quaternions.T
    rows = [[1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)],
            [2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)],
            [2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)]]
    return np.moveaxis(np.array(rows), -1, 0)


def normalized(quaternions: np.ndarray) -> np.ndarray:
    """Returns unit quaternions with w >= 0. Raises ValueError if one has no direction."""
    lengths = np.linalg.norm(quaternions, axis=1, keepdims=True)
    if not (lengths > 0).all():
        raise ValueError("The quaternion of row %d is 0." % np.flatnonzero(lengths <= 0)[0])
    return _with_positive_scalar(quaternions / lengths)


def _with_positive_scalar(quaternions: np.ndarray) -> np.ndarray:
    return np.where(quaternions[:, :1] < 0, -quaternions, quaternions) + 0.0


def _wrapped(angles: np.ndarray) -> np.ndarray:
    """Returns angles in [0, 2 pi)."""
    wrapped = np.mod(angles, TURN)
    return np.where(wrapped >= TURN, 0.0, wrapped)
