"""Tests state that is copied, and state that is conserved: elements and cells have equal sums."""

import numpy as np
import pytest

import volume_fraction_mesh as vfm
from fields import BALL, PLATE, STATE

SPACING = (0.5, 0.25, 1.0)
CELL = np.prod(SPACING)
MAKES = [vfm.hexes, vfm.tets]
FRACTIONS = {"ball": BALL, "plate": PLATE}
DENSITY, VELOCITY, ENERGY, HEAT = (STATE[name]
                                   for name in ("density", "velocity", "energy", "temperature"))
GIVEN = {"density": DENSITY, "velocity": VELOCITY, "energy": ENERGY, "spacing": SPACING}


def close(found, expected, scale):
    return np.abs(np.asarray(found) - expected).max() <= 1e-12 * scale


@pytest.mark.parametrize("make", MAKES)
@pytest.mark.parametrize("order", [1, 2])
def test_conserved(make, order):
    mesh = make(FRACTIONS, state={"T": HEAT}, state_order=order, **GIVEN)
    volumes = mesh.volumes()
    masses = volumes * mesh.state["density"]
    for label, fraction in enumerate(FRACTIONS.values(), 1):
        own, mass = mesh.material == label, fraction * CELL * DENSITY
        assert close(masses[own].sum(), mass.sum(), mass.sum())
        assert close((masses * mesh.state["T"])[own].sum(), (mass * HEAT).sum(),
                     (mass * HEAT).sum())
        momentum = np.einsum("ijk,ijkc->c", mass, VELOCITY)
        assert close(masses[own] @ mesh.state["velocity"][own], momentum,
                     np.abs(mass[..., None] * VELOCITY).sum())
        assert close((masses * mesh.state["energy"])[own].sum(), (mass * ENERGY).sum(),
                     (mass * ENERGY).sum())
        for column in ("InputMass", "MeshMass"):
            assert close(mesh.materials[column][label - 1], mass.sum(), mass.sum())


@pytest.mark.parametrize("make", MAKES)
def test_energy_is_whole(make):
    mesh = make(FRACTIONS, nodal_velocity=True, lost_kinetic_energy="internal_energy", **GIVEN)
    masses = mesh.volumes() * mesh.state["density"]
    nodal = np.zeros(len(mesh.points))
    np.add.at(nodal, mesh.cells, masses[:, None] / mesh.cells.shape[1])
    kinetic = 0.5 * (nodal * (mesh.point_state["velocity"] ** 2).sum(axis=1)).sum()
    total = sum(
        ((fraction * CELL * DENSITY) * (ENERGY + 0.5 * (VELOCITY**2).sum(axis=3))).sum()
        for fraction in FRACTIONS.values()
    )
    assert close((masses * mesh.state["energy"]).sum() + kinetic, total, total)


@pytest.mark.parametrize("make", MAKES)
def test_copied(make):
    """Elements get unchanged values of cells, of any type."""
    state = {"code": STATE["code"], "T": HEAT.astype(np.float32), "velocity": VELOCITY}
    mesh = make(FRACTIONS, state=state)
    assert mesh.state["code"].dtype == np.int16 and mesh.state["T"].dtype == np.float32
    assert set(mesh.state["code"].tolist()) <= set(STATE["code"].ravel().tolist())
    assert mesh.state["velocity"].shape == (len(mesh), 3)
    x, y = mesh.state["code"] % 100 - 50, mesh.state["code"] // 100
    centre = mesh.points[mesh.cells].mean(axis=1)
    assert np.abs(centre[:,
                         0] - x - 0.5).mean() < 0.6 and np.abs(centre[:, 1] - y - 0.5).mean() < 0.6


def test_copied_of_stair_steps():
    """Each element is a cell."""
    labels = (BALL + PLATE > 0.5).astype(int)
    mesh = vfm.hexes(labels=labels, stair_step=True, state={"T": HEAT})
    assert np.isclose(mesh.state["T"].sum(), HEAT[labels > 0].sum(), rtol=1e-13)
    cells = np.floor(mesh.points[mesh.cells].mean(axis=1)).astype(int)
    assert np.array_equal(mesh.state["T"], HEAT[tuple(cells.T)])


def test_transfer():
    assert vfm.hexes(FRACTIONS, state={"T": HEAT}, **GIVEN).materials["InputMass"].shape == (2,)
    copied = vfm.hexes(FRACTIONS, state={"T": HEAT}, state_transfer="copy", **GIVEN)
    assert "InputMass" not in copied.materials and set(copied.state) == {
        "T", "velocity", "energy", "density"}
    mesh = vfm.hexes(FRACTIONS, state={"T": HEAT}, state_transfer="conserve", spacing=SPACING)
    total = sum((fraction * HEAT).sum() for fraction in FRACTIONS.values()) * CELL
    # without a density, mass is volume
    assert np.isclose((mesh.volumes() * mesh.state["T"]).sum(), total, rtol=1e-5)


def test_kinds():
    state = {"pressure": HEAT, "charge": BALL * 3, "code": STATE["code"]}
    for kinds in ({"pressure": "volume", "charge": "extensive"},
                  ["pressure=volume", "charge=extensive"]):
        mesh = vfm.hexes(FRACTIONS, state=state, state_kinds=kinds, **GIVEN)
        total = ((BALL + PLATE) * HEAT).sum() * CELL
        assert close((mesh.volumes() * mesh.state["pressure"]).sum(), total, total)
        assert close(mesh.state["charge"].sum(), BALL.sum() * 3, BALL.sum() * 3)
        assert mesh.state["code"].dtype == np.int16


@pytest.mark.parametrize("how", ("copy", "conserve"))
def test_rotated_arrays(how):
    """Vectors and tensors along the axes of a rotated image are those in world coordinates."""
    axes = np.array([[0.48, -0.6, 0.64], [0.8, 0, -0.6], [0.36, 0.8, 0.48]])
    random = np.random.default_rng(3)
    tensor = random.random((*BALL.shape, 3, 3))
    even = tensor + tensor.swapaxes(-1, -2)

    def arrays(vector, any_tensor, symmetric):
        return {"v": vector, "t": any_tensor.reshape(*BALL.shape, 9),
                "s": symmetric[..., (0, 1, 2, 0, 1, 0), (0, 1, 2, 1, 2, 2)]}

    given = dict(direction=axes, state_transfer=how)
    names = ["v", "t", "s"]
    mesh = vfm.hexes(FRACTIONS, state=arrays(VELOCITY, tensor, even), rotated_arrays=names, **given)
    world = arrays(VELOCITY @ axes.T, axes @ tensor @ axes.T, axes @ even @ axes.T)
    expected = vfm.hexes(FRACTIONS, state=world, **given)
    assert np.array_equal(mesh.points, expected.points)
    for name in names:
        assert np.allclose(mesh.state[name], expected.state[name], rtol=0, atol=1e-13), name


def test_arrays_of_materials():
    dense = {"ball": DENSITY, "plate": 3 * DENSITY}
    mesh = vfm.hexes(FRACTIONS, density=dense, spacing=SPACING)
    again = vfm.hexes(FRACTIONS, density=[DENSITY, 3 * DENSITY], spacing=SPACING)
    assert list(mesh.state) == ["density"] and np.array_equal(
        mesh.state["density"], again.state["density"])
    masses = [(FRACTIONS[name] * dense[name]).sum() * CELL for name in FRACTIONS]
    assert np.allclose(mesh.materials["MeshMass"], masses,
                       rtol=1e-13) and mesh.roles["density"] == "density"
    both = vfm.hexes(
        FRACTIONS,
        density=dense,
        velocity=[VELOCITY, 2 * VELOCITY],
        energy={"ball": ENERGY, "plate": ENERGY},
        state={"T": [HEAT, HEAT]},
    )
    assert set(both.state) == {"T", "density", "velocity", "energy"}
    momentum = np.einsum("ijk,ijkc->c", PLATE * 3 * DENSITY, 2 * VELOCITY)
    assert np.allclose(both.materials["MeshMomentum"][1], momentum, rtol=1e-12)


def test_arrays_of_labels():
    labels = np.where(BALL > 0.5, 7, np.where(PLATE > 0.5, 3, 0))
    mesh = vfm.hexes(labels=labels, density={3: DENSITY, 7: 2 * DENSITY})
    expected = [DENSITY[labels == 3].sum(), 2 * DENSITY[labels == 7].sum()]
    assert list(mesh.state) == ["density"] and np.allclose(mesh.materials["MeshMass"], expected,
                                                           rtol=1e-13)


def test_numbers():
    """A number applies to all cells, or to all cells of a material."""
    expected = vfm.hexes(FRACTIONS, density={"ball": 0 * BALL + 2, "plate": 0 * BALL + 3})
    for order, fractions in (("xyz", FRACTIONS),
                             ("zyx", {name: array.T for name, array in FRACTIONS.items()})):
        mesh = vfm.hexes(fractions, density={"ball": 2, "plate": 3.0}, order=order)
        assert np.array_equal(mesh.state["density"], expected.state["density"])
    assert np.allclose(vfm.hexes(BALL, density=7).state["density"], 7, rtol=1e-6)
    with pytest.raises(ValueError, match="of the material 'Material 3' no array is selected"):
        vfm.hexes(labels=np.where(BALL > 0.5, 7, np.where(PLATE > 0.5, 3, 0)), density={7: 2.0})
    assert list(vfm.hexes(labels=7 * (BALL > 0.5), density={7: 2.0}).state) == ["density"]


def test_names_of_components():
    parts = {"%s velocity" % axis: VELOCITY[..., a] for a, axis in enumerate("XYZ")}
    mesh = vfm.hexes(FRACTIONS, state=parts, density=DENSITY, velocity="X velocity")
    expected = vfm.hexes(FRACTIONS, density=DENSITY, velocity=VELOCITY)
    assert (
        np.allclose(mesh.state["velocity"], expected.state["velocity"], rtol=0, atol=1e-12)
        and mesh.roles["velocity"] == "velocity"
    )


def test_orders():
    zyx = {name: array.transpose(2, 1, 0, *range(3, array.ndim)) for name, array in STATE.items()}
    mesh = vfm.hexes(
        [BALL.T, PLATE.T],
        order="zyx",
        state={"T": zyx["temperature"]},
        density=zyx["density"],
        velocity=zyx["velocity"],
    )
    expected = vfm.hexes([BALL, PLATE], state={"T": HEAT}, density=DENSITY, velocity=VELOCITY)
    for name in ("T", "density", "velocity"):
        assert np.array_equal(mesh.state[name], expected.state[name])


def test_unmeshed():
    """A warning and the table report material far from all elements of its kind."""
    fraction = np.zeros((12, 8, 8))
    fraction[:3], fraction[10, 4, 4] = 1, 0.1
    with pytest.warns(vfm.VolumeFractionMeshWarning, match="left out"):
        mesh = vfm.hexes(fraction, density=np.ones_like(fraction))
    assert np.isclose(mesh.materials["UnmeshedMass"][0], 0.1)
    assert np.isclose(mesh.materials["MeshMass"][0], 192)
