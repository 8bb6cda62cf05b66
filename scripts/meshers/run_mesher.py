"""Runs one mesher in a process of its own.

usage: run_mesher.py MESHER INPUT.npz OUTPUT.npz

INPUT has `labels`, uint8, 0 is not meshed, in voxels of width 1. For meshers of surfaces it also
has the triangles of a closed `surface` (triangles, 3, 3) around label 1, and the part `wall` of it
that is inside of the box. `smoothing`: passes of smoothing of labels by this project.
OUTPUT has points, and cells with their materials or the faces of polyhedra, the seconds of CPU and
of the clock, the peak of memory of the process, and `settings` of the mesher. Files are written
and read outside of the measured time, except by the programs of OpenFOAM.
"""
import os
import resource
import sys
import tempfile
import time

import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))


def read_peak():
    """Returns the peak of memory since the program began, kB; ru_maxrss counts its parent too."""
    with open("/proc/self/status", encoding="ascii") as file:
        return next(int(line.split()[1]) for line in file if line.startswith("VmHWM"))


class Clock:
    """Adds up CPU seconds, with those of child processes, and seconds of the clock."""

    def __enter__(self):
        self.begin = self.read()
        return self

    def __exit__(self, *_):
        self.cpu, self.wall = (b - a for a, b in zip(self.begin, self.read()))
        self.peak = max(read_peak(), resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss) / 1024

    @staticmethod
    def read():
        times = os.times()
        return sum(times[:4]), time.perf_counter()


def describe(settings):
    return ", ".join("%s=%s" % item for item in settings.items())


def run_ours(make, given, clock):
    with clock:
        mesh = make(labels=given["labels"], label_smoothing=int(given["smoothing"]), threads=1)
    passes = ", label_smoothing=%d" % given["smoothing"] if given["smoothing"] else ""
    return {"points": mesh.points, "cells": mesh.cells, "material": mesh.material,
            "settings": "defaults" + passes}


def make_hexes(given, clock):
    import volume_fraction_mesh as vfm
    return run_ours(vfm.hexes, given, clock)


def make_tets(given, clock):
    import volume_fraction_mesh as vfm
    return run_ours(vfm.tets, given, clock)


def read_inp(path):
    """Reads points, hexahedra and their blocks of an Abaqus file of automesh."""
    points, cells, material, kind, block = [], [], [], None, 0
    with open(path, encoding="utf-8") as file:
        for line in file:
            if line.startswith("*"):
                words = line.upper().replace(" ", "").strip().split(",")
                kind = words[0]
                if kind == "*ELEMENT":
                    block = int("".join(filter(str.isdigit, words[-1].split("=")[1])))
            elif kind == "*NODE":
                points.append(line.split(",")[1:4])
            elif kind == "*ELEMENT":
                cells.append(line.split(",")[1:9])
                material.append(block)
    return np.array(points, float), np.array(cells, int) - 1, np.array(material)


def run_automesh(given, clock, settings):
    """Makes hexahedra of the voxels. settings: of the smoothing, or None."""
    import automesh
    with tempfile.TemporaryDirectory() as folder:
        image, out = os.path.join(folder, "image.npy"), os.path.join(folder, "mesh.inp")
        np.save(image, given["labels"])
        with clock:
            mesh = automesh.Voxels.from_npy(image).as_finite_elements(remove=[0])
            if settings:
                mesh.smooth(**settings)
        mesh.write_inp(out)
        points, cells, material = read_inp(out)
    return {"points": points, "cells": cells, "material": material,
            "settings": describe(settings) + ", other defaults" if settings else "no smoothing"}


def make_automesh_voxels(given, clock):
    return run_automesh(given, clock, None)


def make_automesh(given, clock):  # as its command by default
    return run_automesh(given, clock, {"method": "Taubin", "iterations": 20})


def make_automesh_hierarchical(given, clock):  # points of surfaces move only by those of surfaces
    return run_automesh(given, clock, {"method": "Taubin", "iterations": 20, "hierarchical": True})


def make_cgal(given, clock):
    import pygalmesh
    sizes = {"min_facet_angle": 30.0, "max_radius_surface_delaunay_ball": 1.0,
             "max_facet_distance": 0.25, "max_circumradius_edge_ratio": 3.0,
             "max_cell_circumradius": 1.0}
    # Labels are at points, half a voxel from the sides; label 0 around puts the sides back.
    with clock:
        mesh = pygalmesh.generate_from_array(np.pad(given["labels"], 1), (1.0, 1.0, 1.0),
                                             verbose=False, seed=1, **sizes)
    (block,) = [i for i, cells in enumerate(mesh.cells) if cells.type == "tetra"]
    return {"points": mesh.points - 0.5, "cells": mesh.cells[block].data,
            "material": mesh.cell_data["medit:ref"][block],
            "settings": describe(sizes)}


def index_triangles(triangles):
    """Returns points, and the triangles as numbers of points."""
    points, numbers = np.unique(triangles.reshape(-1, 3), axis=0, return_inverse=True)
    return points, numbers.reshape(-1, 3)


def make_ftetwild(given, clock):
    import pytetwild
    points, triangles = index_triangles(given["surface"])
    with clock:
        points, cells = pytetwild.tetrahedralize(points, triangles.astype(np.int32), num_threads=1,
                                                 vtk_ordering=True)
    return {"points": points, "cells": cells, "material": np.ones(len(cells), int),
            "settings": "defaults: edges of 1/20 of the diagonal of the box"}


def make_gmsh(given, clock):
    import gmsh
    points, triangles = index_triangles(given["surface"])
    gmsh.initialize(interruptible=False)
    gmsh.option.setNumber("General.Terminal", 0)
    with clock:
        surface, model = gmsh.model.addDiscreteEntity(2), gmsh.model
        model.mesh.addNodes(2, surface, np.arange(1, len(points) + 1), points.ravel())
        model.mesh.addElementsByType(surface, 2, [], triangles.ravel() + 1)
        model.geo.addVolume([model.geo.addSurfaceLoop([surface])])
        model.geo.synchronize()
        model.mesh.generate(3)
    tags, found, _ = gmsh.model.mesh.getNodes()
    _, cells = gmsh.model.mesh.getElementsByType(4)
    order = np.argsort(tags)
    cells = order[np.searchsorted(tags, cells, sorter=order)].reshape(-1, 4)
    return {"points": found.reshape(-1, 3), "cells": cells, "material": np.ones(len(cells), int),
            "settings": "defaults; triangles of the surface are kept"}


def make_snappy(given, clock):
    sys.path.insert(0, os.path.join(HERE, "..", "..", "Examples"))
    sys.path.insert(0, os.path.join(HERE, "..", "..", "Testing", "Clients"))
    import foam_files
    import porous_flow
    with tempfile.TemporaryDirectory() as folder:
        wall = os.path.join(folder, "wall.stl")
        porous_flow.write_triangles(given["wall"], wall)
        porous_flow.write_case(folder, 1)
        with clock:
            porous_flow.run_snappy(folder, wall, given["labels"].astype(float), 0)
        mesh = foam_files.PolyMesh(folder)
    return {"points": mesh.points, "faces": np.concatenate(mesh.faces),
            "sizes": [len(face) for face in mesh.faces], "owner": mesh.owner,
            "neighbour": mesh.neighbour, "settings": "cells of one voxel, 30 solver iterations, "
            "implicit features off, no layers, limits of quality of its tutorials"}


MESHERS = {"ours, hexahedra": make_hexes, "ours, tetrahedra": make_tets,
           "automesh, voxels": make_automesh_voxels, "automesh, Taubin": make_automesh,
           "automesh, hierarchical": make_automesh_hierarchical,
           "CGAL (pygalmesh)": make_cgal, "snappyHexMesh": make_snappy,
           "fTetWild (pytetwild)": make_ftetwild, "Gmsh": make_gmsh}


def main():
    mesher, path, out = sys.argv[1:]
    with np.load(path) as file:
        given = dict(file)
    clock = Clock()
    mesh = MESHERS[mesher](given, clock)
    np.savez(out, cpu=clock.cpu, wall=clock.wall, peak=clock.peak, **mesh)


if __name__ == "__main__":
    main()
