"""Input that cannot be meshed gives one message and empty outputs; the next run works."""
import os
import tempfile

import numpy as np
from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonDataModel import (
    vtkImageData, vtkMultiBlockDataSet, vtkNonOverlappingAMR, vtkPolyData, vtkTable,
    vtkUniformGrid)
from vtkmodules.vtkCommonCore import vtkStringArray

from amr_cases import set_boxes
from vfmtest import (
    GHOST, ORIGIN, SPACING, add_array, at_points, ball_and_plate, check_error, collect, failure_of,
    fraction_image, image, labels, main,
    producer, rectilinear, run, VolumeFractionFragments, VolumeFractionToHex, servermanager)

N = 8


def arrays():
    ball, plate = ball_and_plate(N)
    return {"ball": ball, "plate": plate}


def changed(name, cell, value, dtype=np.float64):
    """Returns the field with one value changed; cell is (i, j, k)."""
    values = {key: array.astype(dtype) for key, array in arrays().items()}
    values[name][cell[::-1]] = value
    return image(values)


def blocks(*data):
    result = vtkMultiBlockDataSet()
    for i, block in enumerate(data):
        result.SetBlock(i, block)
    return result


def half(part, spacing=SPACING, shift=0.0):
    """Returns half of the field along x, moved by `shift`."""
    values = {name: array[:, :, part * N // 2:(part + 1) * N // 2].copy()
              for name, array in arrays().items()}
    data = image(values)
    data.SetSpacing(spacing)
    data.SetOrigin(ORIGIN[0] + part * N // 2 * SPACING[0] + shift, *ORIGIN[1:])
    return data


def test_no_array_chosen():
    check_error(fraction_image(N), "No array is chosen", "Tick Volume Fraction Arrays",
                "Material Id Array", VolumeFractionArrays=[])


def test_both_ways_chosen():
    check_error(fraction_image(N), "Choose one or the other", "'ball'", MaterialIdArray="ball",
                VolumeFractionArrays=["plate"])


def test_array_that_is_missing():
    check_error(fraction_image(N), "no numeric cell array 'void'", "'ball', 'plate'",
                VolumeFractionArrays=["ball", "void"])
    check_error(fraction_image(N), "no numeric cell array 'id'", MaterialIdArray="id")
    bad = half(1)
    bad.GetCellData().RemoveArray("plate")
    check_error(blocks(half(0), bad), "Block 1 has no numeric cell array 'plate'")


def test_array_of_text():
    data = fraction_image(N)
    text = vtkStringArray()
    text.SetName("names")
    text.SetNumberOfValues(N ** 3)
    data.GetCellData().AddArray(text)
    check_error(data, "no numeric cell array 'names'", VolumeFractionArrays=["names"])


def test_point_data():
    data = fraction_image(N)
    add_array(data.GetPointData(), "nodal", np.zeros((N + 1,) * 3))
    check_error(data, "'nodal' is point data, and 'ball' is cell data", "of one kind",
                VolumeFractionArrays=["ball", "nodal"])
    check_error(data, "'ball' is cell data, and 'nodal' is point data",
                VolumeFractionArrays=["nodal", "ball"])
    check_error(data, "'ball' is cell data, and 'nodal' is point data",
                VolumeFractionArrays=["nodal"], StateArrays=["ball"])
    check_error(data, "'ball' is cell data, and 'nodal' is point data",
                VolumeFractionArrays=["POINTS", "nodal", "CELLS", "ball"])
    check_error(data, "no numeric point array 'ball'", "'nodal'",
                MaterialIdArray=["POINTS", "ball"])
    check_error(data, "no numeric cell array 'nodal'", MaterialIdArray=["CELLS", "nodal"])
    check_error(data, "'ball' is chosen as data of neither cells nor points",
                MaterialIdArray=["FIELD", "ball"])
    grid = rectilinear(arrays(), [np.arange(N + 1.0)] * 3)
    add_array(grid.GetPointData(), "nodal", np.zeros((N + 1,) * 3))
    check_error(grid, "is a vtkRectilinearGrid, and point data are chosen", "Resample To Image",
                VolumeFractionArrays=["nodal"])
    check_error(blocks(image(arrays()), at_points(image(arrays()))),
                "'ball' is cell data in some blocks, and point data")


def test_several_components():
    data = fraction_image(N)
    add_array(data.GetCellData(), "velocity", np.zeros((N, N, N, 3)))
    check_error(data, "'velocity' has 3 components", VolumeFractionArrays=["velocity"])
    add_array(data.GetCellData(), "ids", np.zeros((N, N, N, 2), np.int32))
    check_error(data, "'ids' has 2 components", MaterialIdArray="ids")


def test_array_of_wrong_length():
    data = fraction_image(N)
    add_array(data.GetCellData(), "short", np.zeros((2, 2, 2)))
    check_error(data, "'short' has 8 values for 512 cells", VolumeFractionArrays=["short"])


def test_values_that_are_no_fractions():
    for value, text in ((np.nan, "nan"), (np.inf, "inf"), (-np.inf, "-inf")):
        check_error(changed("ball", (1, 2, 3), value), "'ball' holds " + text, "cell (1, 2, 3)",
                    "finite")
    for value in (-1e-5, 1 + 1e-5, 255.0):
        check_error(changed("plate", (7, 0, 4), value), "'plate' holds", "cell (7, 0, 4)", "[0, 1]")
    check_error(changed("ball", (0, 0, 7), np.nan, np.float32), "'ball' holds nan",
                "cell (0, 0, 7)")
    check_error(changed("ball", (0, 0, 0), 2, np.int32), "'ball' holds 2", "cell (0, 0, 0)")


def test_values_that_are_almost_fractions():
    data = changed("ball", (7, 7, 7), -5e-7)
    assert not run(data).errors
    assert not run(changed("plate", (0, 0, 0), 1 + 5e-7)).errors


def test_values_that_are_clipped():
    data = changed("ball", (7, 7, 7), -0.01)
    check_error(data, "'ball' holds -0.01 in cell (7, 7, 7)",
                "FractionTolerance 0.011 (--clip 0.011)")
    result = run(data, FractionTolerance=0.02)
    assert not result.errors and result.field("ClippedCells") == [1], result.errors
    assert (len(result.warnings) == 1 and "fractions of 1 cells lay outside [0, 1] and were clipped"
            in result.warnings[0])
    check_error(changed("ball", (7, 7, 7), -0.03), "'ball' holds -0.03", FractionTolerance=0.02)
    check_error(changed("ball", (7, 7, 7), 1.5), "'ball' holds 1.5", FractionTolerance=0.02)


def test_sums_over_one():
    check_error(changed("ball", (3, 3, 0), 0.25), "cell (3, 3, 0) sum to 1.25",
                "separate materials")
    result = run(changed("ball", (3, 3, 0), 5e-4))
    assert not result.errors
    assert len(result.warnings) == 1 and "1 cells sum to slightly more than 1" in result.warnings[0]
    assert result.field("NormalisedCells") == [1]


def test_material_ids_that_are_not_whole_numbers():
    for dtype in (np.float32, np.float64):
        for value, text in ((1.5, "1.5"), (-1, "-1"), (np.nan, "nan"), (np.inf, "inf"),
                            (2.0 ** 31, "2147483648"), (0.998, "0.998"), (-np.inf, "-inf")):
            ids = labels(N).astype(dtype)
            ids[6, 5, 4] = value
            check_error(image({"id": ids}), "'id' holds %s in cell (4, 5, 6)" % text,
                        "material ids are integers", MaterialIdArray="id")


def test_arrays_that_hold_no_materials():
    marks = np.zeros((N, N, N), np.uint8)
    data = image({**arrays(), "vtkGhostType": marks,
                  "GlobalCellIds": np.arange(N ** 3).reshape(N, N, N)})
    for properties in ({"VolumeFractionArrays": ["vtkGhostType"]},
                       {"VolumeFractionArrays": ["ball", "vtkGhostType"]},
                       {"MaterialIdArray": "vtkGhostType"}, {"StateArrays": ["vtkGhostType"]},
                       {"Refinement": "Automatic", "RefinementArray": "vtkGhostType"}):
        check_error(data, "'vtkGhostType' only marks", **properties)
    for properties in ({"VolumeFractionArrays": ["GlobalCellIds"]},
                       {"MaterialIdArray": "GlobalCellIds"}):
        check_error(data, "'GlobalCellIds' holds ids", **properties)
    data.GetCellData().SetGlobalIds(add_array(data.GetCellData(), "number",
                                              np.arange(N ** 3).reshape(N, N, N)))
    check_error(data, "'number' holds ids", MaterialIdArray="number")
    assert not run(data, StateArrays=["number"]).errors


def test_material_ids_out_of_range():
    for value in (-1, 2 ** 31):
        ids = labels(N).astype(np.int64)
        ids[6, 5, 4] = value
        check_error(image({"id": ids}), "'id' holds %d in cell (4, 5, 6)" % value,
                    MaterialIdArray="id")


def test_flat_and_empty_grids():
    flat = vtkImageData()
    flat.SetDimensions(5, 5, 1)
    add_array(flat.GetCellData(), "ball", np.zeros((1, 4, 4)))
    check_error(flat, "flat", "no cells along z", "Label Slices Reader reads pictures and slices",
                VolumeFractionArrays=["ball"])
    check_error(blocks(half(0), flat), "Block 1 is flat")
    check_error(vtkImageData(), "no cells")
    check_error(vtkMultiBlockDataSet(), "no cells")
    ghosts = fraction_image(N)
    add_array(ghosts.GetCellData(), "vtkGhostType", np.full((N, N, N), GHOST), np.uint8)
    check_error(ghosts, "no cells")


def test_direction_matrices():
    for matrix in ([[1, 0.1, 0], [0, 1, 0], [0, 0, 1]], [[2, 0, 0], [0, 1, 0], [0, 0, 1]],
                   [[1, 0, 0]] * 3, [[np.nan] * 3] * 3):
        check_error(at_points(fraction_image(N), matrix), "The input has the direction matrix",
                    "sheared or scaled")
    turned = at_points(fraction_image(N), [[0, -1, 0], [1, 0, 0], [0, 0, 1]])
    check_error(blocks(at_points(fraction_image(N)), turned), "different direction matrices")
    oblique = at_points(fraction_image(N), [[0.6, -0.8, 0], [0.8, 0.6, 0], [0, 0, 1]])
    check_error(oblique, "Refinement boxes have sides along x, y and z", Refinement="Automatic",
                RefinementBoxes=[0, 0, 0, 1, 1, 1, 1])


def test_points_of_several_levels():
    fine = at_points(half(1, spacing=[s / 2 for s in SPACING]))
    check_error(blocks(at_points(half(0)), fine), "several levels (AMR)", "cell data are needed")


def test_coordinates_that_do_not_increase():
    data = fraction_image(N)
    data.SetSpacing(1, -1, 1)
    check_error(data, "y coordinates do not increase")
    data.SetSpacing(1, 1, np.nan)
    check_error(data, "z coordinates do not increase or are not finite")


def test_blocks_of_other_kinds():
    check_error(blocks(half(0), vtkPolyData()), "Block 1 is a vtkPolyData", "Resample To Image")
    check_error(blocks(vtkTable()), "Block 0 is a vtkTable")


def test_blocks_that_do_not_tile():
    fine = half(1, spacing=[s / 2 for s in SPACING])
    check_error(blocks(half(0), fine), "leave a gap", "of level 0")
    check_error(blocks(half(0), half(1, shift=-0.1 * SPACING[0])), "does not fit", "along x")
    check_error(blocks(half(0), half(1, shift=2 * SPACING[0])), "leave a gap",
                "64 of the 576 cells", "cell (4, 0, 0) at (0, 0.5, 2)")
    check_error(blocks(half(0), half(1, shift=-SPACING[0])),
                "Block 0 and Block 1 overlap at cell (3, 0, 0)")
    check_error(blocks(half(0), half(1), half(1)), "Block 1 and Block 2 overlap")


def test_ghosts_inside_a_block():
    ghost = np.zeros((N, N, N), np.uint8)
    ghost[3, 4, 5] = GHOST
    check_error(image({**arrays(), "vtkGhostType": ghost}), "ghost cells", "among its own cells")


def test_levels_of_one_width():
    amr = vtkNonOverlappingAMR()
    set_boxes(amr, [1, 1])
    for level in range(2):
        amr.SetDataSet(level, 0, image(arrays(), kind=vtkUniformGrid))
    check_error(amr, "Block 0 and Block 1 overlap at cell (0, 0, 0)")


def test_more_cells_than_ids_can_number():
    data = vtkImageData()
    data.SetDimensions(2 ** 20, 2 ** 20, 2 ** 20)
    check_error(data, "more than 64-bit ids can number")


def test_options_out_of_range():
    for value in (0.0, 1.0, -1.0, 2.0, float("nan")):
        check_error(fraction_image(N), "IsoValue", IsoValue=value)
    for value in (-0.1, 1.0, float("nan")):
        check_error(fraction_image(N), "TargetScaledJacobian", TargetScaledJacobian=value)


def test_input_of_another_kind():
    hexes = VolumeFractionToHex(Input=producer(vtkPolyData()), VolumeFractionArrays=["ball"])
    collect(hexes.GetClientSideObject())
    errors = []
    hexes.GetClientSideObject().GetExecutive().AddObserver("ErrorEvent",
                                                           lambda *_: errors.append(1))
    hexes.UpdatePipeline()
    assert errors


class Failing(VTKPythonAlgorithmBase):
    def __init__(self):
        super().__init__(nInputPorts=0, nOutputPorts=1, outputType="vtkUnstructuredGrid")
        self.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)

    def RequestData(self, request, inputs, outputs):
        return 0


def test_writers_refuse_a_mesh_that_failed():
    """Writers report why a mesh is missing, write no file, and work again after the correction."""
    hexes = VolumeFractionToHex(Input=producer(fraction_image(N)))
    collect(hexes.GetClientSideObject())
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "mesh.inp")
        proxy = servermanager.ProxyManager().NewProxy("writers", "VolumeFractionAbaqusWriter")
        proxy.GetProperty("FileName").SetElement(0, path)
        proxy.UpdateVTKObjects()
        writer = proxy.GetClientSideObject()
        writer.SetInputConnection(hexes.GetClientSideObject().GetOutputPort())
        errors, _ = collect(writer)
        for expected in (0, 0, 1):
            hexes.VolumeFractionArrays = ["ball"] if expected else ["none"]
            hexes.UpdateVTKObjects()
            assert writer.Write() == expected == int(os.path.exists(path)) == int(
                writer.GetErrorCode() == 0)
        assert (len(errors) == 2 and "Cannot write %s: The mesh could not be made: " % path
                in errors[0]), errors
        failing = Failing()
        # RequestData of the writer is not called.
        writer.SetInputConnection(failing.GetOutputPort())
        assert writer.Write() == 0 and "The input could not be made." in errors[2] and len(
            errors) == 3, errors


def test_filters_behind_a_mesh_that_failed():
    """Filters downstream of a failed mesh report the failure once."""
    hexes = VolumeFractionToHex(Input=producer(fraction_image(N)), VolumeFractionArrays=["none"])
    collect(hexes.GetClientSideObject())
    table = VolumeFractionFragments(Input=hexes)
    errors, _ = collect(table.GetClientSideObject())
    table.UpdatePipeline()
    output = table.GetClientSideObject().GetOutputDataObject(0)
    assert output.GetNumberOfRows() == 0 and failure_of(output).startswith(
        "The input could not be made: ")
    assert len(errors) == 1 and failure_of(output) in errors[0]


def test_the_same_filter_works_after_an_error():
    hexes = VolumeFractionToHex(Input=producer(fraction_image(N)),
                                VolumeFractionArrays=["ball", "none"])
    algorithm = hexes.GetClientSideObject()
    errors, _ = collect(algorithm)
    hexes.UpdatePipeline()
    assert len(errors) == 1 and algorithm.GetOutputDataObject(0).GetNumberOfCells() == 0
    hexes.VolumeFractionArrays = ["ball", "plate"]
    hexes.UpdatePipeline()
    assert len(errors) == 1 and algorithm.GetOutputDataObject(0).GetNumberOfCells() > 0
    hexes.IsoValue = 7
    hexes.UpdatePipeline()
    assert len(errors) == 2
    assert [algorithm.GetOutputDataObject(port).GetNumberOfCells() for port in range(4)] == [0] * 4


def test_empty_field_is_no_error():
    nothing = {name: 0 * array for name, array in arrays().items()}
    result = run(image(nothing))
    assert not result.errors and result.mesh.GetNumberOfCells() == 0
    assert len(result.warnings) == 1 and "The mesh is empty" in result.warnings[0]
    assert result.field("MaterialNames") == ["ball", "plate"]


main(globals())
