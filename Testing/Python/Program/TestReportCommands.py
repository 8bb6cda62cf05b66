"""Each command in appendix B of Sculptor's report, and the equivalent command of this project.

Documentation/validation/sculptor-report.md has the same table. A row of COMMANDS
holds the report's command, the equivalent after the word sculptor, and a check of
its result; only the equivalent runs. The file impact.spcth is in Data;
cube_mesh.exo.1.0 is an Exodus file of hexahedra with element variables at two times.
"""
import os
import shutil
import tempfile

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import VTK_HEXAHEDRON, VTK_TETRA
from vtkmodules.vtkIOXML import vtkXMLMultiBlockDataReader

from compare_meshes import difference, merge, read_pieces
from exodus_grids import TIMES, fields, hexes, shuffled, write_exodus
from sculptor_program import rows, sculptor
from vfmtest import hex_volumes, main, tet_volumes

DATA = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..", "Data")
FOLDER = tempfile.mkdtemp()
CELL = 1 / 32  # cell width of impact.spcth


class Mesh:
    """The mesh that a command wrote."""

    def __init__(self, path):
        self.piece = read_pieces(path)[0]
        self.points = vtk_to_numpy(self.piece.GetPoints().GetData())
        self.kind = self.piece.GetCellType(0)
        corners = vtk_to_numpy(self.piece.GetCells().GetConnectivityArray())
        self.elements = corners.reshape(-1, 4 if self.kind == VTK_TETRA else 8)
        measure = tet_volumes if self.kind == VTK_TETRA else hex_volumes
        self.volumes = measure(self.points, self.elements)
        self.materials = set(vtk_to_numpy(self.piece.GetCellData().GetArray("MaterialId")).tolist())

    def field(self, name):
        return self.piece.GetFieldData().GetArray(name).GetTuple1(0)

    def is_that_of(self, other):
        return not difference(merge([self.piece]), merge([other.piece]))


def mesh_of(words):
    """Returns the mesh of a command that writes out.vtu."""
    run(words)
    return Mesh(os.path.join(FOLDER, "out.vtu"))


def run(words, ranks=1):
    result = sculptor(*words.split(), ranks=ranks, folder=FOLDER)
    other = [line for line in result.stderr.splitlines()
             if "misses its volume" not in line and "in another place" not in line]
    assert result.returncode == 0 and not other, (words, result)
    return result.stdout


def lists(*expected):
    """Returns a check of the listed materials, ids and times."""
    def check(words):
        out = run(words)
        assert run(words, ranks=2) == out
        for line in expected:
            assert line in [" ".join(row.split()) for row in out.splitlines()], (line, out)
    return check


def meshes(kind=VTK_HEXAHEDRON, material=1, least=0.0, same_as=None, other_than=None):
    """Returns a check of elements of one kind and material.

    Each element is larger than `least`; together they have the reported volume of the material. The
    mesh is equal to, or differs from, the mesh of another command.
    """
    def check(words):
        mesh = mesh_of(words)
        assert mesh.kind == kind and len(mesh.elements) > 100 and mesh.materials == {material}, (
            words, mesh.materials)
        assert mesh.volumes.min() > least, (words, mesh.volumes.min())
        assert np.isclose(mesh.volumes.sum(),
                          mesh.piece.GetFieldData().GetArray("MeshVolume").GetValue(material - 1),
                          rtol=1e-9)
        if same_as:
            assert mesh.is_that_of(mesh_of(same_as)), words
        if other_than:
            assert not mesh.is_that_of(mesh_of(other_than)), words
    return check


def steps(words):
    """Checks that each element is a whole cell."""
    mesh = mesh_of(words)
    assert mesh.materials == {1} and len(mesh.elements) > 100 and np.allclose(
        mesh.volumes, CELL ** 3, rtol=1e-5)


def at_time(time):
    def check(words):
        mesh = mesh_of(words)
        assert mesh.piece.GetFieldData().GetArray("TimeValue").GetTuple1(0) == time
        target = fields(TIMES.index(time))["MAT_10"].sum() * 0.25 * 0.25 * 0.5
        assert np.isclose(mesh.volumes.sum(), target, rtol=1e-5), (mesh.volumes.sum(), target)
    return check


def bounds(words):
    """Checks that there are surfaces, curves where they meet, and no vertices."""
    run(words)
    reader = vtkXMLMultiBlockDataReader()
    reader.SetFileName(os.path.join(FOLDER, "geometry.vtm"))
    reader.Update()
    blocks = reader.GetOutput()
    cells = {blocks.GetMetaData(b).Get(blocks.NAME()): blocks.GetBlock(b).GetNumberOfCells()
             for b in range(blocks.GetNumberOfBlocks())}
    assert cells["Surfaces"] > 100 and cells["Curves"] > 10, cells


def passes(elements=None, kind=None):
    """Returns a check of the built-in test on 1, 2 and 4 ranks.

    All runs print PASS and equal numbers. `elements` is
    the number of elements in box 2, which stays unrefined.
    """
    def check(words):
        outputs = [run(words, ranks) for ranks in (1, 2, 4)]
        assert all(out.endswith("\nPASS\n") and "WRONG" not in out for out in outputs), outputs
        assert "--tetmesh" in words or len(set(outputs)) == 1, outputs
        refined = outputs[0].split("\nChosen cells refined\n")[-1]
        assert elements is None or rows(refined)["2 of material 1"][0] == elements
        if kind:
            assert mesh_of(words + " --output out.vtu").kind == kind
    return check


IMPACT, PLAIN = "impact.spcth out.vtu --step 3", "impact.spcth out.vtu --step 3 --material 1"
COMMANDS = [
    ('import volume fraction "impact.spcth"', "--list impact.spcth",
     lists("1 Material volume fraction - 1", "2 Material volume fraction - 2", "4 times")),
    ('import volume fraction "cube_mesh.exo.1.0" variable "MAT_10"',
     "cube_mesh.exo.1.0 out.vtu --fractions MAT_10", at_time(0.5)),
    ('import volume fraction "cube_mesh.exo.1.0" variable "MAT_10" time 2.0',
     "cube_mesh.exo.1.0 out.vtu --fractions MAT_10 --time 2.0", at_time(2.0)),
    ("mesh volume fraction", PLAIN, meshes()),
    ("mesh volume fraction material 2", IMPACT + " --material 2", meshes(material=2)),
    ("mesh volume fraction stairstep", PLAIN + " --stairstep", steps),
    ("mesh volume fraction no_smooth", PLAIN + " --no-smooth", meshes(other_than=PLAIN)),
    ("mesh volume fraction smooth 0", PLAIN + " --smooth 0",
     meshes(same_as=PLAIN + " --no-smooth")),
    ("mesh volume fraction smooth 1", PLAIN + " --smooth 1", meshes(same_as=PLAIN)),
    ("mesh volume fraction smooth 2", PLAIN + " --smooth 2", meshes(other_than=PLAIN)),
    ("mesh volume fraction tetmesh", PLAIN + " --tetmesh Lattice", meshes(VTK_TETRA)),
    ("mesh volume fraction material 2 smooth 2 tetmesh",
     IMPACT + " --material 2 --smooth 2 --tetmesh Lattice", meshes(VTK_TETRA, 2)),
    ("mesh volume fraction test", "test", passes(432, VTK_HEXAHEDRON)),
    ("mesh volume fraction test tetmesh", "test --tetmesh", passes(kind=VTK_TETRA)),
    ("mesh volume fraction test no_smooth", "test --no-smooth", passes(432, VTK_HEXAHEDRON)),
    ("mesh volume fraction test tetmesh no_smooth", "test --tetmesh --no-smooth",
     passes(kind=VTK_TETRA)),
    ("set sculpt refine on; mesh volume fraction test", "test --refine-cells",
     passes(432, VTK_HEXAHEDRON)),
    ("create mesh geom hex all feature 0", IMPACT + " --geometry geometry.vtm", bounds),
    ("create mesh geom tet all feature 0", IMPACT + " --tetmesh Lattice --geometry geometry.vtm",
     bounds),
]


def make_files():
    shutil.copy(os.path.join(DATA, "impact.spcth"), FOLDER)
    shutil.copytree(os.path.join(DATA, "impact"), os.path.join(FOLDER, "impact"))
    cells = shuffled()
    path = write_exodus(os.path.join(FOLDER, "cube.exo"),
                        lambda step: {"cube": hexes(fields(step), cells)})
    shutil.move(path, os.path.join(FOLDER, "cube_mesh.exo.1.0"))


def test_commands_are_on_the_page():
    with open(os.path.join(DATA, "..", "Documentation", "validation",
                           "sculptor-report.md"), encoding="utf-8") as file:
        page = file.read().splitlines()
    for command, ours, _ in COMMANDS:
        assert "| `%s` | `sculptor %s` |" % (command, ours) in page, (command, ours)


def test_commands():
    make_files()
    try:
        for command, ours, check in COMMANDS:
            print("%-75s sculptor %s" % (command, ours), flush=True)
            check(ours)
    finally:
        shutil.rmtree(FOLDER)


main(globals())
