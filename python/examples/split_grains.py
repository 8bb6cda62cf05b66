"""Splits the interfaces of a polycrystal and inserts cohesive elements; the picture shows these
elements, and the grains moved apart.

usage: python split_grains.py [--picture split_grains.png]
"""

import argparse

import numpy as np

import volume_fraction_mesh as vfm

APART = 0.35  # distance of the grains, relative to that of their centres


def show(mesh: vfm.Mesh, path: str) -> None:
    """Shows the cohesive elements, and the grains apart: each grain has its own nodes."""
    import pyvista

    grains = mesh.to_pyvista()
    centres = {material: grains.cell_centers().points[mesh.material == material].mean(axis=0)
               for material in np.unique(mesh.material)}
    for material, centre in centres.items():
        nodes = np.unique(mesh.cells[mesh.material == material])
        grains.points[nodes] += APART * centre
    plotter = pyvista.Plotter(off_screen=True, window_size=(1100, 560), shape=(1, 2), border=False)
    plotter.background_color = "white"
    style = {"show_edges": True, "edge_color": "#303030", "line_width": 0.5,
             "show_scalar_bar": False, "cmap": "tab20"}
    blocks = mesh.cohesive().values()
    faces = pyvista.PolyData.from_regular_faces(
        mesh.points, np.concatenate([block.cells[:, :4] for block in blocks]))
    faces.cell_data["pair"] = np.repeat(np.arange(len(blocks)), [len(block) for block in blocks])
    plotter.add_mesh(faces, scalars="pair", **style)
    plotter.subplot(0, 1)
    plotter.add_mesh(grains, scalars="MaterialId", **style)
    for column in (0, 1):
        plotter.subplot(0, column)
        plotter.camera_position = [(3.1, -4.3, 2.6), (0, 0, 0), (0, 0, 1)]
        plotter.camera.zoom(0.85 if column == 0 else 0.78)
    plotter.screenshot(path)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--picture")
    words = parser.parse_args()
    fractions = vfm.shapes("polycrystal grains=12 seed=4", 16, bounds=[-1, 1] * 3)
    mesh = vfm.hexes(fractions, split_interfaces="all", split_connection="cohesive")
    print(mesh)
    print("%d nodes added, %d cohesive elements between %d pairs of grains"
          % (mesh.fields["AddedNodes"][0], sum(map(len, mesh.cohesive().values())),
             len(mesh.cohesive())))
    if words.picture:
        show(mesh, words.picture)


if __name__ == "__main__":
    main()
