"""State arrays: each element has the values of the cell that the rule selects, in the same type."""
import random

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkBitArray, vtkSOADataArrayTemplate, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet

from state_rule import graded_coordinates, of_labels, specks, state_cells, with_void
from vfmtest import (
    GHOST, HIDDEN, ORIGIN, SPACING, TET_METHODS, add_array, ball_and_plate, check_error, digest,
    elements, fraction_image, image, labels,
    main, mesh_of, producer, rectilinear, uniform, VolumeFractionToHex, VolumeFractionToTet)

N = 12
NUMBERS = np.arange(N ** 3, dtype=np.int64).reshape(N, N, N)
COORDINATES = [ORIGIN[a] + SPACING[a] * np.arange(N + 1.0) for a in range(3)]
BALL, PLATE = ball_and_plate(N)
FRACTIONS = with_void({1: BALL, 2: PLATE})
NOISE = np.random.default_rng(3).choice([0, 2, 3, 5], (8, 8, 8)).astype(np.int32)
KINDS = [{}] + [{"make": VolumeFractionToTet, "Method": method} for method in TET_METHODS]


def with_numbers(arrays):
    shape = next(iter(arrays.values())).shape
    return image({**arrays, "number": np.arange(np.prod(shape), dtype=np.int64).reshape(shape)})


DATA = with_numbers({"ball": BALL, "plate": PLATE})


def check_rule(data, coordinates, fractions, **properties):
    """Checks the rule and returns how many elements use another cell than their own."""
    result = mesh_of(data, StateArrays=["number"], **properties)
    limited = properties.get("Method") != "TetGen"
    expected, moved = state_cells(result, coordinates, fractions, limited)
    wrong = (result.cells("number") != expected).sum()
    assert wrong == 0, (wrong, len(expected), properties)
    return moved


def test_rule_with_fractions():
    for kind in KINDS:
        moved = sum(check_rule(DATA, COORDINATES, FRACTIONS, MeshVoid=void, **kind)
                    for void in (0, 1))
        assert moved > 0, kind


def test_rule_with_labels():
    for kind in KINDS:
        moved = sum(check_rule(with_numbers({"id": ids}), [x[:len(ids) + 1] for x in COORDINATES],
                               of_labels(ids), MaterialIdArray="id", **kind)
                    for ids in (labels(N), NOISE))
        assert moved > 0, kind


def test_rule_on_graded_grids():
    speck, coordinates = specks(N), graded_coordinates(N)
    data = rectilinear({"speck": speck, "number": NUMBERS}, coordinates)
    for kind in KINDS:
        moved = check_rule(data, coordinates, with_void({1: speck}), VolumeFractionArrays=["speck"],
                           **kind)
        assert moved > 0, kind


def test_stair_steps_keep_their_cells():
    """An element of a stair-step mesh has the state of its cell."""
    ids = labels(N)
    result = mesh_of(with_numbers({"id": ids}), MaterialIdArray="id", StateArrays=["number"],
                     StairStep=1)
    assert (np.sort(result.cells("number")) == NUMBERS[ids > 0]).all()


def test_halves_of_cells_keep_the_values_of_the_whole():
    """Elements of halved cells have the state of the whole cell."""
    ids = labels(N)
    for refinement in (1, 2):
        result = mesh_of(
            with_numbers({"id": ids}), MaterialIdArray="id", StateArrays=["number"], StairStep=1,
            **uniform(refinement))
        assert (np.sort(result.cells("number")) == np.repeat(
            NUMBERS[ids > 0], 8 ** refinement)).all()
        centres = vtk_to_numpy(result.mesh.GetPoints().GetData())[elements(result)].mean(axis=1)
        i, j, k = ((centres - ORIGIN) / SPACING).astype(int).T
        assert (result.cells("number") == NUMBERS[k, j, i]).all()


def values_of(dtype, components):
    """Returns values that need the full range of the type."""
    if np.issubdtype(dtype, np.integer):
        limits = np.iinfo(dtype)
        values = np.random.default_rng(1).integers(limits.min, limits.max, (N, N, N, components),
                                                   dtype, endpoint=True)
    else:
        values = np.random.default_rng(1).normal(size=(N, N, N, components)).astype(dtype)
        values[0, 0, 0, 0], values[5, 5, 5, 0] = np.nan, np.inf
    return values


def check_values(data, values, name, **properties):
    """Checks a state array by 'number', the cell of each element, and returns it."""
    result = mesh_of(data, StateArrays=[name, "number"], **properties)
    found = result.mesh.GetCellData().GetArray(name)
    flat = values.reshape(N ** 3, -1)
    assert found.GetNumberOfComponents() == flat.shape[1]
    expected = flat[result.cells("number")]
    assert vtk_to_numpy(found).reshape(expected.shape).tobytes() == expected.tobytes(), (
        name, values.dtype)
    return found


def test_types_and_components():
    for dtype in (np.int8, np.uint8, np.int16, np.uint16, np.int32, np.uint32, np.int64, np.uint64,
                  np.float32, np.float64):
        for components in (1, 3, 9):
            values = values_of(dtype, components)
            data = with_numbers({"ball": BALL, "plate": PLATE})
            array = add_array(data.GetCellData(), "state", values)
            found = check_values(data, values, "state", StairStep=1)
            assert found.GetDataType() == array.GetDataType() and not found.HasAComponentName()


def test_component_names():
    values = values_of(np.float64, 3)
    data = with_numbers({"ball": BALL, "plate": PLATE})
    array = add_array(data.GetCellData(), "velocity", values)
    for c, name in ((0, "u along x"), (2, "w")):
        array.SetComponentName(c, name)
    found = check_values(data, values, "velocity")
    assert [found.GetComponentName(c) for c in range(3)] == ["u along x", None, "w"]


def test_arrays_that_are_not_plain_memory():
    values = values_of(np.int64, 3)
    columns = vtkSOADataArrayTemplate["int64"]()
    columns.SetName("columns")
    columns.SetNumberOfComponents(3)
    columns.SetNumberOfTuples(N ** 3)
    for (cell, component), value in np.ndenumerate(values.reshape(-1, 3)):
        columns.SetTypedComponent(cell, component, int(value))
    data = with_numbers({"ball": BALL, "plate": PLATE})
    data.GetCellData().AddArray(columns)
    assert not columns.HasStandardMemoryLayout()
    found = check_values(data, values, "columns")
    assert found.GetDataType() == columns.GetDataType()

    inside = BALL.ravel() > 0.25
    bits = vtkBitArray()
    bits.SetName("bits")
    for value in inside:
        bits.InsertNextValue(int(value))
    data.GetCellData().AddArray(bits)
    result = mesh_of(data, StateArrays=["bits", "number"])
    found = result.mesh.GetCellData().GetArray("bits")
    assert found.IsA("vtkBitArray") and found.GetNumberOfTuples() == result.mesh.GetNumberOfCells()
    assert [found.GetValue(i)
            for i in range(found.GetNumberOfTuples())] == inside[result.cells("number")].tolist()


def cell_arrays(result):
    data = result.mesh.GetCellData()
    return [data.GetArrayName(i) for i in range(data.GetNumberOfArrays())]


def test_the_mesh_stays_what_it_is():
    """State arrays do not change the rest of the mesh."""
    plain, carrying = mesh_of(DATA), mesh_of(DATA, StateArrays=["number", "ball", "number"])
    assert cell_arrays(carrying) == cell_arrays(plain) + ["number", "ball"]
    assert carrying.mesh.GetCellData().GetScalars().GetName() == "MaterialId"
    assert (carrying.cells("ball") == BALL.ravel()[carrying.cells("number")]).all()
    for name in ("number", "ball"):
        carrying.mesh.GetCellData().RemoveArray(name)
    assert digest(carrying) == digest(plain)


def test_threads():
    for kind in KINDS:
        one, two = (mesh_of(DATA, StateArrays=["number"], NumberOfThreads=n, **kind)
                    for n in (1, 2))
        assert digest(one) == digest(two), kind


def blocks(ghosts):
    """Returns DATA as eight blocks in random order.

    Ghost cells are marked and hold invalid values.
    """
    result = []
    arrays = {"ball": BALL, "plate": PLATE, "number": NUMBERS}
    cuts = [[(0, c), (c, N)] for c in (5, 7, 4)]  # z, y, x
    for z, y, x in ((z, y, x) for z in cuts[0] for y in cuts[1] for x in cuts[2]):
        window = tuple(slice(max(lower - ghosts, 0), upper + ghosts) for lower, upper in (z, y, x))
        own = np.zeros((N, N, N), bool)
        own[tuple(slice(*span) for span in (z, y, x))] = True
        own = own[window]
        parts = {name: np.where(own, values[window], -99).astype(values.dtype)
                 for name, values in arrays.items()}
        block = image({**parts, "vtkGhostType": np.where(own, 0, GHOST).astype(np.uint8)})
        block.SetOrigin([ORIGIN[a] + SPACING[a] * window[2 - a].start for a in range(3)])
        result.append(block)
    random.Random(5).shuffle(result)
    return result


def composite(parts):
    data = vtkMultiBlockDataSet()
    for i, part in enumerate(parts):
        data.SetBlock(i, part)
    return data


def test_blocks_and_ghosts():
    for kind in KINDS:
        reference = digest(mesh_of(DATA, StateArrays=["number"], **kind))
        for ghosts in (0, 2):
            assert digest(mesh_of(composite(blocks(ghosts)), StateArrays=["number"],
                                  **kind)) == reference, (kind, ghosts)


def test_blanked_cells_give_their_values():
    """Elements may take state from blanked cells."""
    hidden = np.zeros((N, N, N), np.uint8)
    hidden[4:8, 4:8, 4:8] = HIDDEN
    data = image({"ball": BALL, "plate": PLATE, "number": NUMBERS, "vtkGhostType": hidden})
    seen = {1: np.where(hidden, 0, BALL), 2: np.where(hidden, 0, PLATE)}
    check_rule(data, COORDINATES, with_void(seen), MeshVoid=1)
    result = mesh_of(data, MeshVoid=1, StateArrays=["number"])
    assert hidden.ravel()[result.cells("number")].any()


def offered(mesher, name):
    domain = mesher.GetProperty(name).SMProperty.GetDomain("array_list")
    return {domain.GetString(i) for i in range(domain.GetNumberOfStrings())}


def test_list_of_the_property():
    data = with_numbers({"ball": BALL, "plate": PLATE})
    add_array(data.GetCellData(), "velocity", values_of(np.float32, 3))
    for make in (VolumeFractionToHex, VolumeFractionToTet):
        mesher = make(Input=producer(data))
        assert list(mesher.StateArrays) == []
        assert offered(mesher, "StateArrays") == {"ball", "plate", "number", "velocity"}
        assert offered(mesher, "VolumeFractionArrays") == {"ball", "plate", "number"}
        mesher.VolumeFractionArrays = ["ball", "plate"]
        for chosen in (["velocity"], ["number", "velocity"], []):
            mesher.StateArrays = chosen
            mesher.UpdatePipeline()
            cells = mesher.GetClientSideObject().GetOutputDataObject(0).GetCellData()
            assert [name for name in ("number", "velocity") if cells.HasArray(name)] == chosen


def test_arrays_that_cannot_be_carried():
    data = fraction_image(N)
    check_error(data, "no numeric cell array 'density'", "'ball', 'plate'",
                StateArrays=["ball", "density"])
    text = vtkStringArray()
    text.SetName("names")
    text.SetNumberOfValues(N ** 3)
    data.GetCellData().AddArray(text)
    check_error(data, "no numeric cell array 'names'", StateArrays=["names"])
    add_array(data.GetPointData(), "nodal", np.zeros((N + 1,) * 3))
    check_error(data, "'nodal' is point data, and 'ball' is cell data", "Point Data to Cell Data",
                StateArrays=["nodal"])
    add_array(data.GetCellData(), "short", np.zeros((2, 2, 2, 3)))
    check_error(data, "'short' has 8 values for 1728 cells", StateArrays=["short"])


def test_names_that_the_mesh_needs():
    names = {name for kind in KINDS for name in cell_arrays(mesh_of(DATA, **kind))}
    assert len(names) == 4
    for name in names:
        data = image({"ball": BALL, "plate": PLATE, name: np.zeros((N, N, N), np.uint8)})
        check_error(data, "state array '%s'" % name, "the mesh itself", StateArrays=[name])


def test_blocks_that_disagree():
    for change, words in (
            (lambda cells: cells.GetArray("number").SetNumberOfComponents(2),
             "has 2 components of type"),
            (lambda cells: add_array(cells, "number", np.zeros((cells.GetNumberOfTuples(), 1, 1)),
                                     np.float32),
             "has 1 component of type float")):
        parts = blocks(0)
        change(parts[6].GetCellData())
        if "2 components" in words:
            parts[6].GetCellData().GetArray("number").SetNumberOfTuples(parts[6].GetNumberOfCells())
        check_error(composite(parts), "Block 6: the state array 'number' " + words,
                    "in other blocks it has 1 component of", StateArrays=["ball", "number"])
    parts = blocks(0)
    parts[3].GetCellData().RemoveArray("number")
    check_error(composite(parts), "Block 3 has no numeric cell array 'number'",
                StateArrays=["number"])


main(globals())
