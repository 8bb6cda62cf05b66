"""Meshes the grains of a solidification by ExaCA, or of a growth by SPPARKS, as a deck with
orientations.

usage: python Examples/exaca_grains.py [FILE.vtk] [--array GrainID] [--orientations FILE.csv]
                                       [--folder DIR]

FILE.vtk has one number per point or cell, as ExaCA writes it (STRUCTURED_POINTS, array GrainID,
below 0 for grains that nucleated) and SPPARKS by its tools (array Spin). Without a file a growth of
columns with nucleated grains is made. A row of the orientations, GrainOrientationEulerAnglesBunge
of ExaCA, has three Euler angles in degrees; grain g has the row (|g| - 1) modulo the number of
rows, counted from 0. Without a file random orientations are made.

Grains get the labels 1 to n. Grains of few cells join their neighbours. Writes

    grains.inp, orientations.inp   Abaqus and CalculiX
    grains.e                       Exodus: blocks with angles and the number of ExaCA as variables

Prints the number of grains and their volumes in the mesh against those of the cells.

Requires volume_fraction_mesh, and vtk to read the file.
"""
import argparse
import os

import numpy as np

import volume_fraction_mesh as vfm

SMALLEST = 8  # cells of a grain
ROWS = 10000  # of ExaCA's table of orientations


def make_file(path, cells=20):
    """Writes columns that grow from the bottom, with grains that nucleated above."""
    random = np.random.default_rng(8)
    seeds = np.vstack([random.random((12, 3)) * [1, 1, 0], random.random((6, 3))])
    numbers = np.concatenate([np.arange(1, 13) * 37, -np.arange(1, 7) * 211])
    axis = (np.arange(cells) + 0.5) / cells
    x, y, z = np.meshgrid(axis, axis, axis, indexing="ij")
    slow = np.array([0.25] * 12 + [1.0] * 6)  # columns grow faster along z
    times = [(x - a) ** 2 + (y - b) ** 2 + s * (z - c) ** 2 + 0.05 * (n < 0)
             for (a, b, c), s, n in zip(seeds, slow, numbers)]
    grain = numbers[np.argmin(times, axis=0)]
    with open(path, "w", encoding="ascii") as file:
        file.write("# vtk DataFile Version 3.0\nvtk output\nASCII\nDATASET STRUCTURED_POINTS\n"
                   "DIMENSIONS %d %d %d\nORIGIN 0 0 0\nSPACING 1e-6 1e-6 1e-6\nPOINT_DATA %d\n"
                   "SCALARS GrainID int 1\nLOOKUP_TABLE default\n" % (*grain.shape, grain.size))
        np.savetxt(file, grain.ravel("F")[None], fmt="%d")


def random_orientations(count=ROWS):
    """Returns Euler angles of Bunge in degrees."""
    first, middle, last = np.random.default_rng(9).random((3, count))
    return np.degrees(np.stack([2 * np.pi * first, np.arccos(1 - 2 * middle), 2 * np.pi * last],
                               axis=1))


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("file", nargs="?", help="file of ExaCA or SPPARKS, .vtk")
    parser.add_argument("--array", default="GrainID", help="array of the grains")
    parser.add_argument("--orientations", metavar="FILE.csv", help="Euler angles in degrees")
    parser.add_argument("--folder", default="out/exaca", help="folder for the files")
    arguments = parser.parse_args()
    os.makedirs(arguments.folder, exist_ok=True)
    path = arguments.file
    if path is None:
        path = os.path.join(arguments.folder, "exaca.vtk")
        make_file(path)
    angles = (np.loadtxt(arguments.orientations, delimiter=",", skiprows=1)
              if arguments.orientations else random_orientations())
    image = vfm.read(path, arrays=[arguments.array])
    numbers, labels = np.unique(image[arguments.array], return_inverse=True)
    labels = labels.reshape(image[arguments.array].shape) + 1
    mesh = vfm.tets(labels=labels, coordinates=image.coordinates, label_smoothing=2,
                    minimum_region_cells=SMALLEST)
    grains = vfm.Grains(angles[(abs(numbers) - 1) % len(angles)], degrees=True,
                        phase_names={1: "metal"})
    mesh.state.update(grains.arrays(mesh))
    mesh.state["GrainID"] = numbers[mesh.material - 1].astype(np.int32)
    mesh.save(os.path.join(arguments.folder, "grains.inp"))
    mesh.save(os.path.join(arguments.folder, "grains.e"))
    grains.save(os.path.join(arguments.folder, "orientations.inp"), mesh)
    of_cells = np.asarray(mesh.materials["TargetVolume"])
    of_mesh = np.asarray(mesh.materials["MeshVolume"])
    print("%d grains in the file, %d in the mesh, %d tetrahedra" % (
        len(numbers), len(np.unique(mesh.material)), len(mesh)))
    box = np.prod([nodes[-1] - nodes[0] for nodes in image.coordinates])
    print("volume %.6e of %.6e, largest error of a grain %.1e" % (
        of_mesh.sum(), box, abs(of_mesh / of_cells - 1).max()))


if __name__ == "__main__":
    main()
