"""Sums of mass, momentum and energy of elements and particles, read back from files of a mesh of
Examples/impact, are those of the cells.

usage: pvpython TestReadBack.py IMPACT FOLDER      VFM_SCULPTOR: path of sculptor

Exodus is read by ncdump, .vtu and .vtp by VTK, .rad and .k by the columns of their manuals. Exodus
and .vtu have velocities of elements: the sums of each body are compared. Decks have velocities of
nodes; an element gives each corner an equal part of its mass. Nodes on the contact of ball and
plate have one velocity, so the sums over both bodies are compared. What a deck lacks is taken from
Exodus, in the order of the ids: .k has no densities and energies, .rad no energies of particles.
The test also checks the warning of displaced material.
"""
import math
import os
import shutil
import sys

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import (
    vtkXMLPImageDataReader, vtkXMLPolyDataReader, vtkXMLUnstructuredGridReader)

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(os.path.dirname(HERE), "Python"))
from exodus_dump import Dump
from mpi_run import mpi_run
from sculptor_program import sculptor
from vfmtest import hex_volumes

CELLS, STEPS, RESOLVED = "40", (180, 240), 120  # the last one has no thin parts
BODIES = ("ball", "plate")
LEAST_FRACTION = 1e-9  # the mesher reads smaller fractions, also of the void, as 0
STATE = ["--fractions", "ball,plate", "--density", "density - 1,density - 2",
         "--velocity", "velocity - 1", "--energy", "energy - 1",
         "--state", "velocity - 1,velocity - 2,energy - 1,energy - 2", "--unmeshed", "particles",
         "--set", "LostKineticEnergy=InternalEnergy"]
EXACT = 1e-13  # also .rad: fields of 20 characters
K, K_SPEED = 1e-11, 1e-8  # sums of numbers in fields of 16 and of 10 characters


class Parts:
    """Points with mass of each body: elements and particles, or cells.

    material, mass, velocity and energy (internal, per mass) have one value for each.
    """

    def __init__(self, material, mass, velocity, energy):
        self.material, self.mass, self.velocity, self.energy = material, mass, velocity, energy

    def sums(self):
        """Returns, for each body, mass, momentum along x, y, z, and energy."""
        energy = self.mass * (self.energy + (self.velocity**2).sum(1) / 2)
        columns = np.column_stack([self.mass, self.mass[:, None] * self.velocity, energy])
        return np.array([[math.fsum(column) for column in columns[self.material == body].T]
                         for body in (1, 2)])


class Mesh:
    """Elements, nodes and particles of a file, in the order of their ids."""

    def __init__(self, **arrays):
        self.points, self.speeds = arrays["points"], arrays["speeds"]
        self.hexes, self.material = arrays["hexes"], arrays["material"]
        self.density, self.energy = arrays.get("density"), arrays.get("energy")
        self.velocity = arrays.get("velocity")  # of elements; None in decks
        self.particles = arrays["particles"]

    def masses(self):
        return hex_volumes(self.points, self.hexes) * self.density

    def sums(self):
        """Returns the sums of each body, with the velocities of elements."""
        elements = Parts(self.material, self.masses(), self.velocity, self.energy)
        return elements.sums() + self.particles.sums()

    def sums_at_nodes(self):
        """Returns mass, momentum and energy of both bodies, with the velocities of nodes."""
        masses, nodes = self.masses(), np.zeros(len(self.points))
        np.add.at(nodes, self.hexes, masses[:, None] / 8)
        moving = Parts(np.ones(len(nodes)), nodes, self.speeds, np.zeros(len(nodes)))
        internal = math.fsum(masses * self.energy)
        return moving.sums()[0] + self.particles.sums().sum(0) + [0, 0, 0, 0, internal]


def read_vtk(reader, path):
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def array_of(data, name):
    return vtk_to_numpy(data.GetArray(name))


def read_cells(dump):
    """Returns the contents of the cells of a dump."""
    image = read_vtk(vtkXMLPImageDataReader(), dump)
    data, volume, bodies = image.GetCellData(), math.prod(image.GetSpacing()), []
    fractions = [array_of(data, name) for name in BODIES]
    fractions = [np.where(own > LEAST_FRACTION, own, 0) for own in fractions]
    filled = sum(fractions)
    filled[1 - filled > LEAST_FRACTION] = 1
    for body, own in enumerate(fractions, 1):
        get = lambda stem, n=body: array_of(data, "%s - %d" % (stem, n))
        fraction = own / filled
        bodies.append((np.full(len(fraction), body), fraction * get("density") * volume,
                       get("velocity"), get("energy")))
    return Parts(*(np.concatenate(columns) for columns in zip(*bodies)))


def read_vtu(path):
    mesh = read_vtk(vtkXMLUnstructuredGridReader(), path)
    beside = read_vtk(vtkXMLPolyDataReader(), path[:-4] + "_particles.vtp").GetPointData()
    get = mesh.GetCellData()
    return Mesh(
        points=vtk_to_numpy(mesh.GetPoints().GetData()), speeds=None,
        hexes=vtk_to_numpy(mesh.GetCells().GetConnectivityArray()).reshape(-1, 8),
        material=array_of(get, "MaterialId"), density=array_of(get, "density"),
        energy=array_of(get, "energy"), velocity=array_of(get, "velocity"),
        particles=Parts(array_of(beside, "Material"), array_of(beside, "Mass"),
                        array_of(beside, "velocity"), array_of(beside, "energy")))


def read_exodus(path):
    dump = Dump(path)
    elements = dump.elements()
    is_solid = np.array([len(corners) == 8 for _, corners in elements])
    names = dump.names("eb")
    material = np.array([1 + [body for body, name in enumerate(BODIES)
                              if names[block].startswith(name)][0] for block, _ in elements])
    values = {}
    for b in range(dump.size("num_el_blk")):
        count = dump.size("num_el_in_blk%d" % (b + 1))
        for v, name in enumerate(dump.get("name_elem_var"), 1):
            own = dump.get("vals_elem_var%deb%d" % (v, b + 1)) if count else np.zeros(0)
            values.setdefault(name, []).append(own if len(own) else np.full(count, np.nan))
    values = {name: np.concatenate(columns) for name, columns in values.items()}
    vector = lambda of, name: np.column_stack([of[name + "_" + axis] for axis in "XYZ"])
    nodal = dump.variables("nod", "vals_nod_var")
    speeds = vector(nodal, "velocity") if "velocity_X" in nodal else None
    order = np.argsort(dump.get("elem_num_map")[is_solid])
    free = np.flatnonzero(~is_solid)
    free = free[np.argsort(values["Id"][free])]
    return Mesh(
        points=dump.points(), speeds=speeds,
        hexes=np.array([corners for _, corners in elements if len(corners) == 8])[order],
        material=material[is_solid][order],
        **{name: values[name][is_solid][order] for name in ("density", "energy")},
        velocity=vector(values, "velocity")[is_solid][order],
        particles=Parts(material[free], values["Mass"][free], vector(values, "velocity")[free],
                        values["energy"][free]))


def blocks_of(path):
    """Returns the lines after each keyword of a deck, without comments, as (keyword, lines)."""
    blocks = []
    with open(path) as file:
        for line in file.read().split("\n"):
            if line[:1] in ("*", "/"):
                blocks.append((line, []))
            elif line and line[0] not in "$#" and blocks:
                blocks[-1][1].append(line)
    return blocks


def table_of(lines, *widths):
    """Returns the numbers in columns of these widths."""
    ends = np.cumsum(widths)
    return np.array([[float(line[end - width:end]) for width, end in zip(widths, ends)]
                     for line in lines]).reshape(-1, len(widths))


def join(blocks, keyword, *widths):
    """Returns (number at the end of the keyword, row) of all blocks of a keyword as one table."""
    tables = [np.column_stack([np.full(len(lines), float(name.split("/")[-1])),
                               table_of(lines, *widths)])
              for name, lines in blocks if name.startswith(keyword)]
    return np.concatenate(tables)


def in_order(table):
    return table[np.argsort(table[:, 0])]


def deck_mesh(nodes, elements, speeds, cloud, **state):
    """Returns the mesh of a deck. Rows start with a number; particles are nodes without elements.

    elements: number, body, corners; cloud: node, body, mass; energies: of particles
    """
    nodes, elements, speeds, cloud = (
        in_order(table) for table in (nodes, elements, speeds, cloud))
    assert (nodes[:, 0] == np.arange(1, len(nodes) + 1)).all()
    assert (speeds[:, 0] == nodes[:, 0]).all() and len(elements) + len(cloud) > 0
    free = cloud[:, 0].astype(int) - 1
    energies = state.pop("energies")
    return Mesh(points=nodes[:, 1:], speeds=speeds[:, 1:], hexes=elements[:, 2:].astype(int) - 1,
                material=elements[:, 1], **state,
                particles=Parts(cloud[:, 1], cloud[:, 2], speeds[free, 1:], energies))


def read_rad(path, exodus):
    """Reads a deck of OpenRadioss. Internal energies of particles are those of Exodus."""
    blocks = blocks_of(path)
    first = lambda name: [lines for keyword, lines in blocks if keyword.startswith(name)][0]
    elements = join(blocks, "/BRICK/", *[10] * 9)
    cloud = join(blocks, "/SPHCEL/", 10, 10, 20)
    assert (cloud[:, 2] == 1).all()  # the number is a mass
    parts = len(BODIES) + 2  # after the bodies and the void
    state = first("/INIBRI")
    heads = table_of(state[::5], 10)[:, 0]
    energy, density = table_of(state[1::5], 20, 20)[np.argsort(heads)].T
    return deck_mesh(
        table_of(first("/NODE"), 10, 20, 20, 20), elements[:, [1, 0, *range(2, 10)]],
        table_of(first("/INIVEL")[1::2], 10, 10, 20, 20, 20)[:, [0, 2, 3, 4]],
        np.column_stack([cloud[:, 1], cloud[:, 0] - parts + 1, cloud[:, 3]]), density=density,
        energy=energy / density, energies=exodus.particles.energy)


def read_k(path, exodus):
    """Reads a deck of LS-DYNA. Densities and internal energies are those of Exodus."""
    blocks = dict(blocks_of(path))
    cloud = table_of(blocks["*ELEMENT_SPH"], 8, 8, 16)
    cloud[:, 1] -= len(BODIES) + 1
    return deck_mesh(
        table_of(blocks["*NODE"], 8, 16, 16, 16), table_of(blocks["*ELEMENT_SOLID"], *[8] * 10),
        table_of(blocks["*INITIAL_VELOCITY_NODE"], 10, 10, 10, 10), cloud,
        density=exodus.density, energy=exodus.energy, energies=exodus.particles.energy)


def compare(what, found, wanted, scale, limits):
    """Prints and checks the differences of mass, momentum and energy relative to their scales.

    There is one row for each body, or one for both.
    """
    off = np.abs(found - wanted) / scale
    off = np.column_stack([off[:, 0], off[:, 1:4].max(1), off[:, 4]])
    print("%-14s mass %s, momentum %s, energy %s" % (what, *(
        " ".join("%.1e" % value for value in column) for column in off.T)), flush=True)
    assert (off <= limits).all(), (what, off)


def write(dump, folder, suffix, *options):
    path = os.path.join(folder, "mesh." + suffix)
    run = sculptor(dump, path, *STATE, *options, "--quiet")
    assert run.returncode == 0, run
    return path


def check_sums(dump, folder):
    cells = read_cells(dump)
    wanted = cells.sums()
    mass, speed = wanted[:, :1], np.abs(cells.velocity).max()
    scale = np.hstack([mass, mass * speed, mass * speed, mass * speed, wanted[:, 4:]])
    for name, mesh in (("Exodus", read_exodus(write(dump, folder, "e"))),
                       (".vtu and .vtp", read_vtu(write(dump, folder, "vtu")))):
        compare(name, mesh.sums(), wanted, scale, EXACT)
    nodal = ["NodalVelocity=on"]
    exodus = read_exodus(write(dump, folder, "e", *nodal))
    count, particles = len(exodus.material), exodus.particles.mass
    print("%d elements, %d particles with %.2g of the mass" % (
        count, len(particles), particles.sum() / mass.sum()))
    assert count > 1000 and len(particles) > 10
    both = [table.sum(0)[None] for table in (wanted, scale)]
    for name, mesh, limits in (
            ("Exodus, nodes", exodus, EXACT),
            (".rad", read_rad(write(dump, folder, "rad", *nodal), exodus), EXACT),
            (".k", read_k(write(dump, folder, "k", *nodal), exodus), [K, K_SPEED, K_SPEED])):
        assert len(mesh.particles.mass) == len(particles)
        compare(name, mesh.sums_at_nodes()[None], *both, limits)


def check_warning(dump, folder, has_warning):
    """The message of displaced material is printed once on any number of ranks."""
    texts = []
    for ranks in (1, 3):
        run = sculptor(dump, os.path.join(folder, "mesh.vtu"), *STATE[:2], "--quiet", ranks=ranks)
        assert run.returncode == 0, run
        texts.append(run.stderr)
    assert texts[0] == texts[1] and len(texts[0].splitlines()) == has_warning, texts
    assert not has_warning or ("1 material has more than 5 % of its volume in another place than "
                               "in the input: 'ball' (id 1) " in texts[0]), texts
    print(texts[0], end="")


def main(impact, folder):
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    run = mpi_run(1, [impact, "--cells", CELLS, "--steps", str(STEPS[-1]), "--every", "60",
                      "--restart", folder])
    assert run.returncode == 0, run
    dump_of = lambda step: os.path.join(folder, "restart_%04d.pvti" % step)
    check_warning(dump_of(RESOLVED), folder, False)
    for step in STEPS:
        print("step %d" % step)
        check_warning(dump_of(step), folder, True)
        check_sums(dump_of(step), folder)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
