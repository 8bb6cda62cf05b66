"""Compares our hexahedra of closed surfaces with published ones, at equal numbers of elements.

usage: compare_meshers --surfaces FOLDER [--models NAMES] [--count 1] [--edge-angle 40]

FOLDER is a clone of https://github.com/CMU-CBML/HybridOctree_Hex: surfaces in "input boundaries",
hexahedra that its authors published in "our results". Without it there is a message and no table.
Their meshes are moved and scaled back onto the surfaces, on which their nodes lie. --count: our
number of elements as a multiple of theirs, within 1 %.

Columns: number of elements; smallest scaled Jacobian; distances of the surfaces of mesh and input,
both ways, in thousandths of the diagonal of the model: root mean square, and largest (Hausdorff);
error of the volume; seconds of ours.
"""
import argparse
import glob
import os
import sys
import time

import numpy as np
import pyvista
import vtk
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

import measure_mesh
import volume_fraction_mesh as vfm

HEADER = ("model", "mesher", "elements", "SJ", "rms", "Hausdorff", "volume error", "s")
SAMPLES = 4  # along each direction of a facet
ROUNDS = 50  # of aligning meshes
STEPS = 8    # of the search for the width of cells


def read_raw(path):
    """Returns points and triangles. Point 0 is not used; the triangles count from it."""
    with open(path, encoding="ascii") as file:
        points, triangles = (int(word) for word in file.readline().split())
        values = np.array(file.read().split(), float)
    corners = values[3 * points:3 * (points + triangles)].astype(int)
    return values[:3 * points].reshape(-1, 3)[1:], corners.reshape(-1, 3) - 1


class Surface:
    """Closed triangle surface, and distances of points from it."""

    def __init__(self, points, triangles):
        self.points, self.triangles = points, triangles
        self.corners = points[triangles]
        self.data = pyvista.PolyData.from_regular_faces(points, triangles)
        self.function = vtk.vtkImplicitPolyDataDistance()
        self.function.SetInput(self.data)

    def find_distances(self, points):
        out = vtk.vtkDoubleArray()
        self.function.FunctionValue(numpy_to_vtk(np.ascontiguousarray(points)), out)
        return np.abs(vtk_to_numpy(out))

    def find_nearest(self, points):
        """Returns the nearest points, and the normals of their triangles."""
        cells, nearest = self.data.find_closest_cell(points, return_closest_point=True)
        a, b, c = self.corners[cells].transpose(1, 0, 2)
        normals = np.cross(b - a, c - a)
        return nearest, normals / np.maximum(np.linalg.norm(normals, axis=1), 1e-300)[:, None]

    def find_volume(self):
        return np.linalg.det(self.corners).sum() / 6

    def sample(self):
        """Returns points on all triangles, and the area of each."""
        area = 0.5 * np.linalg.norm(np.cross(self.corners[:, 1] - self.corners[:, 0],
                                             self.corners[:, 2] - self.corners[:, 0]), axis=1)
        weights = np.array([(4, 1, 1), (1, 4, 1), (1, 1, 4), (2, 2, 2)]) / 6
        points = np.einsum("sc,tcx->tsx", weights, self.corners).reshape(-1, 3)
        return points, np.repeat(area / 4, 4)


def sample_facets(facets):
    """Returns points on bilinear facets, and the area of each."""
    at = (np.arange(SAMPLES) + 0.5) / SAMPLES
    u, v = (values.ravel()[:, None] for values in np.meshgrid(at, at))
    shares = np.concatenate([(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v], axis=1)
    area = 0.5 * np.linalg.norm(np.cross(facets[:, 2] - facets[:, 0], facets[:, 3] - facets[:, 1]),
                                axis=1)
    return np.einsum("sc,fcx->fsx", shares, facets).reshape(-1, 3), np.repeat(
        area / len(u), len(u))


def make_surface(facets):
    """Returns the surface of quads, each as four triangles around its centre."""
    count = len(facets)
    points = np.concatenate([facets.reshape(-1, 3), facets.mean(1)])
    corner = np.arange(4 * count).reshape(-1, 4)
    centre = np.broadcast_to(4 * count + np.arange(count)[:, None], (count, 4))
    return Surface(points, np.stack([corner, np.roll(corner, -1, 1), centre], 2).reshape(-1, 3))


def find_facets(points, cells):
    mesh = measure_mesh.of_elements(points, cells, np.ones(len(cells), int))
    return points[np.concatenate([corners for corners, _ in measure_mesh.find_facets(mesh)])]


def align(points, boundary, surface):
    """Scales and moves points so that those on the boundary of their mesh lie on a surface."""
    ends = [(some.min(0), some.max(0)) for some in (points[boundary], surface.points)]
    scale = np.linalg.norm(ends[1][1] - ends[1][0]) / np.linalg.norm(ends[0][1] - ends[0][0])
    moved = (points - ends[0][0]) * scale + ends[1][0]
    for _ in range(ROUNDS):
        nearest, normals = surface.find_nearest(moved[boundary])
        middle = moved[boundary].mean(0)
        rows = np.concatenate([normals, (normals * (moved[boundary] - middle)).sum(
            1, keepdims=True)], axis=1)
        away = (normals * (nearest - moved[boundary])).sum(1)
        step = np.linalg.lstsq(rows, away, rcond=None)[0]
        moved = middle + (1 + step[3]) * (moved - middle) + step[:3]
        if np.abs(away).max() < 1e-7 * np.ptp(moved):
            break
    return moved


def measure(name, mesher, points, cells, surface, seconds):
    """Returns the row of a mesh, as numbers from the third column on."""
    diagonal = np.linalg.norm(np.ptp(surface.points, axis=0))
    grid = pyvista.UnstructuredGrid({pyvista.CellType.HEXAHEDRON: cells}, points)
    jacobian = grid.cell_quality("scaled_jacobian")["scaled_jacobian"].min()
    facets = find_facets(points, cells)
    squares, largest = [], []
    for (samples, area), other in ((sample_facets(facets), surface),
                                   (surface.sample(), make_surface(facets))):
        distances = other.find_distances(samples)
        squares.append(np.average(distances ** 2, weights=area))
        largest.append(distances.max())
    mesh = measure_mesh.of_elements(points, cells, np.ones(len(cells), int))
    volume = measure_mesh.find_volumes(mesh).sum() / surface.find_volume() - 1
    return (name, mesher, len(cells), jacobian, 1000 * np.mean(squares) ** 0.5 / diagonal,
            1000 * max(largest) / diagonal, volume, seconds)


def print_row(row):
    name, mesher, count, jacobian, rms, hausdorff, volume, seconds = row
    print("| %s | %s | %d | %.3f | %.3f | %.2f | %.1e | %s |" % (
        name, mesher, count, jacobian, rms, hausdorff, volume,
        "" if seconds is None else "%.1f" % seconds), flush=True)


def mesh_surface(surface, width, options):
    """Returns our hexahedra with cells of a width, and the seconds."""
    begin = time.perf_counter()
    low, high = surface.points.min(0), surface.points.max(0)
    cells = np.ceil((high - low) / width).astype(int) + 4
    low = 0.5 * (low + high - cells * width)
    bounds = np.stack([low, low + cells * width], 1).ravel()
    mesh = vfm.hexes(vfm.surface((surface.points, surface.triangles), tuple(cells), bounds=bounds),
                     **options)
    return mesh, time.perf_counter() - begin


def mesh_with_count(surface, count, options):
    """Returns our hexahedra of about a number, and the seconds of the last mesh."""
    width = (abs(surface.find_volume()) / count) ** (1 / 3)
    for _ in range(STEPS):
        mesh, seconds = mesh_surface(surface, width, options)
        if abs(len(mesh.cells) / count - 1) < 0.01:
            break
        width *= (len(mesh.cells) / count) ** (1 / 3)
    return mesh, seconds


def compare_model(name, folder, share, options):
    """Prints the rows of a model, and returns them."""
    surface = Surface(*read_raw(os.path.join(folder, "input boundaries", name + "_tri.raw")))
    if surface.find_volume() < 0:
        surface = Surface(surface.points, surface.triangles[:, ::-1])
    theirs = pyvista.read(os.path.join(folder, "our results", name + ".vtk"))
    cells = theirs.cells_dict[pyvista.CellType.HEXAHEDRON]
    mesh = measure_mesh.of_elements(theirs.points, cells, np.ones(len(cells), int))
    boundary = np.unique(np.concatenate([some for some, _ in measure_mesh.find_facets(mesh)]))
    points = align(np.array(theirs.points, float), boundary, surface)
    rows = [measure(name, "HybridOctree_Hex", points, cells, surface, None)]
    ours, seconds = mesh_with_count(surface, share * len(cells), options)
    rows.append(measure(name, "ours", ours.points, ours.cells, surface, seconds))
    for row in rows:
        print_row(row)
    return rows


def compare(folder, models="", share=1.0, **options):
    """Prints the table. options: of our mesher."""
    found = sorted(os.path.basename(path)[:-len(".vtk")]
                   for path in glob.glob(os.path.join(folder, "our results", "*.vtk")))
    chosen = [name for name in found if not models or name in models.split(",")]
    if not chosen:
        print("No meshes in %s: clone https://github.com/CMU-CBML/HybridOctree_Hex" % folder)
        return
    print("| %s |\n|%s" % (" | ".join(HEADER), "---|" * len(HEADER)))
    rows = [compare_model(name, folder, share, options) for name in chosen]
    numbers = np.array([[row[3:6] for row in pair] for pair in rows])
    ratios = numbers[:, 1] / numbers[:, 0]
    print("\nOurs better in, of %d: scaled Jacobian %d, rms %d, Hausdorff %d" % (
        len(rows), (ratios[:, 0] > 1).sum(), (ratios[:, 1] < 1).sum(), (ratios[:, 2] < 1).sum()))
    print("Geometric means, theirs and ours: rms %.3f, %.3f; Hausdorff %.2f, %.2f" % tuple(
        np.exp(np.log(numbers[:, :, 1:]).mean(0)).T.ravel()))


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder")
    parser.add_argument("--models", default="", help="names, separated by commas; default: all")
    parser.add_argument("--count", type=float, default=1.0)
    parser.add_argument("--edge-angle", type=float, default=40.0, help="179: no sharp edges")
    arguments = parser.parse_args()
    compare(arguments.folder, arguments.models, arguments.count, edge_angle=arguments.edge_angle)


if __name__ == "__main__":
    sys.exit(main())
