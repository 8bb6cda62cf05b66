"""Examples/restart.py and its solver.

usage: pvpython TestRestart.py IMPACT PLUGIN FOLDER

Cells, elements, nodes and the solver conserve the sums over the material points of impact. The
forces and shocks of the solver are correct.
"""
import csv
import os
import re
import shutil
import subprocess
import sys

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLImageDataReader

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
EXAMPLES = os.path.join(ROOT, "Examples")
sys.path[:0] = [EXAMPLES, os.path.join(ROOT, "Testing", "Python")]
from impact_material import MATERIALS
from lagrangian import CORNERS, Lagrangian, volume_gradients
from mpi_run import mpi_run

ROUNDING = 1e-13
CASE = ["--cells", "24", "--step", "30", "--last", "42"]
PARTICLES = ["--unmeshed", "Particles"]
QUANTITIES = ["mass [mg]", "momentum x [mg km/s]", "momentum y [mg km/s]", "momentum z [mg km/s]",
              "kinetic energy [J]", "internal energy [J]"]


def block(cells, width):
    """Returns points and hexahedra of a block of cells."""
    n = np.array(cells) + 1
    points = np.stack(np.meshgrid(*[width * np.arange(count) for count in n], indexing="ij"),
                      -1).reshape(-1, 3)
    first = np.stack(np.meshgrid(*[np.arange(count) for count in cells], indexing="ij"),
                     -1).reshape(-1, 1, 3)
    place = first + (CORNERS > 0)
    return points, (place[..., 0] * n[1] + place[..., 1]) * n[2] + place[..., 2]


def at_rest(elements, material):
    """Returns the state of undeformed elements."""
    state = {name: np.zeros(elements) for name in ("energy", "plastic_strain", "damage")}
    return {**state, "density": np.full(elements, MATERIALS["density"][material - 1]),
            "ratio": np.ones(elements),
            "toughness": np.full(elements, 1e9), "deviator": np.zeros((elements, 6))}


def check_gradients():
    """Compares the gradients of the volume with difference quotients."""
    x = CORNERS.T[:, :, None] + 0.2 * np.random.default_rng(1).standard_normal((3, 8, 20))
    gradients, volume = volume_gradients(x)
    assert (volume > 0).all() and np.abs(gradients.sum(1)).max() < 1e-14
    for axis in range(3):
        for corner in range(8):
            step = np.zeros_like(x)
            step[axis, corner] = 1e-5
            change = (volume_gradients(x + step)[1] - volume_gradients(x - step)[1]) / 2e-5
            assert np.allclose(change, gradients[axis, corner], atol=1e-9)


def check_flight():
    """A rotating and flying body keeps its angular momentum to second order, the rest to rounding.

    Its deformation is small.
    """
    points, hexahedra = block((4, 3, 5), 0.1)
    spin, elements = np.array([0.3, -0.2, 0.4]), len(hexahedra)
    velocities = np.cross(spin, points) + [1, 2, 3]
    solver = Lagrangian(points, hexahedra, np.full(elements, 2), at_rest(elements, 2), velocities)
    angular = lambda: (solver.node_mass * np.cross(solver.x.T, solver.v.T).T).sum(1)
    before, at_start = angular(), solver.totals()
    solver.run(0.3, lambda _: None)
    assert solver.steps > 20 and np.allclose(angular(), before, rtol=1e-4), (before, angular())
    change = (solver.totals() - at_start).sum(0)
    assert np.abs(change[:4]).max() < 1e-13 * at_start[:,
                                                       0].sum() and abs(
                                                           change[4] + change[
                                                               5]) < 1e-13 * at_start[
                                                                   :, 4].sum(), change
    assert at_start[0].tolist() == [0] * 6  # there is no ball


def check_shock():
    """Two halves of aluminium collide.

    The pressure between the shocks is that of the Hugoniot plus two thirds of the yield stress.
    """
    points, hexahedra = block((24, 24, 24), 0.05)
    elements, speed = len(hexahedra), 0.5
    velocities = np.where(points[:, :1] < 0.599, speed,
                          np.where(points[:, :1] > 0.601, -speed, 0)) * [1, 0, 0]
    solver = Lagrangian(points, hexahedra, np.full(elements, 1), at_rest(elements, 1), velocities)
    at_start = solver.totals().sum(0)
    solver.run(0.055, lambda _: None)
    inside = np.abs(solver.x[:, solver.corners].mean(1) - [[0.6]] * 3).max(0) < 0.06
    found = (solver.pressure - solver.deviator[0])[inside].mean()
    m = {name: values[0] for name, values in MATERIALS.items()}
    expected = m["density"] * (m["sound"] + m["slope"] * speed) * speed + 2 / 3 * m["yield0"]
    print("shock: %.3f GPa, by the Hugoniot %.3f" % (found, expected))
    assert inside.sum() >= 8 and abs(found / expected - 1) < 0.04, (found, expected)
    totals = solver.totals().sum(0)
    assert abs((totals[4] + totals[5]) / (at_start[4] + at_start[5]) - 1) < ROUNDING


def run_restart(impact, plugin, folder, *options):
    """Returns {row of the printed table: mass, ball, plate, momentum, energy} and the output."""
    command = ["pvpython", os.path.join(EXAMPLES, "restart.py"), "--plugin", plugin,
               "--impact", impact, "--out", folder, *CASE, *options]
    run = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    print(run.stdout)
    assert run.returncode == 0, run
    rows = re.findall(r"^(.*?)((?: +[-+.\de]+){5})$", run.stdout, re.M)
    return {name.strip(): np.abs(np.array(numbers.split(), float))
            for name, numbers in rows}, run.stdout


def read_csv(path):
    with open(path, newline="", encoding="ascii") as file:
        return list(csv.DictReader(file))


def check_restart(impact, plugin, folder):
    rows, text = run_restart(impact, plugin, os.path.join(folder, "conserve"))
    points = rows["points of impact to cells"]
    # Small fragments of the plate are missing.
    assert points[[1, 3, 4]].max() <= ROUNDING and points.max() <= 1e-9, points
    for name in ("cells to mesh and not meshed", "the solver's run"):
        assert rows[name].max() <= ROUNDING, (name, rows[name])
    assert "not meshed: 0 mg" in text
    copied, _ = run_restart(impact, plugin, os.path.join(folder, "copy"), "--transfer", "Copy")
    # The check above would otherwise prove nothing.
    assert copied["cells to mesh and not meshed"][3:].min() > 1e-4, copied
    before, after = (read_csv(os.path.join(folder, "conserve", name))
                     for name in ("before.csv", "after.csv"))
    assert float(before[30]["time [us]"]) == float(after[0]["time [us]"]) and len(after) > 12
    assert np.isclose(float(after[-1]["time [us]"]), float(before[-1]["time [us]"]), rtol=1e-12)
    gained = float(after[-1]["plate momentum x [mg km/s]"]) - float(
        after[0]["plate momentum x [mg km/s]"])
    assert gained > 0.1, gained  # the ball continues to push
    assert os.path.getsize(os.path.join(folder, "conserve", "restart.png")) > 10000


def check_particles(impact, plugin, folder, step, least):
    """Elements and particles continue a late step, with its mass, momentum and energy.

    At least `least` particles are expected, and as many mg of them.
    """
    folder = os.path.join(folder, "particles%d" % step)
    rows, text = run_restart(impact, plugin, folder, "--step", str(step), "--last", str(step + 12),
                             *PARTICLES)
    for name in ("cells to mesh and not meshed", "the solver's run"):
        assert rows[name].max() <= ROUNDING, (name, rows[name])
    assert "not meshed: 0 mg" in text
    particles = read_csv(os.path.join(folder, "particles.csv"))
    mass = sum(float(row["mass [mg]"]) for row in particles)
    assert len(particles) >= least[0] and mass > least[1], (len(particles), mass)
    assert "particles: %d, %.3g mg" % (len(particles), mass) in text
    moved = read_csv(os.path.join(folder, "after.csv"))
    duration = float(moved[-1]["time [us]"]) - float(moved[0]["time [us]"])
    fastest = max(particles, key=lambda row: abs(float(row["velocity x [km/s]"])))
    assert abs(float(fastest["velocity x [km/s]"])) * duration > 0.01, fastest
    check_shares(moved, mass)
    check_hand_over(folder, step, moved[0])


def values_of(row, parts, quantities=QUANTITIES):
    return np.array([sum(float(row[part + " " + quantity]) for part in parts)
                     for quantity in quantities])


def check_shares(moved, mass):
    """The columns of particles have their mass, and do not change, because nothing acts on them."""
    first, last = (values_of(row, ["ball particles", "plate particles"])
                   for row in (moved[0], moved[-1]))
    assert np.isclose(first[0], mass, rtol=1e-12) and first[4:].min() > 0, (first, mass)
    assert np.allclose(first, last, rtol=1e-12, atol=0), (first, last)


def check_hand_over(folder, step, first):
    """Sums over the cells of the dump are those of elements and particles, to 1e-12."""
    before = np.zeros(6)
    for name in sorted(os.listdir(os.path.join(folder, "dump"))):
        if name.startswith("restart_%04d" % step) and name.endswith(".vti"):
            before += totals_of_dump(os.path.join(folder, "dump", name))
    after = values_of(first, ["ball", "plate"])
    for old, new in ((before[0], after[0]), (before[4:].sum(), after[4:].sum()),
                     *zip(before[1:4], after[1:4])):
        assert abs(new - old) <= 1e-12 * before[0], (before, after)


def totals_of_dump(path):
    reader = vtkXMLImageDataReader()
    reader.SetFileName(path)
    reader.Update()
    cells = reader.GetOutput()
    array = lambda name: vtk_to_numpy(cells.GetCellData().GetArray(name))
    totals = np.zeros(6)
    for body, name in enumerate(("ball", "plate"), 1):
        mass = array(name) * array("density - %d" % body) * np.prod(cells.GetSpacing())
        velocity = array("velocity - %d" % body)
        totals += [mass.sum(), *(mass[:, None] * velocity).sum(0),
                   (mass * (velocity ** 2).sum(1)).sum() / 2,
                   (mass * array("energy - %d" % body)).sum()]
    return totals


def check_ranks(impact, folder):
    """The history is bitwise identical on 1 and 3 ranks."""
    files = []
    for ranks in (1, 3):
        path = os.path.join(folder, "history%d.csv" % ranks)
        run = mpi_run(ranks, [impact, "--cells", "24", "--steps", "40", "--history", path])
        assert run.returncode == 0, run
        with open(path, "rb") as file:
            files.append(file.read())
    assert files[0] == files[1] and files[0].count(b"\n") == 42
    run = mpi_run(2, [impact, "--history", os.path.join(folder, "none", "history.csv")])
    assert run.returncode == 1 and "cannot write" in run.stderr and len(
        run.stderr.splitlines()) == 1, run


def main(impact, plugin, folder):
    check_gradients()
    check_flight()
    check_shock()
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    check_ranks(impact, folder)
    check_restart(impact, plugin, folder)
    check_particles(impact, plugin, folder, 120, (45, 0.35))
    check_particles(impact, plugin, folder, 180, (35, 0.2))


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    main(*sys.argv[1:])
