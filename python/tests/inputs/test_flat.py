"""Meshes of a plane: arrays of two axes."""

import numpy as np
import pytest

import volume_fraction_mesh as vfm


def grains(cells=30, count=15, seed=2):
    """Returns labels of the nearest of random points."""
    points = np.random.default_rng(seed).random((count, 2)) * cells
    x = np.stack(np.meshgrid(*[np.arange(cells) + 0.5] * 2, indexing="ij"), -1)
    return 1 + ((x[:, :, None] - points) ** 2).sum(-1).argmin(-1)


def disc(cells=20, samples=16):
    x = (np.arange(cells * samples) + 0.5) / samples - 9.3
    inside = (x[:, None] ** 2 + (x[None] - 0.9) ** 2 < 6.2 ** 2).astype(float)
    return inside.reshape(cells, samples, cells, samples).mean((1, 3))


GRAINS = vfm.hexes(labels=grains(), label_smoothing=3)
TRIANGLES = vfm.tets(labels=grains(), label_smoothing=3)


@pytest.mark.parametrize("mesh, corners", [(GRAINS, 4), (TRIANGLES, 3)])
def test_areas_are_those_of_the_labels(mesh, corners):
    assert mesh.is_flat and mesh.cells.shape[1] == corners
    assert mesh.kind == ("quad" if corners == 4 else "triangle")
    areas = mesh.volumes()
    assert (areas > 0).all()
    labels, counts = np.unique(grains(), return_counts=True)
    own = np.bincount(mesh.material, areas)[labels]
    np.testing.assert_allclose(own, counts, rtol=1e-6)
    np.testing.assert_allclose(mesh.materials["MeshVolume"], counts, rtol=1e-6)
    assert mesh.quality.min() >= (0.45 if corners == 4 else 0.1)
    assert (mesh.points[:, 2] == 0).all()


def test_disc_of_fractions():
    mesh = vfm.hexes(disc(), spacing=(0.5, 0.25))
    assert abs(mesh.volumes().sum() / (disc().sum() * 0.125) - 1) < 1e-6
    assert mesh.quality.min() >= 0.55
    sets = mesh.facet_sets()
    assert "Material 1_to_Void" in sets and "z_min" not in sets
    ends = mesh.points[sets["Material 1_to_Void"].points]
    x, y = ends[..., 0] / 0.5 - 9.3, ends[..., 1] / 0.25 - 10.2
    np.testing.assert_allclose(np.hypot(x, y), 6.2, atol=0.06)


def test_order_and_layers_of_cells_give_the_same():
    labels = grains()
    layer = vfm.hexes(labels=labels[:, :, None], label_smoothing=3, flat=True)
    turned = vfm.hexes(labels=labels.T, order="zyx", label_smoothing=3)
    for other in (layer, turned):
        assert np.array_equal(other.points, GRAINS.points)
        assert np.array_equal(other.cells, GRAINS.cells)
    assert vfm.hexes(labels=labels[:, :, None], label_smoothing=3).kind == "hexahedron"


def test_neighbours_and_interfaces():
    behind = GRAINS.neighbours()
    for side in range(4):
        has = behind[:, side] >= 0
        assert (behind[behind[has, side]] == np.flatnonzero(has)[:, None]).any(axis=1).all()
    sets = GRAINS.facet_sets()
    length = lambda name: np.linalg.norm(
        np.diff(GRAINS.points[sets[name].points], axis=1), axis=-1).sum()
    sides = [length(name) for name in ("x_min", "x_max", "y_min", "y_max")]
    assert sides == pytest.approx([30] * 4)
    pair = next(name for name in sets if "_to_" in name)
    first, second = pair.split("_to_")
    assert length(pair) == pytest.approx(length(second + "_to_" + first))


def test_state_is_that_of_the_cells():
    heat = np.arange(900.0).reshape(30, 30)
    mesh = vfm.hexes(labels=grains(), state={"heat": heat})
    assert mesh.state["heat"].shape == (len(mesh),)
    flux = np.stack([heat, -heat], -1)
    both = vfm.tets(labels=grains(), state={"flux": flux})
    assert both.state["flux"].shape == (len(both), 2)
    held = vfm.hexes(labels=grains(), density=1.0 + heat)
    total = (held.state["density"] * held.volumes()).sum()
    assert total == pytest.approx((1.0 + heat).sum(), rel=1e-12)


def test_periodic_copies():
    mesh = vfm.hexes(labels=grains(), periodic="xy", label_smoothing=2)
    copies, partners, periods = mesh.periodic_pairs()
    away = mesh.points[copies] - mesh.points[partners]
    np.testing.assert_allclose(away, 30.0 * periods, atol=1e-12)
    assert len(copies) > 50


@pytest.mark.parametrize("mesh", [GRAINS, TRIANGLES])
def test_files_have_the_elements_and_names(mesh, tmp_path):
    meshio = pytest.importorskip("meshio")
    for name in ("a.vtu", "a.msh", "a.inp"):
        mesh.save(tmp_path / name, **{"a.vtu": {"texts": False}, "a.inp": {"plane": "stress"}}.get(
            name, {}))
        read = meshio.read(tmp_path / name)
        blocks = [block for block in read.cells if block.type in ("quad", "triangle")]
        assert sum(len(block.data) for block in blocks) == len(mesh), name
    text = (tmp_path / "a.inp").read_text()
    assert "TYPE=CPS%d" % mesh.cells.shape[1] in text and "*SURFACE, NAME=X_MIN" in text
    netcdf = pytest.importorskip("netCDF4")
    mesh.save(tmp_path / "a.e")
    with netcdf.Dataset(tmp_path / "a.e") as file:
        assert file.dimensions["num_dim"].size == 2
        assert file.variables["connect1"].elem_type == ("QUAD4" if mesh is GRAINS else "TRI3")
        total = sum(size.size for name, size in file.dimensions.items() if "num_el_in_blk" in name)
        assert total == len(mesh)
        sides = file.variables["side_ss1"][:]
        elements = file.variables["elem_ss1"][:]
    assert len(sides) == len(elements) == len(mesh.facets("x_min"))
    mesh.save(tmp_path / "a.xdmf")
    head = (tmp_path / "a.xdmf").read_text()[:3000]
    assert ("Quadrilateral" if mesh is GRAINS else "Triangle") in head
    with pytest.raises(OSError, match="not written for meshes of a plane"):
        mesh.save(tmp_path / "a.feb")


def test_scikit_fem_solves_on_it():
    skfem = pytest.importorskip("skfem")
    from skfem.models.poisson import laplace
    for mesh, element in ((GRAINS, skfem.ElementQuad1()), (TRIANGLES, skfem.ElementTriP1())):
        made = mesh.to_skfem()
        basis = skfem.Basis(made, element)
        left, right = (basis.get_dofs(made.boundaries[name]) for name in ("x_min", "x_max"))
        x = basis.zeros()
        x[right] = 1.0
        held = np.concatenate([left.flatten(), right.flatten()])
        solution = skfem.solve(*skfem.condense(laplace.assemble(basis), x=x, D=held))
        np.testing.assert_allclose(solution, basis.doflocs[0] / 30.0, atol=1e-12)


def test_pyvista_cells():
    pyvista = pytest.importorskip("pyvista")
    grid = GRAINS.to_pyvista()
    assert set(grid.celltypes) == {pyvista.CellType.QUAD}
    assert grid.compute_cell_sizes()["Area"].sum() == pytest.approx(900.0)


def test_input_that_does_not_fit():
    with pytest.raises(ValueError, match="Flat needs one layer of cells"):
        vfm.hexes(np.ones((3, 4, 2)), flat=True)
    with pytest.raises(ValueError, match="does not support ElementOrder"):
        vfm.hexes(np.ones((3, 4)), element_order="quadratic")
