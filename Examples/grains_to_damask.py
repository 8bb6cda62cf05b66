"""Writes grains with their orientations for DAMASK, MOOSE and CalculiX, and computes the stiffness
of the grains by CalculiX.

usage: python Examples/grains_to_damask.py [FILE.dream3d] [--folder DIR] [--cells N] [--grains N]

Without a file it makes one, with Voronoi grains of copper of random orientations. Into the folder
(default out/grains) it writes

    grains.msh, material.yaml          DAMASK's solver on meshes; sides of the box have the tags 1
                                       (x_min) to 6 (z_max)
    grains.e, grains.txt, grains.csv   MOOSE: blocks with angles as variables; Euler angles for
                                       EulerAngleFileReader, and for PropertyReadFile
    grains.inp, orientations.inp       Abaqus and CalculiX

Then CalculiX stretches the box along x by displacements of all its boundary nodes, and prints the
mean stress over the strain: for a single crystal (--one: all grains have the orientation of the
first one) it is exactly C11 of the turned crystal; for grains it is between the bounds of Reuss and
Voigt. damask, if it is installed, adds the properties of the phases to material.yaml and checks it.

Requires volume_fraction_mesh, h5py, and ccx (Debian package calculix-ccx); damask of PyPI on
request.
"""
import argparse
import os
import re

import numpy as np

import calculix
import homogenise
import volume_fraction_mesh as vfm

STRAIN = 1e-3
SIDES = ("x_min", "x_max", "y_min", "y_max", "z_min", "z_max")


def make_file(path, cells, count):
    """Writes Voronoi grains as a file of DREAM.3D 6."""
    import h5py
    random = np.random.default_rng(3)
    points = random.random((count, 3))
    axis = (np.arange(cells) + 0.5) / cells
    place = np.stack(np.meshgrid(axis, axis, axis, indexing="ij"), axis=-1)
    labels = np.argmin([((place - point) ** 2).sum(axis=-1) for point in points], axis=0) + 1
    euler = np.stack([random.uniform(0, 2 * np.pi, count), np.arccos(random.uniform(-1, 1, count)),
                      random.uniform(0, 2 * np.pi, count)], axis=1)
    with h5py.File(path, "w") as file:
        file.attrs["FileVersion"] = np.bytes_("7.0")
        group = file.create_group("DataContainers/Grains")
        for name, value in (("DIMENSIONS", [cells] * 3), ("SPACING", [1 / cells] * 3),
                            ("ORIGIN", [0.0] * 3)):
            group["_SIMPL_GEOMETRY/" + name] = np.array(value)
        group["CellData/FeatureIds"] = labels.transpose(2, 1, 0).astype(np.int32)[..., None]
        group["CellFeatureData/AvgEulerAngles"] = np.vstack([np.zeros((1, 3)), euler])
        group["CellFeatureData/Phases"] = np.minimum(np.arange(count + 1), 1).astype(np.int32)
        group["CellEnsembleData/PhaseName"] = np.array(["Unknown", "copper"], "S")


def write_inputs(mesh, grains, folder):
    """Writes the files of all solvers."""
    mesh.state.update(grains.arrays(mesh))
    for name in ("grains.msh", "grains.e", "grains.inp"):
        mesh.save(os.path.join(folder, name))
    for name in ("material.yaml", "grains.txt", "grains.csv", "orientations.inp"):
        grains.save(os.path.join(folder, name), mesh)


def complete_for_damask(folder, phases):
    """Adds the properties of the phases and the load. Returns whether damask is installed."""
    try:
        import damask
    except ImportError:
        return False
    path = os.path.join(folder, "material.yaml")
    config = damask.ConfigMaterial.load(path)
    c11, c12, c44 = (1e9 * value for value in homogenise.COPPER)
    for name in phases:
        config["phase"][name] = {"lattice": "cF", "mechanical": {
            "output": ["F", "P"],
            "elastic": {"type": "Hooke", "C_11": c11, "C_12": c12, "C_44": c44},
            "plastic": {"type": "none"}}}
    assert config.is_complete and config.is_valid
    config.save(path)
    return True


def read_materials(path):
    """Returns the names of the materials in orientations.inp."""
    with open(path, encoding="utf-8") as file:
        return sorted(set(re.findall(r"MATERIAL=(\w+)", file.read())))


def write_deck(path, mesh, materials):
    """Writes a deck that prescribes u = (STRAIN x, 0, 0) on the boundary."""
    c11, c12, c44 = (calculix.number(value) for value in homogenise.COPPER)
    lines = ["*INCLUDE, INPUT=grains.inp"]
    for name in materials:
        lines += ["*MATERIAL, NAME=" + name, "*ELASTIC, TYPE=ORTHO",
                  ", ".join([c11, c12, c11, c12, c12, c11, c44, c44]), c44]
    lines += ["*INCLUDE, INPUT=orientations.inp", "*STEP", "*STATIC", "*BOUNDARY"]
    boundary = np.unique(np.concatenate([mesh.facets(side).points.ravel() for side in SIDES]))
    for node in boundary:
        lines += ["%d, 1, 1, %s" % (node + 1, calculix.number(STRAIN * mesh.points[node, 0])),
                  "%d, 2, 3, 0" % (node + 1)]
    lines += ["*NODE PRINT, NSET=X_MAX, TOTALS=ONLY", "RF", "*EL PRINT, ELSET=EALL, TOTALS=ONLY",
              "ELSE", "*END STEP"]
    with open(path, "w", encoding="ascii") as file:
        file.write("\n".join(lines + [""]))


def solve(mesh, folder):
    """Returns the mean stress along x over the strain, from the energy of the elements."""
    path = os.path.join(folder, "stretch.inp")
    write_deck(path, mesh, read_materials(os.path.join(folder, "orientations.inp")))
    calculix.run(path, seconds=3600)
    with open(os.path.join(folder, "stretch.dat"), encoding="ascii") as file:
        energy = float(re.search(r"total internal energy.*?(\S+)\s*$", file.read(), re.DOTALL)[1])
    return 2 * energy / mesh.volumes().sum() / STRAIN ** 2


def bounds(mesh, grains):
    """Returns the bounds of Reuss and Voigt of C11 without lateral strain: means of the
    compliances and of the stiffnesses of the elements."""
    crystal = homogenise.cubic(*homogenise.COPPER)
    turned = np.array([homogenise.rotated(crystal, axes.T) for axes in grains.axes()])
    shares = np.bincount(mesh.material, mesh.volumes(), grains.ids.max() + 1)[grains.ids]
    shares /= shares.sum()
    compliance = np.tensordot(shares, np.linalg.inv(turned), 1)
    return np.linalg.inv(compliance)[0, 0], np.tensordot(shares, turned, 1)[0, 0]


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("file", nargs="?", help="file of DREAM.3D")
    parser.add_argument("--folder", default="out/grains", help="folder for the files")
    parser.add_argument("--cells", type=int, default=16, help="cells along each axis, default 16")
    parser.add_argument("--grains", type=int, default=12, help="number of grains, default 12")
    parser.add_argument("--one", action="store_true", help="one orientation for all grains")
    arguments = parser.parse_args()
    os.makedirs(arguments.folder, exist_ok=True)
    path = arguments.file
    if path is None:
        path = os.path.join(arguments.folder, "grains.dream3d")
        make_file(path, arguments.cells, arguments.grains)
    grains = vfm.read_grains(path)
    if arguments.one:
        grains = vfm.Grains(np.tile(grains.euler_angles[:1], (len(grains), 1)), ids=grains.ids,
                            phases=grains.phases, phase_names=grains.phase_names)
    mesh = vfm.tets(labels=vfm.read(path), arrays=["FeatureIds"], label_smoothing=2)
    print("%d tetrahedra, %s" % (len(mesh), grains))
    write_inputs(mesh, grains, arguments.folder)
    known = complete_for_damask(arguments.folder, grains.phase_names.values())
    print("material.yaml: " + ("accepted by damask" if known else "damask is not installed"))
    found, (lower, upper) = solve(mesh, arguments.folder), bounds(mesh, grains)
    print("stress / strain along x: %.5f GPa, bounds %.5f and %.5f GPa" % (found, lower, upper))


if __name__ == "__main__":
    main()
