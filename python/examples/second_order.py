"""Meshes a ball on 8^3 cells with straight and with curved elements; the picture shows both.

usage: python second_order.py [--picture second_order.png]
"""

import argparse

import numpy as np
import volume_fraction_mesh as vfm

RADIUS = 0.7
EDGES = [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6),
         (3, 7)]


def find_edges(mesh: vfm.Mesh, steps: int) -> np.ndarray:
    """Returns points along each edge of the surface, shape (edges, steps + 1, 3)."""
    ends = mesh.cells[:, EDGES].reshape(-1, 2)
    on_surface = (mesh.geometry.dimension[ends] < 3).all(axis=1)
    if mesh.mids is not None:
        on_surface = mesh.geometry.dimension[mesh.mids[:, :12].ravel()] < 3
    first, last = mesh.points[ends[on_surface, 0]], mesh.points[ends[on_surface, 1]]
    bulge = np.zeros_like(first)
    if mesh.mids is not None:
        bulge = mesh.points[mesh.mids[:, :12].ravel()[on_surface]] - (first + last) / 2
    t = np.linspace(0, 1, steps + 1)[:, None]
    return first[:, None] * (1 - t) + last[:, None] * t + bulge[:, None] * (4 * t * (1 - t))


def show(meshes: list, path: str) -> None:
    """Shows the surfaces, with the edges of their elements."""
    import pyvista
    from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter

    plotter = pyvista.Plotter(off_screen=True, shape=(1, 2), border=False, window_size=(1000, 500))
    for number, mesh in enumerate(meshes):
        plotter.subplot(0, number)
        plotter.background_color = "white"
        surface = vtkDataSetSurfaceFilter()
        surface.SetInputData(mesh.to_pyvista())
        surface.SetNonlinearSubdivisionLevel(4)
        surface.Update()
        plotter.add_mesh(pyvista.wrap(surface.GetOutput()), color="#9ecae1", specular=0.3)
        for line in find_edges(mesh, 12):
            plotter.add_mesh(pyvista.lines_from_points(line * 1.002), color="#303030", line_width=2)
        plotter.camera_position = [(2.6, -2.6, 1.6), (0, 0, 0), (0, 0, 1)]
        plotter.camera.zoom(1.35)
    plotter.screenshot(path)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--picture")
    words = parser.parse_args()
    ball = vfm.shapes("sphere radius=%g" % RADIUS, 8, bounds=[-1, 1] * 3)
    meshes = [vfm.hexes(ball), vfm.hexes(ball, element_order="quadratic")]
    for mesh in meshes:
        off = abs(np.linalg.norm(find_edges(mesh, 20), axis=2) - RADIUS)
        print("%s\n  edges on the surface are off the sphere by %.5f cells rms"
              % (mesh, np.sqrt((off ** 2).mean()) * 4))
    if words.picture:
        show(meshes, words.picture)


if __name__ == "__main__":
    main()
