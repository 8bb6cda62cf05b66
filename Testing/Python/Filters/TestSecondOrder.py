"""Second-order elements: cells of VTK, and files with their nodes."""
import os

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkHexahedron, vtkTetra

from compare_meshes import read_pieces
from sculptor_program import mesh_file, refused
from vfmtest import (
    collect, exodus_parts, fraction_image, held_class, in_folder, main, mesh_of, producer,
    servermanager, write as write_data, VolumeFractionToTet)

DATA = fraction_image()
TETS = {"make": VolumeFractionToTet, "Method": "Lattice"}
KINDS = [({"ElementOrder": "Quadratic"}, 25, 20), ({"ElementOrder": "Quadratic27"}, 29, 27),
         ({**TETS, "ElementOrder": "Quadratic"}, 24, 10),
         ({**TETS, "ElementOrder": "Quadratic27"}, 24, 10)]


def curved(kind):
    return mesh_of(DATA, **kind)


def nodes_of(grid):
    """Returns the points of the cells (cells, nodes, 3), all of one type."""
    cells = vtk_to_numpy(grid.GetCells().GetConnectivityArray())
    points = vtk_to_numpy(grid.GetPoints().GetData())
    return points[cells.reshape(grid.GetNumberOfCells(), -1)]


def test_numbering_of_vtk():
    """Straight edges have their mid node where VTK's shape functions have it."""
    for kind, cell_type, count in KINDS:
        grid = curved(kind).mesh
        assert {grid.GetCellType(i) for i in range(grid.GetNumberOfCells())} == {cell_type}
        nodes = nodes_of(grid)
        assert nodes.shape[1] == count
        cell = grid.GetCell(0)
        linear = vtkTetra() if count == 10 else vtkHexahedron()
        corners = linear.GetNumberOfPoints()
        places = np.reshape([cell.GetParametricCoords()[i] for i in range(3 * count)], (-1, 3))
        cells = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, count)
        inside = vtk_to_numpy(grid.GetPointData().GetArray("GeometryDimension"))[cells] == 3
        edges = 12 if corners == 8 else 6
        for i in range(corners, count):
            weights = [0.0] * corners
            linear.InterpolateFunctions(list(places[i]), weights)
            straight = np.tensordot(nodes[:, :corners], weights, axes=(1, 0))
            off = np.linalg.norm(nodes[:, i] - straight, axis=1)
            assert off.max() < 0.1, (kind, i, off.max())
            if i < corners + edges:
                assert off[inside[:, i]].max() < 1e-12, (kind, i)


@in_folder
def test_exodus_is_read_by_vtk(at):
    for kind, cell_type, _ in KINDS:
        result = curved(kind)
        writer = servermanager.writers.VolumeFractionExodusWriter(
            Input=producer(result.mesh), FileName=at("mesh.e"))
        errors, _ = collect(held_class(writer))
        writer.UpdatePipeline()
        assert not errors, errors
        materials = vtk_to_numpy(result.mesh.GetCellData().GetArray("MaterialId"))
        nodes = nodes_of(result.mesh)
        blocks = [part for _, part in exodus_parts(at("mesh.e"))
                  if part.GetCellType(0) == cell_type]
        assert len(blocks) == 2
        for material, block in zip((1, 2), blocks):
            assert np.array_equal(nodes_of(block), nodes[materials == material]), kind


@in_folder
def test_files_of_sculptor(at):
    """VTK reads the nodes of the filter from a .vtu. HEX27 is not in Abaqus files."""
    path = write_data(DATA, at("in.vti"))
    for kind, _, count in KINDS[:3]:
        tets = ["--tetmesh", "Lattice"] if count == 10 else []
        mesh_file(path, at("mesh.vtu"), "--element-order", kind["ElementOrder"], *tets)
        (read,), made = read_pieces(at("mesh.vtu")), curved(kind).mesh
        assert np.array_equal(nodes_of(read), nodes_of(made))
    refused(4, "Files of Abaqus are not written with elements of 27 nodes", "--input", path,
            "--output", at("mesh.inp"), "--element-order", "Quadratic27")


def count_lines(path, start):
    with open(path, encoding="ascii") as file:
        return sum(line.startswith(start) for line in file)


@in_folder
def test_abaqus(at):
    path = write_data(DATA, at("in.vti"))
    for arguments, name in (([], "C3D20"), (["--reduced"], "C3D20R"),
                            (["--tetmesh", "Lattice"], "C3D10")):
        mesh_file(path, at("mesh.inp"), "--element-order", "Quadratic", *arguments)
        assert count_lines(at("mesh.inp"), "*ELEMENT, TYPE=%s, " % name) == 2
    assert os.path.getsize(at("mesh.inp")) > 1000


main(globals())
