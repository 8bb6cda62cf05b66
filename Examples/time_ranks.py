"""Measures the time and memory of Volume Fraction To Hex on a gyroid, on several ranks.

usage: mpiexec --bind-to none -n N pvbatch --sym Examples/time_ranks.py PLUGIN [CELLS]

CELLS is the number of cells per axis, 128 by default. Each rank uses one thread and prints one
line. The time is the time of the filter, without that of its input.
"""
import os
import resource
import sys
import time

from vtkmodules.vtkParallelCore import vtkMultiProcessController

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from load_plugin import load_plugin
from need_files import need_files


def peak_megabytes():
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024


def main(plugin, cells=128):
    need_files(plugin)
    cells = int(cells)
    load_plugin(plugin, globals())  # defines the source and the filter
    ranks = vtkMultiProcessController.GetGlobalController()
    field = VolumeFractionShapes(
        Shapes="gyroid material=1 center=0.1,0.2,0.3 period=16",
        Bounds=[0, cells, 0, cells, 0, cells], Dimensions=[cells, cells, cells])
    field.UpdatePipeline()
    before = peak_megabytes()
    hexes = VolumeFractionToHex(
        Input=field, VolumeFractionArrays=["Material1"], NumberOfThreads=1)
    ranks.Barrier()
    start = time.time()
    hexes.UpdatePipeline()
    ranks.Barrier()
    mine = hexes.GetClientSideObject().GetOutputDataObject(0).GetNumberOfCells()
    print("rank %d of %d: %.2f s, %d hexahedra, memory %.0f MB before, peak %.0f MB" % (
        ranks.GetLocalProcessId(), ranks.GetNumberOfProcesses(), time.time() - start, mine, before,
        peak_megabytes()), flush=True)


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    main(*sys.argv[1:])
