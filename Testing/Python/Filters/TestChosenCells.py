"""User-selected cells for refinement, by an array or by boxes, on each kind of input."""
import functools

import numpy as np

from amr_cases import cut, fields, multiblock, nested
from exodus_grids import hexes
from vfmtest import (
    HIDDEN, ORIGIN, SPACING, TET_METHODS, VolumeFractionToHex, VolumeFractionToTet, add_array,
    ball_and_plate, check_error, check_hexes,
    check_surfaces, digest, elements, hex_volumes, image, labels, main, mesh_of, points_of,
    producer, rectilinear, run)

N = 12
# refines only user-selected cells
ALONE = {"Refinement": "Automatic", "ThinCells": 0.0, "FineInterfaces": 0}
check_choice_error = functools.partial(check_error, **ALONE)
CELLS = np.zeros((N, N, N), int)
CELLS[4:6, 6:9, 2:4] = 1


def data_of(wishes=None, dtype=np.float64, **more):
    arrays = dict(zip(("ball", "plate"), ball_and_plate(N)))
    return image({**arrays, **({} if wishes is None else {"wish": np.asarray(wishes, dtype)}),
                  **more})


def of_array(wishes, make=None, dtype=np.float64, **properties):
    return mesh_of(data_of(wishes, dtype), make, RefinementArray="wish", **{**ALONE, **properties})


def of_boxes(*boxes, **properties):
    return mesh_of(data_of(), RefinementBoxes=[number for box in boxes for number in box],
                   **{**ALONE, **properties})


def box(lower, upper, halvings=1):
    """Returns a box, whose corners are given in cells, as numbers of RefinementBoxes."""
    place = lambda at: [ORIGIN[a] + at[a] * SPACING[a] for a in range(3)]
    return place(lower) + place(upper) + [halvings]


def in_box(lower, upper, halvings=1):
    """Returns the array that selects the cells in a box with corners at nodes."""
    wishes = np.zeros((N, N, N), int)
    wishes[lower[2]:upper[2], lower[1]:upper[1], lower[0]:upper[0]] = halvings
    return wishes


def sizes(wishes, **properties):
    """Returns for each cell the largest volume of the elements in it, in cell volumes.

    All space is meshed and no node moves.
    """
    result = of_array(wishes, StairStep=1, MeshVoid=1, **properties)
    check_hexes(result)
    points, cells = points_of(result), elements(result)
    assert np.isclose(hex_volumes(points, cells).sum(), N ** 3 * np.prod(SPACING))
    where = ((points[cells].mean(axis=1) - ORIGIN) / SPACING).astype(int)
    largest = np.zeros((N, N, N))
    np.maximum.at(largest, tuple(where.T[::-1]), hex_volumes(points, cells) / np.prod(SPACING))
    return largest


def distance_to(cells):
    """Returns the distance of each cell to the nearest selected cell, the maximum over the axes."""
    every = np.stack(np.meshgrid(*[np.arange(N)] * 3, indexing="ij"), axis=-1)
    return np.abs(every[..., None, :] - np.argwhere(cells)).max(axis=-1).min(axis=-1)


def test_chosen_cells_are_halved_and_far_ones_are_not():
    largest = sizes(CELLS)
    assert largest[CELLS == 1].max() < 0.126, largest[CELLS == 1].max()
    far = largest[distance_to(CELLS) > 4]
    assert far.size > 100 and np.allclose(far, 1.0), (far.min(), far.max())


def test_cells_get_the_levels_that_they_ask_for():
    """Cells get the requested number of halvings, up to MaximumLevel."""
    wishes = CELLS.copy()
    wishes[10, 1, 10], wishes[9, 1, 11] = 2, 2
    largest = sizes(wishes)
    assert largest[wishes == 2].max() < 0.0157 and largest[wishes == 1].max() < 0.126
    assert np.isclose(largest[wishes == 1].max(), 0.125)
    assert np.allclose(sizes(wishes, MaximumLevel=1)[wishes == 2], 0.125)
    result = of_array(wishes)
    assert len(result.field("LevelCells")) == 3 and result.field("ChosenCells") == [14]
    assert len(of_array(wishes, MaximumLevel=1).field("LevelCells")) == 2


def test_meshes_are_valid_and_keep_volumes():
    for properties in ({}, {"MeshVoid": 1}, {"FineInterfaces": 1}, {"ThinCells": 2.0},
                       {"InterfaceLayers": 1, "MaximumLevel": 1}):
        result = of_array(CELLS, **properties)
        check_hexes(result)
        assert np.allclose(result.field("MeshVolume"), result.field("TargetVolume"), rtol=1e-6,
                           atol=0)
        assert result.field("ChosenCells") == [12]
        assert result.field("MinimumScaledJacobian")[0] > 0.3, (
            properties, result.field("MinimumScaledJacobian"))


def test_fine_interfaces_get_the_finest_cells():
    """With FineInterfaces, one selected cell far from all interfaces makes them all fine."""
    wishes = np.zeros((N, N, N), int)
    wishes[0, 0, 0] = 1
    count = lambda **properties: of_array(wishes, **properties).mesh.GetNumberOfCells()
    plain = mesh_of(data_of()).mesh.GetNumberOfCells()
    assert plain < count() < 1.5 * plain and count(FineInterfaces=1) > 3 * plain


def test_tetrahedra():
    plain = mesh_of(data_of(), VolumeFractionToTet, Method="Cells").mesh.GetNumberOfCells()
    for method in TET_METHODS:
        result = of_array(CELLS, VolumeFractionToTet, Method=method)
        check_surfaces(result)
        assert result.cells(
            "ScaledJacobian").min() > 0 and result.mesh.GetNumberOfCells() > 1.5 * plain, method
        assert np.allclose(result.field("MeshVolume"), result.field("TargetVolume"), rtol=1e-6)


def test_types_of_arrays():
    expected = digest(of_array(CELLS))
    for dtype in (np.uint8, np.int8, np.int16, np.int32, np.int64, np.uint64, np.float32):
        assert digest(of_array(CELLS, dtype=dtype)) == expected, dtype


def test_nothing_chosen_changes_nothing():
    """Without selected cells, or with Refinement off, the mesh is unchanged."""
    plain = mesh_of(data_of(), Refinement="Off")
    result = of_array(0 * CELLS)
    assert digest(result) == digest(plain)
    assert result.field("ChosenCells") == plain.field("ChosenCells") == [0] and not result.warnings
    # Only Automatic uses the array.
    assert digest(of_array(CELLS, Refinement="Off")) == digest(plain)
    assert digest(of_boxes(box((2, 6, 4), (4, 9, 6), 0))) == digest(plain)


def test_boxes_are_arrays():
    """A box selects the same cells as an array."""
    expected = digest(of_array(CELLS))
    assert digest(of_boxes(box((2, 6, 4), (4, 9, 6)))) == expected
    # Each cell that a box overlaps is selected.
    assert digest(of_boxes(box((2.99, 6.1, 4.5), (3.01, 8.2, 5.3)))) == expected
    assert digest(of_boxes(box((2.5, 6, 4), (3.5, 8, 6)), box((2, 7.5, 4), (4, 9, 6)))) == expected
    flat = of_boxes(box((2, 8.5, 4), (4, 8.5, 6)), box((2, 6.5, 4), (4, 7.5, 5)),
                    box((2, 6.5, 5), (4, 7.5, 6)))
    assert digest(flat) == expected and flat.field("ChosenCells") == [12]
    two = in_box((0, 0, 0), (3, 3, 3), 2)
    both = np.maximum(two, in_box((2, 1, 1), (9, 4, 2)))
    assert digest(of_boxes(box((2, 1, 1), (9, 4, 2)),
                           box((-5, -5, -5), (3, 3, 3), 2))) == digest(of_array(both))
    mixed = mesh_of(data_of(two), RefinementArray="wish", RefinementBoxes=box((2, 1, 1), (9, 4, 2)),
                    **ALONE)
    assert digest(mixed) == digest(of_array(both)) and mixed.field("ChosenCells") == [
        (both > 0).sum()]
    infinite = ORIGIN[0] + 2 * SPACING[0]
    assert digest(of_boxes([infinite, -np.inf, -np.inf, np.inf, np.inf, np.inf,
                            1])) == digest(of_array(in_box((2, 0, 0), (N, N, N))))


def test_boxes_beside_cells_choose_none():
    """Boxes that only touch cells, or lie outside, select none and give a warning."""
    result = of_boxes(box((3, 3, 3), (3, 4, 4)), box((2, 6, 4), (4, 9, 6)),
                      box((20, 20, 20), (21, 21, 21)))
    assert len(result.warnings) == 1 and "box 1, 3" in result.warnings[0], result.warnings
    assert digest(result) == digest(of_array(CELLS))
    # an overlap below a thousandth of the cell width
    tiny = of_boxes(box((2, 6, 4), (4.0005, 9, 6)))
    assert digest(tiny) == digest(of_array(CELLS)) and not tiny.warnings


def test_properties_can_be_cleared():
    mesher = VolumeFractionToHex(Input=producer(data_of(CELLS)),
                                 VolumeFractionArrays=["ball", "plate"], RefinementArray="wish",
                                RefinementBoxes=box((2, 6, 4), (4, 9, 6)), **ALONE)
    algorithm = mesher.GetClientSideObject()
    mesher.UpdatePipeline()
    assert "RefinementBoxes: None" not in str(algorithm) and "RefinementArray: wish" in str(
        algorithm)
    refined = algorithm.GetOutputDataObject(0).GetNumberOfCells()
    mesher.RefinementBoxes, mesher.RefinementArray = [], "None"
    mesher.UpdatePipeline()
    assert "RefinementBoxes: None" in str(algorithm) and algorithm.GetOutputDataObject(
        0).GetNumberOfCells() < refined


def test_rectilinear_grids():
    ball, plate = ball_and_plate(N)
    graded = lambda a: (ORIGIN[a] + SPACING[a]
                        * np.cumsum(np.concatenate([[0], 1.03 ** np.arange(N)]))).tolist()
    x = [graded(a) for a in range(3)]
    grid = rectilinear({"ball": ball, "plate": plate, "wish": CELLS}, x)
    result = mesh_of(grid, RefinementArray="wish", **ALONE)
    check_hexes(result)
    place = [x[0][2], x[1][6], x[2][4], x[0][4], x[1][9], x[2][6], 1]
    assert digest(mesh_of(grid, RefinementBoxes=place,
                          **ALONE)) == digest(result) != digest(mesh_of(grid, Refinement="Off"))


def test_hexahedra_in_any_order():
    """Hexahedra in any order, as in Exodus files, give the same mesh."""
    ball, plate = ball_and_plate(N)
    grid = hexes({"ball": ball, "plate": plate, "wish": CELLS},
                 np.random.default_rng(3).permutation(N ** 3),
                 [ORIGIN[a] + SPACING[a] * np.arange(N + 1) for a in range(3)])
    assert digest(mesh_of(grid, RefinementArray="wish", **ALONE)) == digest(of_array(CELLS))


def test_labels():
    result = mesh_of(image({"id": labels(N), "wish": CELLS}), MaterialIdArray="id",
                     RefinementArray="wish", LabelSmoothing=2, **ALONE)
    check_hexes(result)
    assert len(result.field("LevelCells")) == 2 and result.field("ChosenCells") == [12]


def test_cut_cells():
    """If cells are cut because of their aspect ratio, each part is halved."""
    result = of_array(CELLS, MaximumAspectRatio=1.1)
    check_hexes(result)
    parts = data_of(CELLS)  # Cells of 0.25 x 0.25 x 0.5 are cut in two along z.
    cut = image({"ball": parts_of(parts, "ball"), "plate": parts_of(parts, "plate"),
                 "wish": parts_of(parts, "wish")})
    cut.SetSpacing(SPACING[0], SPACING[1], SPACING[2] / 2)
    expected = mesh_of(cut, RefinementArray="wish", **ALONE)
    assert result.field("ChosenCells") == [12] and expected.field("ChosenCells") == [24]
    assert result.field("RefinedCells") == expected.field("RefinedCells")
    parent = of_array(CELLS, MaximumAspectRatio=1.1, ChildFractions="Parent")
    assert digest(parent) == digest(mesh_of(cut, RefinementArray="wish", ChildFractions="Parent",
                                            **ALONE))


def parts_of(data, name):
    array = data.GetCellData().GetArray(name)
    values = np.array([array.GetValue(i)
                       for i in range(array.GetNumberOfTuples())]).reshape(N, N, N)
    return values.repeat(2, 0)


def test_blanked_cells_ask_for_nothing():
    """Values of blanked cells are ignored, also if they are invalid."""
    blank = np.zeros((N, N, N), np.uint8)
    blank[4:6, 6:9, 2] = HIDDEN
    wild = CELLS.astype(float)
    wild[blank > 0] = np.nan
    data = data_of(wild)
    add_array(data.GetCellData(), "vtkGhostType", blank)
    kept = data_of(np.where(blank > 0, 0, CELLS))
    add_array(kept.GetCellData(), "vtkGhostType", blank)
    result = mesh_of(data, RefinementArray="wish", **ALONE)
    assert result.field("ChosenCells") == [6] and digest(result) == digest(
        mesh_of(kept, RefinementArray="wish", **ALONE))
    assert mesh_of(data, RefinementBoxes=box((2, 6, 4), (4, 9, 6)),
                   **ALONE).field("ChosenCells") == [6]


def amr_of(wishes, blocks, levels, **properties):
    """Returns the mesh for one array `wish` per level."""
    return mesh_of(multiblock(fields(levels), blocks, extra=[{"wish": own} for own in wishes]),
                   RefinementArray="wish", **{**ALONE, **properties})


MIDDLE = [(0, part) for part in cut(6, 2)] + [(1, ((4, 8), (4, 8), (4, 8)))]


def nothing(level):
    return np.zeros((6 << level,) * 3)


def test_levels_of_the_input():
    """Halvings count from the level of the cell.

    A coarse cell needs no further level if the levels of finer blocks meet its request.
    """
    plain = amr_of([nothing(0), nothing(1)], MIDDLE, 1)
    assert len(plain.field("LevelCells")) == 2 and plain.field("ChosenCells") == [0]
    coarse = nothing(0)
    coarse[5, 0, 0] = 1  # at a corner, away from finer blocks
    once = amr_of([coarse, nothing(1)], MIDDLE, 1)
    check_hexes(once)
    assert len(once.field("LevelCells")) == 2 and once.field("ChosenCells") == [1]
    assert once.field("RefinedCells")[0] > plain.field("RefinedCells")[0]
    twice = amr_of([2 * coarse, nothing(1)], MIDDLE, 1)
    check_hexes(twice)
    assert len(twice.field("LevelCells")) == 3
    assert digest(amr_of([2 * coarse, nothing(1)], MIDDLE, 1, MaximumLevel=1)) == digest(once)
    fine = nothing(1)
    fine[4, 4, 4] = 1
    finer = amr_of([coarse, fine], MIDDLE, 1)
    check_hexes(finer)
    assert len(finer.field("LevelCells")) == 3 and finer.field("ChosenCells") == [2]


def test_coarse_data_below_finer_are_ignored():
    covered = nothing(0)
    covered[2:4, 2:4, 2:4] = np.nan
    assert digest(amr_of([covered, nothing(1)], nested(1),
                         1)) == digest(amr_of([nothing(0), nothing(1)], nested(1), 1))


def test_boxes_in_levels():
    """A box selects the finest cells of the input in it."""
    wishes = [nothing(0), nothing(1)]
    wishes[0][:, :2, :2], wishes[1][:, :4, :4] = 1, 1
    end = [ORIGIN[0] + 2 * SPACING[0], ORIGIN[1] + 2 * SPACING[1], 100.0]
    by_box = mesh_of(multiblock(fields(1), nested(1)), RefinementBoxes=[-100.0] * 3 + end + [1],
                     **ALONE)
    by_array = amr_of(wishes, nested(1), 1)
    assert digest(by_box) == digest(by_array) and by_box.field("ChosenCells") == by_array.field(
        "ChosenCells")


def test_wishes_finer_than_the_mesh_are_left():
    """Requests of data finer than MaximumLevel, which are averaged, are ignored."""
    assert digest(amr_of([nothing(0), 1 + nothing(1)], nested(1), 1, MaximumLevel=0)) == digest(
        amr_of([nothing(0), nothing(1)], nested(1), 1, MaximumLevel=0))


def test_wrong_arrays():
    for value, text in ((np.nan, "nan"), (-1, "-1"), (1.5, "1.5"), (11, "11"), (np.inf, "inf")):
        wishes = CELLS.astype(float)
        wishes[3, 2, 1] = value
        check_choice_error(data_of(wishes), "'wish' holds " + text, "(1, 2, 3)",
                           "an integer from 0 to 10", RefinementArray="wish")
    check_choice_error(data_of(), "no numeric cell array 'wish'", RefinementArray="wish")
    vectors = data_of()
    add_array(vectors.GetCellData(), "wish", np.zeros((N, N, N, 3)))
    check_choice_error(vectors, "'wish' has 3", RefinementArray="wish")
    at_points = data_of()
    add_array(at_points.GetPointData(), "wish", np.zeros((N + 1, N + 1, N + 1)))
    check_choice_error(at_points, "'wish' is point data", RefinementArray="wish")
    result = run(multiblock(fields(1), nested(1), extra=[{"wish": nothing(0)}, {}]),
                 RefinementArray="wish", **ALONE)
    assert len(result.errors) == 1 and "'wish'" in result.errors[0]


def test_wrong_boxes():
    check_choice_error(data_of(), "box 2", "along y",
                       RefinementBoxes=box((1, 1, 1), (2, 2, 2)) + box((1, 2, 1), (2, 1, 2)))
    check_choice_error(data_of(), "box 1", "along z", RefinementBoxes=[0, 0, np.nan, 1, 1, 1, 1])
    for halvings in (-1, 0.5, 11, np.nan):
        check_choice_error(data_of(), "box 1", "an integer from 0 to 10",
                           RefinementBoxes=box((1, 1, 1), (2, 2, 2), halvings))


main(globals())
