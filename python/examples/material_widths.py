"""Meshes an image of a piece of brain with narrow cells for its cortex, and wide ones inside.

The cortex is folded, and three voxels thick. Wide cells everywhere tear it, and cells as wide as a
voxel everywhere fill the inside with elements that it does not need.

usage: python material_widths.py [--picture material_widths.png]
"""

import argparse

import numpy as np

import volume_fraction_mesh as vfm

VOXELS, THICKNESS, WIDE = 64, 3.0, 4
NAMES = {1: "cortex", 2: "inside", 3: "nucleus"}


def make_image() -> np.ndarray:
    """Returns the label of each voxel: the cortex below a folded surface, the inside, and a nucleus
    in it."""
    x, y, z = np.indices([VOXELS] * 3) + 0.5
    surface = 52 + 4 * np.sin(0.25 * x + 0.05 * y) * np.cos(0.2 * y - 0.08 * x) + np.sin(0.5 * y)
    depth = surface - z
    nucleus = (x - 34) ** 2 + (y - 36) ** 2 + 1.5 * (z - 22) ** 2 < 11**2
    return np.where(depth < 0, 0, np.where(depth < THICKNESS, 1, np.where(nucleus, 3, 2)))


def show(meshes: dict[str, vfm.Mesh], path: str) -> None:
    """Shows the elements of each mesh behind a plane."""
    import pyvista

    plotter = pyvista.Plotter(off_screen=True, shape=(1, len(meshes)), window_size=(1500, 480),
                              border=False)
    plotter.background_color = "white"
    middle = VOXELS / 2
    for column, (name, mesh) in enumerate(meshes.items()):
        plotter.subplot(0, column)
        grid = mesh.to_pyvista()
        behind = grid.cell_centers().points[:, 1] > middle
        plotter.add_mesh(
            grid.extract_cells(behind),
            scalars="MaterialId",
            cmap=["#d98880", "#f2e2c4", "#7fb3d5"],
            show_edges=True,
            edge_color="#303030",
            line_width=0.5,
            show_scalar_bar=False,
            ambient=0.3,
        )
        plotter.add_text("%s: %s elements" % (name, "{:,}".format(len(mesh.cells))),
                         font_size=11, color="black")
        plotter.camera_position = [(middle - 40, -150, middle + 65),
                                   (middle, middle, 0.47 * VOXELS), (0, 0, 1)]
        plotter.camera.zoom(1.35)
    plotter.screenshot(path)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--picture")
    words = parser.parse_args()
    labels = make_image()
    cases = {
        "voxels": {},
        "width %d" % WIDE: {"cell_width": WIDE},
        "cortex 1, others %d" % WIDE: {"cell_width": WIDE, "material_widths": {"cortex": 1}},
        "auto": {"material_widths": "auto"},
    }
    meshes = {}
    print("widths of cells       hexahedra  smallest scaled Jacobian  pieces of the cortex")
    for name, options in cases.items():
        mesh = vfm.hexes(labels=labels, names=NAMES, **options)
        table = mesh.materials
        print("%-20s %10d %25.2f %21d" % (name, len(mesh.cells),
                                          min(table["MinimumScaledJacobian"]),
                                          table["Fragments"][0]))
        meshes[name] = mesh
    if words.picture:
        del meshes["width %d" % WIDE]
        show(meshes, words.picture)


if __name__ == "__main__":
    main()
