"""Smoothing of labels, and removal of small regions."""
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from vfmtest import (
    ORIGIN, SPACING, TET_METHODS, check_surfaces, digest, facets, fraction_image, image, labels,
    main, mesh_of, run, uniform, VolumeFractionToTet)

N = 16
CELL = np.prod(SPACING)
BALL_SIZE = 18, 30, 30  # cells along z, y, x
MIDDLE, RADIUS = np.array(ORIGIN) + np.array(SPACING) * (15.1, 15.2, 9.05), 3.2


def ball_labels():
    """Returns labels of a ball by cell centres; the cells are twice as long along z."""
    axes = [ORIGIN[a] + SPACING[a] * (np.arange(BALL_SIZE[2 - a]) + 0.5) for a in range(3)]
    z, y, x = np.meshgrid(*axes[::-1], indexing="ij")
    distance = np.sqrt((x - MIDDLE[0]) ** 2 + (y - MIDDLE[1]) ** 2 + (z - MIDDLE[2]) ** 2)
    return (7 * (distance < RADIUS)).astype(np.int32)


def crumbs():
    """Returns labels with small regions.

    A block of 3 on a block of 5 has a cavity of three
    cells. In the void are a pair of 3 and a single 5.
    """
    ids = np.zeros((N, N, N), np.int32)
    ids[2:7, 3:13, 3:13], ids[7:12, 3:13, 3:13] = 5, 3
    ids[9, 8, 6:9] = 0
    ids[14, 14, 6:8], ids[14, 2, 2] = 3, 5
    return ids


BALL, CRUMBS = ball_labels(), crumbs()


def mesh_labels(ids, make=None, **properties):
    return mesh_of(image({"id": ids}), make, MaterialIdArray="id", **properties)


def rms_distance(result):
    points = vtk_to_numpy(result.surfaces.GetPoints().GetData())
    return np.sqrt(np.mean((np.linalg.norm(points[np.unique(facets(result))] - MIDDLE,
                                           axis=1) - RADIUS) ** 2))


def check_volumes(result, ids):
    """Checks that target volumes are the volumes of the cells, and that the mesh has them."""
    for material, target, volume in zip(*map(result.field,
                                             ("MaterialIds", "TargetVolume", "MeshVolume"))):
        expected = (ids == material).sum() * CELL
        assert abs(target - expected) < 1e-6 * expected, (material, target, expected)
        assert abs(volume - expected) < 1e-5 * expected, (material, volume, expected)


def test_label_smoothing():
    """Smoothing brings the surface closer to the ball and keeps the volume."""
    kinds = [{}] + [{"make": VolumeFractionToTet, "Method": method} for method in TET_METHODS]
    for kind in kinds:
        steps, smooth = (mesh_labels(BALL, LabelSmoothing=passes, **kind) for passes in (0, 2))
        assert rms_distance(smooth) < 0.8 * rms_distance(steps), (
            kind, rms_distance(smooth), rms_distance(steps))
        assert not smooth.warnings
        check_volumes(smooth, BALL)
        assert smooth.cells("ScaledJacobian").min() > 0 and set(smooth.cells("MaterialId")) == {7}
    check_surfaces(mesh_labels(CRUMBS, LabelSmoothing=2))


def test_labels_stay():
    """Smoothing does not change the label of any cell."""
    for ids in (BALL, CRUMBS):
        steps, smooth = (mesh_labels(ids, StairStep=1, LabelSmoothing=passes) for passes in (0, 4))
        assert digest(steps) == digest(smooth)


def test_volumes_of_noise():
    noise = np.random.default_rng(2).choice([0, 2, 3, 9], (7, 8, 9)).astype(np.int32)
    steps, smooth = (mesh_labels(noise, StairStep=1, LabelSmoothing=passes) for passes in (0, 4))
    assert np.allclose(steps.field("TargetVolume"), smooth.field("TargetVolume"), rtol=1e-6)
    assert all("is read as void" in text for text in smooth.warnings), smooth.warnings


def test_refinement_of_smooth_labels():
    rough, fine = (mesh_labels(BALL, **uniform(1), LabelSmoothing=passes, ConserveVolume=0)
                   for passes in (0, 2))
    assert rms_distance(fine) < 0.7 * rms_distance(rough)
    assert np.allclose(fine.field("TargetVolume"), rough.field("TargetVolume"), rtol=1e-6)


def test_fractions_are_not_smoothed():
    data = fraction_image()
    assert digest(mesh_of(data, LabelSmoothing=5)) == digest(mesh_of(data))


def test_threads():
    reference = digest(mesh_labels(CRUMBS, LabelSmoothing=2, MinimumRegionCells=3,
                                   NumberOfThreads=1))
    for threads in (2, 5):
        assert digest(mesh_labels(CRUMBS, LabelSmoothing=2, MinimumRegionCells=3,
                                  NumberOfThreads=threads)) == reference


def test_minimum_region():
    for minimum, regions, cells in ((0, 0, 0), (1, 0, 0), (2, 1, 1), (3, 2, 3), (4, 3, 6)):
        for smoothing in (0, 2):
            result = mesh_labels(CRUMBS, MinimumRegionCells=minimum, LabelSmoothing=smoothing)
            assert result.field("RemovedRegions") == [regions] and result.field("RemovedCells") == [
                cells]
            assert result.field("NumberOfFragments") == [4 - min(regions, 2)]
    whole = CRUMBS.copy()
    whole[9, 8, 6:9], whole[14] = 3, 0
    check_volumes(result, whole)


def test_material_widths():
    """Materials have cells of their widths, and keep their volumes."""
    ids = np.zeros((16, 32, 32), np.int32)
    ids[4:], ids[2:4] = 3, 7
    twice = ",".join(str(2 * width) for width in SPACING)
    one, two, none = (mesh_labels(ids, CellWidth=twice, MaterialWidths=widths)
                      for widths in ("7=0.25", "3=0.25,7=0.25", "None"))
    counts = [result.mesh.GetNumberOfCells() for result in (none, one, two)]
    assert 2 * counts[0] < counts[1] < counts[2], counts
    widths = one.materials.GetRowData().GetArray("MaterialWidths")
    assert [widths.GetValue(m) for m in (0, 1)] == [2 * max(SPACING), max(SPACING)]
    assert none.materials.GetRowData().GetArray("MaterialWidths") is None
    check_volumes(one, ids)
    wide, narrow = (mesh_labels(BALL, MaterialWidths="auto", AllowedError=allowed)
                    for allowed in (0.5, 0))
    assert wide.mesh.GetNumberOfCells() < 0.5 * narrow.mesh.GetNumberOfCells()
    assert digest(narrow) == digest(mesh_labels(BALL))
    check_volumes(wide, BALL)


def test_minimum_region_of_fractions():
    """Small parts go together with the fractions around them; distant material is kept."""
    water = np.zeros((N, N, N))
    water[:5], water[5] = 1.0, 0.3
    volume = water.sum()
    water[10, 8, 7:10] = 0.8, 0.9, 0.4
    result = mesh_of(image({"water": water}), VolumeFractionArrays=["water"], MinimumRegionCells=3)
    assert result.field("RemovedRegions") == [1] and result.field("RemovedCells") == [2]
    assert result.field("NumberOfFragments") == [1]
    assert abs(result.field("TargetVolume")[0] - volume * CELL) < 1e-9 * volume * CELL
    kept = mesh_of(image({"water": water}), VolumeFractionArrays=["water"])
    assert kept.field("RemovedRegions") == [0] and kept.field("NumberOfFragments") == [2]


def test_iso_value_decides_what_a_region_is():
    water = np.zeros((8, 8, 8))
    water[:3] = 1.0
    water[5, 5, 5] = 0.4
    for iso, regions in ((0.5, 0), (0.3, 1)):
        result = mesh_of(image({"water": water}), VolumeFractionArrays=["water"],
                         MinimumRegionCells=2, IsoValue=iso)
        assert result.field("RemovedRegions") == [regions], iso


def test_all_too_small():
    """If only void is left, the mesh is empty and a warning says so."""
    ids = np.zeros((6, 6, 6), np.int32)
    ids[2:4, 2:4, 2:4] = 1
    result = run(image({"id": ids}), MaterialIdArray="id", MinimumRegionCells=1000,
                 LabelSmoothing=2)
    assert result.mesh.GetNumberOfCells() == 0 and not result.errors
    assert any("empty" in warning for warning in result.warnings)


def distances_to_plane(normal, **properties):
    """Returns the largest distances, in cells, of interface points on sides and inside."""
    count, normal = 24, np.array(normal) / np.linalg.norm(normal)
    z, y, x = np.indices((count, count, count)) + 0.5

    def distance(x, y, z):
        return np.stack([x, y, z], -1) @ normal - count / 2 * normal.sum() - 0.1

    grid = image({"id": np.where(distance(x, y, z) < 0, 1, 2).astype(np.int32)})
    grid.SetOrigin(0, 0, 0)
    grid.SetSpacing(1, 1, 1)
    result = mesh_of(grid, MaterialIdArray="id", **properties)
    sides = vtk_to_numpy(result.surfaces.GetCellData().GetArray("DomainSide"))
    points = vtk_to_numpy(result.surfaces.GetPoints().GetData())
    points = points[np.unique(facets(result)[sides < 0])]
    is_on_side = ((np.abs(points) < 1e-6) | (np.abs(points - count) < 1e-6)).any(axis=1)
    far = np.abs(distance(*points.T))
    return far[is_on_side].max(), far[~is_on_side].max()


def test_interfaces_at_sides():
    """Points of interfaces on the sides of the domain are off by more than inside (limits.md)."""
    for properties, most in (({}, (1.35, 0.65)), ({"LabelSmoothing": 3}, (0.85, 0.35))):
        found = [distances_to_plane(normal, **properties)
                 for normal in ((1, 0.3, 0.2), (1, 0.1, 0.05), (1, 1, 0.3))]
        print(properties, "on sides and inside:", ", ".join("%.3f %.3f" % pair for pair in found))
        assert (np.max(found, axis=0) < most).all(), found


main(globals())
