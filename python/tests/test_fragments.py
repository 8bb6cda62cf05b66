"""Tests the table of fragments."""

import numpy as np
import pytest

import volume_fraction_mesh as vfm
from fields import BALL, PLATE, STATE

TWO = vfm.shapes(
    "sphere radius=0.3 center=-0.5,0,0\nsphere radius=0.2 center=0.5,0.1,0\n"
    "halfspace point=0,0,-0.5 normal=0,0,1 material=2",
    24,
    bounds=[-1, 1] * 3,
)


@pytest.mark.parametrize("make", [vfm.hexes, vfm.tets])
def test_bodies(make):
    mesh = make(TWO)
    table = vfm.fragments(mesh)
    assert (
        table["id"].tolist() == [1, 2, 3]
        and sorted(table["material"].tolist()) == [1, 1, 2]
        and set(table["name"]) == set(TWO)
    )
    assert table["elements"].sum() == len(mesh) and "mass" not in table
    order = np.argsort(-table["volume"])
    radii = np.cbrt(table["volume"][order[1:]] * 0.75 / np.pi)
    assert np.allclose(radii, [0.3, 0.2],
                       rtol=2e-3) and np.isclose(table["volume"][order[0]], 2, rtol=1e-6)
    assert np.allclose(table["volume"], table["fraction_volume"], rtol=1e-6)
    assert np.allclose(table["centroid"][order], [[0, 0, -0.75], [-0.5, 0, 0], [0.5, 0.1, 0]],
                       atol=2e-3)
    assert np.allclose(table["bounds"][order[1]], [-0.8, -0.2, -0.3, 0.3, -0.3, 0.3], atol=0.02)
    assert all(len(ids) == 0 for ids in table["neighbours"])


def test_neighbours():
    mesh = vfm.hexes([BALL, PLATE], mesh_void=True)
    table = vfm.fragments(mesh)
    around = {
        int(m): {int(table["material"][f - 1]) for f in ids}
        for m, ids in zip(table["material"], table["neighbours"])
    }
    assert around == {0: {1, 2}, 1: {0, 2},
                      2: {0, 1}} and table["name"][int(np.argmin(table["material"]))] == "Void"


def test_mass_and_momentum():
    mesh = vfm.hexes(
        [BALL, PLATE], density=STATE["density"], velocity=STATE["velocity"],
        state={"T": STATE["temperature"]}
    )
    table = vfm.fragments(mesh)
    for fraction, row in zip((BALL, PLATE), np.argsort(table["material"])):
        mass = fraction * STATE["density"]
        assert np.isclose(table["mass"][row], mass.sum(), rtol=1e-12)
        assert np.allclose(table["momentum"][row],
                           np.einsum("ijk,ijkc->c", mass, STATE["velocity"]), rtol=1e-10)
    assert np.isclose(vfm.fragments(mesh, density="T")["mass"].sum(),
                      (mesh.volumes() * mesh.state["T"]).sum())
    with pytest.raises(KeyError, match="no array 'weight'. Its state: 'T', 'density', 'velocity'"):
        vfm.fragments(mesh, density="weight")


def test_empty():
    with pytest.warns(vfm.VolumeFractionMeshWarning):
        table = vfm.fragments(vfm.hexes(np.zeros((5, 5, 5))))
    assert all(len(column) == 0 for column in table.values())
