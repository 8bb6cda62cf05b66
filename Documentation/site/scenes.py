"""Writes the scenes of the site: meshes that a browser turns and cuts.

usage: scenes.py FOLDER VTK_JS      in the root of the repository; the package volume_fraction_mesh,
       pyvista and nibabel are installed
A scene is a page, made from scene.html, and a script with the mesh: points, elements, their
neighbours and colours."""
import base64
import json
import os
import shutil
import sys

import nibabel
import numpy as np
import pyvista as pv
import volume_fraction_mesh as vfm

HERE = os.path.dirname(os.path.abspath(__file__))
ATLAS = "/usr/share/mricron/templates/aal.nii.gz"  # Debian's mricron-data
LOW, HIGH = 0.4, 1.0  # scaled Jacobians at the ends of the colour map
FACES = {8: ((0, 4, 7, 3), (1, 2, 6, 5), (0, 1, 5, 4), (3, 7, 6, 2), (0, 3, 2, 1), (4, 5, 6, 7)),
         4: ((0, 1, 3), (1, 2, 3), (0, 3, 2), (0, 2, 1))}  # as in VTK


def make_splash():
    mesh = vfm.hexes(pv.read("Data/splash_3500us.vti"), arrays=["water"])
    return mesh, color_by_quality(
        mesh), "Splash: %s hexahedra, coloured by scaled Jacobian from %g (blue) to %g (yellow)" % (
        format(len(mesh.cells), ","), LOW, HIGH)


def make_ball_and_plate():
    mesh = vfm.hexes(pv.read("Data/ball_and_plate.vti"), arrays=["ball", "plate"])
    return mesh, color_by_number(
        mesh.material), "Ball and plate: %s hexahedra of two materials" % format(
            len(mesh.cells), ",")


def make_atlas():
    image = nibabel.load(ATLAS)
    labels = np.asanyarray(image.dataobj).astype(np.int32)[100:124, 95:119, 65:89]
    mesh = vfm.tets(labels=labels, label_smoothing=3)
    return mesh, color_by_number(
        mesh.material), "Brain atlas (AAL), 24 x 24 x 24 voxels: %s tetrahedra of %d regions" % (
        format(len(mesh.cells), ","), len(np.unique(mesh.material)))


SCENES = {"splash": make_splash, "ball_and_plate": make_ball_and_plate, "atlas": make_atlas}


def color_by_quality(mesh):
    """RGB colours, shape (elements, 3): the scaled Jacobian on a colour map."""
    quality = np.asarray(mesh.to_pyvista().cell_quality("scaled_jacobian")["scaled_jacobian"])
    colors = pv.LookupTable("viridis", n_values=256).values[:, :3]
    return colors[np.clip((quality - LOW) / (HIGH - LOW) * 255, 0, 255).astype(int)]


def color_by_number(numbers):
    """RGB colours, shape (elements, 3): one per number, spread over the hues."""
    unique, index = np.unique(numbers, return_inverse=True)
    hues = (np.arange(len(unique)) * 0.618034 + 0.55) % 1.0
    return np.array([rgb_of_hue(hue) for hue in hues], np.uint8)[index]


def rgb_of_hue(hue):
    """A light colour, three numbers up to 255, of a hue from 0 to 1."""
    offsets = (np.array([5.0, 3.0, 1.0]) + 6.0 * hue) % 6.0
    return 255 * (0.92 - 0.55 * np.clip(np.minimum(offsets, 4.0 - offsets), 0.0, 1.0))


def find_neighbours(cells):
    """The element behind each face of each element, shape (elements, faces); -1 on the boundary."""
    faces = np.concatenate([np.sort(cells[:, face], axis=1) for face in FACES[cells.shape[1]]])
    order = np.lexsort(faces.T)
    same = np.all(faces[order[1:]] == faces[order[:-1]], axis=1)
    neighbours = np.full(len(faces), -1, np.int32)
    first, second = order[:-1][same], order[1:][same]
    neighbours[first] = second % len(cells)
    neighbours[second] = first % len(cells)
    return neighbours.reshape(-1, len(cells)).T


def encode(array, kind):
    return base64.b64encode(np.ascontiguousarray(array, kind).tobytes()).decode()


def write_scene(folder, name, mesh, colors, caption):
    cells = np.asarray(mesh.cells)
    points = np.asarray(mesh.points)
    points = (points - points.mean(axis=0)) / np.ptp(points, axis=0).max()
    scene = {"caption": caption, "corners": cells.shape[1], "faces": FACES[cells.shape[1]],
             "points": encode(points, "<f4"),
             "cells": encode(cells, "<i4"), "neighbours": encode(find_neighbours(cells), "<i4"),
             "colors": encode(colors, "u1")}
    with open(os.path.join(folder, name + ".js"), "w", encoding="utf-8") as file:
        file.write("const scene = %s;\n" % json.dumps(scene))
    with open(os.path.join(HERE, "scene.html"), encoding="utf-8") as file:
        page = file.read().replace("@NAME@", name)
    with open(os.path.join(folder, name + ".html"), "w", encoding="utf-8") as file:
        file.write(page)
    print("%s: %s" % (name, caption))


def main():
    folder, vtk_js = sys.argv[1:]
    os.makedirs(folder, exist_ok=True)
    shutil.copy(vtk_js, os.path.join(folder, "vtk.js"))
    for name, make in SCENES.items():
        write_scene(folder, name, *make())


if __name__ == "__main__":
    main()
