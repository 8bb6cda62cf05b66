"""Tests periodic meshes: copies of points, sides, files, and errors."""

import numpy as np
import pytest

import volume_fraction_mesh as vfm
from digest_cases import ORIGIN, SPACING, TURNED
from fields import BALL, PLATE, ball, check_valid

N = 9
CORNER = np.roll(ball(N), (4, 5, 4), axis=(0, 1, 2))  # a ball that sides cut
FRACTIONS = {"ball": CORNER, "rest": 1 - CORNER}
GRID = {"spacing": SPACING, "origin": ORIGIN}
MESHES = {
    "flat": vfm.hexes(FRACTIONS, periodic="xyz", **GRID),
    "free": vfm.hexes(FRACTIONS, periodic="xyz", periodic_sides="free", **GRID),
    "along x": vfm.hexes(FRACTIONS, periodic="x", periodic_sides="free", **GRID),
    "along y and z": vfm.hexes(FRACTIONS, periodic="yz", **GRID),
    "ball": vfm.hexes({"ball": CORNER}, periodic="xyz", periodic_sides="free", **GRID),
    "void": vfm.hexes({"ball": CORNER}, periodic="xyz", mesh_void=True, **GRID),
    "lattice": vfm.tets(FRACTIONS, periodic="xyz", **GRID),
    "cells": vfm.tets(FRACTIONS, periodic="xyz", method="cells", **GRID),
    "curved": vfm.hexes(FRACTIONS, periodic="xyz", element_order="quadratic", **GRID),
    "curved tets": vfm.tets(FRACTIONS, periodic="xy", element_order="quadratic", **GRID),
    "rotated": vfm.hexes(FRACTIONS, periodic="xz", direction=TURNED, **GRID),
}
SIDES = ["x_min", "x_max", "y_min", "y_max", "z_min", "z_max"]


@pytest.fixture(params=MESHES)
def mesh(request):
    return MESHES[request.param]


def vectors(mesh, periods):
    """Returns numbers of periods along the axes of the input as vectors in space."""
    steps = periods * mesh.fields["PeriodLengths"]
    frame = mesh.fields.get("DomainFrame")
    return steps if frame is None else steps @ frame[:9].reshape(3, 3).T


def test_lengths(mesh):
    repeats = np.isin(list("xyz"), list(mesh.run.options["periodic"]))
    assert np.array_equal(mesh.fields["PeriodLengths"], np.where(repeats, N * np.array(SPACING), 0))
    check_valid(mesh)


def test_copies_are_translates(mesh):
    """Copies are bitwise translates, in the directions of the periods."""
    copies, partners, periods = mesh.periodic_pairs()
    found, expected = mesh.points[copies], mesh.points[partners] + vectors(mesh, periods)
    assert len(copies) > N * N and (periods != 0).any(axis=1).all() and abs(periods).max() == 1
    if mesh is MESHES["rotated"]:
        assert np.allclose(found, expected, rtol=0, atol=1e-12)
    else:
        assert np.array_equal(found, expected)
    assert not periods[:, mesh.fields["PeriodLengths"] == 0].any()


def test_families(mesh):
    """The partner is the lowest id of a family. Each copy is in one pair, and is no partner."""
    copies, partners, _ = mesh.periodic_pairs()
    assert np.array_equal(copies, np.flatnonzero(mesh.partner != mesh.point_ids))
    assert np.array_equal(mesh.point_ids[partners], mesh.partner[copies])
    assert (mesh.partner <= mesh.point_ids).all()
    assert len(np.unique(copies)) == len(copies) and not np.isin(copies, partners).any()
    _, sizes = np.unique(mesh.partner, return_counts=True)
    assert sizes.max() <= 2 ** np.count_nonzero(mesh.fields["PeriodLengths"])


def keys_of(mesh, name):
    """Returns the partners of the corners of each face of a side, as sorted rows."""
    keys = np.sort(mesh.partner[mesh.facets(name).points], axis=1)
    return keys[np.lexsort(keys.T)]


def test_opposite_sides(mesh):
    """Sides that repeat have faces whose corners are partners. All sides close the mesh."""
    sets = mesh.facet_sets()
    assert [name for name in sets if name in SIDES] == SIDES
    for axis, length in enumerate(mesh.fields["PeriodLengths"]):
        lower, upper = (mesh.facets(name) for name in SIDES[2 * axis:2 * axis + 2])
        assert len(lower) > 0 and not set(lower.elements) & set(upper.elements)
        if length > 0:
            assert len(lower) == len(upper)
            assert np.array_equal(*(keys_of(mesh, name) for name in SIDES[2 * axis:2 * axis + 2]))
    if mesh is not MESHES["ball"]:
        assert sum(len(sets[name]) for name in SIDES) == np.count_nonzero(mesh.neighbours() < 0)


@pytest.mark.parametrize("name", ["flat", "lattice", "cells", "void"])
def test_flat_sides(name):
    mesh = MESHES[name]
    for axis in range(3):
        for end, side in enumerate(SIDES[2 * axis:2 * axis + 2]):
            plane = ORIGIN[axis] + end * mesh.fields["PeriodLengths"][axis]
            assert (mesh.points[mesh.facets(side).points][..., axis] == plane).all()


def test_fragment_across_sides():
    """The pieces of the ball are one fragment, and their volume is that of the fractions."""
    for name in ("flat", "free", "lattice", "cells"):
        materials = MESHES[name].materials
        assert materials["Fragments"].tolist() == [1, 1]
        assert np.allclose(materials["MeshVolume"], materials["TargetVolume"], rtol=1e-6)
    assert vfm.hexes(FRACTIONS).materials["Fragments"][0] > 1


@pytest.mark.parametrize("make", [vfm.hexes, vfm.tets])
def test_joined(make):
    """Without copies, each face has an element behind it."""
    mesh = make(FRACTIONS, periodic="xyz", periodic_sides="joined", **GRID)
    assert mesh.partner is None and (mesh.neighbours() >= 0).all()
    assert not set(SIDES) & set(mesh.facet_sets())
    assert mesh.materials["Fragments"].tolist() == [1, 1]
    if make is vfm.hexes:
        free = MESHES["free"]
        assert len(mesh) == len(free) and len(mesh.points) == len(np.unique(free.partner))


def test_without_the_option():
    mesh = vfm.hexes(FRACTIONS)
    assert mesh.partner is None and "PeriodLengths" not in mesh.fields


def read_equations(path):
    """Returns {set: (node, coordinates)} and, per equation, its terms {(node, direction): factor}
    and its first term."""
    references, equations, keyword, count, numbers = {}, [], "", 0, []
    for line in path.read_text(encoding="ascii").splitlines():
        if line.startswith("**"):
            continue
        if line.startswith("*"):
            assert len(numbers) == 3 * count
            keyword, count, numbers = line, 0, []
        elif keyword.startswith("*NODE, NSET="):
            node, *place = line.split(",")
            references[keyword[len("*NODE, NSET="):]] = (int(node), list(map(float, place)))
        elif count == 0:
            assert keyword == "*EQUATION"
            count = int(line)
        else:
            row = line.split(",")
            assert len(row) % 3 == 0 and len(row) <= 12
            numbers += row
            if len(numbers) == 3 * count:
                terms = [(int(node), int(direction)) for node, direction
                         in zip(numbers[::3], numbers[1::3])]
                equations.append((dict(zip(terms, map(float, numbers[2::3]))), terms[0]))
                assert len(equations[-1][0]) == count
    return references, equations


def test_equations(mesh, tmp_path):
    """The second file for Abaqus has the pairs, and eliminates each copy once."""
    mesh.save(tmp_path / "mesh.inp")
    assert {path.name for path in tmp_path.iterdir()} == {"mesh.inp", "mesh_periodic.inp"}
    text = (tmp_path / "mesh.inp").read_text()
    assert text.endswith("\n*INCLUDE, INPUT=mesh_periodic.inp\n")
    references, equations = read_equations(tmp_path / "mesh_periodic.inp")
    lengths = mesh.fields["PeriodLengths"]
    assert list(references) == ["REF_" + "XYZ"[a] for a in range(3) if lengths[a] > 0]
    nodes = [references.get("REF_" + axis, (0, []))[0] for axis in "XYZ"]
    assert [node for node in nodes if node] == [
        len(mesh.points) + 1 + i for i in range(len(references))]
    expected = {}
    for copy, partner, periods in zip(*mesh.periodic_pairs()):
        for direction in (1, 2, 3):
            terms = {(copy + 1, direction): 1, (partner + 1, direction): -1}
            terms.update({(nodes[a], direction): -periods[a] for a in range(3) if periods[a]})
            expected[copy + 1, direction] = terms
    assert {first: terms for terms, first in equations} == expected
    assert len(equations) == len(expected)


def test_reference_nodes(tmp_path):
    """They lie one period from the lower corner, also of a rotated image."""
    for name in ("flat", "rotated"):
        mesh = MESHES[name]
        mesh.save(tmp_path / "mesh.inp")
        references, _ = read_equations(tmp_path / "mesh_periodic.inp")
        for axis in range(3):
            if mesh.fields["PeriodLengths"][axis] > 0:
                place = np.array(ORIGIN) + vectors(mesh, np.eye(3)[axis])
                assert np.allclose(references["REF_" + "XYZ"[axis]][1], place, atol=1e-12)


def test_other_meshes_have_no_equations(tmp_path):
    vfm.hexes(FRACTIONS).save(tmp_path / "mesh.inp")
    assert [path.name for path in tmp_path.iterdir()] == ["mesh.inp"]
    assert "*INCLUDE" not in (tmp_path / "mesh.inp").read_text()


def test_archive(mesh, tmp_path):
    mesh.save(tmp_path / "mesh.npz")
    loaded = vfm.load(tmp_path / "mesh.npz")
    assert np.array_equal(loaded.partner, mesh.partner)
    assert all(map(np.array_equal, loaded.periodic_pairs(), mesh.periodic_pairs()))


def test_vtu(mesh, tmp_path):
    pyvista = pytest.importorskip("pyvista")
    mesh.save(tmp_path / "mesh.vtu")
    grid = pyvista.read(tmp_path / "mesh.vtu")
    assert np.array_equal(grid.point_data["PeriodicPartner"], mesh.partner)
    assert np.array_equal(grid.field_data["PeriodLengths"], mesh.fields["PeriodLengths"])


def test_refined():
    mesh = vfm.hexes(np.roll(BALL, 5, axis=0), periodic="xyz", refinement="uniform")
    assert len(mesh.periodic_pairs()[0]) > 0
    assert np.array_equal(keys_of(mesh, "x_min"), keys_of(mesh, "x_max"))


@pytest.mark.parametrize("sides", [{}, {"periodic": "xyz", "periodic_sides": "joined"}])
def test_no_pairs(sides):
    with pytest.raises(ValueError, match="has no copies of points: make it with periodic"):
        vfm.hexes(FRACTIONS, **sides).periodic_pairs()


@pytest.mark.parametrize("make, cells, options, message", [
    (vfm.hexes, (2, 4, 4), {}, "at least 3 cells along"),
    (vfm.hexes, (9, 8, 8), {"refinement": "automatic"}, "an even number of cells along"),
    (vfm.hexes, (4, 4, 4), {"periodic": "zyx"}, "periodic"),
    (vfm.tets, (4, 4, 4), {"periodic_sides": "free"}, "can only be Flat or Joined"),
])
def test_errors(make, cells, options, message):
    with pytest.raises(ValueError, match=message):
        make(np.ones(cells), **{"periodic": "xyz", **options})


def test_input_that_does_not_repeat():
    """A warning reports materials that differ on opposite sides."""
    with pytest.warns(UserWarning, match="one period"):
        vfm.hexes({"ball": BALL, "plate": PLATE, "rest": 1 - BALL - PLATE}, periodic="z")
