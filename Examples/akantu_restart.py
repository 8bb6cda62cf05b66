"""Restarts an Eulerian simulation in Akantu: a ball strikes a plate.

usage: python akantu_restart.py DUMP [--duration 0.53] [--steps N] [--hourglass 0.1]
       [--picture FILE.png]

DUMP holds the fields and the state of one step of Examples/impact:

    build/bin/impact --cells 40 --steps 50 --every 50 --restart dump
    python Examples/akantu_restart.py dump/restart_0050.pvti --picture akantu_restart.png

The Python package meshes the fields with their state. Two solvers continue from the same mesh with
the same time steps: lagrangian.py, and Akantu (PyPI) with the material of impact_material.py as a
material in Python (akantu_material.py). The node masses of Akantu are replaced by equal shares of
the masses of the elements, which belong to the velocities that the mesh transfers.

Prints the largest relative change of momentum and energy during the run of each solver, and the
momentum of the ball. The picture shows both meshes at the end, cut, and the tables over time.
Requires volume_fraction_mesh, akantu and pyvista, and matplotlib for the picture.
"""
import argparse
import os
import sys
import tempfile

import akantu as aka
import numpy as np
import pyvista

import volume_fraction_mesh as vfm

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import akantu_material  # noqa: E402, F401: registers the material "impact"
from impact_material import totals_of  # noqa: E402: after the path
from lagrangian import Lagrangian  # noqa: E402
from need_files import need_files  # noqa: E402

BODIES = ["ball", "plate"]
STATES = ["ratio", "deviator", "plastic_strain", "damage", "toughness"]
HEX = aka._hexahedron_8
DECK = "material impact [\n name = impact\n rho = 1\n]\n"
VIEW = [(3.5, -5, 5), (3.7, 3, 1.4), (0, 0, 1)]  # camera, focal point, up
SPEED = 3.0  # of the brightest colour, km/s


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("dump", help="fields of impact with state: .pvti, .vti")
    parser.add_argument("--duration", type=float, default=0.53,
                        help="time to continue, microseconds (default: 0.53)")
    parser.add_argument("--steps", type=int, help="most time steps (default: no limit)")
    parser.add_argument("--hourglass", type=float, default=0.1,
                        help="viscosity of lagrangian.py against hourglass modes (default: 0.1)")
    parser.add_argument("--picture", metavar="FILE", help="save a picture, .png")
    return parser.parse_args()


def make_mesh(path):
    def of_bodies(stem):
        return ["%s - %d" % (stem, body + 1) for body in range(len(BODIES))]

    return vfm.hexes(pyvista.read(path), arrays=BODIES,
                     state=[name for stem in STATES for name in of_bodies(stem)],
                     density=of_bodies("density"), velocity=of_bodies("velocity"),
                     energy=of_bodies("energy"), nodal_velocity=True,
                     lost_kinetic_energy="internal_energy")


class AkantuRun:
    """The mesh and its state in Akantu."""

    def __init__(self, mesh, masses, node_masses):
        self.mesh, self.masses = mesh, masses
        self.akantu_mesh = copy_mesh(mesh)
        self.model = aka.SolidMechanicsModel(self.akantu_mesh)
        with tempfile.NamedTemporaryFile("w", suffix=".dat") as deck:
            deck.write(DECK)
            deck.flush()
            aka.parseInput(deck.name)
        self.model.initFull(_analysis_method=aka._explicit_lumped_mass)
        self.material = self.model.getMaterial(0)
        self.material.start(mesh, mesh.volumes())
        self.model.getVelocity()[:] = mesh.point_state["velocity"]
        self.set_masses(node_masses)

    def set_masses(self, node_masses):
        """Replaces Akantu's masses, and starts with the accelerations of the stresses."""
        model = self.model
        model.assembleMassLumped()  # before getMass()
        model.getDOFManager().assembleToLumpedMatrix(
            "displacement", node_masses[:, None] - model.getMass(), "M")
        model.assembleInternalForces()
        model.getAcceleration()[:] = model.getInternalForce() / node_masses[:, None]

    def step(self, dt):
        self.material.dt = dt
        self.model.setTimeStep(dt)
        self.model.solveStep()

    def points(self):
        return self.mesh.points + self.model.getDisplacement()

    def totals(self):
        energy, internal = self.material.points.energy[:, None], np.zeros((len(self.mesh), 1))
        self.model.getFEEngine().integrate(energy * self.material.first_density[:, None], internal,
                                           1, HEX)
        at_corners = self.model.getVelocity()[self.mesh.cells].transpose(2, 1, 0)
        return totals_of(self.mesh.material - 1, self.masses, at_corners, internal[:, 0])


def copy_mesh(mesh):
    """Copies nodes and hexahedra, whose corners Akantu has in the same order as VTK."""
    copied = aka.Mesh(3)
    arrays = aka.MeshAccessor(copied)
    arrays.resizeNodes(len(mesh.points))
    copied.getNodes()[:] = mesh.points
    copied.addConnectivityType(HEX)
    arrays.resizeConnectivity(len(mesh), HEX)
    copied.getConnectivity(HEX)[:] = mesh.cells
    arrays.makeReady()
    return copied


def run_both(mesh, duration, most_steps=None, hourglass=0.1):
    """Returns both solvers, the times, and the totals (time, body, quantity) of each."""
    solver = Lagrangian(mesh.points, mesh.cells, mesh.material, mesh.state,
                        mesh.point_state["velocity"], hourglass)
    akantu = AkantuRun(mesh, solver.mass, solver.node_mass)
    times, tables = [0.0], ([solver.totals()], [akantu.totals()])
    while duration - solver.time > 1e-12 * duration and solver.steps != most_steps:
        solver.step(duration - solver.time)
        akantu.step(solver.time - times[-1])
        times.append(solver.time)
        for table, run in zip(tables, (solver, akantu)):
            table.append(run.totals())
    return solver, akantu, np.array(times), [np.array(table) for table in tables]


def changes(table):
    """Returns the largest relative changes of momentum and energy."""
    total = table.sum(1)
    momentum, energy = total[:, 1:4], total[:, 4] + total[:, 5]
    return (np.linalg.norm(momentum - momentum[0], axis=1).max() / np.linalg.norm(momentum[0]),
            np.abs(energy / energy[0] - 1).max())


def report(name, table):
    print("%-14s momentum %.1e, energy %.1e, p_x of the ball %.2f to %.2f mg km/s" % (
        name, *changes(table), table[0, 0, 1], table[-1, 0, 1]))


def show(axes, mesh, points, velocities, name):
    """Draws the mesh at the end, cut in the middle."""
    grid = pyvista.UnstructuredGrid({pyvista.CellType.HEXAHEDRON: mesh.cells}, points)
    grid["speed"] = np.linalg.norm(velocities, axis=1)
    behind = mesh.points[mesh.cells].mean(1)[:, 1] > 3
    plotter = pyvista.Plotter(off_screen=True, window_size=(1100, 640))
    plotter.add_mesh(grid.extract_cells(behind), scalars="speed", clim=(0, SPEED), cmap="viridis",
                     show_edges=True, line_width=0.5, show_scalar_bar=False)
    plotter.camera_position = VIEW
    plotter.camera.zoom(1.6)
    axes.imshow(plotter.screenshot(return_img=True))
    axes.set(title=name)
    axes.axis("off")


def draw(path, solver, akantu, times, tables):
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot
    figure, axes = pyplot.subplots(2, 2, figsize=(10, 6.6), layout="constrained")
    show(axes[0, 0], akantu.mesh, solver.x.T, solver.v.T, "lagrangian.py")
    show(axes[0, 1], akantu.mesh, akantu.points(), akantu.model.getVelocity(), "Akantu")
    for table, style, name in zip(tables, (":", "-"), ("lagrangian.py", "Akantu")):
        total = table.sum(1)
        for axis, values, colour, what in (
                (0, table[:, 0, 1], "C0", "ball, x"), (0, table[:, 1, 1], "C1", "plate, x"),
                (0, total[:, 1], "black", "both, x"), (1, total[:, 4], "C0", "kinetic"),
                (1, total[:, 5], "C1", "internal"), (1, total[:, 4] + total[:, 5], "black", "sum")):
            axes[1, axis].plot(times, values, style, color=colour, lw=2,
                               label=what if style == "-" else None)
    for axis, title in ((0, "Momentum [mg km/s]"), (1, "Energy [J]")):
        axes[1, axis].set(title=title + ", dotted: lagrangian.py", xlabel="time [µs]")
        axes[1, axis].grid(alpha=0.3)
        axes[1, axis].legend(loc="center left", frameon=False)
    figure.savefig(path, dpi=90)


def main():
    arguments = parse_arguments()
    need_files(arguments.dump)
    mesh = make_mesh(arguments.dump)
    solver, akantu, times, tables = run_both(mesh, arguments.duration, arguments.steps,
                                             arguments.hourglass)
    print("%d hexahedra, %d steps, %.3f us" % (len(mesh), solver.steps, times[-1]))
    report("lagrangian.py:", tables[0])
    report("Akantu:", tables[1])
    if arguments.picture:
        draw(arguments.picture, solver, akantu, times, tables)


if __name__ == "__main__":
    main()
