"""Tests materials of bins: CalculiX stretches a bar whose modulus follows the density of layers."""

import os
import sys

import numpy as np
import pytest

from ball_in_block import need_program

vfm = pytest.importorskip("volume_fraction_mesh")
sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Examples"))
import calculix

A, B = 6850.0, 1.49  # MPa, of a density in g/cm3
PRESSURE = 2.0


@pytest.fixture(autouse=True)
def program():
    need_program("ccx", "calculix-ccx")


def make_bar(kind, density, width):
    """Returns a bar along x with a layer of cells per density.

    Tetrahedra reach over the faces of cells inside of a material, so each layer is a material.
    """
    shape = (len(density), 3, 4)
    values = np.broadcast_to(np.asarray(density)[:, None, None], shape)
    given = dict(state={"density": values}, spacing=width)
    if kind == "hexes":
        return vfm.hexes({"bone": np.ones(shape)}, **given)
    layers = np.broadcast_to(np.arange(1, len(density) + 1)[:, None, None], shape)
    return vfm.tets(labels=layers, **given)


def stretch(mesh, tmp_path):
    """Returns the elongation under a tension, without contraction across."""
    mesh.save(tmp_path / "bar.inp")
    deck = str(tmp_path / "stretched.inp")
    calculix.write_deck(deck, "bar.inp", {}, [("X_MIN", 1, 1, 0.0), ("Y_MIN", 2, 2, 0.0),
                                              ("Z_MIN", 3, 3, 0.0)], [("X_MAX", -PRESSURE)])
    calculix.run(deck)
    moved = calculix.read_results(deck).displacements
    ends = moved[np.isclose(mesh.points[:, 0], mesh.points[:, 0].max()), 0]
    return ends.mean()


@pytest.mark.parametrize("kind", ["hexes", "tets"])
def test_series_of_springs(kind, tmp_path):
    """Each layer is a bin; the elongation is the sum over the layers."""
    density = np.array([1.75, 0.25, 1.0, 2.0, 0.5, 1.25, 0.75, 1.5])
    mesh = make_bar(kind, density, 0.5).bin_materials("density", 8, a=A, b=B, poisson=0)
    own = np.sort(density) if kind == "hexes" else density
    assert np.allclose(mesh.fields["BinMean"], own, rtol=1e-12)
    assert np.allclose(mesh.fields["BinModulus"], A * own ** B, rtol=1e-12)
    expected = PRESSURE * np.sum(0.5 / (A * density ** B))
    found = stretch(mesh, tmp_path)
    print("%s: elongation %.6e, springs %.6e" % (kind, found, expected))
    # CalculiX prints seven digits; interfaces of labels are planes to a few thousandths of a cell.
    assert abs(found / expected - 1) < (2e-6 if kind == "hexes" else 5e-5)


def test_more_bins_are_more_exact(tmp_path):
    """A modulus that grows along the bar: its elongation is an integral."""
    cells, least, most = 64, 0.4, 1.8
    density = least + (most - least) * (np.arange(cells) + 0.5) / cells
    length = cells * 0.5
    exact = PRESSURE * length / (most - least) / A * (
        least ** (1 - B) - most ** (1 - B)) / (B - 1)
    errors = []
    for count in (4, 8, 16):
        mesh = make_bar("hexes", density, 0.5).bin_materials("density", count, a=A, b=B, poisson=0)
        errors.append(abs(stretch(mesh, tmp_path) / exact - 1))
    print("relative errors of 4, 8 and 16 bins: %.2e, %.2e, %.2e" % tuple(errors))
    assert errors[0] < 0.05 and errors[2] < 0.003
    assert errors[0] > 3 * errors[1] > 9 * errors[2]
