"""Tests sfepy: arrays, and .mesh."""

import numpy as np
import pytest

from ball_in_block import (SIDES, check_maximum, check_side, check_volumes, fixed_points,
                           run_recipe, solve, volume_of)

sfepy = pytest.importorskip("sfepy")


@pytest.fixture(autouse=True)
def quiet():
    from sfepy.base.base import output

    output.set_output(quiet=True)


def test_recipe(mesh, tmp_path):
    names = run_recipe("sfepy", mesh, tmp_path)
    check_maximum(mesh, names["u"])
    domain = names["domain"]
    cells = names["solid"].get_conn(names["solid"].descs[0])
    check_volumes(mesh, {name: volume_of(mesh.points, cells[names[name].cells])
                         for name in ("ball", "block")})
    corners, offsets = (getattr(domain.cmesh.get_conn(2, 0), name)
                        for name in ("indices", "offsets"))
    for name in SIDES:
        side = domain.create_region(name, "vertices of set " + name, "facet")
        check_side(mesh, name, mesh.points[[corners[offsets[i]:offsets[i + 1]]
                                            for i in side.facets]])


def test_mesh_file(mesh, tmp_path):
    from sfepy.discrete.fem import Mesh

    mesh.save(tmp_path / "ball.mesh")
    read = Mesh.from_file(str(tmp_path / "ball.mesh"))
    assert np.array_equal(read.cmesh.cell_groups, mesh.material)
    check_maximum(mesh, solve(read.coors, read.get_conn(read.descs[0]), read.cmesh.cell_groups,
                              fixed_points(read.coors)))
