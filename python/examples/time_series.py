"""Meshes the time steps of a drop that stretches as it flies. Each mesh keeps the mass, momentum
and energy of the cells.

usage: python time_series.py [--folder meshes] [--picture steps.png]
"""

import argparse
import os
from typing import Dict

import numpy as np

import volume_fraction_mesh as vfm

CELLS, BOUNDS, RADIUS, TIMES = (
    (52, 32, 32), [0.0, 3.25, -1.0, 1.0, -1.0, 1.0], 0.45, np.linspace(0, 1, 5))


def field_at(time: float) -> Dict[str, object]:
    """Returns the fractions and the state of an ellipsoid of constant volume."""
    stretch = 1 + time
    radii = RADIUS * np.array([stretch, stretch**-0.5, stretch**-0.5])
    centre = 0.7 + 1.4 * time
    drop = vfm.shapes("ellipsoid radii=%.9f,%.9f,%.9f center=%.9f,0,0" % (*radii, centre), CELLS,
                      bounds=BOUNDS)
    x, y, z = np.meshgrid(*(0.5 * (nodes[1:] + nodes[:-1]) for nodes in drop.coordinates),
                          indexing="ij")
    rate = 1 / stretch
    velocity = np.stack([1.4 + rate * (x - centre), -0.5 * rate * y, -0.5 * rate * z], axis=-1)
    return {"fractions": drop, "density": 1000 + 50 * (x - centre), "velocity": velocity,
            "energy": 2.0 + 0.1 * y}


def show(meshes, path: str) -> None:
    """Shows the first, the middle and the last mesh."""
    import pyvista

    plotter = pyvista.Plotter(off_screen=True, window_size=(900, 800))
    plotter.background_color = "white"
    for mesh in meshes[::2]:
        grid = mesh.to_pyvista()
        grid.cell_data["speed"] = np.linalg.norm(mesh.state["velocity"], axis=1)
        grid.points[:, 2] -= 1.1 * meshes.index(mesh) / 2
        plotter.add_mesh(grid, scalars="speed", clim=(0.9, 2.1), show_edges=True, line_width=0.5,
                         show_scalar_bar=False)
    plotter.view_xz()
    plotter.camera.parallel_projection = True
    plotter.camera.tight(padding=0.05, view="xz", adjust_render_window=False)
    plotter.screenshot(path)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--folder")
    parser.add_argument("--picture")
    words = parser.parse_args()
    meshes = []
    for step, time in enumerate(TIMES):
        mesh = vfm.hexes(**field_at(time), lost_kinetic_energy="internal_energy")
        meshes.append(mesh)
        told = mesh.materials
        print("time %.2f: %s" % (time, mesh))
        for name in ("Mass", "Momentum"):
            given, kept = (np.ravel(told[place + name])[0] for place in ("Input", "Mesh"))
            print(
                "  %-9s of the cells %.12g, of the mesh %.12g: off by %.1e"
                % (name.lower(), given, kept, abs(kept / given - 1))
            )
        given, kept = (
            told[place + "InternalEnergy"][0] + told[place + "KineticEnergy"][0]
            for place in ("Input", "Mesh")
        )
        print(
            "  %-9s of the cells %.12g, of the mesh %.12g: off by %.1e"
            % ("energy", given, kept, abs(kept / given - 1))
        )
        row = vfm.fragments(mesh)
        print("  the drop: volume %.6f, centroid %.4f %.4f %.4f"
              % (row["volume"][0], *row["centroid"][0]))
        if words.folder:
            os.makedirs(words.folder, exist_ok=True)
            mesh.save(os.path.join(words.folder, "drop_%02d.vtu" % step))
    if words.picture:
        show(meshes, words.picture)


if __name__ == "__main__":
    main()
