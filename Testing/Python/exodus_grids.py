"""Hexahedra that form a Cartesian grid, and Exodus files of them.

usage: mpiexec -n P pvbatch --sym exodus_grids.py write FILE
       mpiexec -n P pvbatch --sym exodus_grids.py mesh READER STEP FILE OUT

The command write makes FILE.P.0, ..., each a ragged part of the grid. The command mesh makes a mesh
of FILE, which READER reads: OpenDataFile, IOSSReader or ExodusIIReader.
"""
import sys

import numpy as np
from vtkmodules import vtkIOIOSS
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import (
    VTK_HEXAHEDRON, VTK_VOXEL, vtkCellArray, vtkCompositeDataSet, vtkDataAssembly,
    vtkPartitionedDataSetCollection, vtkUnstructuredGrid)
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm, vtkStreamingDemandDrivenPipeline
from vtkmodules.vtkParallelCore import vtkMultiProcessController

from vfmtest import ORIGIN, SPACING, VolumeFractionToHex, ball_and_plate, main, needs_vtk, simple

CORNERS = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1],
                    [0, 1, 1]])
VOXEL_CORNERS = CORNERS[[0, 1, 3, 2, 4, 5, 7, 6]]
N = 12
UNIFORM = [ORIGIN[a] + SPACING[a] * np.arange(N + 1.0) for a in range(3)]
# The values are also exact as float.
GRADED = [np.cumsum(np.resize(widths, N + 1))
          for widths in ([0.25, 0.5, 0.375], [0.5, 0.25], [0.25])]
TIMES = [0.5, 2.0]


def fields(step=0):
    """Returns the element variables at a time: fractions of ball_and_plate, and "number"."""
    ball, plate = ball_and_plate(N)
    turn = slice(None, None, -1 if step else 1)
    return {"MAT_10": ball[turn], "MAT_20": plate[turn],
            "number": np.arange(N ** 3, dtype=float).reshape(N, N, N)}


def shuffled(seed=1):
    return np.random.default_rng(seed).permutation(N ** 3)


def ragged(rank, ranks):
    """Returns the cells nearest to the random point of this rank, in random order."""
    generator = np.random.default_rng(5)
    points = generator.uniform(0, N, (ranks, 3))
    cells = np.stack(np.unravel_index(np.arange(N ** 3), (N, N, N)), axis=1) + 0.5
    owner = np.argmin(((cells[:, None] - points[None]) ** 2).sum(axis=2), axis=1)
    return generator.permutation(np.flatnonzero(owner == rank))


def hexes(arrays, cells, coordinates=UNIFORM, kind=VTK_HEXAHEDRON):
    """Returns the cells with these numbers (x fastest), in that order.

    The grid has global ids and the cell arrays {name: values (z, y, x)}.
    """
    size = np.array([len(x) - 1 for x in coordinates])
    z, y, x = np.unravel_index(cells, size[::-1])
    corners = CORNERS if kind == VTK_HEXAHEDRON else VOXEL_CORNERS
    nodes = np.stack([x, y, z], axis=1)[:, None] + corners[None]
    ids = (nodes[..., 2] * (size[1] + 1) + nodes[..., 1]) * (size[0] + 1) + nodes[..., 0]
    used, connectivity = np.unique(ids, return_inverse=True)
    k, j, i = np.unravel_index(used, size[::-1] + 1)
    points = np.stack([coordinates[0][i], coordinates[1][j], coordinates[2][k]], axis=1)
    grid, holder, connected = vtkUnstructuredGrid(), vtkPoints(), vtkCellArray()
    holder.SetData(numpy_to_vtk(points, deep=1))
    connected.SetData(8, numpy_to_vtkIdTypeArray(connectivity.ravel().astype(np.int64), deep=1))
    grid.SetPoints(holder)
    grid.SetCells(kind, connected)
    for attributes, numbers in ((grid.GetCellData(), np.asarray(cells)),
                                (grid.GetPointData(), used)):
        array = numpy_to_vtkIdTypeArray(numbers.astype(np.int64) + 1, deep=1)
        array.SetName("ids")
        attributes.SetGlobalIds(array)
    for name, values in arrays.items():
        values = np.asarray(values)
        array = numpy_to_vtk(np.ascontiguousarray(values.reshape(-1, *values.shape[3:])[cells]),
                             deep=1)
        array.SetName(name)
        grid.GetCellData().AddArray(array)
    return grid


def element_blocks(grids):
    """Returns the grids {block: grid} in the form that the writer requires."""
    blocks, assembly = vtkPartitionedDataSetCollection(), vtkDataAssembly()
    assembly.SetRootNodeName("IOSS")
    root = assembly.AddNode("element_blocks")
    for b, (name, grid) in enumerate(grids.items()):
        blocks.SetPartition(b, 0, grid)
        blocks.GetMetaData(b).Set(vtkCompositeDataSet.NAME(), name)
        assembly.AddDataSetIndex(assembly.AddNode(name, root), b)
    blocks.SetDataAssembly(assembly)
    return blocks


class Steps(VTKPythonAlgorithmBase):
    """Source of element blocks that change with time."""

    def __init__(self, times, make):
        super().__init__(nInputPorts=0, nOutputPorts=1,
                         outputType="vtkPartitionedDataSetCollection")
        self.times, self.make = times, make

    def RequestInformation(self, request, inputs, outputs):
        info = outputs.GetInformationObject(0)
        info.Set(vtkStreamingDemandDrivenPipeline.TIME_STEPS(), self.times, len(self.times))
        info.Set(vtkStreamingDemandDrivenPipeline.TIME_RANGE(), [self.times[0], self.times[-1]], 2)
        info.Set(vtkAlgorithm.CAN_HANDLE_PIECE_REQUEST(), 1)
        return 1

    def RequestData(self, request, inputs, outputs):
        info = outputs.GetInformationObject(0)
        time = info.Get(vtkStreamingDemandDrivenPipeline.UPDATE_TIME_STEP())
        step = 0 if time is None else self.times.index(time)
        vtkPartitionedDataSetCollection.GetData(info).ShallowCopy(element_blocks(self.make(step)))
        return 1


def write_exodus(path, make, times=TIMES):
    """Writes an Exodus file. On several ranks all call this function, each with its part.

    make(step) returns {block: grid}.
    """
    needs_vtk(9, 2, "vtkIOSSWriter")
    source, writer = Steps(times, make), vtkIOIOSS.vtkIOSSWriter()
    writer.SetInputConnection(source.GetOutputPort())
    writer.SetFileName(path)
    writer.PreserveInputEntityGroupsOn()
    assert writer.Write()
    return path


def write_ragged(path):
    controller = vtkMultiProcessController.GetGlobalController()
    cells = ragged(controller.GetLocalProcessId(), controller.GetNumberOfProcesses())
    half = len(cells) // 2
    write_exodus(path,
                 lambda step: {"left": hexes(fields(step), cells[:half]),
                               "right": hexes(fields(step), cells[half:])})


def read(kind, path):
    """Returns a ParaView source with all element variables."""
    if kind == "OpenDataFile":
        return simple.OpenDataFile(path)
    source = getattr(simple, kind)(FileName=[path])
    source.UpdatePipelineInformation()
    if kind == "ExodusIIReader":
        source.ElementVariables = source.ElementVariables.Available
    return source


def mesh_of_reader(kind, step, path):
    """Meshes MAT_10 and MAT_20 at a time and transfers the numbers of the cells."""
    mesher = VolumeFractionToHex(
        Input=read(kind, path), VolumeFractionArrays=["MAT_10", "MAT_20"], StateArrays=["number"])
    mesher.UpdatePipeline(TIMES[step])
    return mesher


def run_script(command, *words):
    if command == "write":
        write_ragged(*words)
    else:
        kind, step, path, output = words
        simple.SaveData(output, proxy=mesh_of_reader(kind, int(step), path), DataMode="Binary")


if __name__ == "__main__":
    main({"test_script": lambda: run_script(*sys.argv[1:])})
