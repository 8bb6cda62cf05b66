"""The filters and the Exodus writer as classes of plain VTK Python, without ParaView's proxies."""
import os
import sys
import tempfile

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOExodus import vtkExodusIIReader

sys.path.insert(0, os.environ["VFM_WRAPPERS"])
from volumefractionmesh.vtkVolumeFractionMeshFilters import (
    vtkVolumeFractionToHex, vtkVolumeFractionToTet)
from volumefractionmesh.vtkVolumeFractionMeshIO import vtkVolumeFractionExodusWriter


def field():
    data = vtkImageData()
    data.SetDimensions(7, 7, 7)
    values = np.zeros((6, 6, 6))
    values[2:4, 2:4, 1:5] = 1
    array = numpy_to_vtk(values.ravel(), deep=1)
    array.SetName("bar")
    data.GetCellData().AddArray(array)
    return data


def check_tets():
    tets = vtkVolumeFractionToTet()
    assert tets.GetMethod() == tets.METHOD_LATTICE
    tets.SetMethod(99)
    assert tets.GetMethod() == tets.METHOD_LATTICE
    tets.SetMethod(tets.METHOD_CELLS)
    tets.SetRelativeSize(0.5)
    assert "Method: Cells" in str(tets) and "RelativeSize: 0.5" in str(tets)
    tets.AddVolumeFractionArray("bar")
    tets.SetInputData(field())
    tets.Update()
    mesh, surfaces = tets.GetOutputDataObject(0), tets.GetOutputDataObject(1)
    assert mesh.GetCellType(
        0) == 10 and mesh.GetNumberOfCells() > 100 and surfaces.GetNumberOfCells() >= 80


def check_exodus(mesh):
    writer = vtkVolumeFractionExodusWriter()
    assert not writer.GetSingleFile() and "SingleFile: 0" in str(writer)
    with tempfile.TemporaryDirectory() as folder:
        writer.SetInputData(mesh)
        writer.SetFileName(os.path.join(folder, "mesh.exo"))
        assert writer.Write() == 1
        reader = vtkExodusIIReader()
        reader.SetFileName(writer.GetFileName())
        reader.UpdateInformation()
        assert (reader.GetObjectName(reader.ELEM_BLOCK, 0) == "bar"
                and reader.GetTotalNumberOfElements() == mesh.GetNumberOfCells())
        sides = {reader.GetObjectName(reader.SIDE_SET, i)
                 for i in range(reader.GetNumberOfSideSetArrays())}
        assert {"bar_to_Void", "bar_skin"} <= sides, sides
        writer.SetFileName(os.path.join(folder, "missing", "mesh.exo"))
        messages = []
        writer.AddObserver("ErrorEvent", lambda *_: messages.append(1))
        assert writer.Write() == 0 and len(messages) == 1


def main():
    hexes = vtkVolumeFractionToHex()
    assert hexes.GetNumberOfVolumeFractionArrays() == 0 and hexes.GetMaterialIdArray() == ""
    hexes.AddVolumeFractionArray("rest")
    hexes.ClearVolumeFractionArrays()
    for name in ("bar", "bar", ""):
        hexes.AddVolumeFractionArray(name)
    assert hexes.GetNumberOfVolumeFractionArrays() == 1
    assert hexes.GetVolumeFractionArray(0) == "bar" and hexes.GetVolumeFractionArray(1) is None
    hexes.AddStateArray("rest")
    hexes.ClearStateArrays()
    for name in ("bar", "bar", ""):
        hexes.AddStateArray(name)
    assert hexes.GetNumberOfStateArrays() == 1
    assert hexes.GetStateArray(0) == "bar" and hexes.GetStateArray(1) is None
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
    assert "VolumeFractionArrays: 'bar'" in str(hexes) and "StateArrays: 'bar'" in str(hexes)
    assert set(vtk_to_numpy(mesh.GetCellData().GetArray("bar"))) == {1.0}
    check_tets()
    check_exodus(mesh)
    print("%d hexahedra, %d quadrilaterals" % (mesh.GetNumberOfCells(),
                                               surfaces.GetNumberOfCells()))


main()
