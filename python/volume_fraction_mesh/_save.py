"""Files of a mesh, by their endings."""

from __future__ import annotations

import os
from importlib.util import find_spec
from typing import TYPE_CHECKING, Any

from ._abaqus import write as write_abaqus

if TYPE_CHECKING:
    from .mesh import Mesh

EXODUS = (".e", ".ex2", ".exo")


def save(mesh: Mesh, path: Any, **options: Any) -> None:
    """See Mesh.save."""
    path = os.fspath(path)
    suffix = os.path.splitext(path)[1].lower()
    if not suffix:
        raise ValueError(
            "%r has no ending, which would tell what kind of file to write: .vtu, .e, .inp, .msh .." % path
        )
    if suffix in (".vtu", ".vtk") and find_spec("pyvista"):
        mesh.to_pyvista().save(path, **options)
    elif suffix == ".vtp":
        mesh.to_pyvista("surfaces").save(path, **options)
    elif suffix == ".inp":
        write_abaqus(mesh, path, **options)
    elif find_spec("meshio"):
        _save_by_meshio(mesh, path, suffix, **options)
    else:
        raise ImportError(
            "%s is written by %s: pip install %s"
            % (path, *(["PyVista or meshio", "meshio"] if suffix == ".vtu" else ["meshio"] * 2))
        )


def _save_by_meshio(mesh: Mesh, path: str, suffix: str, **options: Any) -> None:
    import meshio

    from ._meshio import for_gmsh

    if suffix not in meshio.extension_to_filetypes:
        raise ValueError("%r: no files with the ending %s are written." % (path, suffix))

    if suffix == ".msh":
        data = for_gmsh(mesh)
        options = {"file_format": "gmsh22", **options}
    elif suffix in EXODUS:
        data = mesh.to_meshio(blocks=True)
        options = {"file_format": "exodus", **options}
    else:
        data = mesh.to_meshio()
    meshio.write(path, data, **options)
