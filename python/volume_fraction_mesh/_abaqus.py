"""Input files of Abaqus and CalculiX: nodes, elements in a set a material, and a set of nodes a surface."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any, Dict, Iterable, TextIO

import numpy as np

if TYPE_CHECKING:
    from .mesh import Mesh

TYPES = {"hexahedron": "C3D8", "tetra": "C3D4"}
PER_LINE = 12  # ids; 16 are allowed


def write(mesh: Mesh, path: str) -> None:
    """Nodes and elements are numbered from 1 in the order of the mesh."""
    with open(path, "w", encoding="ascii") as file:
        file.write("*HEADING\n%r\n*NODE, NSET=NALL\n" % mesh)
        lines = (", ".join([str(n + 1), *map(number, x)]) for n, x in enumerate(mesh.points.tolist()))
        file.writelines(line + "\n" for line in lines)
        for label, name in set_names(mesh).items():
            own = np.flatnonzero(mesh.material == label)
            if len(own):
                file.write("*ELEMENT, TYPE=%s, ELSET=%s\n" % (TYPES[mesh.kind], name))
                rows = np.column_stack([own, mesh.cells[own]]) + 1
                file.writelines(", ".join(map(str, row)) + "\n" for row in rows.tolist())
        for surface in range(1, mesh.surfaces.surface_id.max(initial=0) + 1):
            facets = mesh.surfaces.cells[mesh.surfaces.surface_id == surface]
            file.write("*NSET, NSET=SURFACE_%d\n" % surface)
            _write_ids(file, np.unique(facets) + 1)


def number(value: float) -> str:
    """In 20 characters: Abaqus and CalculiX drop the others."""
    text = repr(value)
    return text if len(text) <= 20 else "%.13g" % value


def set_names(mesh: Mesh) -> Dict[int, str]:
    """Of the materials by their ids, as the plugin has them: capitals, letters and digits, each once."""
    names: Dict[int, str] = {}
    for label, name in zip(mesh.materials["MaterialId"], mesh.materials["Name"]):
        clean = re.sub(r"[^A-Za-z0-9]+", "_", name).strip("_").upper()
        clean = unique = (clean if clean[:1].isalpha() else "S_" + clean)[:70]
        count = 1
        while unique in names.values():
            count += 1
            unique = "%s_%d" % (clean, count)
        names[int(label)] = unique
    return names


def _write_ids(file: TextIO, ids: Iterable[Any]) -> None:
    words = [str(i) for i in ids]
    for first in range(0, len(words), PER_LINE):
        file.write(", ".join(words[first : first + PER_LINE]) + ",\n")  # the last comma is for lines of one
