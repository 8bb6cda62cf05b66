"""Compares meshers that are installed, on images of labels: prints a table per image.

usage: compare.py [--cells 48] [--grains 50] [--images pores,grains] [--meshers "NAME;.."]
                  [--seed 1] [--keep FOLDER]

pores: one label with the pores of Examples/porous_flow.py. The true surface is the level of the
noise that the image samples. grains: labels of the nearest of random seeds, which fill the box.
The true surfaces are the planes between two seeds.

Each mesher runs in a process of its own with one thread; CGAL by PYTHON_DEBIAN, default
/usr/bin/python3. Meshers of surfaces get the surface of our hexahedra, only of the pores. --keep:
keeps images, meshes and messages.

Columns: CPU and wall seconds; peak MB of the process; largest error of the volume of a label;
smallest scaled Jacobian at a corner of hexahedra or tetrahedra; smallest dihedral angle of
tetrahedra in degrees; cells whose volume is not positive, or a Jacobian at a corner of theirs;
rms distance of points of interfaces to
the true surface, in voxels; faces inside of the box that belong to one cell, where all of the box
is meshed: 0 if interfaces conform.
"""
import argparse
import os
import subprocess
import sys
import tempfile

import numpy as np
from scipy import ndimage
from scipy.spatial import cKDTree

import measure_mesh

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "..", "Examples"))
import porous_flow

DEBIAN = os.environ.get("PYTHON_DEBIAN", "/usr/bin/python3")
OURS = "ours, hexahedra"  # the first mesher, whose surface others get
# (name, Python, whether it meshes a surface)
MESHERS = [(OURS, sys.executable, False), ("ours, tetrahedra", sys.executable, False),
           ("automesh, voxels", sys.executable, False),
           ("automesh, Taubin", sys.executable, False),
           ("automesh, hierarchical", sys.executable, False), ("CGAL (pygalmesh)", DEBIAN, False),
           ("snappyHexMesh", sys.executable, True), ("Gmsh", sys.executable, True),
           ("fTetWild (pytetwild)", sys.executable, True)]
HEADER = ("mesher", "cells", "kind", "CPU s", "wall s", "peak MB", "volume error", "SJ", "angle",
          "inverted", "distance", "open faces")
PASSES = 3  # of smoothing of labels by this project
NOT_HAD = {"iso2mesh": "PyPI has its functions, but not the programs that they run",
           "Cleaver": "PyPI has it as itk-cleaver, which is not run yet",
           "Sculpt": "part of Cubit, under a licence"}


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--cells", type=int, default=48, help="voxels along an edge of the box")
    parser.add_argument("--grains", type=int, default=50, help="number of grains, at most 255")
    parser.add_argument("--images", default="pores,grains")
    parser.add_argument("--meshers", help="names, separated by semicolons; default: all")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--keep", metavar="FOLDER")
    return parser.parse_args()


class Pores:
    """An image of pores, and distances to the level of the noise that it samples."""

    fills_box = False

    def __init__(self, arguments):
        noise = porous_flow.make_noise(arguments.cells, arguments.seed)
        level = np.quantile(noise, porous_flow.PORES)
        self.labels = porous_flow.make_pores(arguments.cells, arguments.seed).astype(np.uint8)
        self.spline = ndimage.spline_filter(noise - level, order=5, mode="grid-wrap")

    def evaluate(self, points):
        return ndimage.map_coordinates(self.spline, points.T - 0.5, order=5, mode="grid-wrap",
                                       prefilter=False)

    def distance(self, points, _):
        """Returns how far Newton's steps along the gradient move points to the level."""
        at, width = points, 1e-3
        for _ in range(5):
            slope = np.column_stack([self.evaluate(at + step) - self.evaluate(at - step)
                                     for step in width * np.eye(3)]) / (2 * width)
            at = at - self.evaluate(at)[:, None] * slope / (slope ** 2).sum(1, keepdims=True)
        return np.linalg.norm(at - points, axis=1)


class Grains:
    """An image of the nearest of random seeds, and distances to the planes between them."""

    fills_box = True

    def __init__(self, arguments):
        cells, random = arguments.cells, np.random.default_rng(arguments.seed)
        self.seeds = random.uniform(0, cells, (arguments.grains, 3))
        centres = np.stack(np.meshgrid(*3 * [np.arange(cells) + 0.5], indexing="ij"), axis=-1)
        self.labels = (cKDTree(self.seeds).query(centres)[1] + 1).astype(np.uint8)

    def distance(self, points, materials):
        a, b = self.seeds[materials[:, 0] - 1], self.seeds[materials[:, 1] - 1]
        difference = ((points - a) ** 2).sum(1) - ((points - b) ** 2).sum(1)
        return np.abs(difference) / (2 * np.linalg.norm(a - b, axis=1))


IMAGES = {"pores": Pores, "grains": Grains}


def run_mesher(name, python, given, folder):
    """Returns the arrays that run_mesher.py writes, or its last message."""
    out = os.path.join(folder, name.replace(" ", "_").replace(",", "") + ".npz")
    environment = dict(os.environ, OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1",
                       PYTHONDONTWRITEBYTECODE="1")
    with open(out + ".log", "w+", encoding="utf-8", errors="replace") as log:
        done = subprocess.run([python, os.path.join(HERE, "run_mesher.py"), name, given, out],
                              env=environment, cwd=folder, stdout=log, stderr=log, check=False)
        log.seek(0)
        message = log.read().strip().rsplit("\n", 1)[-1]
    if done.returncode:
        return message or "status %d" % done.returncode
    with np.load(out) as file:
        return dict(file)


def read_mesh(made):
    if "cells" in made:
        return measure_mesh.of_elements(made["points"], made["cells"], made["material"])
    faces = np.split(made["faces"], np.cumsum(made["sizes"])[:-1])
    return measure_mesh.of_polyhedra(made["points"], faces, made["owner"], made["neighbour"])


def name_kind(mesh, made):
    if "cells" in made:
        return {4: "tetrahedra", 8: "hexahedra"}[made["cells"].shape[1]]
    return "polyhedra, %.0f %% hexahedra" % (100 * measure_mesh.find_elements(mesh).mean())


def make_row(name, made, image):
    """Measures a mesh and returns the row of the table."""
    mesh, box = read_mesh(made), image.labels.shape
    volumes = measure_mesh.find_volumes(mesh)
    corners = measure_mesh.find_corner_jacobians(mesh)
    kind = name_kind(mesh, made)
    angle = measure_mesh.find_smallest_angle(made["points"], made["cells"]) \
        if kind == "tetrahedra" else None
    return (name, "%d" % len(volumes), kind, "%.2f" % made["cpu"], "%.2f" % made["wall"],
            "%.0f" % made["peak"],
            "%.2g %%" % (100 * measure_mesh.find_volume_error(mesh, volumes, image.labels)),
            "%.3f" % corners[1].min(), "" if angle is None else "%.1f" % angle,
            "%d" % measure_mesh.count_inverted(volumes, *corners),
            "%.3f" % measure_mesh.find_distance(mesh, image),
            "%d" % measure_mesh.count_open_faces(mesh, box) if image.fills_box else "")


def add_surface(given, mesh, box):
    """Adds the surface of a mesh, and the wall, which is the surface inside of the box."""
    surface, wall = [], []
    for corners, _ in measure_mesh.find_facets(mesh):
        at = mesh.points[corners]
        outside = ((at == 0).all(1) | (at == box).all(1)).any(1)
        triangles = at[:, [0, 1, 2, 0, 2, 3]].reshape(-1, 2, 3, 3)
        surface.append(triangles.reshape(-1, 3, 3))
        wall.append(triangles[~outside].reshape(-1, 3, 3))
    given.update(surface=np.concatenate(surface), wall=np.concatenate(wall))


def print_row(row):
    print("| " + " | ".join(row) + " |", flush=True)


def compare(image, chosen, folder):
    """Prints a table, then the settings of each mesher, or why it did not run."""
    given = {"labels": image.labels, "smoothing": PASSES}
    path, remarks = os.path.join(folder, "image.npz"), []
    np.savez(path, **given)
    print_row(HEADER)
    print("|" + "---|" * len(HEADER))
    for name, python, of_surface in MESHERS:
        if name not in chosen:
            continue
        if of_surface and image.labels.max() > 1:
            remarks.append((name, "not run: meshes one closed surface here"))
            continue
        made = run_mesher(name, python, path, folder)
        if isinstance(made, str):
            remarks.append((name, "not run: " + made))
            continue
        print_row(make_row(name, made, image))
        remarks.append((name, str(made["settings"])))
        if name == OURS:
            add_surface(given, read_mesh(made), image.labels.shape)
            np.savez(path, **given)
    print()
    for remark in remarks:
        print("- %s: %s" % remark)
    print(flush=True)


def main():
    arguments = parse_arguments()
    chosen = arguments.meshers.split(";") if arguments.meshers else [row[0] for row in MESHERS]
    with tempfile.TemporaryDirectory() as temporary:
        for name in arguments.images.split(","):
            folder = os.path.abspath(os.path.join(arguments.keep or temporary, name))
            os.makedirs(folder, exist_ok=True)
            image = IMAGES[name](arguments)
            print("%s: %d x %d x %d voxels, %d labels\n" % (
                name, *image.labels.shape, image.labels.max()))
            compare(image, chosen, folder)
    print("Not compared:")
    for remark in NOT_HAD.items():
        print("- %s: %s" % remark)


if __name__ == "__main__":
    main()
