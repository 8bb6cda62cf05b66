"""Splits interfaces of a mesh, cuts it into layers, and groups its elements in bins."""

from __future__ import annotations

import operator
import warnings
from dataclasses import replace
from typing import Any, Dict, List, Mapping, Optional, Sequence, TypeVar, Union

import numpy as np

from . import _core
from ._data import MeshData
from ._facets import material_id
from ._result import data_of
from ._tables import core_arrays, core_fields
from ._warning import VolumeFractionMeshWarning

MeshType = TypeVar("MeshType", bound=MeshData)
BIN_ID = "BinId"  # name of the array with the bin of each element
BIN_LAW = ("BinDensity", "BinModulus", "BinPoisson")  # columns of a table of bins with a law
CALLER = 3  # stack level of the caller of Mesh.split(), for warnings


def modify(mesh: MeshType, extensive: Sequence[str] = (), **options: Any) -> MeshType:
    """Implements Mesh.split and Mesh.cut_layers. options: names and values of hexes()."""
    chosen = _core.Options(False, **options)
    told: List[str] = []
    result = _core.modify_mesh(*core_arrays(mesh), core_fields(mesh.fields),
                               _arrays_of(mesh.surfaces), _arrays_of(mesh.curves),
                               list(extensive), chosen, told.append)
    for text in told:
        warnings.warn(text, VolumeFractionMeshWarning, stacklevel=CALLER)
    point_state = result.pop("point_state")
    # Points keep their numbers, and the geometry its tables.
    result.update(vertices={"points": mesh.vertices.points, "vertex_id": mesh.vertices.vertex_id},
                  surface_fields=mesh.surfaces.fields, curve_fields=mesh.curves.fields,
                  vertex_fields=mesh.vertices.fields, particles=mesh.particles,
                  materials=_update(mesh.materials, result["materials"]))
    run = replace(mesh.run, options={**mesh.run.options, **chosen.changed()},
                  warnings=mesh.run.warnings + told)
    data = data_of(result, mesh.roles, run)
    return replace(mesh, **{**data, "point_state": point_state})


def bin_materials(mesh: MeshType, array: str, count: int, law: Sequence[Optional[float]],
                  materials: Union[int, str, Sequence[Union[int, str]]]) -> MeshType:
    """Implements Mesh.bin_materials. law: a, b, Poisson's ratio, c0, c1; none if a is None."""
    chosen = [materials] if isinstance(materials, (int, str)) else materials
    ids, table = _core.bin_materials(
        *core_arrays(mesh), core_fields(mesh.fields), array, operator.index(count),
        [material_id(mesh, material) for material in chosen],
        None if law[0] is None else [float(number) for number in law])
    kept = {name: values for name, values in mesh.fields.items()
            if name not in table and name not in BIN_LAW}
    return replace(mesh, state={**mesh.state, BIN_ID: ids}, fields={**kept, **table})


def _arrays_of(geometry: Any) -> Dict[str, np.ndarray]:
    return {name: np.ascontiguousarray(values) for name, values in vars(geometry).items()
            if name != "fields"}


def _update(materials: Mapping[str, Any], columns: Mapping[str, Any]) -> Dict[str, Any]:
    """Returns the table of materials with the columns that layers change."""
    updated = dict(materials)
    if columns:
        rows = np.searchsorted(columns["MaterialId"], materials["MaterialId"])
        found = np.append(columns["MaterialId"], -1)[rows] == materials["MaterialId"]
        for name in updated.keys() & columns.keys() - {"MaterialId"}:
            updated[name] = np.where(found, np.append(columns[name], 0)[rows], 0)
    return updated
