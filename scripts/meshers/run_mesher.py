"""Runs one mesher in a process of its own.

usage: run_mesher.py MESHER SETTINGS INPUT.npz OUTPUT.npz SECONDS

MESHER is a key of MESHERS, SETTINGS are its settings as JSON. INPUT has `labels`, uint8, 0 is not
meshed, in voxels of width 1. For meshers of surfaces it also has the triangles of a closed
`surface` (triangles, 3, 3) around label 1, and the part `wall` of it that is inside of the box.
OUTPUT has points, and cells with their materials or the faces of polyhedra, the seconds of CPU, and
the peak of memory of the process. Files are written and read, and modules loaded, outside of the
measured time, except by the programs of OpenFOAM. After SECONDS of CPU the process is ended.
"""
import json
import os
import resource
import sys
import tempfile

import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))


def read_peak():
    """Returns the peak of memory since the program began, kB; ru_maxrss counts its parent too."""
    with open("/proc/self/status", encoding="ascii") as file:
        return next(int(line.split()[1]) for line in file if line.startswith("VmHWM"))


class Clock:
    """Adds up CPU seconds, with those of child processes."""

    def __enter__(self):
        self.begin = self.read()
        return self

    def __exit__(self, *_):
        self.cpu = self.read() - self.begin
        self.peak = max(read_peak(), resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss) / 1024

    @staticmethod
    def read():
        return sum(os.times()[:4])


def run_ours(make, given, clock, settings):
    with clock:
        mesh = make(labels=given["labels"], threads=1, **settings)
    return {"points": mesh.points, "cells": mesh.cells, "material": mesh.material}


def make_hexes(given, clock, settings):
    import volume_fraction_mesh as vfm
    return run_ours(vfm.hexes, given, clock, settings)


def make_tets(given, clock, settings):
    import volume_fraction_mesh as vfm
    return run_ours(vfm.tets, given, clock, settings)


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


def make_automesh(given, clock, settings):
    """Makes hexahedra of the voxels. settings: of the smoothing, none without it."""
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
    return {"points": points, "cells": cells, "material": material}


def make_cgal(given, clock, settings):
    import pygalmesh
    # Labels are at points, half a voxel from the sides; label 0 around puts the sides back.
    with clock:
        mesh = pygalmesh.generate_from_array(np.pad(given["labels"], 1), (1.0, 1.0, 1.0),
                                             verbose=False, seed=1, **settings)
    (block,) = [i for i, cells in enumerate(mesh.cells) if cells.type == "tetra"]
    return {"points": mesh.points - 0.5, "cells": mesh.cells[block].data,
            "material": mesh.cell_data["medit:ref"][block]}


def make_cleaver(given, clock, settings):
    """Meshes all of the box. settings: FeatureScaling, Lipschitz, .. of the filter."""
    import itk
    image = itk.image_from_array(np.ascontiguousarray(given["labels"].T))
    cleaver = itk.CleaverImageToMeshFilter[type(image), itk.Mesh[itk.D, 3]].New()
    cleaver.SetInput(image)
    for name, value in settings.items():
        getattr(cleaver, "Set" + name)(value)
    with clock:
        cleaver.Update()
    made = itk.dict_from_mesh(cleaver.GetOutput(0))
    cells = np.asarray(made["cells"]).reshape(-1, 6)[:, 2:]  # after the type and the corners
    # The label of a cell is its place among the labels of the image.
    material = np.unique(given["labels"])[np.asarray(made["cellData"], int)]
    return {"points": np.asarray(made["points"], float).reshape(-1, 3),
            "cells": cells[material > 0].astype(int), "material": material[material > 0]}


def make_surface_nets(labels, smoothing):
    """Returns points and triangles of the surfaces between labels, also at the sides of the box."""
    import vtk
    from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy
    labels = np.pad(labels, 1)
    image, nets = vtk.vtkImageData(), vtk.vtkSurfaceNets3D()
    image.SetDimensions(*labels.shape)
    image.SetOrigin(-0.5, -0.5, -0.5)
    image.GetPointData().SetScalars(numpy_to_vtk(labels.ravel(order="F"), deep=1))
    nets.SetInputData(image)
    for i, label in enumerate(np.unique(labels)[1:]):
        nets.SetLabel(i, int(label))
    nets.SetSmoothing(smoothing)
    nets.SetOutputMeshTypeToTriangles()
    nets.Update()
    surface = nets.GetOutput()
    return (vtk_to_numpy(surface.GetPoints().GetData()).astype(float),
            vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3))


def find_region_labels(points, cells, region, labels):
    """Returns for each cell the label that fills most of its region."""
    at = points[cells]
    edges = at[:, 1:] - at[:, :1]
    volumes = np.abs(np.linalg.det(edges))
    voxels = np.clip(np.floor(at.mean(1)).astype(int), 0, np.array(labels.shape) - 1)
    table = np.zeros((region.max() + 1, labels.max() + 1))
    np.add.at(table, (region, labels[tuple(voxels.T)]), volumes)
    return table.argmax(1)[region]


def make_tetgen(given, clock, settings):
    """Fills the surfaces of SurfaceNets3D. settings: whether it smooths, and those of TetGen."""
    import tetgen
    import vtk.util.numpy_support  # not in the time that is measured
    smoothing = settings.pop("smoothing")
    with clock:
        points, triangles = make_surface_nets(given["labels"], smoothing)
        filled = tetgen.TetGen(points, triangles.astype(np.int32)).tetrahedralize(
            plc=True, regionattrib=True, quiet=True, **settings)
    points, cells, region = filled[:3]
    material = find_region_labels(points, cells, region.ravel().astype(int), given["labels"])
    return {"points": points, "cells": cells[material > 0], "material": material[material > 0]}


def index_triangles(triangles):
    """Returns points, and the triangles as numbers of points."""
    points, numbers = np.unique(triangles.reshape(-1, 3), axis=0, return_inverse=True)
    return points, numbers.reshape(-1, 3)


def make_ftetwild(given, clock, _):
    import pytetwild
    points, triangles = index_triangles(given["surface"])
    with clock:
        points, cells = pytetwild.tetrahedralize(points, triangles.astype(np.int32), num_threads=1,
                                                 vtk_ordering=True)
    return {"points": points, "cells": cells, "material": np.ones(len(cells), int)}


def make_gmsh(given, clock, _):
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
    return {"points": found.reshape(-1, 3), "cells": cells, "material": np.ones(len(cells), int)}


def make_snappy(given, clock, _):
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
            "neighbour": mesh.neighbour}


MESHERS = {"hexes": make_hexes, "tets": make_tets, "automesh": make_automesh, "cgal": make_cgal,
           "cleaver": make_cleaver, "tetgen": make_tetgen, "snappy": make_snappy,
           "gmsh": make_gmsh, "ftetwild": make_ftetwild}


def main():
    mesher, settings, path, out, seconds = sys.argv[1:]
    resource.setrlimit(resource.RLIMIT_CPU, (int(seconds), int(seconds) + 5))
    with np.load(path) as file:
        given = dict(file)
    clock = Clock()
    mesh = MESHERS[mesher](given, clock, json.loads(settings))
    np.savez(out, cpu=clock.cpu, peak=clock.peak, **mesh)


if __name__ == "__main__":
    main()
