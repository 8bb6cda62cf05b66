"""Cuts the hexahedra on both sides of the surface of a ball into layers; the picture shows half of
the mesh.

usage: python layers.py [--picture layers.png]
"""

import argparse

import volume_fraction_mesh as vfm


def show(mesh: vfm.Mesh, path: str) -> None:
    """Shows the elements behind a plane, coloured by layer."""
    import pyvista

    grid = mesh.to_pyvista()
    half = grid.extract_cells(grid.cell_centers().points[:, 1] > 0)
    plotter = pyvista.Plotter(off_screen=True, window_size=(760, 600))
    plotter.background_color = "white"
    plotter.add_mesh(half, scalars="Layer", show_edges=True, edge_color="#303030", line_width=0.5,
                     show_scalar_bar=False, lighting=False,
                     cmap=["#d9d9d9", "#08519c", "#4292c6", "#9ecae1"])
    plotter.camera_position = [(0.5, -4.2, 0.9), (0, 0, 0), (0, 0, 1)]
    plotter.camera.zoom(1.05)
    plotter.screenshot(path)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--picture")
    words = parser.parse_args()
    ball = vfm.shapes("sphere radius=0.6", 20, bounds=[-1, 1] * 3)
    mesh = vfm.hexes(ball, mesh_void=True, layers=3, layer_growth=1.5, first_layer=0.1)
    print(mesh)
    print("%d elements in layers, smallest scaled Jacobian %.2f"
          % ((mesh.layer > 0).sum(), mesh.quality.min()))
    if words.picture:
        show(mesh, words.picture)


if __name__ == "__main__":
    main()
