"""Writes meshes in the legacy format of VTK, version 4.2, which most readers support."""

from __future__ import annotations

from typing import IO, Any, Mapping
from urllib.parse import quote

import numpy as np

from ._data import MeshData
from ._convert.to_pyvista import TYPES as CELL_TYPES, all_nodes, cell_arrays, point_arrays
from ._tables import material_tags

TYPES = {"f4": "float", "f8": "double", "i1": "char", "u1": "unsigned_char", "i2": "short",
         "u2": "unsigned_short", "i4": "int", "u4": "unsigned_int", "i8": "long",
         "u8": "unsigned_long"}


def write(mesh: MeshData, file: IO[bytes], binary: bool = False) -> None:
    """Writes a mesh without the fields of the whole mesh. The first array is `material`."""

    def head(text: str, *values: Any) -> None:
        file.write((text % values + "\n").encode("ascii"))

    def body(values: np.ndarray) -> None:
        if binary:
            file.write(values.astype(values.dtype.newbyteorder(">")).tobytes() + b"\n")
        else:
            columns = [map(repr, column.tolist()) for column in values.reshape(len(values), -1).T]
            file.write(("\n".join(map(" ".join, zip(*columns))) + "\n").encode("ascii"))

    def fields(arrays: Mapping[str, np.ndarray]) -> None:
        head("FIELD FieldData %d", len(arrays))
        for name, values in arrays.items():
            head("%s %d %d %s", quote(name), values[:1].size or 1, len(values),
                 TYPES[values.dtype.str[1:]])
            body(values)

    head("# vtk DataFile Version 4.2\nvolume_fraction_mesh\n%s", "BINARY" if binary else "ASCII")
    head("DATASET UNSTRUCTURED_GRID\nPOINTS %d double", len(mesh.points))
    body(mesh.points)
    cells = all_nodes(mesh)
    count, nodes = cells.shape
    head("CELLS %d %d", count, count * (nodes + 1))
    body(np.column_stack([np.full(count, nodes), cells]).astype(np.int32))
    head("CELL_TYPES %d", count)
    body(np.full(count, CELL_TYPES[mesh.kind], np.int32))
    head("CELL_DATA %d\nSCALARS material int 1\nLOOKUP_TABLE default", count)
    tags = material_tags(mesh)
    body(np.array([tags[i] for i in mesh.material.tolist()], np.int32))
    fields(cell_arrays(mesh))
    head("POINT_DATA %d", len(mesh.points))
    fields(point_arrays(mesh))
