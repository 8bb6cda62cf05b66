#!/usr/bin/env pvpython
"""Restarts an Eulerian simulation in a Lagrangian code: a ball strikes a plate.

usage: pvpython restart.py --plugin VolumeFractionMesh.so --impact build/bin/impact [--cells 80]
       [--step 100] [--last 200] [--transfer Conserve|Copy] [--unmeshed Give|Particles] [--out DIR]
       [--picture FILE.png]

Runs Examples/impact up to the step --last. Meshes its fields with their state at the step --step.
Then the Lagrangian solver (lagrangian.py) continues to the time of the step --last, so that
both codes can be compared. Prints the differences of mass, momentum and energy. Writes into OUT
  before.csv      totals at each step of impact: mass, momentum, kinetic and internal energy of ball
                  and plate, and of material that left the grid
  handover.vtu    mesh with the transferred state
  after.csv       totals at each step of the solver, and the part of particles
  after.vtu       mesh at the end of the solver's run
  particles.csv   with --unmeshed Particles: mass, position and velocity of each at the end
  restart.png     plot of both tables; with particles, that of the ball
With --transfer Copy, each element takes the values of one cell, and each node the mean velocity of
its elements. This shows the errors that conservative transfer avoids. With --unmeshed Particles,
material without elements becomes particles, which the solver moves as point masses, so that late
steps of the impact lose nothing. The picture shows both meshes, cut; it needs a screen or xvfb-run.
"""
import argparse
import csv
import math
import os
import subprocess
import sys

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader, vtkXMLUnstructuredGridWriter

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import pictures
from lagrangian import Lagrangian
from load_plugin import load_plugin
from need_files import need_files

BODIES = ["ball", "plate"]
QUANTITIES = ["mass [mg]", "momentum x [mg km/s]", "momentum y [mg km/s]", "momentum z [mg km/s]",
              "kinetic energy [J]", "internal energy [J]"]
SHARES = [("Mass of the ball [mg]", BODIES[:1], QUANTITIES[:1]),  # plots: bodies and quantities
          ("Momentum x [mg km/s]", BODIES, QUANTITIES[1:2]), ("Energy [J]", BODIES, QUANTITIES[4:])]
VIEW_SIZE, SPEED = (1200, 720), 3.0  # size of pictures; speed of the brightest colour, km/s
PARTICLES = 6  # output of the filter
LEAST_FRACTION = 1e-9  # the mesher ignores smaller fractions
STATES = ["velocity", "energy", "ratio", "deviator", "plastic_strain", "damage", "toughness"]


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--plugin", required=True, help="path of VolumeFractionMesh.so")
    parser.add_argument("--impact", required=True, help="path of the program impact")
    parser.add_argument("--cells", type=int, default=80,
                        help="number of cells along x (default: 80)")
    parser.add_argument("--step", type=int, default=100,
                        help="step of impact that is meshed (default: 100)")
    parser.add_argument("--last", type=int, default=200,
                        help="step of impact at whose time both codes end (default: 200)")
    parser.add_argument("--transfer", choices=("Conserve", "Copy"), default="Conserve")
    parser.add_argument("--unmeshed", choices=("Give", "Particles"), default="Give",
                        help="material without elements (default: Give)")
    parser.add_argument("--out", default="restart", help="folder of the files (default: restart)")
    parser.add_argument("--picture", metavar="FILE",
                        help="save a picture of the meshes and the tables, .png")
    return parser.parse_args()


def of_bodies(stem):
    """Returns the names of the arrays of a quantity, one per body."""
    return ["%s - %d" % (stem, body + 1) for body in range(len(BODIES))]


def of_particles(bodies):
    """Returns the names of the columns of the bodies' particles."""
    return [body + " particles" for body in bodies]


# ---- the Eulerian side ----

def run_impact(arguments):
    """Runs impact and returns the path of the fields to mesh."""
    command = [arguments.impact, "--cells", arguments.cells, "--steps", arguments.last,
               "--every", arguments.step, "--restart", os.path.join(arguments.out, "dump"),
               "--history", os.path.join(arguments.out, "before.csv")]
    if subprocess.run([str(word) for word in command], stdout=subprocess.DEVNULL).returncode != 0:
        sys.exit("impact failed, see the message above")
    return os.path.join(arguments.out, "dump", "restart_%04d.pvti" % arguments.step)


def totals_of_cells(data):
    """Returns QUANTITIES of each body, as exact sums over cells. Excludes fractions that the mesher
    ignores."""
    volume = math.prod(data.GetSpacing())
    rows = []
    for body, name in enumerate(BODIES):
        fraction, density, velocity, energy = (
            vtk_to_numpy(data.GetCellData().GetArray(array)) for array in (
                name, *(of_bodies(stem)[body] for stem in ("density", "velocity", "energy"))))
        fraction = np.where(fraction > LEAST_FRACTION, fraction, 0)
        rows.append(exact_totals(fraction * density * volume, velocity, energy))
    return np.array(rows)


def totals_of_points(before, step):
    """Returns QUANTITIES of each body, from the points of impact at a step."""
    row = np.flatnonzero(before["step"] == step)[0]
    return np.array([[before[body + " " + quantity][row] for quantity in QUANTITIES]
                     for body in BODIES])


def totals_not_meshed(mesh):
    """Returns QUANTITIES of unmeshed material, from the field data of the mesh; 0 with Copy, which
    does not report them."""
    field = mesh.GetFieldData()
    if not field.HasArray("UnmeshedMass"):
        return np.zeros((len(BODIES), len(QUANTITIES)))
    return np.column_stack([vtk_to_numpy(field.GetArray("Unmeshed" + name))
                            for name in ("Mass", "Momentum", "KineticEnergy", "InternalEnergy")])


def exact_totals(mass, velocity, energy):
    speeds = (velocity ** 2).sum(1)
    return [math.fsum(values)
            for values in (mass, *(mass * velocity.T), mass * speeds / 2, mass * energy)]


# ---- transfer ----

def make_mesh(dump, transfer, unmeshed):
    source = simple.XMLPartitionedImageDataReader(FileName=[dump])
    source.UpdatePipeline()
    densities = of_bodies("density")
    states = [name for stem in STATES for name in of_bodies(stem)]
    options = dict(StateArrays=states, DensityArrays=densities,
                   VelocityArray=of_bodies("velocity")[0],
                   EnergyArray=of_bodies("energy")[0], NodalVelocity=1,
                   LostKineticEnergy="Internal Energy", UnmeshedMaterial=unmeshed)
    if transfer == "Copy":
        options = dict(StateArrays=states + densities)
    mesher = VolumeFractionToHex(Input=source, VolumeFractionArrays=BODIES, **options)
    mesher.UpdatePipeline()
    return source, mesher


def read_mesh(path):
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def read_state(mesh, name, body):
    """Returns a quantity of each element. With Copy, the mesh has an array per body, and each
    element uses the array of its own body."""
    data = mesh.GetCellData()
    if data.HasArray(name):
        return vtk_to_numpy(data.GetArray(name))
    values = [vtk_to_numpy(data.GetArray(array)) for array in of_bodies(name)]
    chosen = body if values[0].ndim == 1 else body[:, None]
    return np.where(chosen == 0, *values)


def read_particles(mesher):
    """Returns the arrays of the particles by name; an empty dict without particles."""
    output = mesher.GetClientSideObject().GetOutputDataObject(PARTICLES)
    if output.GetNumberOfPoints() == 0:
        return {}
    data = output.GetPointData()
    arrays = {data.GetArrayName(a): vtk_to_numpy(data.GetArray(a))
              for a in range(data.GetNumberOfArrays())}
    return {**arrays, "Position": vtk_to_numpy(output.GetPoints().GetData())}


def start_solver(mesh, particles):
    points = vtk_to_numpy(mesh.GetPoints().GetData())
    hexahedra = vtk_to_numpy(mesh.GetCells().GetConnectivityArray()).reshape(-1, 8)
    materials = vtk_to_numpy(mesh.GetCellData().GetArray("MaterialId"))
    state = {name: read_state(mesh, name, materials - 1) for name in STATES + ["density"]}
    at_nodes = mesh.GetPointData().GetArray("velocity")
    return Lagrangian(points, hexahedra, materials, state,
                      vtk_to_numpy(at_nodes) if at_nodes else None, particles=particles)


# ---- the Lagrangian side ----

def run_solver(solver, start, duration, path):
    solver.time = start
    with open(path, "w", newline="", encoding="ascii") as file:
        table = csv.writer(file)
        table.writerow(["step", "time [us]"]
                       + [body + " " + quantity for body in BODIES + of_particles(BODIES)
                          for quantity in QUANTITIES] + ["removed elements"])
        solver.run(duration, lambda s: table.writerow(
            [s.steps, repr(s.time), *map(repr, s.totals().ravel().tolist()),
             *map(repr, totals_of_particles(s).ravel().tolist()), np.count_nonzero(~s.lives)]))


def totals_of_particles(solver):
    return (solver.particles.totals() if solver.particles
            else np.zeros((len(BODIES), len(QUANTITIES))))


def save_mesh(mesh, solver, path):
    """Writes the deformed mesh with velocity, pressure, damage and energy."""
    moved = mesh.NewInstance()
    moved.DeepCopy(mesh)
    moved.GetPoints().SetData(numpy_to_vtk(np.ascontiguousarray(solver.x.T), deep=1))
    for data, name, values in ((moved.GetPointData(), "velocity", solver.v.T),
                               (moved.GetCellData(), "pressure", solver.pressure),
                               (moved.GetCellData(), "damage", solver.damage),
                               (moved.GetCellData(), "energy", solver.energy),
                               (moved.GetCellData(), "alive", solver.lives.astype(np.uint8))):
        array = numpy_to_vtk(np.ascontiguousarray(values), deep=1)
        array.SetName(name)
        data.AddArray(array)
    writer = vtkXMLUnstructuredGridWriter()
    writer.SetInputData(moved)
    writer.SetFileName(path)
    writer.SetDataModeToBinary()
    if not writer.Write():
        sys.exit("cannot write " + path)


def save_particles(particles, path):
    """Writes a row per particle."""
    with open(path, "w", newline="", encoding="ascii") as file:
        table = csv.writer(file)
        table.writerow(["body", "mass [mg]", "x [mm]", "y [mm]", "z [mm]", "velocity x [km/s]",
                        "velocity y [km/s]", "velocity z [km/s]", "internal energy [J]"])
        for body, *values in zip(particles.body, particles.mass, *particles.x, *particles.v,
                                 particles.mass * particles.energy):
            table.writerow([BODIES[body], *map(repr, map(float, values))])


# ---- report ----

def read_table(path):
    with open(path, encoding="ascii") as file:
        rows = list(csv.reader(file))
    return {name: np.array(column, float) for name, column in zip(rows[0], zip(*rows[1:]))}


def sum_of(table, quantity, bodies=BODIES):
    return sum(table[body + " " + quantity] for body in bodies)


def total_energy(totals):
    return totals[:, 4].sum() + totals[:, 5].sum()


def report(rows):
    """Prints the differences between totals, relative to the totals before. rows: (name, totals
    after, totals before). The difference of momentum is relative to its length."""
    print("%-30s%12s%12s%12s%12s%12s" % (
        "relative difference", "mass", *BODIES, "momentum", "energy"))
    for what, after, before in rows:
        change = after - before
        print("%-30s%12.1e%12.1e%12.1e%12.1e%12.1e" % (
            what, change[:, 0].sum() / before[:, 0].sum(), *(change[:, 0] / before[:, 0]),
            np.linalg.norm(change[:, 1:4].sum(0)) / np.linalg.norm(before[:, 1:4].sum(0)),
            total_energy(change) / total_energy(before)))


def draw_tables(figure, places, before, after, start):
    """Plots momentum and energy over time. A dashed line marks the transfer; dotted lines are the
    continued run of impact."""
    momentum, energy = (figure.add_subplot(place) for place in places)
    first = before["time [us]"] <= start * (1 + 1e-12)
    lines = [(momentum, "momentum x [mg km/s]", "x"), (momentum, "momentum z [mg km/s]", "z"),
             (energy, "kinetic energy [J]", "kinetic"), (energy, "internal energy [J]", "internal")]
    for number, (axes, quantity, label) in enumerate(lines):
        colour = "C%d" % number
        old, new = sum_of(before, quantity), sum_of(after, quantity)
        axes.plot(before["time [us]"], old, color=colour, lw=0.8, ls=":")
        axes.plot(before["time [us]"][first], old[first], color=colour, lw=2)
        axes.plot(after["time [us]"], new, color=colour, lw=2, label=label)
    for table, chosen in ((before, first), (after, slice(None))):
        total = sum_of(table, "kinetic energy [J]") + sum_of(table, "internal energy [J]")
        energy.plot(table["time [us]"][chosen], total[chosen], color="black", lw=2,
                    label="both" if table is after else None)
    for axes, title in ((momentum, "Momentum [mg km/s]"), (energy, "Energy [J]")):
        finish(axes, title, start, after)


def draw_shares(figure, places, before, after, start):
    """Plots mass, momentum and energy over time: in impact, in elements, in particles, and the sum
    of both."""
    first = before["time [us]"] <= start * (1 + 1e-12)
    for place, (title, bodies, quantities) in zip(places, SHARES):
        axes = figure.add_subplot(place)
        old, both, loose = (
            sum(sum_of(table, quantity, parts) for quantity in quantities)
            for table, parts in ((before, bodies), (after, bodies), (after, of_particles(bodies))))
        axes.plot(before["time [us]"], old, color="black", lw=0.8, ls=":")
        axes.plot(before["time [us]"][first], old[first], color="black", lw=2)
        for values, colour, label in ((both, "black", "both"), (both - loose, "C0", "elements"),
                                      (loose, "C1", "particles")):
            axes.plot(after["time [us]"], values, color=colour, lw=2, label=label)
        finish(axes, title, start, after)


def finish(axes, title, start, after):
    axes.axvline(start, color="0.4", lw=1, ls="--")
    axes.set(title=title, xlabel="time [µs]", xlim=(0, after["time [us]"][-1]))
    axes.grid(alpha=0.3)
    axes.legend(loc="center left", frameon=False)


def colour_by_speed(shown, view):
    simple.ColorBy(shown, ("POINTS", "speed"))
    table = simple.GetColorTransferFunction("speed")
    table.ApplyPreset(pictures.VIRIDIS, True)
    table.RescaleTransferFunction(0, SPEED)
    shown.SetScalarBarVisibility(view, False)


def show_spheres(spheres, view):
    """Shows particles. spheres: positions, velocities, radii."""
    position, velocity, radius = spheres
    data = vtkPolyData()
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(position), deep=1))
    data.SetPoints(points)
    for name, values in (("speed", np.linalg.norm(velocity, axis=1)), ("Radius", radius)):
        array = numpy_to_vtk(values, deep=1)
        array.SetName(name)
        data.GetPointData().AddArray(array)
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(data)
    colour_by_speed(pictures.show_particles(source, view), view)


def spheres_of(particles, moved):
    """Returns positions, velocities and radii of the particles before and after they moved; None
    twice without particles."""
    if not particles:
        return None, None
    return ((particles["Position"], particles["velocity"], particles["Radius"]),
            (moved.x.T, moved.v.T, particles["Radius"]))


def render(path, spheres, picture):
    """Saves a picture of a mesh, coloured by the speed of its nodes, without removed elements:
    half of it, or all of it and its particles."""
    simple._DisableFirstRenderCameraReset()
    view = pictures.make_view(VIEW_SIZE)
    view.BackgroundColorMode, view.Background = "Single Color", (1, 1, 1)
    mesh = simple.OpenDataFile(path)
    mesh.UpdatePipeline()
    if mesh.CellData.GetArray("alive"):
        mesh = simple.Threshold(Input=mesh, Scalars=["CELLS", "alive"], LowerThreshold=1,
                                UpperThreshold=1)
    speed = simple.Calculator(Input=mesh, AttributeType="Point Data", Function="mag(velocity)",
                              ResultArrayName="speed")
    if spheres:
        show_spheres(spheres, view)
        pictures.aim(view, [1.5, 12, 0, 6, 0, 4], (0.25, -1, 0.75), 1.45, sink=0.15)
    else:
        speed = pictures.cut(speed, [0, 3.01, 0], [0, 1, 0])
        pictures.aim(view, [0.5, 6.5, 3, 6, 0, 4], (0.15, -1, 0.35), 1.75, sink=0.12)
    colour_by_speed(pictures.show(speed, view), view)
    pictures.save(view, picture)


def draw(arguments, before, after, start, spheres):
    """Draws the plot and the picture. spheres: of the particles at the transfer and at the end."""
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import cm, colors, pyplot
    draw_curves, columns = (draw_shares, 3) if all(spheres) else (draw_tables, 2)
    figure = pyplot.figure(figsize=(11, 4), layout="constrained")
    draw_curves(figure, figure.add_gridspec(1, columns), before, after, start)
    figure.savefig(os.path.join(arguments.out, "restart.png"), dpi=110)
    if not arguments.picture:
        return
    figure = pyplot.figure(figsize=(12, 7.4), layout="constrained")
    rows = figure.add_gridspec(2, 1, height_ratios=[1.05, 1])
    places, shown = rows[0].subgridspec(1, 2), []
    times = start, after["time [us]"][-1]
    for place, name, time, own in zip(places, ("handover", "after"), times, spheres):
        path = os.path.join(arguments.out, name)
        render(path + ".vtu", own, path + ".png")
        shown.append(figure.add_subplot(place))
        shown[-1].imshow(pyplot.imread(path + ".png"))
        shown[-1].axis("off")
        shown[-1].set_title("%.2f µs" % time)
    figure.colorbar(cm.ScalarMappable(colors.Normalize(0, SPEED), "viridis"), ax=shown,
                    label="speed [km/s]", shrink=0.8, pad=0.01)
    draw_curves(figure, rows[1].subgridspec(1, columns), before, after, start)
    figure.savefig(arguments.picture, dpi=100)


def main():
    arguments = parse_arguments()
    need_files(arguments.plugin, arguments.impact)
    if not 0 < arguments.step < arguments.last:
        sys.exit("restart.py: --step must be above 0 and below --last")
    if arguments.transfer == "Copy" and arguments.unmeshed == "Particles":
        sys.exit("restart.py: --unmeshed Particles needs --transfer Conserve")
    load_plugin(arguments.plugin, globals())  # defines VolumeFractionToHex
    os.makedirs(arguments.out, exist_ok=True)
    source, mesher = make_mesh(run_impact(arguments), arguments.transfer, arguments.unmeshed)
    files = {name: os.path.join(arguments.out, name)
             for name in ("before.csv", "after.csv", "handover.vtu", "after.vtu")}
    simple.SaveData(files["handover.vtu"], proxy=mesher, DataMode="Binary")
    mesh = read_mesh(files["handover.vtu"])
    if mesh.GetNumberOfCells() == 0:
        sys.exit("no mesh, see the message above")
    before = read_table(files["before.csv"])
    times = dict(zip(before["step"].astype(int), before["time [us]"]))
    particles = read_particles(mesher)
    solver = start_solver(mesh, particles)
    cells, at_start = (
        totals_of_cells(source.GetClientSideObject().GetOutputDataObject(0)), solver.totals())
    left_out = totals_not_meshed(mesh)
    run_solver(solver, times[arguments.step], times[arguments.last] - times[arguments.step],
               files["after.csv"])
    save_mesh(mesh, solver, files["after.vtu"])
    if solver.particles:
        save_particles(solver.particles, os.path.join(arguments.out, "particles.csv"))
    report([("points of impact to cells", cells, totals_of_points(before, arguments.step)),
            ("cells to mesh and not meshed", at_start + left_out, cells),
            ("the solver's run", solver.totals(), at_start)])
    print("not meshed: %.3g mg" % left_out[:, 0].sum())
    if solver.particles:
        print("particles: %d, %.3g mg" % (len(solver.particles.mass), solver.particles.mass.sum()))
    draw(arguments, before, read_table(files["after.csv"]), times[arguments.step],
         spheres_of(particles, solver.particles))
    print("%s: %d hexahedra, %d steps, %d removed" % (
        files["after.vtu"], len(solver.mass), solver.steps, np.count_nonzero(~solver.lives)))


if __name__ == "__main__":
    main()
