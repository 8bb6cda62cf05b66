"""Writes tables of grains for solvers: Abaqus and CalculiX, DAMASK, MOOSE."""

from __future__ import annotations

import re
from typing import Any, Callable, Dict, List

import numpy as np

from .grain_table import GrainTable

MOOSE_HEADER = ("# Euler angles of Bunge in degrees and a weight, one row per grain",
                "# row k: grain k", "# volume_fraction_mesh", "# phi1 Phi phi2 weight")


def abaqus_lines(grains: GrainTable) -> List[str]:
    """Returns an *ORIENTATION and a *SOLID SECTION for each grain. Sets of elements have the names
    of Mesh.save, materials those of the phases."""
    lines = ["** Orientations and sections of %d grains, after the mesh" % len(grains)]
    names = abaqus_materials(grains)
    for number, phase, axes in zip(grains.ids, grains.phases, grains.axes()):
        values = [repr(float("%.15f" % value) + 0.0) for value in axes[:2].ravel()]
        lines += ["*ORIENTATION, NAME=GRAIN_%d, SYSTEM=RECTANGULAR" % number, ", ".join(values),
                  "*SOLID SECTION, ELSET=EB%d, MATERIAL=%s, ORIENTATION=GRAIN_%d"
                  % (number, names[int(phase)], number)]
    return lines


def abaqus_materials(grains: GrainTable) -> Dict[int, str]:
    """Returns the material of each phase: its name in capitals, unique."""
    names: Dict[int, str] = {}
    for phase, name in grains.phase_names.items():
        clean = re.sub("[^A-Z0-9]+", "_", name.upper()).strip("_")
        clean = clean if re.match("[A-Z]", clean) else "S_" + clean
        names[phase] = clean if clean not in names.values() else "%s_%d" % (clean, phase)
    return names


def damask_lines(grains: GrainTable) -> List[str]:
    """Returns material.yaml of DAMASK. Cells of a mesh with number k have the entry k, from 0, so
    numbers without a grain, such as 0, have an entry that no cell uses."""
    lines = ["homogenization:", "  SX:", "    N_constituents: 1",
             "    mechanical: {type: pass}", "phase:"]
    lines += ["  %s: null" % _quoted(name) for name in grains.phase_names.values()]
    lines += ["material:"]
    quaternions, phases = np.zeros((grains.ids.max() + 1, 4)), np.zeros(grains.ids.max() + 1, int)
    quaternions[:, 0], phases[:] = 1, grains.phases[0]
    quaternions[grains.ids], phases[grains.ids] = grains.quaternions, grains.phases
    for phase, quaternion in zip(phases, quaternions):
        lines += ["  - homogenization: SX", "    constituents:",
                  "      - phase: %s" % _quoted(grains.phase_names[int(phase)]),
                  "        v: 1.0", "        O: [%s]" % _numbers(quaternion)]
    return lines


def moose_lines(grains: GrainTable) -> List[str]:
    """Returns the file of EulerAngleFileReader of MOOSE, which skips four lines."""
    return [*MOOSE_HEADER, *("%s 1" % _numbers(row, " ") for row in _rows_by_id(grains))]


def moose_table_lines(grains: GrainTable) -> List[str]:
    """Returns the file of PropertyReadFile of MOOSE for blocks from 1."""
    return [_numbers(row) for row in _rows_by_id(grains)]


def _rows_by_id(grains: GrainTable) -> np.ndarray:
    """Returns angles in degrees: row k - 1 is that of grain k, or 0 if there is none."""
    rows = np.zeros((grains.ids.max(), 3))
    rows[grains.ids - 1] = np.degrees(grains.euler_angles)
    return rows


def _quoted(name: str) -> str:
    return "'%s'" % name.replace("'", "''")


def _numbers(values: Any, between: str = ", ") -> str:
    return between.join(repr(float(value)) for value in values)


WRITERS: Dict[str, Callable[[GrainTable], List[str]]] = {
    ".inp": abaqus_lines, ".yaml": damask_lines, ".txt": moose_lines, ".csv": moose_table_lines}
