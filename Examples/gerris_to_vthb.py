"""Converts the octree of cells that Gerris writes into AMR data of VTK (.vthb).

usage: pvpython gerris_to_vthb.py CELLS.txt[.gz] OUT.vthb

CELLS.txt is written by OutputSimulation { format = text } of Gerris. The first line has the names,
'1:x 2:y 3:z 4:T ...'; each other line has the centre and the values of a leaf cell. The domain must
be one box of length 1 around 0. The coarsest leaves become level 0. The boxes of a level cover its
leaves and all refined cells. A refined cell has the mean of its children, so that the volume of a
fluid is equal on all levels.
"""
import gzip
import os
import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkAMRBox, vtkOverlappingAMR, vtkUniformGrid
from vtkmodules.vtkIOXML import vtkXMLUniformGridAMRWriter

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from need_files import need_files

DEEPEST = 12  # deepest level that coordinates of six digits can identify
LOWER = -0.5  # lower corner of the box of Gerris


def read_cells(path):
    """Returns the names of the fields, the centres (n, 3) as fractions of the box, and the values
    (n, fields)."""
    with (gzip.open if path.endswith(".gz") else open)(path, "rt") as file:
        names = [word.partition(":")[2] for word in file.readline().lstrip("# ").split()
                 if ":" in word]
        if names[:3] != ["x", "y", "z"]:
            raise SystemExit("%s has no cells of Gerris in three dimensions." % path)
        table = np.loadtxt(file, ndmin=2)
    return names[3:], table[:, :3] - LOWER, table[:, 3:len(names)]


def find_levels(centres):
    """Returns the level of each leaf. With n = 2^level cells along the box, a centre is at an odd
    multiple of 1 / 2n."""
    levels = np.full(len(centres), -1)
    for level in range(DEEPEST, -1, -1):
        halves = centres * 2 ** (level + 1)
        whole = np.round(halves)
        fits = (np.abs(halves - whole) < 0.1) & (whole % 2 == 1)
        levels[fits.all(axis=1) & (levels < 0)] = level
    if levels.min() < 0 or not np.isclose((0.125 ** levels).sum(), 1):
        raise SystemExit("These are not the leaves of one octree, the box of length 1 around 0.")
    return levels


def fill_levels(centres, levels, values):
    """Returns two dictionaries by level, from the level of the coarsest leaves: which cells exist
    (z, y, x), and their values (z, y, x, fields)."""
    exist, filled = {}, {}
    for level in range(levels.max(), levels.min() - 1, -1):
        n = 2 ** level
        leaves = levels == level
        x, y, z = np.floor(centres[leaves] * n).astype(int).T
        exist[level] = np.zeros((n, n, n), bool)
        filled[level] = np.zeros((n, n, n, values.shape[1]))
        if level + 1 in exist:
            families = lambda a: a.reshape(n, 2, n, 2, n, 2, *a.shape[3:])
            exist[level] = families(exist[level + 1]).all(axis=(1, 3, 5))
            filled[level] = families(filled[level + 1]).mean(axis=(1, 3, 5))
        exist[level][z, y, x] = True
        filled[level][z, y, x] = values[leaves]
    return exist, filled


def cover(cells):
    """Returns boxes, as slices in z y x, that contain each of these cells once. Each box grows from
    the first remaining cell along x, then y, then z."""
    left, boxes = cells.copy(), []
    while left.any():
        z, y, x = np.unravel_index(np.argmax(left), left.shape)
        end = lambda row: len(row) if row.all() else int(np.argmin(row))
        X = x + end(left[z, y, x:])
        Y = y + end(left[z, y:, x:X].all(axis=1))
        Z = z + end(left[z:, y:Y, x:X].all(axis=(1, 2)))
        boxes.append((slice(z, Z), slice(y, Y), slice(x, X)))
        left[boxes[-1]] = False
    return boxes


def make_amr(names, exist, filled):
    lists = {level: cover(exist[level]) for level in sorted(exist)}
    amr = vtkOverlappingAMR()
    counts = [len(boxes) for boxes in lists.values()]
    # VTK 9.6 and later, then older versions.
    (amr.Initialize(counts) if hasattr(amr, "GetAMRMetaData")
     else amr.Initialize(len(counts), counts))
    amr.SetOrigin([LOWER] * 3)
    amr.SetGridDescription(8)  # VTK_XYZ_GRID
    for number, (level, boxes) in enumerate(lists.items()):
        h = 0.5 ** level
        amr.SetSpacing(number, [h] * 3)
        for i, box in enumerate(boxes):
            first, end = [s.start for s in box[::-1]], [s.stop for s in box[::-1]]
            grid = vtkUniformGrid()
            grid.SetOrigin([LOWER + f * h for f in first])
            grid.SetSpacing([h] * 3)
            grid.SetDimensions([e - f + 1 for f, e in zip(first, end)])
            for name, values in zip(names, np.moveaxis(filled[level][box], 3, 0)):
                array = numpy_to_vtk(np.ascontiguousarray(values, np.float32).ravel(), deep=1)
                array.SetName(name)
                grid.GetCellData().AddArray(array)
            amr.SetAMRBox(number, i, vtkAMRBox([int(f) for f in first], [int(e) - 1 for e in end]))
            amr.SetDataSet(number, i, grid)
        print("level %d: cells of %g, %d leaves and others in %d boxes"
              % (number, h, exist[level].sum(), len(boxes)))
    return amr


def main(source, target):
    need_files(source)
    names, centres, values = read_cells(source)
    exist, filled = fill_levels(centres, find_levels(centres), values)
    writer = vtkXMLUniformGridAMRWriter()
    writer.SetFileName(target)
    writer.SetInputData(make_amr(names, exist, filled))
    writer.SetDataModeToBinary()
    if not writer.Write():
        raise SystemExit("%s cannot be written." % target)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        raise SystemExit(__doc__)
    main(*sys.argv[1:])
