"""Writes SpyPlot files like CTH: a case file, and binary files of blocks with one ghost layer.

All numbers are big-endian. Coordinates and fields are
run-length encoded float32; file positions are doubles.
"""
import os
import struct

import numpy as np

OUTSIDE = 7.5  # value of ghost cells outside the domain, which no reader may return
GROUP = 100  # number of times in one group header
LONGEST_RUN = 127


class Block:
    """Node coordinates x, y, z and the fields of each time, {name: (z, y, x)}, with ghost cells."""

    def __init__(self, coordinates, steps, level=0):
        self.coordinates = [np.asarray(x, np.float32) for x in coordinates]
        self.steps = steps
        self.level = level

    def size(self):
        return [len(x) - 1 for x in self.coordinates]


def with_ghosts(x):
    """Extends node coordinates by one cell at each end."""
    return np.concatenate([[2 * x[0] - x[1]], x, [2 * x[-1] - x[-2]]])


def split(coordinates, steps, counts=(1, 1, 1)):
    """Splits a domain into counts[0] x counts[1] x counts[2] blocks with ghost cells, x fastest.

    coordinates, steps: without ghost cells, otherwise like the arguments of Block.
    """
    nodes = [with_ghosts(np.asarray(x, float)) for x in coordinates]
    padded = [{name: np.pad(value, 1, constant_values=OUTSIDE) for name, value in step.items()}
              for step in steps]
    spans = [[(part[0], part[-1] + 3) for part in np.array_split(np.arange(len(x) - 1), count)]
             for x, count in zip(coordinates, counts)]  # indices of padded cells
    return [Block([nodes[0][i:I + 1], nodes[1][j:J + 1], nodes[2][k:K + 1]],
                  [{name: value[k:K, j:J, i:I] for name, value in step.items()} for step in padded])
            for k, K in spans[2] for j, J in spans[1] for i, I in spans[0]]


def ints(*values):
    return struct.pack(">%di" % len(values), *values)


def doubles(*values):
    return struct.pack(">%dd" % len(values), *values)


def text(value, size):
    return value.encode().ljust(size, b"\0")


def chunk(data):
    """Returns the data after their number of bytes."""
    return ints(len(data)) + data


def encode(values):
    """Run-length encodes values.

    A byte n < 128 comes before one value that is repeated n times; 128 + n comes before n values.
    """
    values = np.asarray(values, ">f4").ravel()
    starts = np.concatenate([[0], np.flatnonzero(values[1:] != values[:-1]) + 1, [len(values)]])
    result, single = b"", []

    def flush():
        nonlocal result
        if single:
            result += bytes([128 + len(single)]) + b"".join(single)
            single.clear()

    for start, end in zip(starts[:-1].tolist(), starts[1:].tolist()):
        value = values[start:start + 1].tobytes()
        if end - start == 1:
            single.append(value)
            if len(single) == LONGEST_RUN:
                flush()
            continue
        flush()
        for first in range(start, end, LONGEST_RUN):
            result += bytes([min(LONGEST_RUN, end - first)]) + value
    flush()
    return result


def encode_nodes(x):
    """Encodes the first node, the step, and the rest of each node after subtracting its steps."""
    step = x[1] - x[0]
    if not np.array_equal(x, x[0] + np.arange(len(x), dtype=np.float32) * step):
        step = np.float32(0)
    rest = np.full(len(x), x[0]) if step else x
    return struct.pack(">2f", x[0], step) + encode(rest)


class Fields:
    """Numbers and tables of the arrays.

    'NAME - N' is field NAME of material N; the other arrays are cell fields.
    """

    def __init__(self, names):
        materials = sorted({name.rpartition(" - ")[0] for name in names} - {""})
        self.cells = [name for name in names if " - " not in name]
        self.materials = materials
        self.names = names
        self.count = max([int(name.rpartition(" - ")[2]) for name in names if " - " in name],
                         default=0)

    def number(self, name):
        """Returns the number of an array in the file.

        Cell fields count from 0. A material field has the number 100 x (1 + field) + material.
        """
        field, _, material = name.rpartition(" - ")
        return 100 * (1
                      + self.materials.index(field)) + int(material) if field else self.cells.index(
                          name)

    def tables(self, version):
        result = b""
        for names, step in ((self.cells, 1), (self.materials, 100)):
            result += ints(len(names))
            for i, name in enumerate(names):
                number = step * i + (step if step > 1 else 0)
                key = "VOLM" if name == "Material volume fraction" else "F%d" % i
                result += text(key, 30) + text(name, 80) + (ints(number) if version >= 101 else b"")
        return result


def unused(blocks):
    """Returns the number of empty blocks to write before these.

    A single block gets no empty one, because only a file with one block is a flat mesh.
    """
    return int(len(blocks) > 1)


def header(version, blocks, fields, file, files):
    used = np.array([[x[[1, -2]] for x in block.coordinates] for block in blocks], float)
    result = b"spydata\0" + text("A test", 128) + ints(version)
    result += ints(64) if version >= 102 else b""  # bits per file position
    # 30: Cartesian, 3: three dimensions
    result += ints(0, file, files, 30, 3, fields.count, fields.count)
    result += doubles(*used[:, :, 0].min(axis=0),
                      *used[:, :, 1].max(axis=0)) + ints(len(blocks) + unused(blocks))
    result += ints(0) if version >= 105 else b""  # no markers
    result += ints(1 + max(block.level for block in blocks))
    return result + (ints(*[0] * 5) if version >= 105 else b"")


def dump(version, position, blocks, step, fields):
    """Returns the bytes of one time, which begin at this file position."""
    data = []
    for name in fields.names:
        data.append(b"".join(chunk(encode(plane)) for block in blocks
                             for plane in block.steps[step][name]))
    bounds = [0] * (6 if version >= 103 else 0)
    grids = ints(0, 0)  # no tracers, no histogram
    grids += ints(len(blocks) + unused(blocks)) + ints(4, 4, 4, 0, 0, 0, *bounds) * unused(blocks)
    for block in blocks:
        grids += ints(*block.size(), 1, 1, block.level, *bounds)
    grids += b"".join(chunk(encode_nodes(x)) for block in blocks for x in block.coordinates)
    start = ints(len(fields.names), *map(fields.number, fields.names))
    first = position + len(start) + 8 * len(data) + len(grids)
    offsets = first + np.concatenate([[0], np.cumsum([len(d) for d in data])[:-1]])
    return start + doubles(*offsets) + grids + b"".join(data)


def write_file(path, version, times, blocks, file, files):
    fields = Fields(list(blocks[0].steps[0]))
    content = header(version, blocks, fields, file, files) + fields.tables(version)
    content += doubles(len(content) + 8)  # position of the group header
    group_size = 4 + GROUP * (4 + 8 + 8 + (8 if version >= 102 else 0))
    dumps, offsets = b"", []
    for step in range(len(times)):
        offsets.append(len(content) + group_size + len(dumps))
        dumps += dump(version, offsets[-1], blocks, step, fields)
    rest = [0] * (GROUP - len(times))
    content += ints(len(times), *range(len(times)), *rest) + doubles(*times, *rest)
    content += doubles(*[1e-6] * GROUP) if version >= 102 else b""  # time steps
    content += doubles(*offsets, *rest)
    with open(path, "wb") as out:
        out.write(content + dumps)


def write_spyplot(folder, name, times, blocks, files=1, version=105, parts=""):
    """Writes name.spcth and name.spcth.0 .. in the folder and returns the path of the first.

    - times: ascending, fewer than 100
    - blocks: distributed over the files in turn
    - version: version of the format, 101 to 105
    - parts: subfolder for all files but the first

    Files of one block each are a flat mesh, whose nodes may be anywhere. Files of several blocks
    hold block-structured data on uniform cells.
    """
    assert len(times) < GROUP and all(len(block.steps) == len(times) for block in blocks)
    os.makedirs(os.path.join(folder, parts), exist_ok=True)
    names = [os.path.join(parts, "%s.spcth.%d" % (name, file)) for file in range(files)]
    for file in range(files):
        write_file(os.path.join(folder, names[file]), version, times, blocks[file::files], file,
                   files)
    path = os.path.join(folder, name + ".spcth")
    with open(path, "w") as out:
        out.write("spycase\n# files\n" + "".join(line + "\n" for line in names))
    return path
