"""Tests CalculiX: heat on .inp, and pressure on the surface of each side."""

import os
import sys

import numpy as np
import pytest

from ball_in_block import SIDES, area_of, check_maximum, need_program, run_recipe

sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Examples"))
import calculix
import flat_cases as flat

OPPOSITE = dict(zip(SIDES, ("x_max", "x_min", "y_max", "y_min", "z_max", "z_min")))


@pytest.fixture(autouse=True)
def program():
    need_program("ccx", "calculix-ccx")


def test_recipe(mesh, tmp_path):
    names = run_recipe("CalculiX", mesh, tmp_path)
    assert len(names["u"]) == len(mesh.points)
    check_maximum(mesh, names["u"])


@pytest.mark.parametrize("side", SIDES)
def test_pressure(mesh, tmp_path, side):
    """The opposite side carries the pressure times the area."""
    mesh.save(tmp_path / "ball.inp")
    deck, fixed = str(tmp_path / "pressed.inp"), OPPOSITE[side].upper()
    calculix.write_deck(deck, "ball.inp", {"BALL": (10.0, 0.3), "BLOCK": (1.0, 0.3)},
                        [(fixed, 1, 3, 0.0)], [(side.upper(), 1.0)], [fixed])
    calculix.run(deck)
    force = calculix.read_results(deck).reactions[fixed]
    expected = np.zeros(3)
    expected["xyz".index(side[0])] = area_of(side) * (1 if side.endswith("max") else -1)
    assert np.allclose(force, expected, rtol=0, atol=1e-5), force


MODULUS, RATIO, TENSION = 70.0, 0.3, 2.0


@pytest.mark.parametrize("kind", ["hexes", "tets"])
@pytest.mark.parametrize("plane", ["strain", "stress"])
def test_plate_in_tension(kind, plane, tmp_path):
    """Displacements and stresses of a plate that is pulled along x are exact, because they are
    linear and constant."""
    mesh = flat.make_square(kind, 12)
    mesh.save(tmp_path / "plate.inp", plane=plane)
    deck = str(tmp_path / "pulled.inp")
    calculix.write_deck(deck, "plate.inp", {name.upper(): (MODULUS, RATIO) for name in flat.NAMES},
                        [("X_MIN", 1, 1, 0.0), ("Y_MIN", 2, 2, 0.0)], [("X_MAX", -TENSION)],
                        ["X_MIN"])
    calculix.run(deck)
    found = calculix.read_results(deck)
    along = TENSION / MODULUS * (1 - RATIO ** 2 if plane == "strain" else 1)
    across = -TENSION / MODULUS * RATIO * (1 + RATIO if plane == "strain" else 1)
    expected = mesh.points[:, :2] * [along, across]
    error = np.abs(found.displacements[:len(mesh.points), :2] - expected).max() / along
    stresses = found.stresses.reshape(-1, 6)[:, [0, 1, 2, 3]]
    exact = [TENSION, 0, RATIO * TENSION if plane == "strain" else 0, 0]
    print("%s, plane %s: error of displacements %.1e, of stresses %.1e" % (
        kind, plane, error, np.abs(stresses - exact).max() / TENSION))
    assert error < 1e-5
    assert np.allclose(stresses, exact, rtol=0, atol=1e-5 * TENSION)
    assert np.isclose(found.reactions["X_MIN"][0], -TENSION, rtol=1e-5)
