"""Compares meshers that are installed, on images of labels: prints a table per image.

usage: compare.py [--cells 48] [--grains 12] [--images grains,pores,sphere,atlas] [--meshers WORDS]
                  [--seed 1] [--seconds 300] [--keep FOLDER]

grains: labels of the nearest of random seeds, which fill the box; the true surfaces are the planes
between two seeds. pores: one label with the pores of Examples/porous_flow.py; the true surface is
the level of the noise that the image samples. sphere: one label in a box of 4/3 of the cells.
atlas: 192 labels of a brain (Debian's mricron-data); the true surfaces are not known.

Each mesher runs in a process of its own with one thread; CGAL by PYTHON_DEBIAN, default
/usr/bin/python3, Cleaver by PYTHON_CLEAVER. Meshers of surfaces get the surface of our hexahedra,
only where there is one label. --meshers: words separated by semicolons; rows whose names contain
one of them run. --keep: keeps images, meshes and messages.

Columns: number of elements; CPU seconds; peak MB of the process; smallest scaled Jacobian at a
corner of hexahedra or tetrahedra; smallest and largest dihedral angle of tetrahedra in degrees;
elements whose volume is not positive, or a Jacobian at a corner of theirs; largest error of the
volume of a label against its voxels; labels whose volume is wrong by more than 1 %; labels without
an element; rms distance to the true surface, in voxels, of points between two labels, and at lines
where more labels meet; faces inside of the box that belong to one element, where all of the box is
meshed: 0 if interfaces conform.
"""
import argparse
import json
import os
import signal
import subprocess
import sys
import tempfile

import numpy as np

import measure_mesh
from images import IMAGES

HERE = os.path.dirname(os.path.abspath(__file__))
DEBIAN = os.environ.get("PYTHON_DEBIAN", "/usr/bin/python3")
CLEAVER = os.environ.get("PYTHON_CLEAVER", sys.executable)
HEADER = ("mesher", "elements", "kind", "CPU s", "peak MB", "SJ", "angles", "inverted",
          "volume error", "off 1 %", "lost", "distance", "at lines", "open faces")
OFF = 0.01  # relative error of a volume
NOT_HAD = {"iso2mesh": "PyPI has its functions, but not the programs that they run",
           "automesh 0.4 and 0.5": "wheels of the command only, for glibc 2.38 or later; Debian 12 "
                                   "has 2.36",
           "CGAL 6.1": "Debian 12 has 5.5; pygalmesh lacks Detect_features_in_image, which finds "
                       "lines where labels meet",
           "Sculpt": "part of Cubit, under a licence"}


class Mesher:
    """name: of the row. function: of run_mesher.py. of_surface: needs the surface of label 1.
    image: the only one that it meshes."""

    def __init__(self, name, function, python=sys.executable, of_surface=False, image=None,
                 **settings):
        self.name, self.function, self.python = name, function, python
        self.of_surface, self.image, self.settings = of_surface, image, settings

    def describe(self):
        return ", ".join("%s=%s" % item for item in self.settings.items()) or "defaults"


def list_ours():
    widths = [{}] + [{"cell_width": width} for width in (1.5, 2, 3)]
    rows = []
    for kind, function in (("hexahedra", "hexes"), ("tetrahedra", "tets")):
        rows += [Mesher("ours, %s, width %g" % (kind, some.get("cell_width", 1)), function, **some)
                 for some in widths]
        rows.append(Mesher("ours, %s, width 1, smoothed" % kind, function, label_smoothing=3))
    return rows


def list_cgal():
    return [Mesher("CGAL, cells of %g" % size, "cgal", DEBIAN, min_facet_angle=30.0,
                   max_radius_surface_delaunay_ball=size, max_facet_distance=0.25,
                   max_circumradius_edge_ratio=3.0, max_cell_circumradius=size)
            for size in (1.0, 1.5, 2.0)]


TAUBIN = {"method": "Taubin", "iterations": 20}  # as its command by default
TETGEN = {"minratio": 2.0, "mindihedral": 5.0}  # -q of TetGen
SURFACE_OF = "ours, hexahedra, width 1"  # the mesher whose surface others get
MESHERS = [
    *list_ours(),
    Mesher("automesh, voxels", "automesh"),
    Mesher("automesh, Taubin", "automesh", **TAUBIN),
    Mesher("automesh, hierarchical", "automesh", hierarchical=True, **TAUBIN),
    Mesher("SurfaceNets3D, TetGen", "tetgen", smoothing=True, **TETGEN),
    Mesher("SurfaceNets3D unsmoothed, TetGen", "tetgen", smoothing=False, **TETGEN),
    *list_cgal(),
    Mesher("Cleaver", "cleaver", CLEAVER),
    Mesher("Cleaver, sizes x 0.6", "cleaver", CLEAVER, image="grains", FeatureScaling=0.6),
    Mesher("Cleaver, sizes x 1.5", "cleaver", CLEAVER, image="pores", FeatureScaling=1.5),
    Mesher("Cleaver, sizes x 0.15", "cleaver", CLEAVER, image="sphere", FeatureScaling=0.15),
    Mesher("snappyHexMesh", "snappy", of_surface=True),
    Mesher("Gmsh", "gmsh", of_surface=True),
    Mesher("fTetWild", "ftetwild", of_surface=True)]


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--cells", type=int, default=48, help="voxels along an edge of the box")
    parser.add_argument("--grains", type=int, default=12, help="number of grains, at most 255")
    parser.add_argument("--images", default=",".join(IMAGES))
    parser.add_argument("--meshers", default="", help="parts of names; default: all")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--seconds", type=int, default=300, help="limit of CPU time of a mesher")
    parser.add_argument("--keep", metavar="FOLDER")
    return parser.parse_args()


def run_mesher(mesher, given, folder, seconds):
    """Returns the arrays that run_mesher.py writes, or why there are none."""
    out = os.path.join(folder, mesher.name.replace(" ", "_").replace(",", "") + ".npz")
    environment = dict(os.environ, OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1",
                       ITK_GLOBAL_DEFAULT_NUMBER_OF_THREADS="1",
                       VTK_SMP_BACKEND_IN_USE="Sequential", PYTHONDONTWRITEBYTECODE="1")
    command = [mesher.python, os.path.join(HERE, "run_mesher.py"), mesher.function,
               json.dumps(mesher.settings), given, out, str(seconds)]
    if not os.path.exists(mesher.python):
        return "there is no " + mesher.python
    with open(out + ".log", "w+", encoding="utf-8", errors="replace") as log:
        status = subprocess.run(command, env=environment, cwd=folder, stdout=log, stderr=log,
                                check=False).returncode
        log.seek(0)
        message = log.read().strip().rsplit("\n", 1)[-1]
    if status in (-signal.SIGXCPU, -signal.SIGKILL):
        return "ended after %d s of CPU" % seconds
    if status:
        return message if status > 0 and message else "status %d %s" % (status, message)
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
    errors, is_found = measure_mesh.find_volume_errors(mesh, volumes, image.labels)
    kind = name_kind(mesh, made)
    angles = "%.1f to %.1f" % measure_mesh.find_angles(made["points"], made["cells"]) \
        if kind == "tetrahedra" else ""
    distances = ["" if np.isnan(distance) else "%.3f" % distance for distance in (
        measure_mesh.find_distances(mesh, image) if image.distance else 2 * (np.nan,))]
    return (name, "%d" % len(volumes), kind, "%.2f" % made["cpu"], "%.0f" % made["peak"],
            "%.3f" % corners[1].min(), angles,
            "%d" % measure_mesh.count_inverted(volumes, *corners), "%.2g %%" % (100 * errors.max()),
            "%d" % (errors > OFF).sum(), "%d" % (~is_found).sum(),
            *distances, "%d" % measure_mesh.count_open_faces(mesh, box) if image.fills_box else "")


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


def compare(image, chosen, folder, seconds):
    """Prints a table, then why meshers have no row."""
    given, absent = {"labels": image.labels}, []
    path, has_one_label = os.path.join(folder, "image.npz"), image.labels.max() == 1
    np.savez(path, **given)
    print_row(HEADER)
    print("|" + "---|" * len(HEADER))
    for mesher in chosen:
        if mesher.of_surface and "surface" not in given:
            absent.append((mesher.name, "meshes one closed surface here" if not has_one_label else
                           "requires the surface of " + SURFACE_OF))
            continue
        made = run_mesher(mesher, path, folder, seconds)
        if isinstance(made, str):
            absent.append((mesher.name, made))
            continue
        print_row(make_row(mesher.name, made, image))
        if mesher.name == SURFACE_OF and has_one_label:
            add_surface(given, read_mesh(made), image.labels.shape)
            np.savez(path, **given)
    print()
    for remark in absent:
        print("- %s: no mesh: %s" % remark)
    print(flush=True)


def compare_all(arguments, chosen, parent):
    for name in arguments.images.split(","):
        folder = os.path.abspath(os.path.join(parent, name))
        os.makedirs(folder, exist_ok=True)
        try:
            image = IMAGES[name](arguments)
        except (ImportError, OSError) as error:
            print("%s: not compared: %s\n" % (name, error))
            continue
        print("%s: %d x %d x %d voxels, %d labels\n" % (
            name, *image.labels.shape, image.labels.max()))
        compare(image, [mesher for mesher in chosen if mesher.image in (None, name)], folder,
                arguments.seconds)


def main():
    arguments = parse_arguments()
    words = arguments.meshers.split(";")
    chosen = [mesher for mesher in MESHERS if any(word in mesher.name for word in words)]
    with tempfile.TemporaryDirectory() as temporary:
        compare_all(arguments, chosen, arguments.keep or temporary)
    print("Settings:")
    for mesher in chosen:
        print("- %s: %s" % (mesher.name, mesher.describe()))
    print("\nNot compared:")
    for remark in NOT_HAD.items():
        print("- %s: %s" % remark)


if __name__ == "__main__":
    main()
