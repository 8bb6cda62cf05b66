"""Refined input (AMR) for tests: a ball and a plate on several levels, in each kind of data set.

A block is (level, box), where box is ((z0, z1), (y0, y1), (x0, x1)) in cells of that level.
"""
import numpy as np
from vtkmodules.vtkCommonDataModel import (
    vtkAMRBox, vtkMultiBlockDataSet, vtkNonOverlappingAMR, vtkOverlappingAMR, vtkPartitionedDataSet,
    vtkPartitionedDataSetCollection, vtkUniformGrid)

from vfmtest import ORIGIN, SPACING, ball_and_plate, image, rectilinear

N = 6  # cells of level 0 along each axis


def means(values, ratio=2):
    """Returns the means over blocks of ratio^3 cells."""
    shape = [n for count in values.shape for n in (count // ratio, ratio)]
    return values.reshape(shape).mean(axis=(1, 3, 5))


def doubled(values):
    return values.repeat(2, 0).repeat(2, 1).repeat(2, 2)


def fields(levels, n=N):
    """Returns the arrays of each level, coarsest first.

    Fractions of a coarse level are the means over the
    next finer one. "number" encodes level and cell.
    """
    result = [dict(zip(("ball", "plate"), ball_and_plate(n << levels)))]
    for _ in range(levels):
        result.insert(0, {name: means(values) for name, values in result[0].items()})
    for level, arrays in enumerate(result):
        size = arrays["ball"].shape
        arrays["number"] = level * 10 ** 6 + np.arange(np.prod(size)).reshape(size)
    return result


def spacing(level):
    return [h / 2 ** level for h in SPACING]


def block_of(all_fields, block, extra=None, kind=vtkUniformGrid):
    """Returns the grid of a block; `extra`: further arrays of the whole level."""
    level, box = block
    window = tuple(slice(*span) for span in box)
    arrays = {name: np.ascontiguousarray(values[window])
              for name, values in {**all_fields[level], **(extra or {})}.items()}
    h = spacing(level)
    origin = [ORIGIN[a] + box[2 - a][0] * h[a] for a in range(3)]
    if kind == "rectilinear":
        return rectilinear(arrays,
                           [origin[a] + h[a] * np.arange(box[2 - a][1] - box[2 - a][0] + 1)
                            for a in range(3)])
    grid = image(arrays, kind=kind)
    grid.SetOrigin(origin)
    grid.SetSpacing(h)
    return grid


def cut(n, counts):
    """Returns the boxes of a cube of n^3 cells cut into `counts` parts along each axis."""
    spans = [(n * i // counts, n * (i + 1) // counts) for i in range(counts)]
    return [(z, y, x) for z in spans for y in spans for x in spans]


def everywhere(levels, parts=2):
    """Returns blocks of every level; the blocks of each level fill the domain."""
    return [(level, box) for level in range(levels + 1) for box in cut(N << level, parts)]


def nested(levels=2):
    """Returns blocks of level 0 everywhere and of finer levels in the middle.

    One block of level 1 lies at a corner of the domain.
    """
    blocks = [(0, box) for box in cut(N, 2)]
    if levels > 0:
        blocks += [(1, ((2, 12), (2, 10), (2, 6))), (1, ((2, 12), (2, 10), (6, 10))),
                   (1, ((0, 4), (10, 12), (10, 12)))]
    if levels > 1:
        blocks += [(2, ((8, 20), (6, 18), (8, 16)))]
    return blocks


def multiblock(all_fields, blocks, kind=vtkUniformGrid, extra=None):
    data = vtkMultiBlockDataSet()
    for i, block in enumerate(blocks):
        data.SetBlock(i, block_of(all_fields, block, extra and extra[block[0]], kind))
    return data


def collection(all_fields, blocks):
    data = vtkPartitionedDataSetCollection()
    for i, block in enumerate(blocks):
        part = vtkPartitionedDataSet()
        part.SetPartition(0, block_of(all_fields, block))
        data.SetPartitionedDataSet(i, part)
    return data


def by_level(all_fields, blocks, extra=None):
    grids = [[] for _ in range(max(level for level, _ in blocks) + 1)]
    for block in blocks:
        grids[block[0]].append(block_of(all_fields, block, extra and extra[block[0]]))
    return grids


def non_overlapping(all_fields, blocks):
    """Makes vtkNonOverlappingAMR. The caller cuts the blocks so that none is partly covered."""
    return amr_data(by_level(all_fields, blocks))


def overlapping(all_fields, blocks, extra=None, ratio=2):
    return amr_data([level for level in by_level(all_fields, blocks, extra) if level], ratio)


def set_boxes(data, counts):
    """Sets the number of boxes per level of AMR data; VTK 9.6 changed the call."""
    data.Initialize(counts) if hasattr(data,
                                       "GetAMRMetaData") else data.Initialize(len(counts), counts)


def amr_data(grids, ratio=None):
    """Combines the uniform grids of each level, coarsest first.

    Returns vtkOverlappingAMR if a ratio is given, otherwise vtkNonOverlappingAMR.
    """
    data = vtkOverlappingAMR() if ratio else vtkNonOverlappingAMR()
    set_boxes(data, [len(level) for level in grids])
    if ratio:
        data.SetOrigin(ORIGIN)
        data.SetGridDescription(8)  # VTK_XYZ_GRID
    for level, own in enumerate(grids):
        if ratio:
            data.SetSpacing(level, own[0].GetSpacing())
            data.SetRefinementRatio(level, ratio)
        for i, grid in enumerate(own):
            if ratio:
                data.SetAMRBox(level, i,
                               vtkAMRBox(grid.GetOrigin(), grid.GetDimensions(), grid.GetSpacing(),
                                         ORIGIN))
            data.SetDataSet(level, i, grid)
    if ratio:
        data.GenerateParentChildInformation()
    return data


def cover(blocks, levels, level):
    """Returns for each cell of a level whether blocks of that level or a finer one cover it."""
    result = np.zeros((N << level,) * 3, bool)
    for own, box in blocks:
        if level <= own <= levels:
            shift = own - level
            result[tuple(slice(a >> shift, -(-b >> shift)) for a, b in box)] = True
    return result
