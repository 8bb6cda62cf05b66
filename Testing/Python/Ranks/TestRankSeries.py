"""Ten time steps in one run: each mesh is correct, and memory does not grow.

usage: mpiexec -n 4 pvbatch --sym TestRankSeries.py FOLDER
"""
import os
import sys

import numpy as np
from paraview import simple
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter
from vtkmodules.vtkParallelCore import vtkMultiProcessController

from compare_meshes import merge, read_pieces
from vfmtest import SPACING, collect, image, main, save_data, VolumeFractionToHex

CONTROLLER = vtkMultiProcessController.GetGlobalController()
RANK = CONTROLLER.GetLocalProcessId()
FOLDER = os.path.join(sys.argv[1], "series")
DUMPS, N = 10, 24
WARM_UP = 4  # steps until all buffers have their final size
LARGEST_GROWTH = 2.0  # MB; a mesh takes about 8 MB


def radius(dump):
    return (0.25 + 0.015 * dump) * N


def write_dumps():
    z, y, x = np.meshgrid(*[np.arange(N) + 0.5] * 3, indexing="ij")
    distance = np.sqrt((x - N / 2) ** 2 + (y - N / 2) ** 2 + (z - N / 2) ** 2)
    os.makedirs(FOLDER, exist_ok=True)
    for dump in range(DUMPS):
        writer = vtkXMLImageDataWriter()
        writer.SetDataModeToBinary()
        writer.SetInputData(image({"ball": np.clip(radius(dump) - distance + 0.5, 0, 1)}))
        writer.SetFileName(os.path.join(FOLDER, "dump%d.vti" % dump))
        writer.Write()


def resident_memory():
    """Returns the resident memory in MB."""
    with open("/proc/self/statm", encoding="ascii") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE") / 2 ** 20


def test_time_series():
    if RANK == 0:
        write_dumps()
    CONTROLLER.Barrier()
    files = [os.path.join(FOLDER, "dump%d.vti" % dump) for dump in range(DUMPS)]
    hexes = VolumeFractionToHex(Input=simple.XMLImageDataReader(FileName=files),
                                VolumeFractionArrays=["ball"])
    errors, _ = collect(hexes.GetClientSideObject())
    path = os.path.join(FOLDER, "mesh.pvtu")
    memory = []
    for dump in list(range(DUMPS)) + list(range(DUMPS)):
        hexes.UpdatePipeline(dump)
        save_data(path, hexes)
        field = hexes.GetClientSideObject().GetOutputDataObject(0).GetFieldData()
        volume, target = (field.GetArray(name).GetValue(0)
                          for name in ("MeshVolume", "TargetVolume"))
        exact = 4 / 3 * np.pi * radius(dump) ** 3 * np.prod(SPACING)
        assert abs(volume / target - 1) < 1e-6 and abs(volume / exact
                                                       - 1) < 0.02, (dump, volume, target, exact)
        if RANK == 0:
            assert len(merge(read_pieces(path))["cells"]) > 500
        CONTROLLER.Barrier()
        memory.append(resident_memory())
    assert not errors, errors
    growth = max(memory[DUMPS + WARM_UP:]) - max(memory[WARM_UP:DUMPS])
    print("rank %d: %.1f MB, growth %.2f MB over %d dumps" % (RANK, memory[-1], growth, DUMPS))
    assert growth < LARGEST_GROWTH, memory


main(globals())
