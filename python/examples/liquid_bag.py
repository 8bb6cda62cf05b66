"""Meshes a bag of liquid before it bursts: a film of 0.4 cells with a rim, as VOF codes give it.

No cell of the film is filled by more than half, so only the option thin_parts keeps it: without
it, the rim takes over its volume.

usage: python liquid_bag.py [--cells 40] [--thickness 0.4] [--picture bag.png]
"""

import argparse

import numpy as np

import volume_fraction_mesh as vfm

SAMPLES = 6  # along each axis of a cell
RADIUS, RIM, FOOT = 0.3, 0.05, 0.35  # of the bag, of its rim, and height, relative to the domain


def bag_fractions(cells: int, thickness: float) -> np.ndarray:
    """Returns the fractions of liquid in cells^3 cells. thickness: of the film, in cells."""
    points = (np.arange(cells * SAMPLES) + 0.5) / SAMPLES
    x, y, z = np.meshgrid(points - 0.503 * cells, points - 0.497 * cells, points - FOOT * cells,
                          indexing="ij")
    across = np.sqrt(x * x + y * y)
    film = (np.abs(np.sqrt(across**2 + z * z) - RADIUS * cells) < 0.5 * thickness) & (z > 0)
    rim = (across - RADIUS * cells) ** 2 + z * z < (RIM * cells) ** 2
    blocks = (film | rim).reshape(cells, SAMPLES, cells, SAMPLES, cells, SAMPLES)
    return blocks.mean(axis=(1, 3, 5))


def show(meshes, cells: int, path: str) -> None:
    """Shows the meshes side by side, cut open."""
    import pyvista

    plotter = pyvista.Plotter(off_screen=True, window_size=(1200, 600))
    plotter.background_color = "white"
    for place, mesh in enumerate(meshes):
        grid = mesh.to_pyvista()
        grid = grid.extract_cells(grid.cell_centers().points[:, 1] > 0.45 * cells)
        grid.points[:, 0] += 0.8 * cells * place
        plotter.add_mesh(grid, color="lightblue", show_edges=True, line_width=0.5)
    plotter.view_vector((0.3, -1, 0.35), viewup=(0, 0, 1))
    plotter.camera.zoom(2.0)
    plotter.screenshot(path)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--cells", type=int, default=40)
    parser.add_argument("--thickness", type=float, default=0.4)
    parser.add_argument("--picture")
    words = parser.parse_args()
    fractions = bag_fractions(words.cells, words.thickness)
    upper = int((FOOT + 0.5 * RADIUS) * words.cells)
    meshes = []
    for thin_parts in (False, True):
        mesh = vfm.hexes([fractions], names=["liquid"], thin_parts=thin_parts)
        meshes.append(mesh)
        volumes = mesh.volumes()
        is_upper = mesh.points[mesh.cells].mean(axis=1)[:, 2] > upper
        print(
            "thin parts %s: %d hexahedra, %d fragments, %.2f %% of the volume, %.0f %% of the "
            "upper half of the film, scaled Jacobian %.2f"
            % ("on" if thin_parts else "off", len(mesh.cells), len(np.unique(mesh.fragment)),
               100 * volumes.sum() / fractions.sum(),
               100 * volumes[is_upper].sum() / fractions[:, :, upper:].sum(), mesh.quality.min())
        )
    if words.picture:
        show(meshes, words.cells, words.picture)


if __name__ == "__main__":
    main()
