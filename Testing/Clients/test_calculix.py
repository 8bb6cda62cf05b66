"""Tests CalculiX: heat on .inp, and pressure on the surface of each side."""

import os
import sys

import numpy as np
import pytest

from ball_in_block import SIDES, area_of, check_maximum, need_program, run_recipe

sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Examples"))
import calculix

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
