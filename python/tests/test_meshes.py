"""Tests that meshes are valid, keep the volumes, and do not depend on the form of the input."""

import hashlib

import numpy as np
import pytest

import volume_fraction_mesh as vfm
from digest_cases import CASES, digest, graded, mesh_of
from fields import BALL, GRAINS, LABELS, N, PLATE, ball, check_valid, same

MAKES = {
    "hexes": vfm.hexes,
    "lattice": vfm.tets,
    "cells": lambda *fractions, **given: vfm.tets(*fractions, method="cells", **given),
}
MESH = vfm.hexes([BALL, PLATE])


@pytest.mark.parametrize("make", MAKES.values(), ids=MAKES)
def test_meshes_are_valid(make):
    mesh = make([BALL, PLATE], spacing=(0.1, 0.2, 0.1), origin=(-1, 2, 3))
    check_valid(mesh)
    targets = [BALL.sum() * 0.002, PLATE.sum() * 0.002]
    assert np.allclose(mesh.materials["TargetVolume"], targets, rtol=1e-12)
    assert np.allclose(mesh.materials["MeshVolume"], targets, rtol=1e-6)
    assert mesh.materials["Name"] == ["Material 1", "Material 2"]
    assert (mesh.points.min(axis=0) >= [-1, 2, 3]).all() and (
        mesh.points.max(axis=0) <= [0.2 + 1e-9, 4.4 + 1e-9, 4.2]
    ).all()
    assert set(mesh.material) == {1,
                                  2} and mesh.quality.min() > 0.05 and len(mesh) == len(mesh.cells)


def test_types_and_shapes():
    points, cells = len(MESH.points), len(MESH.cells)
    shapes = {
        "points": ((points, 3), "f8"),
        "cells": ((cells, 8), "i8"),
        "material": ((cells,), "i4"),
        "fragment": ((cells,), "i4"),
        "cell_ids": ((cells,), "i8"),
        "point_ids": ((points,), "i8"),
        "quality": ((cells,), "f4"),
    }
    for name, (shape, kind) in shapes.items():
        array = getattr(MESH, name)
        assert array.shape == shape and array.dtype == kind and array.flags.c_contiguous, name
    assert MESH.geometry.dimension.shape == MESH.geometry.id.shape == (points,)
    facets = len(MESH.surfaces.cells)
    assert MESH.surfaces.cells.shape == (facets,
                                         4) and MESH.surfaces.material_pair.shape == (facets, 2)
    assert vfm.tets([BALL]).surfaces.cells.shape[1] == 3
    assert MESH.curves.cells.shape[1] == 2 and MESH.vertices.points.ndim == 1
    assert (
        MESH.fields["NumberOfFragments"] == 2
        and len(MESH.surfaces.fields["SurfaceAreas"]) == MESH.surfaces.surface_id.max()
    )
    assert MESH.kind == "hexahedron" and vfm.tets([BALL]).kind == "tetra"


def test_ways_to_give_fractions():
    assert same(vfm.hexes({"b": BALL, "p": PLATE}),
                MESH) and same(vfm.hexes((BALL, PLATE), names=["b", "p"]), MESH)
    assert (
        vfm.hexes({"b": BALL, "p": PLATE}).materials["Name"]
        == ["b", "p"]
        == vfm.hexes([BALL, PLATE], names="b p".split()).materials["Name"]
    )
    assert same(vfm.hexes(BALL), vfm.hexes([BALL]))
    assert same(vfm.hexes([BALL.tolist()]), vfm.hexes([BALL]))
    swapped = vfm.hexes([PLATE, BALL])
    assert np.array_equal(np.bincount(swapped.material)[:0:-1], np.bincount(MESH.material)[1:])


def test_orders():
    """The order of axes and the memory layout of arrays change nothing."""
    turned = [array.transpose(2, 1, 0) for array in (BALL, PLATE)]
    for copy in (np.asfortranarray, np.ascontiguousarray,
                 lambda array: array[::-1, ::-1][::-1, ::-1]):
        assert same(vfm.hexes([copy(BALL), copy(PLATE)]), MESH)
        assert same(vfm.hexes([copy(array) for array in turned], order="zyx"), MESH)
    assert not np.array_equal(vfm.hexes(turned).points, MESH.points)
    slab = np.zeros((3, 4, 5))
    slab[2] = 1
    assert np.allclose(vfm.hexes(slab).points.min(axis=0), [2, 0, 0], atol=0.01)
    assert np.array_equal(vfm.hexes(slab, order="zyx").points.max(axis=0), [5, 4, 3])


def test_types_of_fractions():
    singles = [array.astype(np.float32) for array in (BALL, PLATE)]
    expected = vfm.hexes([array.astype(np.float64) for array in singles])
    assert same(vfm.hexes(singles),
                expected) and same(vfm.hexes([array.astype(">f4") for array in singles]), expected)
    full = vfm.hexes([LABELS == 1, LABELS == 2])
    assert same(full, vfm.hexes([(LABELS == 1).astype(float), (LABELS == 2).astype(float)]))
    assert same(full, vfm.hexes([np.uint8(255) * (LABELS == 1), np.uint8(255) * (LABELS == 2)]))
    half = np.rint(BALL * 255).astype(np.uint8)
    assert same(vfm.hexes(half), vfm.hexes(half / 255.0))
    halves = BALL.astype(np.float16)
    assert same(vfm.hexes(halves), vfm.hexes(halves.astype(float)))


def test_types_of_labels():
    expected = vfm.hexes(labels=LABELS)
    for kind in ("u1", "i2", "u2", "i4", "u4", "i8", "u8", "f4", "f8", ">i4"):
        assert same(vfm.hexes(labels=LABELS.astype(kind)), expected), kind
    assert same(vfm.hexes(labels=LABELS == 1), vfm.hexes(labels=(LABELS == 1).astype(int)))


def test_labels():
    mesh = vfm.hexes(labels=GRAINS, names={1: "first", 3: "second", 99: "not there"},
                     label_smoothing=2)
    check_valid(mesh)
    assert set(mesh.material) == set(GRAINS.ravel().tolist()) == set(mesh.materials["MaterialId"])
    assert mesh.materials["Name"][:3] == ["first", "second", "Material 5"]
    counts = [(GRAINS == label).sum() for label in mesh.materials["MaterialId"]]
    assert np.allclose(mesh.materials["TargetVolume"], counts, rtol=1e-8)
    assert len(mesh.curves.cells) and len(mesh.vertices.points)


def test_coordinates():
    nodes = graded(N)
    mesh = vfm.hexes([BALL, PLATE], coordinates=nodes)
    check_valid(mesh)
    widths = [np.diff(x) for x in nodes]
    assert np.allclose(
        mesh.materials["TargetVolume"],
        [np.einsum("ijk,i,j,k", array, *widths) for array in (BALL, PLATE)]
    )
    even = [np.arange(N + 1) * s + o for o, s in zip((1, 2, 3), (0.5, 0.25, 2))]
    assert same(vfm.hexes([BALL], coordinates=even),
                vfm.hexes([BALL], origin=(1, 2, 3), spacing=(0.5, 0.25, 2)))
    assert same(vfm.hexes([BALL], spacing=0.5), vfm.hexes([BALL], spacing=[0.5] * 3))


def test_direction():
    turn = np.array([[0.6, -0.8, 0], [0.8, 0.6, 0], [0, 0, 1]])
    origin = np.array([1.0, 2, 3])
    plain, turned = (vfm.hexes([BALL, PLATE], origin=origin, direction=d) for d in (None, turn))
    assert np.allclose(turned.points, origin + (plain.points - origin) @ turn.T, atol=1e-12)
    assert np.array_equal(turned.point_ids, plain.point_ids) and "DomainFrame" in turned.fields
    check_valid(vfm.hexes([BALL, PLATE], direction=np.diag([-1, 1, 1])))


def test_threads_change_no_bit():
    for name, make in CASES.items():
        case = make()
        assert len({digest(vars(mesh_of(case, threads=threads)))
                    for threads in (1, 2, 3)}) == 1, name


def test_digest_feels_every_bit():
    arrays = dict(vars(MESH))
    before = digest(arrays)
    for name in ("points", "quality", "cell_ids"):
        changed = arrays[name].copy()
        changed.flat[7] += 1
        assert digest({**arrays, name: changed}) != before
    assert len(before) == len(hashlib.sha256().hexdigest())


def test_options_have_effect():
    void = vfm.hexes([BALL, PLATE], mesh_void=True)
    assert set(void.material) == {0, 1, 2} and np.isclose(void.volumes().sum(), N**3)
    stairs = vfm.hexes(labels=LABELS, stair_step=True)
    assert len(stairs) == (LABELS > 0).sum()
    assert vfm.hexes([BALL], compute_quality=False).quality is None
    fine = vfm.hexes([BALL], refinement="uniform", maximum_level=1)
    assert 5 < len(fine) / len(vfm.hexes([BALL])) < 9
    chosen = np.zeros((N, N, N), int)
    chosen[:4, :4, :4] = 1
    settings = {"refinement": "automatic", "thin_cells": 0, "fine_interfaces": False,
                "mesh_void": True}
    by_array = vfm.hexes([BALL], refinement_array=chosen, **settings)
    by_box = vfm.hexes([BALL], refinement_boxes=[(0, 0, 0, 4, 4, 4)], **settings)
    assert same(by_array, by_box) and len(by_array) > len(vfm.hexes([BALL], mesh_void=True))
    lost = LABELS.copy()
    lost[0, 0, -1] = 7
    assert 7 not in vfm.hexes(labels=lost, minimum_region_cells=2).material
    assert (
        vfm.hexes([BALL], target_scaled_jacobian=0.8).quality.min()
        > vfm.hexes([BALL], target_scaled_jacobian=0.2).quality.min()
    )


def test_warnings():
    small = np.zeros((6, 6, 6))
    small[3, 3, 3] = 0.1
    with pytest.warns(vfm.VolumeFractionMeshWarning, match="The mesh is empty") as told:
        mesh = vfm.hexes(small)
    assert len(mesh) == 0 and "0 hexahedra" in repr(mesh) and told[0].filename == __file__
    with pytest.warns(vfm.VolumeFractionMeshWarning, match="lay outside"):
        vfm.hexes(ball(8) * 1.05, fraction_tolerance=0.1)


def test_one_layer_of_cells():
    """One layer is meshed, as in a micrograph."""
    check_valid(vfm.hexes(labels=GRAINS[:, :, :1]))
