"""Writes alpha.water of one time of an OpenFOAM case as VTK image data with the Float32 cell array
"water". The case must be ASCII, with one block of equal cubic cells.

usage: pvpython foam_to_vti.py CASE TIME OUT.vti

Reads the cell centres from CASE/TIME/C (postProcess -func writeCellCentres) and puts each value at
its cell centre. Stops if the cells are not numbered x fastest, z slowest, as in a VTK image.
"""
import re
import sys
from pathlib import Path

import numpy as np
from scipy import ndimage
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "Examples"))
from need_files import need_files


def internal_field(path):
    """Returns the nonuniform internalField of an ASCII OpenFOAM field file."""
    kind, count, body = re.search(
        r"internalField\s+nonuniform\s+List<(\w+)>\s*(\d+)\s*\((.*?)\)\s*;",
        path.read_text(), re.S).groups()
    values = np.array(re.sub(r"[()]", " ", body).split(), dtype=float)
    return values.reshape(int(count), 3) if kind == "vector" else values


def main(case, time, out):
    files = [Path(case, time, name) for name in ("alpha.water", "C")]
    need_files(*files)
    alpha, centres = map(internal_field, files)

    low, high = centres.min(axis=0), centres.max(axis=0)
    n = np.array([np.unique(np.round(c, 9)).size for c in centres.T])
    h = (high - low) / (n - 1)
    assert n.prod() == alpha.size and np.allclose(h, h[0], rtol=1e-6)
    h = float("%.6g" % h.mean())

    ijk = np.rint((centres - low) / h).astype(int)
    assert np.abs(low + ijk * h - centres).max() < 1e-4 * h
    index = ijk @ [1, n[0], n[0] * n[1]]
    assert (index == np.arange(alpha.size)).all(), "cells are not numbered x fastest"
    low = np.round(low - h / 2, 9) + 0.0

    below, above = alpha < 0, alpha > 1
    water = np.empty(alpha.size, np.float32)
    water[index] = np.clip(alpha, 0, 1)

    image = vtkImageData()
    image.SetDimensions(*(int(m) + 1 for m in n))
    image.SetOrigin(*low)
    image.SetSpacing(h, h, h)
    array = numpy_to_vtk(water, deep=True)
    array.SetName("water")
    image.GetCellData().SetScalars(array)
    writer = vtkXMLImageDataWriter()
    writer.SetInputData(image)
    writer.SetFileName(out)
    writer.SetDataModeToBinary()
    writer.SetCompressorTypeToZLib()
    writer.SetCompressionLevel(9)
    assert writer.Write() == 1

    grid = water.reshape(n[::-1])
    labels, count = ndimage.label(grid >= 0.5)
    cells = np.sort(np.bincount(labels.ravel())[1:])[::-1]
    volume = water.sum(dtype=float) * h**3
    middle = [low[a] + h * (0.5 + np.average(np.arange(n[a]), weights=grid.sum(
        axis=tuple(b for b in range(3) if b != 2 - a), dtype=float))) for a in range(3)]
    print(f"{out}: {Path(out).stat().st_size} bytes, {n[0]} x {n[1]} x {n[2]} cells of {h:g} m,"
          f" origin {low}")
    print(f"  solver values {alpha.min():.9g} .. {alpha.max():.9g}; clipped"
          f" {below.sum()} below 0, {above.sum()} above 1, by at most"
          f" {max(0, -alpha.min(), alpha.max() - 1):.3g}")
    print(f"  cells with 0 < water < 1: {((water > 0) & (water < 1)).sum()}, of them"
          f" {((water > 0) & (water < 1e-6)).sum()} below 1e-6,"
          f" {((water > 1 - 1e-6) & (water < 1)).sum()} above 1 - 1e-6")
    print(f"  fragments (water >= 0.5, face-connected): {count}, with 27 cells or more:"
          f" {(cells >= 27).sum()}; cells of the largest: {cells[:12].tolist()}")
    print(f"  volume {volume:.9g} m3, centroid ({middle[0]:.9g} {middle[1]:.9g} {middle[2]:.9g})")


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    main(*sys.argv[1:])
