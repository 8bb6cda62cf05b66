"""Meshes an image of grains with cells as wide as one, two and three voxels.

Fractions of wider cells average the steps of the voxels. So at twice the width, with an eighth of
the elements, interfaces between two grains are nearer to the true planes. Lines where more grains
meet get less exact.

usage: python cell_width.py [--picture cell_width.png]
"""

import argparse

import numpy as np

import volume_fraction_mesh as vfm

VOXELS, WIDTHS = 48, (1, 2, 3)


def make_image(seeds: np.ndarray) -> np.ndarray:
    """Returns the grain of each voxel, from 1: that of the nearest seed."""
    centres = np.moveaxis(np.indices([VOXELS] * 3) + 0.5, 0, -1)
    squares = [((centres - seed) ** 2).sum(axis=-1) for seed in seeds]
    return np.argmin(squares, axis=0) + 1


def distances(mesh: vfm.Mesh, seeds: np.ndarray) -> tuple[float, float]:
    """Returns the distance of nodes from the planes half way between the seeds of two grains, rms:
    of nodes between two grains, and of nodes at lines and corners, from all planes there."""
    pairs = np.repeat(mesh.surfaces.material_pair, mesh.surfaces.cells.shape[1], axis=0)
    rows = np.column_stack([mesh.surfaces.cells.ravel(), pairs])[pairs[:, 0] > 0]
    nodes, first, second = np.unique(rows, axis=0).T
    normals = seeds[second - 1] - seeds[first - 1]
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    middles = (seeds[second - 1] + seeds[first - 1]) / 2
    squares = ((mesh.points[nodes] - middles) * normals).sum(axis=1) ** 2
    is_between = np.bincount(nodes)[nodes] == 1
    return np.sqrt(squares[is_between].mean()), np.sqrt(squares[~is_between].mean())


def show(meshes: dict[int, vfm.Mesh], path: str) -> None:
    """Shows the elements of each mesh behind a plane."""
    import pyvista

    plotter = pyvista.Plotter(off_screen=True, shape=(1, len(meshes)), window_size=(1350, 430),
                              border=False)
    plotter.background_color = "white"
    for column, (width, mesh) in enumerate(meshes.items()):
        plotter.subplot(0, column)
        grid = mesh.to_pyvista()
        behind = grid.cell_centers().points @ np.array([1, -1, 0.8]) < 0.35 * VOXELS
        plotter.add_mesh(
            grid.extract_cells(behind),
            scalars="MaterialId",
            cmap="tab20",
            show_edges=True,
            edge_color="#303030",
            line_width=0.5,
            show_scalar_bar=False,
            ambient=0.3,
        )
        plotter.add_text("%d voxel%s: %s elements" % (width, "s" if width > 1 else "",
                                                      "{:,}".format(len(mesh.cells))),
                         font_size=11, color="black")
        plotter.camera_position = [(120, -140, 105), (20, 28, 20), (0, 0, 1)]
        plotter.camera.zoom(1.4)
    plotter.screenshot(path)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--picture")
    words = parser.parse_args()
    seeds = np.random.default_rng(1).random((12, 3)) * VOXELS
    labels = make_image(seeds)
    meshes = {width: vfm.hexes(labels=labels, cell_width=width) for width in WIDTHS}
    print("                              distance from the true planes, rms in voxels")
    print("width  elements               between two grains  where more meet")
    for width, mesh in meshes.items():
        tets = vfm.tets(labels=labels, cell_width=width, method="lattice")
        for kind, made in (("hexahedra", mesh), ("tetrahedra", tets)):
            print("%5d %9d %-12s %18.3f %16.3f"
                  % (width, len(made.cells), kind, *distances(made, seeds)))
    if words.picture:
        show(meshes, words.picture)


if __name__ == "__main__":
    main()
