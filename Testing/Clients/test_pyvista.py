"""Tests PyVista: .vtu with surfaces in .vtp, .vtk, Exodus."""

import numpy as np
import pytest

from ball_in_block import (NAMES, SIDES, area_of, check_maximum, check_volumes, fixed_points,
                           run_recipe, side_faces, solve, volume_of)

pyvista = pytest.importorskip("pyvista")


def corners(grid):
    return next(iter(grid.cells_dict.values()))


def check_grid(mesh, grid, material):
    points, cells = np.asarray(grid.points, float), corners(grid)
    check_volumes(mesh, {i: volume_of(points, cells[material == i]) for i in NAMES})
    check_maximum(mesh, solve(points, cells, material, fixed_points(points)))


def test_recipe(mesh, tmp_path):
    names = run_recipe("PyVista", mesh, tmp_path)
    check_grid(mesh, names["solid"], names["solid"].cell_data["MaterialId"])
    assert names["ball"].n_cells == (mesh.material == 1).sum()
    assert names["x_min"].n_cells == side_faces(mesh, "x_min")
    surfaces = names["surfaces"]
    for number, name in enumerate(SIDES):
        side = surfaces.extract_cells(surfaces.cell_data["DomainSide"] == number)
        assert side.n_cells == side_faces(mesh, name)
        assert np.isclose(side.compute_cell_sizes()["Area"].sum(), area_of(name), rtol=1e-12)


@pytest.mark.parametrize("binary", [False, True])
def test_legacy_vtk(mesh, tmp_path, binary):
    mesh.save(tmp_path / "ball.vtk", binary=binary)
    grid = pyvista.read(tmp_path / "ball.vtk")
    check_grid(mesh, grid, grid.cell_data["material"])


def test_exodus(mesh, tmp_path):
    mesh.save(tmp_path / "ball.e")
    read = pyvista.read(tmp_path / "ball.e")
    blocks = read["Element Blocks"]
    assert blocks.keys() == ["ball", "block"]
    check_volumes(mesh, {name: volume_of(np.asarray(blocks[name].points, float),
                                         corners(blocks[name])) for name in blocks.keys()},
                  tolerance=1e-7)  # VTK's reader of Exodus rounds points to floats
    for name in SIDES:
        side = read["Side Sets"][name].extract_surface().compute_cell_sizes()
        assert side.n_cells == side_faces(mesh, name)
        assert np.isclose(side["Area"].sum(), area_of(name), rtol=1e-6)
