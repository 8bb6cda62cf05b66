"""Writes a quality report of a mesh."""

from __future__ import annotations

import os
from typing import Any, Dict

from . import _core
from ._data import MeshData
from ._input import Field
from ._tables import core_arrays, core_fields

ENDINGS = (".html", ".htm")


def report(mesh: MeshData, path: Any, title: str) -> None:
    """Implements Mesh.report."""
    path = os.fspath(path)
    if os.path.splitext(path)[1].lower() not in ENDINGS:
        raise ValueError("The report %r has an unknown ending: give .html or .htm." % path)
    _core.write_report(
        path,
        *core_arrays(mesh),
        fields=core_fields(mesh.fields),
        materials=core_fields(mesh.materials),
        title=title,
        facts=list(mesh.run.source.items()),
        options=[(name, str(value)) for name, value in mesh.run.options.items()],
        warnings=mesh.run.warnings,
    )


def describe(field: Field) -> Dict[str, str]:
    """Returns the input of a run for its report."""
    if field.blocks is not None:
        place = {"File": field.blocks.path, "Blocks": str(len(field.blocks))}
    else:
        counts = " x ".join(str(len(nodes) - 1) for nodes in field.grid.nodes)
        place = {"Grid": "%s %s" % (counts, "points" if field.grid.are_points else "cells")}
    kind = "labels" if field.labels else "%d arrays of volume fractions" % len(field.fractions)
    return {**place, "Materials from": kind}
