"""Cells of high aspect ratio are cut until none exceeds MaximumAspectRatio."""
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from amr_cases import N, block_of, cover, fields, multiblock, nested
from vfmtest import (
    ORIGIN, SPACING, VolumeFractionToTet, add_array, ball_and_plate, check_hexes, digest, elements,
    fraction_image, hex_volumes, image, labels, main, mesh_of, points_of, rectilinear, run, uniform)

LONG = {"MaximumAspectRatio": 1.5}  # the cells are twice as long along z


def in_halves(values):
    """Cuts cells (z, y, x) in two along z."""
    return np.repeat(values, 2, axis=0)


def cells_of(centres, coordinates):
    """Returns the index along x, y, z of the grid cell around each point."""
    return [np.searchsorted(x, centres[:, a], side="right") - 1 for a, x in enumerate(coordinates)]


def centres_of(result):
    return points_of(result)[elements(result)].mean(axis=1)


def test_cells_that_are_not_long_stay():
    """Cells within the limit are not cut."""
    data = fraction_image(8)
    plain = digest(mesh_of(data))
    assert digest(mesh_of(data, MaximumAspectRatio=2)) == plain
    assert digest(mesh_of(data, MaximumAspectRatio=0)) == plain
    assert digest(mesh_of(data, **LONG)) != plain


def test_labels_are_those_of_cut_cells():
    """The mesh is bitwise identical to that of an image of the parts."""
    ids = labels(12)
    parts = image({"id": in_halves(ids)})
    parts.SetSpacing(SPACING[0], SPACING[1], SPACING[2] / 2)
    assert digest(mesh_of(image({"id": ids}), MaterialIdArray="id",
                          **LONG)) == digest(mesh_of(parts, MaterialIdArray="id"))


def test_fractions_keep_their_volumes():
    for properties in ({}, {"make": VolumeFractionToTet, "Method": "Lattice"}, uniform(1),
                       {"Refinement": "Coarsen"}, {"ChildFractions": "Parent"}):
        whole, cut = (mesh_of(fraction_image(12), **properties, **more) for more in ({}, LONG))
        assert np.allclose(cut.field("TargetVolume"), whole.field("TargetVolume"), rtol=1e-10,
                           atol=0), properties
        assert cut.field("DomainBounds") == whole.field("DomainBounds")
        if "make" not in properties:
            check_hexes(cut)


def test_small_regions_count_cells_of_the_input():
    """MinimumRegionCells counts cells of the input."""
    speck = np.zeros((8, 8, 8), np.int32)
    speck[1:6, 1:6, 1:6] = 1
    speck[6:8, 7, 7] = 2  # two cells, cut into four parts
    for least, removed in ((2, 0), (3, 1)):
        result = mesh_of(image({"id": speck}), MaterialIdArray="id", MinimumRegionCells=least,
                         **LONG)
        assert result.field("RemovedRegions") == [removed]


def test_layers_are_cut_each_into_its_own_number():
    """Each layer that is too long is cut into its own number of parts.

    Elements have the state of the input cell.
    """
    x = np.arange(7.0)
    z = np.array([0.0, 1.0, 2.0, 6.0, 7.2, 9.2])
    data = rectilinear({"id": np.ones((5, 6, 6), np.int32),
                        "number": np.arange(180).reshape(5, 6, 6)}, (x, x, z))
    result = mesh_of(data, MaterialIdArray="id", StateArrays=["number"], StairStep=1, **LONG)
    nodes = np.unique(points_of(result)[:, 2])
    assert np.allclose(nodes, [0, 1, 2, 2 + 4 / 3, 2 + 8 / 3, 6, 7.2, 8.2, 9.2], rtol=1e-15)
    i, j, k = cells_of(centres_of(result), (x, x, z))
    assert (result.cells("number") == (k * 6 + j) * 6 + i).all()
    heights = np.ptp(points_of(result)[elements(result)][:, :, 2], axis=1)
    assert heights.max() <= 1.5 and heights.min() >= 1 / 1.5


def test_state_of_refined_cells():
    """State of cells cut in three, then halved or joined."""
    ids = labels(12)
    data = image({"id": ids, "number": np.arange(12 ** 3).reshape(12, 12, 12)})
    data.SetSpacing(1, 1, 4)
    data.SetOrigin(0, 0, 0)
    grid = [h * np.arange(13.0) for h in (1, 1, 4)]
    for properties, parts in (({}, 3), (uniform(1), 24), ({"Refinement": "Coarsen"}, None)):
        result = mesh_of(data, MaterialIdArray="id", StateArrays=["number"], StairStep=1, **LONG,
                         **properties)
        i, j, k = cells_of(centres_of(result), grid)
        here = (k * 12 + j) * 12 + i
        if parts:
            assert (np.sort(here) == np.repeat(np.flatnonzero(ids), parts)).all(), properties
            assert (result.cells("number") == here).all(), properties
        volume = hex_volumes(points_of(result), elements(result)).sum()
        assert np.isclose(volume, 4 * (ids > 0).sum(), rtol=1e-12), properties


def test_levels_of_the_input_keep_their_ratios():
    """Cells of all levels are cut in the same way and keep their refinement."""
    all_fields, blocks = fields(2), nested()
    names = {"VolumeFractionArrays": ["ball", "plate"], "MeshVoid": 1, "StateArrays": ["number"]}
    whole, cut = (mesh_of(multiblock(all_fields, blocks), **names, **more) for more in ({}, LONG))
    check_hexes(cut)
    assert np.allclose(cut.field("TargetVolume"), whole.field("TargetVolume"), rtol=1e-10, atol=0)
    finest = [result.field("RefinedCells")[-2] for result in (whole, cut)]
    assert 2 * cover(blocks, 2, 2).sum() / 64 <= finest[1] <= 2 * finest[0], finest
    stairs = mesh_of(multiblock(all_fields, blocks), **names, **LONG, **uniform(2), StairStep=1)
    fine = [ORIGIN[a] + SPACING[a] / 4 * np.arange(4 * N + 1) for a in range(3)]
    i, j, k = cells_of(centres_of(stairs), fine)
    expected = np.full((4 * N,) * 3, -1)
    for level in range(3):
        times = 1 << (2 - level)
        number = all_fields[level]["number"].repeat(times, 0).repeat(times, 1).repeat(times, 2)
        covered = cover(blocks, 2, level).repeat(times, 0).repeat(times, 1).repeat(times, 2)
        expected[covered] = number[covered]
    assert (stairs.cells("number") == expected[k, j, i]).all()


def test_elements_of_labels_are_better():
    """A smooth ball of labels in cells three times as long as wide."""
    z, y, x = np.meshgrid((np.arange(8) + 0.5) * 3, np.arange(24) + 0.5, np.arange(24) + 0.5,
                          indexing="ij")
    data = image({"id": ((x - 12) ** 2 + (y - 12.1) ** 2 + (z - 12) ** 2 < 81).astype(np.int32)})
    data.SetSpacing(1, 1, 3)
    properties = {"make": VolumeFractionToTet, "Method": "Lattice", "MaterialIdArray": "id",
                  "LabelSmoothing": 3}
    whole, cut = (mesh_of(data, **properties, **more) for more in ({}, LONG))
    angles = [result.field("MinimumDihedralAngle")[0] for result in (whole, cut)]
    print("labels of a ball in cells of 1 x 1 x 3, Lattice: "
          "smallest dihedral angle %.1f, cut %.1f degrees" % tuple(angles))
    assert angles[0] < 20 < 25 < angles[1]
    assert np.isclose(cut.field("TargetVolume")[0], whole.field("TargetVolume")[0], rtol=1e-9)


def test_errors():
    for ratio in (-1, 0.5, 1, 1.05, float("nan")):
        result = run(fraction_image(4), MaximumAspectRatio=ratio)
        assert len(result.errors) == 1 and "1.1 or more" in result.errors[0], (ratio, result.errors)
    data = fraction_image(4)
    data.SetSpacing(1, 1e9, 1e9)
    result = run(data, **LONG)
    assert (len(result.errors) == 1 and "more nodes than 64-bit global ids can number"
            in result.errors[0]), result.errors


main(globals())
