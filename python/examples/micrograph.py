"""Meshes a segmented micrograph with hexahedra: one layer of pixels of grains, with smoothed steps.

usage: python micrograph.py [--mesh grains.vtu] [--picture grains.png]
"""

import argparse

import numpy as np

import volume_fraction_mesh as vfm

PIXELS, GRAINS, WIDTH = (72, 40), 13, 0.5  # micrometres per pixel


def segmented_image() -> np.ndarray:
    """Returns labels 1, 2, .. of grains (rows, columns), with pores of label 0 and some wrong
    pixels."""
    random = np.random.default_rng(3)
    seeds = random.random((GRAINS, 2)) * PIXELS[::-1]
    rows, columns = np.mgrid[: PIXELS[1], : PIXELS[0]] + 0.5
    distances = (rows[..., None] - seeds[:, 0]) ** 2 + (columns[..., None] - seeds[:, 1]) ** 2
    labels = 1 + np.argmin(distances, axis=2)
    for row, column in ((12, 20), (26, 46), (30, 11)):
        labels[(rows - row) ** 2 + (columns - column) ** 2 < 4**2] = 0
    wrong = random.random(labels.shape) < 0.004
    labels[wrong] = random.integers(1, GRAINS + 1, wrong.sum())
    return labels


def show(meshes, path: str) -> None:
    """Shows meshes one above the other."""
    import pyvista

    plotter = pyvista.Plotter(shape=(2, 1), off_screen=True, window_size=(900, 1050), border=False)
    for row, (title, mesh) in enumerate(meshes):
        plotter.subplot(row, 0)
        plotter.add_text(title, font_size=11, color="black")
        plotter.add_mesh(
            mesh.to_pyvista(),
            scalars="MaterialId",
            cmap="Spectral",
            show_edges=True,
            edge_color="#303030",
            line_width=0.5,
            show_scalar_bar=False,
            copy_mesh=False,
        )
        plotter.view_xy()
        plotter.camera.parallel_projection = True
        plotter.camera.parallel_scale = 0.32 * PIXELS[0] * WIDTH
    plotter.background_color = "white"
    plotter.screenshot(path)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--mesh")
    parser.add_argument("--picture")
    words = parser.parse_args()
    layer = segmented_image()[None, ::-1]  # (z, y, x), rows of an image go down
    settings = {"labels": layer, "order": "zyx", "spacing": WIDTH}
    steps = vfm.hexes(stair_step=True, **settings)
    smooth = vfm.hexes(label_smoothing=3, minimum_region_cells=6, **settings)
    print("pixels  ", steps)
    print("smoothed", smooth)
    print("%d regions of less than 6 pixels removed" % smooth.fields["RemovedRegions"][0])
    if words.mesh:
        smooth.save(words.mesh)
    if words.picture:
        show([("pixels", steps), ("hexahedra, label_smoothing=3, minimum_region_cells=6", smooth)],
             words.picture)


if __name__ == "__main__":
    main()
