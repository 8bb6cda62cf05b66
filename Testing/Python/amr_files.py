"""Small AMR data and its files in four formats: VTK (.vthb), AMReX plotfiles, Enzo and FLASH.

spyplot.py writes SpyPlot files. All files hold a ball in a box, the fractions of the ball and of
the rest, refined at the surface of the ball. Coarse cells under finer ones hold the means of these,
so that each level has equal volumes. Enzo and FLASH files need h5py.
"""
import os
import shutil

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkOverlappingAMR, vtkUniformGrid
from vtkmodules.vtkIOXML import vtkXMLUniformGridAMRWriter

import vfmtest
from amr_cases import amr_data, means
from spyplot import Block, with_ghosts
from vfmtest import image

BLOCK = 4  # cells per block along each axis
ORIGIN, SPACING = np.array(vfmtest.ORIGIN), np.array(vfmtest.SPACING)  # values of level 0
SAMPLES = 2  # samples per finest cell along each axis


class AmrBlock:
    """Cells of one level.

    lo: index of the first cell; arrays: {name: values
    (z, y, x)}; leaf: no finer block covers any cell.
    """

    def __init__(self, level, lo, arrays, leaf):
        self.level, self.lo, self.arrays, self.leaf = level, np.asarray(lo), arrays, leaf

    def size(self):
        return np.array(next(iter(self.arrays.values())).shape[::-1])


class Amr:
    """Blocks sorted by level, coarsest first.

    roots: numbers of level-0 blocks in x, y, z. A cell has
    the size width / ratio^level. The domain begins at ORIGIN.
    """

    def __init__(self, blocks, ratio, levels, roots, width=SPACING):
        self.blocks = sorted(blocks, key=lambda block: block.level)  # a stable sort
        self.ratio, self.levels, self.roots, self.width = ratio, levels, roots, width

    def spacing(self, level):
        return self.width / self.ratio ** level

    def of_level(self, level):
        return [block for block in self.blocks if block.level == level]

    def domain(self, level):
        """Returns the number of cells of the whole domain on that level."""
        return np.array(self.roots) * BLOCK * self.ratio ** level

    def corner(self, block, upper=False):
        return ORIGIN + (block.lo + upper * block.size()) * self.spacing(block.level)


def finest_fractions(cells):
    """Returns the fractions of the ball and of the rest, (z, y, x), on `cells` cells in x, y, z."""
    axes = [(np.arange(n * SAMPLES) + 0.5) / (n * SAMPLES) for n in cells]
    z, y, x = np.meshgrid(*axes[::-1], indexing="ij")
    longest = max(cells)
    inside = sum(((a - 0.5) * n / longest) ** 2 for a, n in zip((x, y, z), cells)) < 0.28 ** 2
    shape = [n for count in cells[::-1] for n in (count, SAMPLES)]
    ball = inside.reshape(shape).mean(axis=(1, 3, 5))
    return {"ball": ball, "rest": 1 - ball}


def make_amr(levels=3, ratio=2, roots=(3, 3, 3), finest=None, width=SPACING):
    """Returns AMR data of the ball, or of the given fractions.

    finest: {name: fractions (z, y, x) on the finest level}. A block
    is refined if it contains an interface of the first array. Of the
    3 x 3 x 3 blocks of the ball, the corner blocks are not refined.
    """
    finest = finest or finest_fractions(np.array(roots) * BLOCK * ratio ** (levels - 1))
    fields = [{name: means(values, ratio ** (levels - 1 - level))
               for name, values in finest.items()}
              for level in range(levels)]
    blocks = []

    def add(level, lo):
        x, y, z = lo
        arrays = {name: values[z:z + BLOCK, y:y + BLOCK, x:x + BLOCK]
                  for name, values in fields[level].items()}
        refined = level + 1 < levels and 0 < next(iter(arrays.values())).mean() < 1
        blocks.append(AmrBlock(level, lo, arrays, not refined))
        if refined:
            steps = range(ratio)
            for child in [(i, j, k) for k in steps for j in steps for i in steps]:
                add(level + 1, np.array(lo) * ratio + np.array(child) * BLOCK)

    for k in range(roots[2]):
        for j in range(roots[1]):
            for i in range(roots[0]):
                add(0, np.array([i, j, k]) * BLOCK)
    return Amr(blocks, ratio, levels, roots, width)


def uniform_grid(amr, block):
    grid = image(block.arrays, kind=vtkUniformGrid)
    grid.SetOrigin(amr.corner(block))
    grid.SetSpacing(amr.spacing(block.level))
    return grid


def vtk_amr(amr, kind=vtkOverlappingAMR):
    """Makes a VTK data set of all blocks if they may overlap, otherwise only of the leaves."""
    overlapping = kind is vtkOverlappingAMR
    grids = [[uniform_grid(amr, block) for block in amr.of_level(level) if overlapping
              or block.leaf] for level in range(amr.levels)]
    return amr_data(grids, amr.ratio if overlapping else None)


def write_vthb(path, amr, kind=vtkOverlappingAMR):
    writer = vtkXMLUniformGridAMRWriter()
    writer.SetFileName(path)
    writer.SetInputData(vtk_amr(amr, kind))
    writer.SetDataModeToBinary()
    assert writer.Write()
    return path


def box_text(lo, hi):
    return "((%d,%d,%d) (%d,%d,%d) (0,0,0))" % (*lo, *hi)


def write_plotfile(folder, amr, time=0.5):
    """Writes an AMReX plotfile (HyperCLaw-V1.1): a folder with Header and Level_0 ..

    All values are little-endian doubles.
    """
    shutil.rmtree(folder, ignore_errors=True)
    names = list(amr.blocks[0].arrays)
    upper = ORIGIN + amr.domain(0) * amr.width
    lines = ["HyperCLaw-V1.1", len(names), *names, 3, repr(time), amr.levels - 1,
             "%r %r %r" % tuple(ORIGIN.tolist()),
             "%r %r %r" % tuple(upper.tolist()), " ".join([str(amr.ratio)] * (amr.levels - 1)),
             " ".join(box_text((0, 0, 0), amr.domain(level) - 1) for level in range(amr.levels)),
             " ".join(["0"] * amr.levels)]
    lines += ["%r %r %r" % tuple(amr.spacing(level).tolist())
              for level in range(amr.levels)] + [0, 0]
    for level in range(amr.levels):
        blocks = amr.of_level(level)
        lines += ["%d %d %r" % (level, len(blocks), time), 0]
        for block in blocks:
            lines += ["%r %r" % pair
                      for pair in zip(amr.corner(block).tolist(), amr.corner(block, True).tolist())]
        lines.append("Level_%d/Cell" % level)
        write_plotfile_level(os.path.join(folder, "Level_%d" % level), blocks, names)
    with open(os.path.join(folder, "Header"), "w") as out:
        out.write("".join("%s\n" % line for line in lines))
    return folder


def write_plotfile_level(folder, blocks, names):
    os.makedirs(folder)
    boxes = [box_text(block.lo, block.lo + block.size() - 1) for block in blocks]
    header = [1, 1, len(names), 0, "(%d 0" % len(blocks), *boxes, ")", len(blocks)]
    with open(os.path.join(folder, "Cell_D_00000"), "wb") as out:
        for block, box in zip(blocks, boxes):
            header.append("FabOnDisk: Cell_D_00000 %d" % out.tell())
            out.write(b"FAB ((8, (64 11 52 0 1 12 0 1023)),(8, (8 7 6 5 4 3 2 1)))%s %d\n"
                      % (box.encode(), len(names)))
            for name in names:
                out.write(np.asarray(block.arrays[name], "<f8").tobytes())
    for function in (np.min, np.max):
        header += ["", "%d,%d" % (len(blocks), len(names))]
        header += ["".join("%r," % float(function(block.arrays[name])) for name in names)
                   for block in blocks]
    with open(os.path.join(folder, "Cell_H"), "w") as out:
        out.write("".join("%s\n" % line for line in header))


def write_enzo(folder, amr, name="DD0001"):
    """Writes Enzo's parameter file, .hierarchy and one .cpu0000 in HDF5.

    Returns the path of the .hierarchy. The children of a block follow it as a list of grids of
    this level and one grid of the next.
    """
    import h5py

    os.makedirs(folder, exist_ok=True)
    path = os.path.join(folder, name)
    with open(path, "w") as out:
        out.write("InitialCycleNumber = 1\nInitialTime = 0.5\nTopGridRank = 3\n")
    text = ""
    grids = amr.blocks
    with h5py.File(path + ".cpu0000", "w") as data:
        for number, block in enumerate(grids, 1):
            group = data.create_group("Grid%08d" % number)
            for array, values in block.arrays.items():
                group[array] = values
            row = lambda values: " ".join("%r" % v for v in np.asarray(values).tolist())
            text += ("\nGrid = %d\nTask = 0\nGridRank = 3\nGridDimension = %s\n"
                     "GridStartIndex = 3 3 3\nGridEndIndex = %s\n"
                     "GridLeftEdge = %s\nGridRightEdge = %s\nTime = 0.5\n"
                     "NumberOfBaryonFields = %d\nBaryonFileName = %s\n"
                     "NumberOfParticles = 0\n" % (
                         number, row(block.size() + 6), row(block.size() + 2),
                         row(amr.corner(block)),
                         row(amr.corner(block, True)), len(block.arrays), name + ".cpu0000"))
            following = grids[number].level if number < len(grids) else block.level
            # The level of the next grid is one more than that of the last grid with a next level.
            if following > block.level:
                text += ("Pointer: Grid[%d]->NextGridThisLevel = 0\n"
                         "Pointer: Grid[%d]->NextGridNextLevel = %d\n" % (
                             number, number, number + 1))
            else:
                text += "Pointer: Grid[%d]->NextGridThisLevel = %d\n" % (
                    number, number + 1 if number < len(grids) else 0)
    with open(path + ".hierarchy", "w") as out:
        out.write(text)
    return path + ".hierarchy"


def write_flash(path, amr, time=0.5):
    """Writes a FLASH3 checkpoint or plot file (format version 9).

    It holds equally sized blocks in an octree; levels count from 1.
    """
    import h5py

    assert amr.ratio == 2
    blocks = amr.blocks
    corners = np.array([[amr.corner(block), amr.corner(block, True)] for block in blocks])
    with h5py.File(path, "w") as out:
        out["sim info"] = np.array([(9,)], dtype=[("file format version", "<i4")])
        whole = {"nxb": BLOCK, "nyb": BLOCK, "nzb": BLOCK, "globalnumblocks": len(blocks),
                 "nstep": 1, "dimensionality": 3}
        out["integer scalars"] = np.array([(name.ljust(20).encode(), value)
                                           for name, value in whole.items()],
                                          dtype=[("name", "S20"), ("value", "<i4")])
        out["real scalars"] = np.array([(b"time".ljust(20), time)],
                                       dtype=[("name", "S20"), ("value", "<f8")])
        out["gid"] = np.full((len(blocks), 15), -1, "<i4")
        out["bounding box"] = corners.transpose(0, 2, 1)
        out["coordinates"] = corners.mean(axis=1)
        out["refine level"] = np.array([block.level + 1 for block in blocks], "<i4")
        out["node type"] = np.array([1 if block.leaf else 2 for block in blocks], "<i4")
        names = list(blocks[0].arrays)
        out["unknown names"] = np.array([[name.ljust(4)[:4].encode()] for name in names], "S4")
        for name in names:
            out[name.ljust(4)[:4]] = np.array([block.arrays[name] for block in blocks])
    return path


def spyplot_blocks(amr, steps=1):
    """Returns the leaves as blocks of a SpyPlot file.

    The value of ghost cells is invalid, so that a reader that returns it is detected.
    """
    blocks = []
    for block in amr.blocks:
        if not block.leaf:
            continue
        nodes = [with_ghosts(lo + h * np.arange(n + 1)) for lo, h, n in
                 zip(amr.corner(block), amr.spacing(block.level), block.size())]
        arrays = {"Material volume fraction - %d" % (i + 1): np.pad(values, 1, constant_values=7.5)
                  for i, values in enumerate(block.arrays.values())}
        blocks.append(Block(nodes, [arrays] * steps, block.level))
    return blocks
