"""Tests of layers of hexahedra along interfaces and sides of the domain, and of Mesh.cut_layers and
Mesh.split."""

import numpy as np
import pytest

import volume_fraction_mesh as vfm

BALL = vfm.shapes("sphere radius=0.6", 12, bounds=[-1, 1] * 3)
GRAINS, FEW_CELLS = (vfm.shapes("polycrystal grains=6 seed=2", cells, bounds=[-1, 1] * 3)
                     for cells in (10, 8))


def count_layers(mesh):
    return [int((mesh.layer == layer).sum()) for layer in (1, 2, 3)]


def test_none_by_default():
    assert vfm.hexes(BALL).layer is None


@pytest.mark.parametrize("fractions", [BALL, GRAINS], ids=["ball", "grains"])
def test_layers(fractions):
    plain = vfm.hexes(fractions, mesh_void=True)
    mesh = vfm.hexes(fractions, mesh_void=True, layers=3, first_layer=0.1)
    counts = count_layers(mesh)
    assert counts[0] == counts[1] == counts[2] > 100
    assert len(mesh) == len(plain) + 2 * counts[0]
    assert mesh.quality.min() > 0.35
    for material in np.unique(plain.material):
        before = plain.volumes()[plain.material == material].sum()
        assert mesh.volumes()[mesh.material == material].sum() == pytest.approx(before, rel=1e-12)


def test_thickness_by_length():
    cells = vfm.hexes(BALL, layers=2, first_layer=0.2)
    length = vfm.hexes(BALL, layers=2, first_layer=0.2 * 2 / 12, first_layer_unit="length")
    assert np.allclose(cells.points, length.points, atol=1e-12)


def test_one_side():
    mesh = vfm.hexes(BALL, mesh_void=True, layers=2, layer_interfaces="1/0",
                     layers_on="first_material")
    assert set(mesh.material[mesh.layer > 0]) == {1}
    with pytest.raises(ValueError, match="LayerInterfaces contains '1/7'"):
        vfm.hexes(BALL, layers=2, layer_interfaces="1/7")


def test_sides_of_the_domain():
    """Each side has one column per face of the mesh before."""
    plain = vfm.hexes(GRAINS)
    faces = sum(len(plain.facets(name)) for name in ("x_min", "x_max"))
    cut = vfm.hexes(GRAINS, layers=2, layer_sides="x")
    inside = vfm.hexes(GRAINS, layers=2)
    assert len(cut) > len(inside) + faces - 1


def test_extensive_state_is_divided():
    heat = np.random.default_rng(1).uniform(1, 2, (12, 12, 12))
    words = {"mesh_void": True, "state": {"heat": heat}, "state_kinds": {"heat": "extensive"},
             "state_transfer": "conserve"}
    plain, cut = vfm.hexes(BALL, **words), vfm.hexes(BALL, layers=3, **words)
    assert cut.state["heat"].sum() == pytest.approx(plain.state["heat"].sum(), rel=1e-12)


def test_with_split_interfaces():
    mesh = vfm.hexes(GRAINS, layers=2, split_interfaces="all", split_connection="cohesive")
    blocks = mesh.cohesive()
    assert sum(map(len, blocks.values())) > 100
    assert mesh.fields["AddedNodes"][0] > 100


@pytest.mark.parametrize("make, options, message", [
    (vfm.tets, {}, "Layers are for hexahedra"),
    (vfm.hexes, {"stair_step": True}, "which StairStep does not make"),
])
def test_errors(make, options, message):
    with pytest.raises(ValueError, match=message):
        make(BALL, layers=2, **options)


def test_layers_follow_curved_interfaces():
    """The mid nodes of thin layers lie between two spheres, and none is moved back."""
    words = {"element_order": "quadratic", "mesh_void": True}
    plain = vfm.hexes(BALL, **words)
    mesh = vfm.hexes(BALL, layers=3, first_layer=0.02, **words)
    assert "hexahedra" in repr(mesh)
    assert mesh.fields["StraightenedMidNodes"][0] == plain.fields["StraightenedMidNodes"][0] == 0
    assert mesh.fields["CurvedMidNodes"][0] > 4 * plain.fields["CurvedMidNodes"][0]
    assert mesh.materials["MeshVolume"] == pytest.approx(plain.materials["MeshVolume"], rel=1e-9)


def check_same(made, expected):
    """Checks that Mesh.split or Mesh.cut_layers made the same mesh as the options."""
    for name in ("points", "cells", "material", "fragment", "point_ids", "cell_ids", "quality",
                 "layer", "original_ids"):
        one, other = getattr(made, name), getattr(expected, name)
        assert (one is None) == (other is None) and np.array_equal(one, other), name
    for part in ("geometry", "surfaces", "curves", "vertices"):
        for name, values in vars(getattr(expected, part)).items():
            if name != "fields":
                assert np.array_equal(getattr(getattr(made, part), name), values), (part, name)
    for table in ("fields", "materials"):
        for name, values in getattr(expected, table).items():
            assert np.array_equal(getattr(made, table)[name], values), name


def test_split_of_a_mesh():
    options = {"split_interfaces": "all", "split_connection": "cohesive"}
    check_same(vfm.hexes(FEW_CELLS).split(connection="cohesive"), vfm.hexes(FEW_CELLS, **options))


def test_cut_layers():
    made = vfm.hexes(FEW_CELLS).cut_layers(3, first_layer=0.02)
    check_same(made, vfm.hexes(FEW_CELLS, layers=3, first_layer=0.02, first_layer_unit="length"))


def test_refusals_of_a_mesh():
    with pytest.raises(ValueError, match="split already"):
        vfm.hexes(FEW_CELLS).split().split()
    with pytest.raises(ValueError, match="Layers are for hexahedra"):
        vfm.tets(FEW_CELLS).cut_layers(2)
