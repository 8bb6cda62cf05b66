"""Exact volumes and centroids of hexahedra (trilinear) and tetrahedra, in numpy."""

from __future__ import annotations

from typing import Tuple

import numpy as np

GAUSS = 1 / np.sqrt(3)  # exact to degree 3, as the integrands are
SIGNS = np.array(
    [[-1, -1, -1], [1, -1, -1], [1, 1, -1], [-1, 1, -1], [-1, -1, 1], [1, -1, 1], [1, 1, 1], [-1, 1, 1]], dtype=float
)
CHUNK = 1 << 16  # elements at a time


def element_moments(points: np.ndarray, cells: np.ndarray) -> Tuple[np.ndarray, np.ndarray]:
    """The volume (n,) of each element, and the integral of the position over it (n, 3)."""
    volumes, moments = np.empty(len(cells)), np.empty((len(cells), 3))
    find = _of_tets if cells.shape[1] == 4 else _of_hexes
    for first in range(0, len(cells), CHUNK):
        part = slice(first, first + CHUNK)
        volumes[part], moments[part] = find(points[cells[part]])
    return volumes, moments


def _triple(a: np.ndarray, b: np.ndarray, c: np.ndarray) -> np.ndarray:
    return np.einsum("ij,ij->i", a, np.cross(b, c))


def _of_tets(corners: np.ndarray) -> Tuple[np.ndarray, np.ndarray]:
    edges = corners[:, 1:] - corners[:, :1]
    volumes = _triple(edges[:, 0], edges[:, 1], edges[:, 2]) / 6
    return volumes, volumes[:, None] * corners.mean(axis=1)


def _of_hexes(corners: np.ndarray) -> Tuple[np.ndarray, np.ndarray]:
    volumes, moments = np.zeros(len(corners)), np.zeros((len(corners), 3))
    for at in GAUSS * SIGNS:
        factors = 1 + SIGNS * at  # of each corner along each axis
        shape = factors.prod(axis=1) / 8
        slopes = [SIGNS[:, a] * factors[:, (a + 1) % 3] * factors[:, (a + 2) % 3] / 8 for a in range(3)]
        determinant = _triple(*(np.einsum("c,ncx->nx", slope, corners) for slope in slopes))
        volumes += determinant
        moments += determinant[:, None] * np.einsum("c,ncx->nx", shape, corners)
    return volumes, moments
