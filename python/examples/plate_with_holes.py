"""Meshes a plate with holes from its STL file, with nodes placed by the fractions only and by the
triangles, and prints the distance of its edges from both meshes.

usage: python plate_with_holes.py [--stl part.stl] [--cells 36] [--picture part.png]
"""

import argparse
import os
from typing import List

import numpy as np

import volume_fraction_mesh as vfm

DATA = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Data", "Surfaces")
STEP = 0.1  # of samples along edges, in cells
SHARP = np.cos(np.radians(40))


def read_stl(path: str) -> np.ndarray:
    """Returns the corners of the triangles of a binary STL file, shape (n, 3, 3)."""
    kind = [("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")]
    return np.fromfile(path, np.dtype(kind), offset=84)["corners"].astype(float)


def sample_edges(corners: np.ndarray, step: float) -> np.ndarray:
    """Returns points along the edges where triangles meet at 40 degrees and more."""
    points, numbers = np.unique(corners.reshape(-1, 3), axis=0, return_inverse=True)
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    edges = np.sort(numbers.reshape(-1, 3)[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    order = np.lexsort(edges.T).reshape(-1, 2)  # the two triangles of each edge
    is_sharp = (normals[order[:, 0] // 3] * normals[order[:, 1] // 3]).sum(1) < SHARP
    samples = []
    for a, b in points[edges[order[is_sharp, 0]]]:
        count = max(1, round(np.linalg.norm(b - a) / step))
        samples.append(a + (np.arange(count) + 0.5)[:, None] / count * (b - a))
    return np.concatenate(samples)


def show(corners: np.ndarray, meshes: List[vfm.Mesh], path: str) -> None:
    import pyvista

    plotter = pyvista.Plotter(shape=(1, 3), off_screen=True, window_size=(1800, 620), border=False)
    plotter.background_color = "white"
    faces = np.arange(3 * len(corners)).reshape(-1, 3)
    plotter.add_mesh(pyvista.PolyData.from_regular_faces(corners.reshape(-1, 3), faces),
                     color="#d8d8d8", show_edges=True, edge_color="#404040", line_width=0.6)
    for place, mesh in enumerate(meshes):
        plotter.subplot(0, 1 + place)
        plotter.add_mesh(mesh.to_pyvista("surfaces"), scalars="SurfaceId", cmap="Set3",
                         show_edges=True, edge_color="#404040", line_width=0.6,
                         show_scalar_bar=False)
        if len(mesh.curves.curve_id):
            plotter.add_mesh(mesh.to_pyvista("curves"), color="black", line_width=3, scalars=None)
    plotter.link_views()
    plotter.camera_position = [(62, -42, 66), (30, 19, 0), (0, 0, 1)]
    plotter.screenshot(path)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--stl", default=os.path.join(DATA, "plate_with_holes.stl"))
    parser.add_argument("--cells", type=int, default=36, help="along the longest side")
    parser.add_argument("--picture")
    words = parser.parse_args()
    fractions = vfm.surface({"steel": words.stl}, words.cells)
    corners = read_stl(words.stl)
    width = np.ptp(corners.reshape(-1, 3), axis=0).max() / words.cells
    edges = sample_edges(corners, STEP * width)
    meshes = [vfm.hexes(fractions, surface_targets=targets) for targets in ("off", "on")]
    for targets, mesh in zip(("fractions", "triangles"), meshes):
        nodes = mesh.points[np.unique(mesh.surfaces.cells)]
        apart = [np.linalg.norm(nodes - x, axis=1).min() for x in edges]
        print("%-10s %5d hexahedra, scaled Jacobian %.3f, %2d sides, edges to nodes %.2f cells rms"
              % (targets + ":", len(mesh.cells), mesh.quality.min(),
                 mesh.surfaces.surface_id.max(), np.sqrt(np.mean(np.square(apart))) / width))
    if words.picture:
        show(corners, meshes, words.picture)


if __name__ == "__main__":
    main()
