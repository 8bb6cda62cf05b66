"""Volume fractions of level sets, and meshes of them."""

import numpy as np
import pytest
import volume_fraction_mesh as vfm

CELLS = 24
GRID = dict(spacing=2 / CELLS, origin=(-1, -1, -1))


def centres():
    return np.meshgrid(*[(np.arange(CELLS) + 0.5) * 2 / CELLS - 1] * 3, indexing="ij")


def radius():
    return np.sqrt(sum(x**2 for x in centres()))


def volumes(fractions):
    return [array.sum() * (2 / CELLS) ** 3 for array in fractions.values()]


def ball(r):
    return 4 / 3 * np.pi * r**3


def test_films_wrap_each_other():
    radii = (0.5, 0.52, 0.7)
    found = vfm.level_set({"r%g" % r: radius() - r for r in radii}, **GRID)
    assert list(found) == ["r0.5", "r0.52", "r0.7"]
    np.testing.assert_allclose(volumes(found), np.diff([0, *map(ball, radii)]), rtol=1e-3)
    assert all(array.shape == (CELLS,) * 3 for array in found.values())


def test_planes_are_exact():
    x, y, z = centres()
    found = vfm.level_set(0.3 * x + 0.4 * y + z - 0.1, **GRID)
    assert abs(sum(volumes(found)) - 4.4) < 1e-12  # the plane z = 0.1 on average


def test_order_and_sign():
    x, _, z = centres()
    phi = x + 0.5 * z - 0.31
    expected = vfm.level_set(phi, **GRID)["Material 1"]
    turned = vfm.level_set(-phi.transpose(2, 1, 0), order="zyx", inside="positive", **GRID)
    assert np.array_equal(turned["Material 1"].transpose(2, 1, 0), expected)


def test_lowest_and_fill():
    x = centres()[0]
    phases = {"left": x + 0.2, "right": 0.2 - x}  # overlap from -0.2 to 0.2: none there
    assert abs(volumes(vfm.level_set(phases, rule="lowest", **GRID))[0] - 3.2) < 1e-12
    assert np.allclose(volumes(vfm.level_set(phases, rule="fill", **GRID)), [4, 4], atol=1e-12)


def test_same_mesh_as_option():
    phi = {"ball": radius() - 0.6, "film": radius() - 0.63}
    expected = vfm.hexes(vfm.level_set(phi, **GRID))
    mesh = vfm.hexes(phi, level_sets="priority", **GRID)
    assert np.array_equal(mesh.points, expected.points)
    assert np.array_equal(mesh.material, expected.material)
    assert mesh.materials["Name"] == ["ball", "film"]
    found = np.array(mesh.materials["TargetVolume"])
    np.testing.assert_allclose(found, [ball(0.6), ball(0.63) - ball(0.6)], rtol=1e-3)


@pytest.mark.parametrize("call, error, words", [
    (lambda: vfm.hexes(radius() - 0.6), ValueError, "LevelSets Priority"),
    (lambda: vfm.level_set(radius() + 1), ValueError, "LevelSetInside Positive"),
    (lambda: vfm.level_set(radius() - 0.6, rule="first"), ValueError, "(?i)LevelSets"),
    (lambda: vfm.level_set((radius() * 10).astype(np.int32) + 1), ValueError, "integers"),
])
def test_wrong_input(call, error, words):
    with pytest.raises(error, match=words):
        call()
