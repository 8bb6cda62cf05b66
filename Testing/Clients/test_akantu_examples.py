"""Examples akantu_restart.py, akantu_grains.py, delamination.py: balances, exact solutions."""

import os
import re
import subprocess
import sys

import numpy as np
import pytest

aka = pytest.importorskip("akantu")
pyvista = pytest.importorskip("pyvista")
pytest.importorskip("matplotlib")
vfm = pytest.importorskip("volume_fraction_mesh")

EXAMPLES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Examples")
NUMBER = r"([-+.\de]+)"
BALL, PLATE = "sphere radius=1 center=2,3,2.3", "box size=10,6,0.75 center=5,3,1 material=2"
VELOCITY = np.array([2.5, 0.0, -1.6])  # of the ball, km/s
ROUNDING, GOOD = 1e-13, 1e-3  # limits of the changes of momentum and of energy


def run_example(name, *arguments):
    """Runs an example in a process of its own and returns what it prints."""
    command = [sys.executable, os.path.join(EXAMPLES, name), *map(str, arguments)]
    run = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    assert run.returncode == 0, run
    print(run.stdout)
    return run.stdout


def find(pattern, text):
    """Returns the numbers of a line. In the pattern, # stands for a number."""
    found = re.search(pattern.replace("#", NUMBER), text)
    assert found, (pattern, text)
    return [float(number) for number in found.groups()]


def at_rest(shape, density):
    """Returns the state of undeformed material with the names of impact."""
    state = {name: np.zeros(shape) for name in ("energy", "plastic_strain", "damage")}
    return {**state, "density": np.full(shape, density), "ratio": np.ones(shape),
            "toughness": np.ones(shape), "deviator": np.zeros((*shape, 6))}


@pytest.fixture(scope="session")
def dump(tmp_path_factory):
    """Writes fields as Examples/impact does: a ball that flies and touches a plate."""
    cells = np.array([20, 12, 8])
    fractions = vfm.shapes(BALL + "; " + PLATE, tuple(cells), bounds=[0, 10, 0, 6, 0, 4])
    grid = pyvista.ImageData(dimensions=cells + 1, spacing=(0.5, 0.5, 0.5))
    for body, (name, field, density) in enumerate(zip(("ball", "plate"), fractions.values(),
                                                      (2.785, 7.83))):
        arrays = at_rest(field.shape, density)
        arrays["velocity"] = np.broadcast_to(VELOCITY * (body == 0), (*field.shape, 3))
        grid[name] = field.ravel(order="F")
        for stem, values in arrays.items():
            flat = values.transpose(2, 1, 0, *range(3, values.ndim))
            grid["%s - %d" % (stem, body + 1)] = flat.reshape(-1, *values.shape[3:])
    path = tmp_path_factory.mktemp("impact") / "fields.vti"
    grid.save(path)
    mass = 2.785 * 0.5**3 * next(iter(fractions.values())).sum()
    return path, mass


def test_restart(dump, tmp_path):
    path, mass = dump
    picture = tmp_path / "restart.png"
    text = run_example("akantu_restart.py", path, "--steps", 30, "--picture", picture)
    assert find(r"# hexahedra, # steps", text)[1] == 30
    line = "momentum #, energy #, p_x of the ball # to # mg"
    own, akantu = (find(name + " +" + line, text) for name in ("lagrangian.py:", "Akantu:"))
    assert akantu[0] < ROUNDING and akantu[1] < GOOD
    assert own[0] < ROUNDING and own[1] < ROUNDING
    # Nodes on the contact have one velocity, so that the plate has part of the ball's momentum.
    assert akantu[2] == own[2] and 0.8 < own[2] / (mass * VELOCITY[0]) <= 1
    assert akantu[2] - akantu[3] > 0.1, "the plate does not brake the ball"
    assert np.isclose(akantu[2] - akantu[3], own[2] - own[3], rtol=0.5)
    assert picture.stat().st_size > 20000


def test_missing_dump():
    run = subprocess.run([sys.executable, os.path.join(EXAMPLES, "akantu_restart.py"), "none.vti"],
                         stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    assert run.returncode == 1 and run.stderr == "akantu_restart.py: none.vti: no such file\n", run


def test_shock():
    """Two halves of aluminium collide in Akantu.

    The stress between the shocks is that of the Hugoniot plus two thirds of the yield stress.
    """
    sys.path.insert(0, EXAMPLES)
    from akantu_restart import changes, run_both
    from impact_material import MATERIALS
    speed, m = 0.5, {name: values[0] for name, values in MATERIALS.items()}
    mesh = vfm.hexes(np.ones((24, 16, 16)), spacing=0.05)
    x = mesh.points[:, :1]
    mesh.state = at_rest((len(mesh),), m["density"])
    mesh.state["toughness"][:] = 1e9
    mesh.point_state = {"velocity": np.where(x < 0.599, speed, np.where(x > 0.601, -speed, 0))
                        * [1, 0, 0]}
    _, akantu, _, tables = run_both(mesh, 0.04)
    middle = np.abs(mesh.points[mesh.cells].mean(1) - [0.6, 0.4, 0.4]).max(1) < 0.06
    points = akantu.material.points
    stress = (points.pressure - points.deviator[0]).reshape(-1, 8)[middle].mean()
    expected = m["density"] * (m["sound"] + m["slope"] * speed) * speed + 2 / 3 * m["yield0"]
    print("shock: %.3f GPa, by the Hugoniot %.3f" % (stress, expected))
    assert middle.sum() >= 8 and abs(stress / expected - 1) < 0.05, (stress, expected)
    shares = mesh.state["density"][0] * mesh.volumes().sum() * speed
    assert np.abs(np.diff(tables[1].sum(1)[:, 1:4], axis=0)).max() < ROUNDING * shares
    assert changes(tables[1])[1] < GOOD


@pytest.fixture(scope="session", params=[False, True], ids=["hexes", "tets"])
def grains(request):
    """Returns options of the example, the number of faces between grains and their area."""
    sys.path.insert(0, EXAMPLES)
    from akantu_grains import make_mesh
    mesh = make_mesh(5, 6, request.param)
    corners = mesh.points[mesh.facets("interfaces").points]
    area = np.linalg.norm(np.cross(corners[:, 2] - corners[:, 0],
                                   corners[:, -1] - corners[:, 1]), axis=1).sum() / 2
    return ["--grains", 5, "--cells", 6] + ["--tets"] * request.param, len(corners), area


def run_grains(*arguments):
    """Returns what the example prints: faces, opened, broken, fragments, momentum, energy, and
    dissipated energy."""
    text = run_example("akantu_grains.py", *arguments)
    return (find("# faces between grains", text)
            + find("# opened, # of them broken: # fragments", text)
            + find(r"momentum #, energy #\n", text) + find("dissipated #,", text))


def check_all_break(case, picture, *arguments):
    """Runs the grains: all faces between them break, and no others. The dissipated energy is that
    of cracks of the area of the faces."""
    options, count, area = case
    faces, opened, broken, fragments, momentum, energy, dissipated = run_grains(
        *options, *arguments, "--picture", picture)
    assert faces == opened == broken == count and fragments == 5
    assert momentum < ROUNDING and energy < GOOD
    assert np.isclose(dissipated, 5e-5 * area, rtol=0.03), (dissipated, area)
    assert picture.stat().st_size > 20000


def test_grains_break(grains, tmp_path):
    """Akantu inserts cohesive elements, which break."""
    check_all_break(grains, tmp_path / "grains.png", "--steps", 200)


def test_own_cohesive_elements(grains, tmp_path):
    """The cohesive elements of the mesh break as those of Akantu do."""
    check_all_break(grains, tmp_path / "split.png", "--split", "--courant", 0.1, "--steps", 400)


def test_grains_stay_whole(grains):
    """Below the strength no face opens."""
    options, count, _ = grains
    faces, opened, _, fragments, momentum, energy, dissipated = run_grains(
        *options, "--rate", 1e-4, "--steps", 50)
    assert faces == count and opened == 0 and fragments == 1 and dissipated == 0
    assert momentum < ROUNDING and energy < GOOD


def test_delamination(tmp_path):
    """All of the glue breaks, at a force below its strength times its area. Forces on both bodies
    agree until then, and the dissipated energy is that of the bilinear law."""
    picture = tmp_path / "delamination.png"
    text = run_example("delamination.py", "--cells", 12, "--picture", picture)
    _, glue, broken = find("# hexahedra, # cohesive elements, # of them broken", text)
    assert glue == broken > 10
    ball, plate, opening = find(
        "greatest force # N on the ball, # N on the plate, opening # µm", text)
    assert 5 < ball < 1000 * 0.03 * 0.5 and np.isclose(ball, plate, rtol=0.05)
    assert 0.1 < opening < 3.4
    force, energy, fracture = find("balances: force #, energy #, fracture #", text)
    assert force < ROUNDING and energy < GOOD and np.isclose(fracture, 1, rtol=0.01)
    assert picture.stat().st_size > 20000
