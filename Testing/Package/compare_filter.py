"""Compares time and memory of the package and the filter on the same grid; prints a row per mesh.

usage: VFM_PLUGIN=build/lib/VolumeFractionMesh.so compare_filter.py PVPYTHON PYTHON [CELLS [RUNS]]

- PYTHON: a Python that has the package
- CELLS: cells along each side, default 128
- RUNS: runs of each, default 5

Runs alternate and use one thread. Memory is the peak minus the memory before the call. Time is
processor time, the minimum over the runs.
"""
import os
import subprocess
import sys
import time

CASES = ("hexes", "tets")


def held(most):
    """Returns the memory of this process in MB, or with `most` its peak since forget()."""
    with open("/proc/self/status", encoding="ascii") as file:
        return next(int(line.split()[1]) for line in file
                    if line.startswith("VmHWM" if most else "VmRSS")) / 1e3


def forget():
    with open("/proc/self/clear_refs", "w", encoding="ascii") as file:
        file.write("5")


def sphere(cells):
    """Returns fractions of a ball by sampling, (z, y, x), in float64."""
    import numpy as np

    x = (np.arange(2 * cells) + 0.5) / 2 - cells / 2
    inside = x[:, None, None] ** 2 + x[:, None] ** 2 + x**2 < (0.4 * cells) ** 2
    return inside.reshape(cells, 2, cells, 2, cells, 2).mean(axis=(1, 3, 5))


def report(make):
    """Calls make() and prints processor seconds, megabytes and the number of elements."""
    forget()
    before, start = held(False), time.process_time()
    elements = make()
    print("measured", time.process_time() - start, held(True) - before, elements)


def run_package(case, cells):
    import volume_fraction_mesh as vfm

    fractions = sphere(cells)
    kinds = {"hexes": vfm.hexes, "tets": vfm.tets}
    report(lambda: len(kinds[case](fractions, order="zyx", threads=1).cells))


def run_filter(case, cells):
    import numpy as np
    from paraview.simple import LoadPlugin
    from vtkmodules.util.numpy_support import numpy_to_vtk
    from vtkmodules.vtkCommonDataModel import vtkImageData
    import paraview.simple as simple

    LoadPlugin(os.path.abspath(os.environ["VFM_PLUGIN"]), ns=vars(simple))
    image = vtkImageData()
    image.SetDimensions(cells + 1, cells + 1, cells + 1)
    array = numpy_to_vtk(np.ascontiguousarray(sphere(cells)).ravel(), deep=True)
    array.SetName("fraction")
    image.GetCellData().AddArray(array)
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(image)
    make = {"hexes": simple.VolumeFractionToHex, "tets": simple.VolumeFractionToTet}[case]
    mesher = make(Input=source, VolumeFractionArrays=["fraction"], NumberOfThreads=1)
    if case == "tets":
        mesher.Method = "Lattice"

    def run():
        mesher.GetClientSideObject().Update()
        return mesher.GetClientSideObject().GetOutputDataObject(0).GetNumberOfCells()

    report(run)


def measure(program, side, case, cells):
    lines = subprocess.run([program, os.path.abspath(__file__), "--run", side, case, str(cells)],
                           check=True, stdout=subprocess.PIPE, text=True).stdout.splitlines()
    words = next(line for line in lines if line.startswith("measured")).split()
    return [float(word) for word in words[1:]]


def compare(pvpython, python, cells=128, runs=5):
    print("| %d^3 | filter s | package s | ratio | filter MB | package MB | ratio | elements |\n|%s"
          % (cells, "---|" * 8))
    for case in CASES:
        pairs = [(measure(pvpython, "filter", case, cells), measure(python, "package", case, cells))
                 for _ in range(runs)]
        other, own = (min(pair[i] for pair in pairs) for i in (0, 1))
        assert other[2] == own[2], "not the same mesh"
        print("| %s | %.2f | %.2f | %.3f | %.0f | %.0f | %.3f | %d |"
              % (case, other[0], own[0], own[0] / other[0], other[1], own[1], own[1] / other[1],
                 own[2]), flush=True)


def main():
    if sys.argv[1] == "--run":
        side, case, cells = sys.argv[2:]
        {"filter": run_filter, "package": run_package}[side](case, int(cells))
    else:
        pvpython, python, *numbers = sys.argv[1:]
        compare(pvpython, python, *map(int, numbers))


if __name__ == "__main__":
    main()
