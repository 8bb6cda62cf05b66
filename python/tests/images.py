"""Writes small images for tests: two boxes in void, in the formats that read() supports."""

import numpy as np

CELLS = (14, 12, 10)
BOX = 240  # cells of each of two boxes
ELEMENTS = 952  # hexahedra of two boxes


def two_boxes(first=1, second=2, dtype=np.uint8):
    """Returns two boxes side by side in void, a[x, y, z]."""
    array = np.zeros(CELLS, dtype)
    array[2:7, 2:10, 2:8] = first
    array[7:12, 2:10, 2:8] = second
    return array


def round_ball(dtype=np.uint8):
    """Returns a ball of 912 cells, which makes 1,584 hexahedra."""
    places = np.indices((16, 16, 16)) - 7.5
    return ((places**2).sum(axis=0) < 36).astype(dtype)


def legacy_vtk(path, array, grid="STRUCTURED_POINTS", spacing=(1, 1, 1)):
    """Writes cell data a[x, y, z] as text of the legacy format of VTK."""
    nodes = [n + 1 for n in array.shape]
    lines = ["# vtk DataFile Version 3.0", "test", "ASCII", "DATASET " + grid]
    if grid == "STRUCTURED_POINTS":
        lines += ["DIMENSIONS %d %d %d" % tuple(nodes), "ORIGIN 0 0 0",
                  "SPACING %g %g %g" % tuple(spacing)]
    elif grid == "RECTILINEAR_GRID":
        lines.append("DIMENSIONS %d %d %d" % tuple(nodes))
        for axis, count, width in zip("XYZ", nodes, spacing):
            lines += ["%s_COORDINATES %d double" % (axis, count),
                      " ".join(map(str, np.arange(count) * width))]
    lines += ["CELL_DATA %d" % array.size, "SCALARS ids int 1", "LOOKUP_TABLE default",
              " ".join(map(str, array.ravel(order="F").tolist()))]
    path.write_text("\n".join(lines) + "\n")


def hexahedra(array, spacing=(1.0, 1.0, 1.0), seed=0, kind=12):
    """Returns points, corners and values of the cells of a[x, y, z], in random order; with a seed,
    hexahedra begin at any corner and may point along any axis."""
    random = np.random.default_rng(seed)
    nodes = [np.arange(n + 1) * width for n, width in zip(array.shape, spacing)]
    points = np.stack(np.meshgrid(*nodes, indexing="ij"), axis=-1).reshape(-1, 3)
    index = np.arange(len(points)).reshape([n + 1 for n in array.shape])
    corners = np.stack([index[i:i + array.shape[0], j:j + array.shape[1], k:k + array.shape[2]]
                        for i in (0, 1) for j in (0, 1) for k in (0, 1)], axis=-1).reshape(-1, 8)
    base = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0],
                     [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]])
    if kind == 11:
        x_fastest = [4 * x + 2 * y + z for z in (0, 1) for y in (0, 1) for x in (0, 1)]
        return points, corners[:, x_fastest], array.ravel()
    cells = np.empty_like(corners)
    for c in range(len(corners)):
        turned = base[:, np.roll((0, 1, 2), random.integers(3))] if seed else base
        start = random.integers(4) if seed else 0
        turned = np.concatenate([np.roll(turned[:4], start, axis=0),
                                 np.roll(turned[4:], start, axis=0)])
        cells[c] = corners[c][turned @ (4, 2, 1)]
    order = random.permutation(len(cells)) if seed else np.arange(len(cells))
    return points, cells[order], array.ravel()[order]
