"""Writes a mesh to a file, in the format of its ending."""

from __future__ import annotations

import os
import warnings
from importlib.util import find_spec
from typing import Any, Optional

from . import _core, _npz, _vtk
from ._convert import to_meshio, to_pyvista
from ._data import MeshData
from ._output import whole_file
from ._tables import core_arrays, core_fields, core_particles
from ._warning import VolumeFractionMeshWarning

BY_CORE = dict(_core.list_formats())  # options by ending
BY_PACKAGE = {".npz": _npz.write, ".vtk": _vtk.write}
# Formats in which meshio 5.3.5 writes hexahedra and tetrahedra with their materials.
BY_MESHIO = (".avs", ".f3grid", ".hmf", ".med", ".mesh", ".meshb", ".vol", ".xmf")


def save(mesh: MeshData, path: Any, **options: Any) -> None:
    """Implements Mesh.save."""
    path = os.fspath(path)
    suffix = os.path.splitext(path)[1].lower()
    _check_suffix(path, suffix)
    if suffix in BY_CORE:
        _warn_of_particles(path, _save_by_core(mesh, path, suffix, **options))
        return
    beside = os.path.splitext(path)[0] + "_particles.vtp"
    with whole_file(path) as unfinished:
        if suffix in BY_PACKAGE:
            with open(unfinished, "wb") as file:
                BY_PACKAGE[suffix](mesh, file, **options)
        elif suffix == ".vtp":
            to_pyvista.convert(mesh, "surfaces").save(unfinished, **options)
        else:
            _save_by_meshio(mesh, unfinished, suffix, **options)
        if mesh.particles and suffix != ".npz":
            _write(mesh, os.path.splitext(unfinished)[0] + "_particles.vtp")
    has_particles = len(mesh.particles.get("Id", ())) > 0
    _warn_of_particles(path, beside if has_particles and suffix != ".npz" else "")


def _warn_of_particles(path: str, beside: str) -> None:
    """Warns that the particles are in a file beside the mesh, if they are."""
    if beside:
        warnings.warn("Files as %s hold no particles: they are in %s." % (path, beside),
                      VolumeFractionMeshWarning, stacklevel=4)


def _check_suffix(path: str, suffix: str) -> None:
    """Raises ValueError if the ending does not select a format that holds the mesh."""
    formats = ", ".join((*BY_CORE, *BY_PACKAGE, ".vtp", *BY_MESHIO))
    if not suffix:
        raise ValueError("%r has no ending to select the format. Supported: %s." % (path, formats))
    if suffix in (*BY_CORE, *BY_PACKAGE, ".vtp"):
        return
    if suffix not in BY_MESHIO:
        raise ValueError("%r: the ending %s is not supported, because no writer keeps the elements "
                         "and their materials in such a file. Supported: %s."
                         % (path, suffix, formats))
    if not find_spec("meshio"):
        raise ImportError("Writing %s requires meshio: pip install meshio" % path)


def _save_by_core(mesh: MeshData, path: str, suffix: str, **options: Any) -> str:
    unknown = set(options) - set(BY_CORE[suffix])
    if unknown:
        raise TypeError("%s is not an option of %s." % (", ".join(sorted(unknown)), suffix))
    return _write(mesh, path, **options)


def _write(mesh: MeshData, path: str, time: Optional[float] = None, texts: bool = True,
           version: Optional[str] = None, binary: bool = False,
           interfaces: bool = True, reduced: bool = False, plane: str = "strain",
           polyhedra: bool = False) -> str:
    fields = core_fields(mesh.fields)
    return _core.write_mesh(
        path,
        *core_arrays(mesh),
        {name: values for name, values in fields.items() if texts or not isinstance(values, list)},
        core_particles(mesh),
        time,
        "" if version is None else str(version),
        binary,
        interfaces,
        reduced,
        plane,
        polyhedra,
    )


def _save_by_meshio(mesh: MeshData, path: str, suffix: str, **options: Any) -> None:
    import meshio

    meshio.write(path, to_meshio.convert(mesh, False), **options)
