"""Meshes a model of lithologies below a topography, for GEOS and for codes that read Gmsh files.

usage: python Examples/geology.py [--cells N] [--folder DIR]

The model is a block of labels, as GemPy and LoopStructural compute it for a regular grid: three
layers with a fold and a fault. The topography is a height at each place of the map; it cuts the
labels, so that the part of a cell below it is filled. Prints the volume of each layer, below the
ground, in the mesh and in the cells, and the volume below the topography by its formula.

    geology.vtu    for GEOS: hexahedra with the regions in the array "attribute"
    geology.msh    Gmsh 2.2: named volumes, sides of the box, the ground and contacts of layers

Requires volume_fraction_mesh. A block of GemPy is the array `solutions.raw_arrays.lith_block` of
its regular grid, in the order x, y, z: `lith_block.reshape(resolution)` replaces `make_labels`.
"""
import argparse
import os

import numpy as np

import volume_fraction_mesh as vfm

SIZE = (2000.0, 1600.0, 1000.0)  # metres along x, y, z
NAMES = {1: "basement", 2: "limestone", 3: "cover"}
GROUND, HILLS = 780.0, 120.0  # mean height and amplitude of the topography
SAMPLES = 4  # of the topography per cell along x and y


def height_of_ground(x, y):
    """Returns the topography, which has the mean GROUND over the map."""
    return GROUND + HILLS * np.sin(2 * np.pi * x / SIZE[0]) * np.cos(2 * np.pi * y / SIZE[1])


def make_labels(x, y, z):
    """Returns the layers: a fold along x, and a fault at x = 1200 that inclines with z."""
    east = x > 1200 + 0.4 * (z - 500)
    depth = z - 60 * np.sin(2 * np.pi * x / 900) - 0.05 * y + 130 * east
    return np.where(depth < 300, 1, np.where(depth < 520, 2, 3))


def filled_parts(cells):
    """Returns the part of each cell below the topography: that of columns through the cell."""
    x, y = ((np.arange(n * SAMPLES) + 0.5) / (n * SAMPLES) * size
            for n, size in zip(cells[:2], SIZE))
    ground = height_of_ground(x[:, None], y) / SIZE[2] * cells[2]
    parts = np.clip(ground[:, :, None] - np.arange(cells[2]), 0, 1)
    return parts.reshape(cells[0], SAMPLES, cells[1], SAMPLES, cells[2]).mean(axis=(1, 3))


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--cells", type=int, default=40, help="cells along x, default 40")
    parser.add_argument("--folder", default="out/geology", help="folder for the files")
    arguments = parser.parse_args()
    os.makedirs(arguments.folder, exist_ok=True)
    width = SIZE[0] / arguments.cells
    cells = tuple(int(round(size / width)) for size in SIZE)
    centres = [(np.arange(n) + 0.5) * width for n in cells]
    labels = make_labels(*np.meshgrid(*centres, indexing="ij"))
    below = filled_parts(cells)
    layers = {name: np.where(labels == label, below, 0) for label, name in NAMES.items()}
    mesh = vfm.hexes(layers, spacing=width)
    mesh.state["attribute"] = mesh.material.astype(np.int32)
    mesh.save(os.path.join(arguments.folder, "geology.vtu"))
    mesh.save(os.path.join(arguments.folder, "geology.msh"))
    print("%d hexahedra, scaled Jacobian at least %.2f" % (len(mesh), mesh.quality.min()))
    volumes = np.bincount(mesh.material, mesh.volumes())[1:]
    for name, volume in zip(layers, volumes):
        print("%s: %.4f m3 in the mesh, %.4f in the cells" % (
            name, volume, layers[name].sum() * width ** 3))
    print("below the ground: %.4f m3, by the formula %.4f" % (
        volumes.sum(), GROUND * SIZE[0] * SIZE[1]))


if __name__ == "__main__":
    main()
