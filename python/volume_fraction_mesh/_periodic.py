"""Pairs of points on opposite sides of a periodic mesh."""

from __future__ import annotations

from typing import Tuple

import numpy as np

from ._data import MeshData


def pairs(mesh: MeshData) -> Tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Implements Mesh.periodic_pairs."""
    if mesh.partner is None:
        raise ValueError("The mesh has no copies of points: make it with periodic, and with "
                         "periodic_sides flat or free.")
    copies = np.flatnonzero(mesh.partner != mesh.point_ids)
    partners = np.searchsorted(mesh.point_ids, mesh.partner[copies])
    steps = mesh.points[copies] - mesh.points[partners]
    if "DomainFrame" in mesh.fields:
        steps = steps @ np.reshape(mesh.fields["DomainFrame"][:9], (3, 3))
    lengths = np.asarray(mesh.fields["PeriodLengths"])
    periods = np.rint(steps / np.where(lengths > 0, lengths, np.inf)).astype(np.int64)
    return copies, partners, periods
