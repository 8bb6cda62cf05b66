#!/usr/bin/env python3
"""Checks a mesh of hexahedra in pieces, of which one at a time is in memory.

usage: python3 check_parts.py MESH.pvtu|MESH.e [--each COMMAND]
  --each COMMAND   runs COMMAND PIECE for each piece of a .pvtu too, such as a check of one file

The pieces of a .pvtu are its files, those of an Exodus file ranges of its elements.
Checked: hexahedra only, positive at every corner; global ids of cells rise through a piece and are
in one piece only; a face is on two cells at most, also of two pieces, where both have the same
points at the same coordinates; the boundary of all pieces together is closed: each of its edges is
on an even number of its faces. Needs NumPy and the vtkmodules of VTK (.pvtu) or netCDF4 (.e).
Prints a line per piece, then PASS or FAIL; the exit status is 0 or 1.
"""
import os
import re
import shlex
import subprocess
import sys

import numpy as np

FACES = np.array([[0, 4, 7, 3], [1, 2, 6, 5], [0, 1, 5, 4], [3, 7, 6, 2], [0, 3, 2, 1],
                  [4, 5, 6, 7]])
CORNERS = np.array([[1, 3, 4], [2, 0, 5], [3, 1, 6], [0, 2, 7], [7, 5, 0], [4, 6, 1], [5, 7, 2],
                    [6, 4, 3]])
CHUNK = 1 << 20  # cells
PIECE = 4 << 20  # elements of an Exodus file


def read_file(path):
    """Returns coordinates, global ids of points and cells, and points of hexahedra."""
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(path)
    reader.Update()
    grid = reader.GetOutput()
    types = vtk_to_numpy(grid.GetCellTypesArray())
    if len(types) and (types.min() < 12 or types.max() > 12):
        raise ValueError("%s has cells that are no hexahedra" % path)
    cells = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 8)
    points = vtk_to_numpy(grid.GetPoints().GetData()).astype(float)
    return (points, vtk_to_numpy(grid.GetPointData().GetArray("GlobalPointIds")).astype(np.int64),
            vtk_to_numpy(grid.GetCellData().GetArray("GlobalCellIds")).astype(np.int64), cells)


def read_files(path):
    """Yields the name of each file of a .pvtu, and what read_file returns."""
    with open(path, encoding="utf-8") as file:
        names = re.findall(r'<Piece Source="([^"]+)"', file.read())
    for name in names:
        piece = os.path.join(os.path.dirname(path), name)
        yield (piece, *read_file(piece))


def read_ranges(path):
    """Yields the name of each range of elements of an Exodus file, and the values of read_file."""
    import netCDF4
    with netCDF4.Dataset(path) as file:
        file.set_auto_mask(False)
        first = 0  # element of the block
        for block in range(1, len(file.dimensions["num_el_blk"]) + 1):
            connect = file["connect%d" % block]
            if connect.elem_type != "HEX8":
                raise ValueError("%s has elements that are no hexahedra" % path)
            for begin in range(0, len(connect), PIECE):
                cells = connect[begin:begin + PIECE].astype(np.int64) - 1
                lower, upper = cells.min(), cells.max() + 1
                points = np.stack([file["coord" + axis][lower:upper] for axis in "xyz"], axis=1)
                numbers = slice(first + begin, first + begin + len(cells))
                yield ("block %d, element %d" % (block, begin + 1), points,
                       file["node_num_map"][lower:upper].astype(np.int64),
                       file["elem_num_map"][numbers].astype(np.int64), cells - lower)
            first += len(connect)


def smallest_corner(points, cells):
    """Returns the smallest determinant at a corner of a cell."""
    smallest = np.inf
    axes = [np.ascontiguousarray(points[:, axis]) for axis in range(3)]
    for begin in range(0, len(cells), CHUNK):
        corners = np.ascontiguousarray(cells[begin:begin + CHUNK].T)
        x, y, z = ([values[corner] for corner in corners] for values in axes)
        for corner, ends in enumerate(CORNERS):
            (a, b, c), (d, e, f), (g, h, i) = (
                [values[end] - values[corner] for values in (x, y, z)] for end in ends)
            smallest = min(smallest, (a * (e * i - f * h) + b * (f * g - d * i)
                                      + c * (d * h - e * g)).min())
    return smallest


def mix(ids):
    """Returns a number of 64 bits per id, whose sums tell sets of ids apart."""
    value = np.asarray(ids).astype(np.uint64) + np.uint64(1)
    for factor, shift in ((0xbf58476d1ce4e5b9, 30), (0x94d049bb133111eb, 27)):
        value = (value ^ (value >> np.uint64(shift))) * np.uint64(factor)
    return value ^ (value >> np.uint64(31))


def hash_rows(rows):
    """Returns a number of 64 bits per row of ids, which does not depend on their order."""
    return mix(rows).sum(axis=1, dtype=np.uint64)


def outer_faces(ids, cells):
    """Returns the faces that are on one cell of a piece, as global ids, and the largest number of
    cells on a face."""
    mixed = mix(ids)
    corners = [mixed[corner] for corner in cells.T]
    keys = np.concatenate([sum(corners[c] for c in face) for face in FACES])
    del corners
    order = np.argsort(keys)
    starts = np.flatnonzero(np.concatenate([[True], np.diff(keys[order]) != 0]))
    counts = np.diff(np.append(starts, len(keys)))
    single = order[starts[counts == 1]]
    side, cell = np.divmod(single, len(cells))
    return ids[cells[cell[:, None], FACES[side]]], counts.max() if len(counts) else 0


def have_common(lists):
    """Returns whether a number is in two of several lists, each in ascending order."""
    ends = sorted((ids[0], ids[-1]) for ids in lists)
    if all(a[1] < b[0] for a, b in zip(ends, ends[1:])):
        return False
    every = np.sort(np.concatenate(lists))
    return bool(np.any(every[1:] == every[:-1]))


def check_boundary(faces):
    """Returns problems of the faces that are outer ones of pieces."""
    _, first, counts = np.unique(hash_rows(faces), return_index=True, return_counts=True)
    problems = []
    if len(counts) and counts.max() > 2:
        problems.append("a face is on cells of more than two pieces")
    outer = faces[first[counts == 1]]
    edges = np.stack([outer, np.roll(outer, -1, axis=1)], axis=2).reshape(-1, 2)
    _, uses = np.unique(hash_rows(edges), return_counts=True)
    if np.any(uses % 2):
        problems.append("%d edges of the boundary are on an odd number of its faces"
                        % np.count_nonzero(uses % 2))
    print("faces between pieces: %d, boundary: %d faces" %
          (np.count_nonzero(counts == 2), len(outer)))
    return problems


def check_same_points(ids, points):
    """Returns problems of points that several pieces have."""
    order = np.argsort(ids, kind="stable")
    ids, points = ids[order], points[order]
    same = ids[1:] == ids[:-1]
    apart = np.count_nonzero(np.any(points[1:] != points[:-1], axis=1) & same)
    print("points between pieces: %d" % np.count_nonzero(same))
    return ["%d points of several pieces have several places" % apart] if apart else []


def main(path, command):
    problems, outer, border_ids, border_points, cell_ids, total = [], [], [], [], [], 0
    read = read_files if path.endswith(".pvtu") else read_ranges
    for piece, points, ids, cell_numbers, cells in read(path):
        if not len(cells):
            continue
        faces, most = outer_faces(ids, cells)
        smallest = smallest_corner(points, cells)
        print("%s: %d hexahedra, smallest determinant %.3g" % (piece, len(cells), smallest),
              flush=True)
        if most > 2:
            problems.append("%s: a face is on %d cells" % (piece, most))
        if not smallest > 0.0:
            problems.append("%s: a cell is not positive" % piece)
        if np.any(np.diff(cell_numbers) <= 0):
            problems.append("%s: ids of cells do not rise" % piece)
        on_border = np.isin(ids, np.unique(faces))
        outer.append(faces)
        border_ids.append(ids[on_border])
        border_points.append(points[on_border])
        cell_ids.append(cell_numbers)
        total += len(cells)
        del points, ids, cells
        if command and subprocess.run(shlex.split(command) + [piece]).returncode:
            problems.append("%s fails for %s" % (command, piece))
    if not total:
        problems.append("there is no hexahedron")
    else:
        problems += check_boundary(np.concatenate(outer))
        problems += check_same_points(np.concatenate(border_ids), np.concatenate(border_points))
        if have_common(cell_ids):
            problems.append("an id of a cell is in two pieces")
    print("%d hexahedra: %s" % (total, "FAIL: " + "; ".join(problems) if problems else "PASS"))
    return 1 if problems else 0


if __name__ == "__main__":
    if len(sys.argv) not in (2, 4) or (len(sys.argv) == 4 and sys.argv[2] != "--each"):
        sys.exit(__doc__)
    sys.exit(main(sys.argv[1], sys.argv[3] if len(sys.argv) == 4 else ""))
