"""The filter as a class of plain VTK Python, without ParaView's proxies."""
import os
import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData

sys.path.insert(0, os.environ["VFM_WRAPPERS"])
from volumefractionmesh.vtkVolumeFractionMeshFilters import vtkVolumeFractionToHex


def field():
    data = vtkImageData()
    data.SetDimensions(7, 7, 7)
    values = np.zeros((6, 6, 6))
    values[2:4, 2:4, 1:5] = 1
    array = numpy_to_vtk(values.ravel(), deep=1)
    array.SetName("bar")
    data.GetCellData().AddArray(array)
    return data


def main():
    hexes = vtkVolumeFractionToHex()
    assert hexes.GetNumberOfVolumeFractionArrays() == 0 and hexes.GetMaterialIdArray() == ""
    hexes.AddVolumeFractionArray("rest")
    hexes.ClearVolumeFractionArrays()
    for name in ("bar", "bar", ""):
        hexes.AddVolumeFractionArray(name)
    assert hexes.GetNumberOfVolumeFractionArrays() == 1
    assert hexes.GetVolumeFractionArray(0) == "bar" and hexes.GetVolumeFractionArray(1) is None
    hexes.SetSmoothing(99)
    assert hexes.GetSmoothing() == hexes.SMOOTHING_GEOMETRY_BASED
    hexes.SetSmoothing(hexes.SMOOTHING_QUADRIC_SURFACE)
    hexes.SetInputData(field())
    hexes.Update()
    mesh, surfaces = hexes.GetOutputDataObject(0), hexes.GetOutputDataObject(1)
    assert mesh.GetNumberOfCells() >= 16 and surfaces.GetNumberOfCells() >= 40
    cells = mesh.GetNumberOfCells()
    hexes.UpdatePiece(1, 2, 0)
    assert hexes.GetOutputDataObject(0).GetNumberOfCells() == 0
    hexes.UpdatePiece(0, 2, 1)
    assert hexes.GetOutputDataObject(0).GetNumberOfCells() == cells
    time = hexes.GetMTime()
    hexes.AddVolumeFractionArray("bar")
    assert hexes.GetMTime() == time
    assert "VolumeFractionArrays: 'bar'" in str(hexes)
    print("%d hexahedra, %d quadrilaterals" % (mesh.GetNumberOfCells(), surfaces.GetNumberOfCells()))


main()
