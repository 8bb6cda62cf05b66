"""Meshes a bag of liquid before it bursts: a film of 0.4 cells with a rim, as VOF codes give it.

usage: python3 Examples/liquid_bag.py [--cells 40] [--thickness 0.4] [--output bag.vtu]

A drop in a gas stream is blown up to a bag: half a sphere whose film is thinner than a cell, with a
thick rim. No cell of the film is filled by more than half, so only Thin Parts keep it: without them
the rim takes over its volume. Prints for both meshes the elements, the fragments, and the volumes of
all and of the upper half of the film, in % of those in the fractions. Needs volume_fraction_mesh.
"""
import argparse

import numpy as np
import volume_fraction_mesh as vfm

SAMPLES = 6  # along each axis of a cell
RADIUS, RIM = 0.3, 0.05  # of the bag and of its rim, relative to the domain
FOOT = 0.35  # height of the rim


def bag_fractions(cells, thickness):
    """Returns the fractions of liquid in cells^3 cells. thickness: of the film, in cells."""
    points = (np.arange(cells * SAMPLES) + 0.5) / SAMPLES
    x, y, z = np.meshgrid(points - 0.503 * cells, points - 0.497 * cells, points - FOOT * cells,
                          indexing="ij")
    across = np.sqrt(x * x + y * y)
    film = (np.abs(np.sqrt(across ** 2 + z * z) - RADIUS * cells) < 0.5 * thickness) & (z > 0)
    rim = (across - RADIUS * cells) ** 2 + z * z < (RIM * cells) ** 2
    blocks = (film | rim).reshape(cells, SAMPLES, cells, SAMPLES, cells, SAMPLES)
    return blocks.mean(axis=(1, 3, 5))


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--cells", type=int, default=40)
    parser.add_argument("--thickness", type=float, default=0.4)
    parser.add_argument("--output", help="file of the mesh with thin parts")
    arguments = parser.parse_args()
    fractions = bag_fractions(arguments.cells, arguments.thickness)
    upper = int((FOOT + 0.5 * RADIUS) * arguments.cells)
    print("thin parts  hexahedra  fragments  volume %  upper half of the film %  scaled Jacobian")
    for thin in (False, True):
        mesh = vfm.hexes([fractions], names=["liquid"], thin_parts=thin)
        volumes = mesh.volumes()
        is_upper = mesh.points[mesh.cells].mean(axis=1)[:, 2] > upper
        print("%-10s  %9d  %9d  %8.2f  %24.1f  %15.3f" % (
            "on" if thin else "off", len(mesh.cells), len(np.unique(mesh.fragment)),
            100 * volumes.sum() / fractions.sum(),
            100 * volumes[is_upper].sum() / fractions[:, :, upper:].sum(), mesh.quality.min()))
    if arguments.output:
        mesh.save(arguments.output)


if __name__ == "__main__":
    main()
