"""CalculiX solves linear elastic problems with exact solutions on meshes written as .inp.

Constant stress is exact on any valid conforming mesh. A hanging node, an inverted or missing
element, a missing face or a wrong number would change it. CalculiX prints seven digits; the chosen
stresses begin with 9, so that the deviation of a correct value is below 6e-8.
"""
import os
import sys

import numpy as np
from paraview import simple

from inp_file import InpFile
from vfmtest import (
    TET_METHODS, ball_and_plate, image, in_folder, main, producer, VolumeFractionShapes,
    VolumeFractionToHex, VolumeFractionToTet)

sys.path.insert(0,
                os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..",
                             "Examples"))
import calculix

KINDS = ["Hex"] + TET_METHODS
N = 10
LIMIT = 1e-6  # relative to the largest stress
PRESSURE = 9.5
SECONDS = 120  # time limit of a solve


class Model:
    """A mesh written to a file, and its solution by CalculiX."""

    def __init__(self, at, field, kind, arrays, velocity=None, **properties):
        properties.update(Input=field, VolumeFractionArrays=arrays)
        mesher = VolumeFractionToHex(**properties) if kind == "Hex" else VolumeFractionToTet(
            Method=kind, **properties)
        self.mesh, self.deck, self.kind = at("mesh.inp"), at("deck.inp"), kind
        if velocity is not None:  # equal for all nodes
            mesher = simple.Calculator(Input=mesher, ResultArrayName="velocity",
                                       Function="%g*iHat+%g*jHat+%g*kHat" % tuple(velocity))
        simple.SaveData(self.mesh, proxy=mesher)
        self.file = InpFile(self.mesh)
        self.points = self.file.nodes.astype(float)

    def solve(self, materials, boundary, **more):
        calculix.write_deck(self.deck, self.mesh, materials, boundary, **more)
        calculix.run(self.deck, seconds=SECONDS)
        results = calculix.read_results(self.deck)
        assert results.displacements.shape == self.points.shape
        assert results.stresses.shape == (len(self.file.elements), 8 if self.kind == "Hex" else 1,
                                          6)
        return results

    def deviation(self, name, stresses, exact):
        """Returns the largest deviation from the exact stress, relative to its largest value."""
        found = abs(stresses - exact).max() / abs(np.array(exact)).max()
        print("  %-24s %-8s %6d elements, deviation of the stress %.1e"
              % (name, self.kind, len(self.file.elements), found))
        return found


def ball_in_matrix():
    ball, _ = ball_and_plate(N)
    return producer(image({"ball": ball, "matrix": 1 - ball}))


def strain(stress, modulus, ratio):
    """Returns the strain by Hooke's law; order of stress: xx yy zz xy xz yz."""
    xx, yy, zz, xy, xz, yz = stress
    tensor = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
    return (1 + ratio) / modulus * tensor - ratio / modulus * np.trace(tensor) * np.eye(3)


@in_folder
def test_patch(at):
    """A linear displacement of the sides gives constant stress, for any shape of the elements."""
    stress, modulus, ratio = [9.0, -4.0, 6.0, 2.0, 3.0, -5.0], 2000.0, 0.3
    spin = 1e-3 * np.array([[0, 1, -2], [-1, 0, 3], [2, -3, 0]])
    gradient = strain(stress, modulus, ratio) + spin
    for kind in KINDS:
        model = Model(at, ball_in_matrix(), kind, ["ball", "matrix"])
        sides = [model.file.node_sets[side + end] for side in "XYZ" for end in ("_MIN", "_MAX")]
        nodes = sorted(set().union(*sides))
        assert 100 < len(nodes) < 0.9 * len(model.points)  # there are free nodes
        boundary = [(node, d + 1, d + 1, value) for node in nodes
                    for d, value in enumerate(gradient @ model.points[node - 1])]
        results = model.solve({"BALL": (modulus, ratio), "MATRIX": (modulus, ratio)}, boundary)
        assert model.deviation("patch", results.stresses, stress) <= LIMIT
        assert np.allclose(results.displacements, model.points @ gradient.T, rtol=1e-6, atol=1e-8)
        other = model.solve({"BALL": (2 * modulus, ratio), "MATRIX": (modulus, ratio)}, boundary)
        assert abs(other.stresses - stress).max() > 1  # the materials are in the right elements


@in_folder
def test_flight(at):
    """Free bodies keep the velocity of their nodes, which the mesh file contains."""
    velocity = np.array([2.0, -3.0, 4.0])
    for kind in KINDS[:1] + KINDS[-1:]:
        model = Model(at, ball_in_matrix(), kind, ["ball", "matrix"], velocity=velocity)
        with open(model.deck, "w", encoding="ascii") as file:
            file.write("*INCLUDE, INPUT=mesh.inp\n*MATERIAL, NAME=M\n*ELASTIC\n1000, 0.3\n"
                       "*DENSITY\n1\n*SOLID SECTION, ELSET=EALL, MATERIAL=M\n"
                       "*STEP\n*DYNAMIC, DIRECT\n0.05, 0.1\n"
                       "*NODE PRINT, NSET=NALL, FREQUENCY=2\nU\n*END STEP\n")
        calculix.run(model.deck, seconds=SECONDS)
        moved = calculix.read_results(model.deck).displacements
        assert len(moved) == len(model.points) and np.allclose(
            moved, 0.1 * velocity, rtol=1e-5), moved


@in_folder
def test_layers_in_series(at):
    """Two materials with equal ratio / modulus under tension have equal stress.

    Both contract equally across the load.
    """
    low = np.repeat([1.0, 0.0], N // 2)[:, None, None] * np.ones((N, N, N))
    for kind in KINDS:
        # A smoothed interface of tetrahedra deviates from its plane
        # by up to 2e-3 of a cell, which would change the stress.
        model = Model(at, producer(image({"low": low, "high": 1 - low})), kind, ["low", "high"],
                      **({} if kind == "Hex" else {"Smoothing": "Off"}))
        results = model.solve({"LOW": (1000.0, 0.15), "HIGH": (2000.0, 0.3)},
                              [("Z_MIN", 3, 3, 0), ("X_MIN", 1, 1, 0), ("Y_MIN", 2, 2, 0)],
                              pressures=[("Z_MAX", -PRESSURE)], reactions=["Z_MIN"])
        assert model.deviation("layers in series", results.stresses,
                               [0, 0, PRESSURE, 0, 0, 0]) <= LIMIT
        size = np.ptp(model.points, axis=0)
        assert np.allclose(results.reactions["Z_MIN"], [0, 0, -PRESSURE * size[0] * size[1]],
                           rtol=1e-6, atol=1e-6)
        strains = PRESSURE / np.array([1000.0, 2000.0])
        assert np.isclose(results.displacements[:, 2].max(), size[2] / 2 * strains.sum(), rtol=1e-6)


@in_folder
def test_names(at):
    """Names of maximum length and of domain sides: ccx confuses no sets and loses no load."""
    low = np.repeat([1.0, 0.0], 2)[:, None, None] * np.ones((4, 4, 4))
    arrays = ["z max", "y" * 90]
    model = Model(at, producer(image({arrays[0]: low, arrays[1]: 1 - low})), "Hex", arrays)
    sets = [name for name in model.file.element_sets if name != "EALL"]
    assert sets == ["Z_MAX_2", "Y" * 80] and "Z_MAX" in model.file.surfaces
    results = model.solve({name: (1000.0, 0.0) for name in sets}, [("Z_MIN", 1, 3, 0)],
                          pressures=[("Z_MAX", -PRESSURE)])
    assert model.deviation("names", results.stresses, [0, 0, PRESSURE, 0, 0, 0]) <= LIMIT


def hold(points):
    """Returns supports of three nodes that prevent rigid motion without reactions."""
    a, b, c = points[:, 0].argmin(), points[:, 0].argmax(), points[:, 1].argmax()
    return [(a + 1, 1, 3, 0), (b + 1, 2, 3, 0), (c + 1, 3, 3, 0)]


@in_folder
def test_ball_under_pressure(at):
    """Pressure on the whole curved surface gives the exact stress.

    Loads of ccx on bilinear faces are exact.
    """
    for kind in KINDS:
        model = Model(at, producer(image({"ball": ball_and_plate(N)[0]})), kind, ["ball"])
        results = model.solve({"BALL": (1000.0, 0.3)}, hold(model.points),
                              pressures=[("BALL_TO_VOID", PRESSURE)], reactions=["NALL"])
        assert model.deviation("ball under pressure", results.stresses,
                               [-PRESSURE] * 3 + [0] * 3) <= LIMIT
        assert abs(results.reactions["NALL"]).max() < 1e-9


@in_folder
def test_stiff_ball_in_matrix(at):
    """The reaction equals the load, and the stiff ball carries more than its share."""
    for kind in KINDS:
        model = Model(at, ball_in_matrix(), kind, ["ball", "matrix"])
        results = model.solve({"BALL": (20000.0, 0.3), "MATRIX": (2000.0, 0.3)},
                              [("Z_MIN", 1, 3, 0)],
                              pressures=[("Z_MAX", PRESSURE)], reactions=["Z_MIN"])
        size = np.ptp(model.points, axis=0)
        load = PRESSURE * size[0] * size[1]
        error = abs(results.reactions["Z_MIN"] - [0, 0, load]).max() / load
        stress = results.stresses.mean(axis=1)[:, 2]
        ball = stress[np.array(model.file.element_sets["BALL"]) - 1].mean()
        print("  %-24s %-8s reaction off by %.1e, mean stress of the ball %.2f of %.2f"
              % ("stiff ball in matrix", kind, error, ball, -PRESSURE))
        assert error <= LIMIT and ball < -1.1 * PRESSURE


def pressure_inside(radius, outer, inside, outside, pressure):
    """Returns the pressure of a ball in a loaded shell (Lame): u = C r + D / r^2 in the shell."""
    bulk, shear = ([f(*material) for material in (inside, outside)] for f in (
        lambda e, nu: e / (3 - 6 * nu), lambda e, nu: e / (2 + 2 * nu)))
    rows = [[3 * bulk[1], -4 * shear[1] / outer ** 3, 0],
            [3 * bulk[1], -4 * shear[1] / radius ** 3, 1],
            [radius, radius ** -2, radius / (3 * bulk[0])]]  # unknowns: C, D, pressure inside
    return np.linalg.solve(rows, [-pressure, 0, 0])[2]


@in_folder
def test_ball_in_shell(at):
    """The solution converges to the exact one for curved interfaces."""
    inside, outside = (20000.0, 0.3), (2000.0, 0.2)
    exact = pressure_inside(0.5, 0.9, inside, outside, PRESSURE)
    for kind in ("Hex", "Lattice"):
        errors = []
        for cells in (8, 16):
            field = VolumeFractionShapes(
                Shapes="sphere radius=0.5 material=1; sphere radius=0.9 material=2",
                Dimensions=[cells] * 3)
            model = Model(at, field, kind, ["Material1", "Material2"])
            results = model.solve({"MATERIAL1": inside, "MATERIAL2": outside}, hold(model.points),
                                  pressures=[("MATERIAL2_TO_VOID", PRESSURE)])
            ball = results.stresses[np.array(model.file.element_sets["MATERIAL1"]) - 1]
            errors.append(np.sqrt(np.mean((ball - np.array([-exact] * 3 + [0] * 3)) ** 2)) / exact)
        print("  %-24s %-8s exact pressure in the ball %.4f, stress there off by %s (rms)" % (
            "ball in shell", kind, exact, ", ".join("%.2g %%" % (100 * e) for e in errors)))
        assert errors[1] < 0.6 * errors[0] and errors[1] < 0.03


main(globals())
