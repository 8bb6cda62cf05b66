"""The filters and the Python package make bitwise identical meshes and files.

Prints a line `case sha256` of the filter's mesh for each case of python/tests/digest_cases.py. The
environment variable VFM_PACKAGE_PYTHON names a Python that has the package. Its digests and files
must be the same; without the variable, the test only prints the lines.
"""

import os
import re
import subprocess
import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkRectilinearGrid
from vtkmodules.vtkCommonMath import vtkMatrix3x3
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
CASES_FOLDER = os.path.join(ROOT, "python", "tests")
sys.path[:0] = [os.path.join(ROOT, "Testing", "Python"), CASES_FOLDER]

from digest_cases import (  # noqa: E402: after the path
    CASES,
    ENDINGS,
    ORIGIN,
    SPACING,
    digest,
    path_of,
)
from vfmtest import (  # noqa: E402
    VolumeFractionToHex,
    VolumeFractionToTet,
    elements,
    in_folder,
    main,
    mesh_of,
    points_of,
    producer,
    simple,
)

ROLES = {"density": "DensityArrays", "velocity": "VelocityArray", "energy": "EnergyArray"}


def as_vtk(values):
    """Makes a VTK array of values (x, y, z) or (x, y, z, components)."""
    values = np.asarray(values)
    flat = values.transpose(2, 1, 0, *range(3, values.ndim)).reshape(-1, *values.shape[3:])
    return numpy_to_vtk(np.ascontiguousarray(flat), deep=1)


def grid_of(case):
    """Makes an image, or a rectilinear grid if the case has node coordinates."""
    cells = next(iter(case.arrays.values())).shape[:3]
    if case.nodes is None:
        grid = vtkImageData()
        grid.SetDimensions([n + 1 for n in cells])
        grid.SetOrigin(ORIGIN)
        grid.SetSpacing(SPACING)
        if case.direction is not None:
            matrix = vtkMatrix3x3()
            matrix.DeepCopy(np.ravel(case.direction).tolist())
            grid.SetDirectionMatrix(matrix)
    else:
        grid = vtkRectilinearGrid()
        grid.SetDimensions([n + 1 for n in cells])
        for axis, nodes in zip("XYZ", case.nodes):
            getattr(grid, "Set%sCoordinates" % axis)(numpy_to_vtk(nodes, deep=1))
    for name, values in case.arrays.items():
        array = as_vtk(values)
        array.SetName(name)
        grid.GetCellData().AddArray(array)
    return grid


def properties_of(case):
    """Returns the options as properties of the filter, such as Smoothing="Geometry Based"."""
    found = {}
    for name, value in case.options.items():
        if isinstance(value, str):
            value = value.replace("_", " ").title()
        found["".join(part.capitalize()
                      for part in name.split("_"))] = int(value) if value is True else value
    found["VolumeFractionArrays"], found["StateArrays"] = list(case.fractions), list(case.state)
    if case.labels:
        found["MaterialIdArray"] = case.labels
    for role, name in ROLES.items():
        if getattr(case, role):
            found[name] = [getattr(case, role)] if role == "density" else getattr(case, role)
    return found


def arrays_of(result, case):
    """Returns the arrays that digest() requires."""
    state = [*case.state, *filter(None, (case.density, case.velocity, case.energy))]
    points = result.mesh.GetPointData()
    nodal = (
        {case.velocity: vtk_to_numpy(points.GetArray(case.velocity))}
        if case.velocity and points.HasArray(case.velocity)
        else {}
    )
    return {
        "points": points_of(result),
        "cells": elements(result),
        "point_ids": result.points("GlobalPointIds"),
        "cell_ids": result.cells("GlobalCellIds"),
        "material": result.cells("MaterialId"),
        "fragment": result.cells("FragmentId"),
        "quality": result.cells("ScaledJacobian"),
        "state": {name: result.cells(name) for name in state},
        "point_state": nodal,
    }


def outer_environment():
    """Returns the environment without that of pvpython."""
    return {name: value for name, value in os.environ.items()
            if name not in ("PYTHONPATH", "PYTHONHOME", "LD_LIBRARY_PATH")}


def digests_of_the_package(folder):
    """Returns {case: digest of the package's mesh} and writes the meshes to files in `folder`.

    The result is empty if VFM_PACKAGE_PYTHON is not set.
    """
    python = os.environ.get("VFM_PACKAGE_PYTHON")
    if not python:
        return {}
    run = subprocess.run(
        [python, os.path.join(CASES_FOLDER, "digest_cases.py"), folder],
        env=outer_environment(),
        stdout=subprocess.PIPE,
        check=True,
        text=True,
    )
    return dict(line.rsplit(" ", 1) for line in run.stdout.splitlines())


def read_without_date(path):
    """Returns the bytes of a file, with zeros as date in the QA record of Exodus."""
    with open(path, "rb") as file:
        return re.sub(rb"\d{4}/\d\d/\d\d(\0+)\d\d:\d\d:\d\d", b"0000/00/00\\g<1>00:00:00",
                      file.read())


def read_folder(folder):
    """Returns {path: bytes} of all files in a folder, without dates."""
    paths = [os.path.join(path, name) for path, _, names in os.walk(folder) for name in names]
    return {os.path.relpath(path, folder): read_without_date(path) for path in paths}


def files_differ(mesh, name, folder):
    """Returns the case and the formats in which files of the package and of the plugin differ."""
    found = []
    for ending in ENDINGS:
        path, other = (path_of(folder, part, ending) for part in (name + " of the plugin", name))
        os.makedirs(os.path.dirname(path))
        simple.SaveData(path, proxy=producer(mesh))
        files = read_folder(os.path.dirname(path))
        if not files or files != read_folder(os.path.dirname(other)):
            found.append("%s .%s" % (name, ending))
    return found


def with_drops():
    """Returns a case of which two cells become particles."""
    case = CASES["hexes, state conserved"]()
    case.arrays["ball"][0, 0, -1], case.arrays["ball"][-1, -1, -1] = 0.1, 0.11
    return case


@in_folder
def test_particles(at):
    """Files with particles are those of sculptor, of which the package reads the same grid."""
    python = os.environ.get("VFM_PACKAGE_PYTHON")
    if not python:
        return
    writer = vtkXMLImageDataWriter()
    writer.SetFileName(at("drops.vti"))
    writer.SetInputData(grid_of(with_drops()))
    writer.Write()
    roles = [word for role in ("density", "velocity", "energy") for word in ("--" + role, role)]
    given = {"package": [python, "-m", "volume_fraction_mesh", at("drops.vti")],
             "sculptor": [os.environ["VFM_SCULPTOR"], at("drops.vti")]}
    options = {"package": ["--array", "ball", "--array", "plate", "--unmeshed-material",
                           "particles", "--state", "code", *roles],
               "sculptor": ["--fractions", "ball,plate", "--unmeshed", "Particles", "--state",
                            "code", *roles]}
    for ending in (*ENDINGS, "data", "vtu", "stl"):
        files = {}
        for program, words in given.items():
            path = path_of(at(program), "drops", ending)
            os.makedirs(os.path.dirname(path))
            subprocess.run([*words, path, *options[program], "--quiet"], env=outer_environment(),
                           check=True)
            files[program] = read_folder(os.path.dirname(path))
        assert files["package"] == files["sculptor"], ending
        assert files["package"], ending


@in_folder
def test_same_bits(at):
    """Meshes and files of all cases are identical."""
    expected, others = digests_of_the_package(at("")), []
    for name, make in CASES.items():
        case = make()
        result = mesh_of(
            grid_of(case), VolumeFractionToTet if case.tets else VolumeFractionToHex,
            **properties_of(case)
        )
        found = digest(arrays_of(result, case))
        print(name, found, flush=True)
        if expected and expected[name] != found:
            others.append(name)
        if expected:
            others += files_differ(result.mesh, name, at(""))
    assert not others, "the package makes other meshes or files: %s" % others


main(globals())
