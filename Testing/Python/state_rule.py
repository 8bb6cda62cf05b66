"""The rule of state arrays in numpy: the cell from which each element takes its values.

It is independent of the implementation in Mesher/State/Transfer/StateCells.h.
"""
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from vfmtest import elements

REACH = 5  # greatest distance, in cells, from the cell that the element was made of


def with_void(materials):
    """Adds the rest of each cell as material 0 to {material id: fractions (z, y, x)}."""
    return {0: 1 - sum(materials.values()), **materials}


def of_labels(ids):
    return {label: (ids == label).astype(float) for label in np.unique(np.append(ids, 0))}


def centroids(result):
    points = vtk_to_numpy(result.mesh.GetPoints().GetData())[elements(result)]
    return sum(points[:, c] for c in range(points.shape[1])) / points.shape[1]


def cells_made_of(result, size):
    """Returns the cell (i, j, k) of each element, derived from its id.

    A tetrahedron belongs to the cell above its face.
    """
    is_hex = elements(result).shape[1] == 8
    n = size if is_hex else size + 1
    key = (result.cells("GlobalCellIds") - 1) // (7 if is_hex else 768)
    return np.minimum(np.stack([key % n[0], key // n[0] % n[1], key // (n[0] * n[1])], axis=1),
                      size - 1)


def state_cells(result, coordinates, fractions, limited=True):
    """Returns the cell number (x fastest) of each element, and how many use another than their own.

    coordinates: node coordinates x, y, z; fractions: of all materials, including void; limited:
    False for tetrahedra of TetGen.
    """
    size = np.array([len(x) - 1 for x in coordinates])
    centre = centroids(result)
    cell = np.stack([np.searchsorted(x, centre[:, a], side="right") - 1
                     for a, x in enumerate(coordinates)], axis=1)
    inside = np.clip(cell, 0, size - 1)
    own = cells_made_of(result, size) if limited else inside
    home = np.clip(inside, own - REACH, own + REACH)
    labels = sorted(fractions)
    table = np.stack([fractions[label].ravel() for label in labels])
    material = np.searchsorted(labels, result.cells("MaterialId"))
    number = lambda c: (c[:, 2] * size[1] + c[:, 1]) * size[0] + c[:, 0]
    # ordered by index
    steps = [np.array([i, j, k]) for k in (-1, 0, 1) for j in (-1, 0, 1) for i in (-1, 0, 1)]
    fraction, distance, numbers = [], [], []
    for near in (home + step for step in steps):
        exists = ((near >= 0) & (near < size)).all(axis=1)
        near = np.clip(near, 0, size - 1)
        middle = np.stack([0.5 * (x[near[:, a]] + x[near[:, a] + 1])
                           for a, x in enumerate(coordinates)], axis=1)
        offset = (centre - middle) ** 2
        fraction.append(np.where(exists, table[material, number(near)], -1))
        distance.append(offset[:, 0] + offset[:, 1] + offset[:, 2])
        numbers.append(number(near))
    best = np.lexsort((numbers, distance, -np.array(fraction)), axis=0)[0]
    fullest = np.array(numbers)[best, np.arange(len(best))]
    takes_home = table[material, number(home)] >= 0.5
    return np.where(takes_home, number(home), fullest), (~takes_home).sum()


def graded_coordinates(n):
    """Returns node coordinates x, y, z; each cell is twice as wide as the one before."""
    return [2.0 ** np.arange(n + 1)] * 3


def specks(n, seed=2):
    """Returns random multiples of 1/64 in few cells.

    Smoothing moves the elements of such cells far across thin cells.
    """
    random = np.random.default_rng(seed)
    filled = random.random((n, n, n)) < 0.1
    return np.where(filled, np.ceil(64 * random.random((n, n, n))) / 64, 0)
