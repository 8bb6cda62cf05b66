"""The property *Cells* of the panel: the cells that Cell Width makes, known before Apply."""
import os
import tempfile

import numpy as np
from paraview import simple
from vtkmodules.vtkCommonCore import vtkDoubleArray

from amr_cases import fields, nested, overlapping
from vfmtest import (VolumeFractionToHex, VolumeFractionToTet, at_points, ball_and_plate, image,
                     main, producer, rectilinear)

BALL, PLATE = ball_and_plate()
ARRAYS = {"ball": BALL, "plate": PLATE}


def shown(mesher):
    return mesher.SMProxy.GetProperty("CellCount").GetElement(0)


def grid(spacing=(1.0, 1.0, 1.0)):
    data = image(ARRAYS)
    data.SetSpacing(spacing)
    return data


def test_of_image():
    for make in (VolumeFractionToHex, VolumeFractionToTet):
        mesher = make(Input=producer(grid()))
        assert shown(mesher) == "12 x 12 x 12 of width 1", shown(mesher)
        for width, text in (("2", "6 x 6 x 6 of width 2"), ("2,4,0", "6 x 3 x 12 of 2 x 4 x 1"),
                            ("0.4", "narrower than 12 x 12 x 12 of width 1"),
                            ("two", "not a width"), ("0", "12 x 12 x 12 of width 1")):
            mesher.CellWidth = width
            assert shown(mesher) == text, shown(mesher)


def test_count_is_that_of_the_mesh():
    mesher = VolumeFractionToHex(Input=producer(grid()), VolumeFractionArrays=["ball", "plate"],
                                 MeshVoid=1, StairStep=1, CellWidth="3")
    mesher.UpdatePipeline()
    assert shown(mesher) == "4 x 4 x 4 of width 3", shown(mesher)
    assert mesher.GetDataInformation().GetNumberOfCells() == 4 ** 3


def test_of_turned_image():
    """Widths are along the axes of the image."""
    data = grid((1.0, 1.0, 2.0))
    c, s = np.cos(0.5), np.sin(0.5)
    data.SetDirectionMatrix(c, -s, 0, s, c, 0, 0, 0, 1)
    mesher = VolumeFractionToHex(Input=producer(data), CellWidth="3")
    assert shown(mesher) == "4 x 4 x 8 of width 3", shown(mesher)


def test_of_points():
    """Points are the centres of cells."""
    data = at_points(grid())
    mesher = VolumeFractionToHex(Input=producer(data))
    assert shown(mesher) == "12 x 12 x 12 of width 1", shown(mesher)
    data.GetCellData().AddArray(cell_array(data))
    mesher = VolumeFractionToHex(Input=producer(data))
    assert shown(mesher) == "11 x 11 x 11 of width 1", shown(mesher)
    mesher.MaterialIdArray = ["POINTS", "ball"]
    assert shown(mesher) == "12 x 12 x 12 of width 1", shown(mesher)


def cell_array(data):
    array = vtkDoubleArray()
    array.SetName("other")
    array.SetNumberOfTuples(data.GetNumberOfCells())
    array.Fill(0.5)
    return array


def test_of_other_grids():
    """Without equal cells, only the new ones are known."""
    mesher = VolumeFractionToHex(Input=producer(rectilinear(ARRAYS, [np.arange(13.0) ** 1.5] * 3)))
    assert shown(mesher) == "12 x 12 x 12 of width 3.464", shown(mesher)
    mesher.CellWidth = "6"
    assert shown(mesher) == "7 x 7 x 7 of width 5.938", shown(mesher)
    levels = overlapping(fields(2), nested(2))
    mesher = VolumeFractionToHex(Input=producer(levels))
    assert shown(mesher) == "", shown(mesher)
    mesher.CellWidth = str(levels_width(levels) / 4)
    assert shown(mesher).startswith("4 x "), shown(mesher)


def levels_width(levels):
    bounds = np.zeros(6)
    levels.GetBounds(bounds)
    return bounds[1] - bounds[0]


def test_trace():
    """It is not a choice of the user, so scripts that ParaView writes do not have it."""
    path = os.path.join(tempfile.mkdtemp(), "state.py")
    mesher = VolumeFractionToHex(Input=producer(grid()), CellWidth="2")
    assert shown(mesher) == "6 x 6 x 6 of width 2"
    from paraview import smstate
    text = smstate.get_state()
    assert "CellWidth = '2'" in text and "CellCount" not in text, text


main(globals())
