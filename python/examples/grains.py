"""Meshes grains that fill a box; the picture shows the mesh cut open.

usage: python grains.py [--picture grains.png]
"""

import argparse

import numpy as np

import volume_fraction_mesh as vfm

TEXT = "sphere radius=0.3 center=0.1,-0.1,0.25 material=1; polycrystal grains=24 seed=4 material=2"


def show(mesh: vfm.Mesh, path: str) -> None:
    """Shows the elements behind a plane, uncut."""
    import pyvista

    grid = mesh.to_pyvista()
    behind = grid.cell_centers().points @ np.array([1, -1, 0.8]) < 0.35
    plotter = pyvista.Plotter(off_screen=True, window_size=(800, 760))
    plotter.background_color = "white"
    plotter.add_mesh(
        grid.extract_cells(behind),
        scalars="MaterialId",
        cmap="tab20",
        show_edges=True,
        edge_color="#303030",
        line_width=0.5,
        show_scalar_bar=False,
    )
    plotter.camera_position = [(3.1, -4.3, 2.6), (-0.1, 0.1, -0.12), (0, 0, 1)]
    plotter.camera.zoom(1.1)
    plotter.screenshot(path)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--picture")
    words = parser.parse_args()
    mesh = vfm.hexes(vfm.shapes(TEXT, 24, bounds=[-1, 1] * 3))
    print(mesh)
    if words.picture:
        show(mesh, words.picture)


if __name__ == "__main__":
    main()
