"""CalculiX solves a ball in a shell under pressure on second-order elements (C3D20, C3D20R, C3D10).

The exact displacement is that of Lame. Prints its error on linear and second-order elements.
"""
import os
import sys

import numpy as np
from paraview import simple

from vfmtest import (
    in_folder, main, VolumeFractionShapes, VolumeFractionToHex, VolumeFractionToTet)

sys.path.insert(0,
                os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..",
                             "Examples"))
import calculix

RADII, PRESSURE = (0.45, 0.8), 9.5  # the shell does not touch the sides of the domain
MATERIALS = {"MATERIAL1": (20000.0, 0.3), "MATERIAL2": (2000.0, 0.2)}  # ball, shell
CELLS = (6, 12)


def exact_displacement(points):
    """Returns u = A r in the ball, and u = C r + D / r^2 in the shell, along the radius."""
    (inner, outer), (ball, shell) = RADII, MATERIALS.values()
    bulk, shear = ([f(*material) for material in (ball, shell)] for f in (
        lambda e, nu: e / (3 - 6 * nu), lambda e, nu: e / (2 + 2 * nu)))
    rows = [[0, 3 * bulk[1], -4 * shear[1] / outer ** 3],
            [-3 * bulk[0], 3 * bulk[1], -4 * shear[1] / inner ** 3],
            [-inner, inner, inner ** -2]]
    a, c, d = np.linalg.solve(rows, [-PRESSURE, 0, 0])
    r = np.linalg.norm(points, axis=1)[:, None]
    return np.where(r < inner, a, c + d / np.maximum(r, 1e-9) ** 3) * points


def without_motion(points, difference):
    """Removes the rigid motion that fits best."""
    x, y, z = points.T
    o, i = np.zeros(len(points)), np.ones(len(points))
    motions = np.stack([np.stack(m, 1).ravel() for m in (
        (i, o, o), (o, i, o), (o, o, i), (o, -z, y), (z, o, -x), (-y, x, o))], 1)
    factors = np.linalg.lstsq(motions, difference.ravel(), rcond=None)[0]
    return difference - (motions @ factors).reshape(-1, 3)


def read_nodes(path):
    with open(path, encoding="ascii") as file:
        lines = file.read().split("*ELEMENT")[0].split("*NODE")[1].split("\n")[1:-1]
    return np.array([line.split(",")[1:] for line in lines], float)


def solve(at, cells, of_tets, order, reduced=False):
    """Returns the relative rms error of the displacement of the nodes."""
    field = VolumeFractionShapes(
        Shapes="sphere radius=%g material=1; sphere radius=%g material=2" % RADII,
        Dimensions=[cells] * 3)
    arrays = ["Material1", "Material2"]
    mesher = (VolumeFractionToTet(Input=field, VolumeFractionArrays=arrays, Method="Lattice",
                                  ElementOrder=order) if of_tets else
              VolumeFractionToHex(Input=field, VolumeFractionArrays=arrays, ElementOrder=order))
    more = {"ReducedIntegration": 1} if reduced else {}
    simple.SaveData(at("mesh.inp"), proxy=mesher, **more)
    points = read_nodes(at("mesh.inp"))
    a, b, c = points[:, 0].argmin(), points[:, 0].argmax(), points[:, 1].argmax()
    calculix.write_deck(
        at("deck.inp"), at("mesh.inp"), MATERIALS,
        [(a + 1, 1, 3, 0), (b + 1, 2, 3, 0), (c + 1, 3, 3, 0)],
        pressures=[("MATERIAL2_TO_VOID", PRESSURE)])
    calculix.run(at("deck.inp"), seconds=300)
    found = calculix.read_results(at("deck.inp")).displacements
    exact = exact_displacement(points)
    error = without_motion(points, found - exact)
    return np.sqrt((error ** 2).sum() / (exact ** 2).sum())


@in_folder
def test_ball_in_shell(at):
    errors = {}
    for name, of_tets, kind, reduced in (
            ("C3D8", False, "Linear", False), ("C3D20", False, "Quadratic", False),
            ("C3D20R", False, "Quadratic", True), ("C3D4", True, "Linear", False),
            ("C3D10", True, "Quadratic", False)):
        errors[name] = [solve(at, cells, of_tets, kind, reduced) for cells in CELLS]
        order = np.log2(errors[name][0] / errors[name][1])
        print("  ball in shell, %-6s error of the displacement %.2e, %.2e for %d^3, %d^3 cells: "
              "order %.1f" % (name, *errors[name], *CELLS, order), flush=True)
    for curved, linear in (("C3D20", "C3D8"), ("C3D20R", "C3D8"), ("C3D10", "C3D4")):
        assert errors[curved][1] < 0.25 * errors[linear][1], (curved, errors)
        assert errors[curved][1] < 0.4 * errors[curved][0], (curved, errors)


main(globals())
