"""Tests that images define the grid, and give the same meshes as arrays."""

import numpy as np
import pytest

import volume_fraction_mesh as vfm
from fields import BALL, LABELS, N, PLATE, STATE, check_valid, graded, same

SPACING, ORIGIN = (0.25, 0.5, 0.25), (-1.0, 0.5, 2.0)
TURN = np.array([[0.6, -0.8, 0], [0.8, 0.6, 0], [0, 0, 1.0]])
PLAIN = vfm.hexes([BALL, PLATE], spacing=SPACING, origin=ORIGIN)


def cell_image(pyvista, **given):
    image = pyvista.ImageData(dimensions=(N + 1,) * 3, spacing=SPACING, origin=ORIGIN, **given)
    for name, array in (
        ("ball", BALL),
        ("plate", PLATE),
        ("id", LABELS),
        ("density", STATE["density"]),
        ("T", STATE["temperature"]),
    ):
        image.cell_data[name] = array.ravel("F")
    image.cell_data["velocity"] = STATE["velocity"].reshape(-1, 3, order="F")
    return image


def point_image(pyvista, **given):
    """Makes an image whose points are the centres of the same cells."""
    first = [o + s / 2 for o, s in zip(ORIGIN, SPACING)]
    image = pyvista.ImageData(dimensions=(N,) * 3, spacing=SPACING, origin=first, **given)
    for name, array in (("ball", BALL), ("plate", PLATE), ("id", LABELS)):
        image.point_data[name] = array.ravel("F")
    return image


def test_pyvista_cells():
    pyvista = pytest.importorskip("pyvista")
    image = cell_image(pyvista)
    mesh = vfm.hexes(image, arrays=["ball", "plate"])
    assert same(mesh, PLAIN) and mesh.materials["Name"] == ["ball", "plate"]
    assert vfm.hexes(image, arrays=["ball", "plate"],
                     names=["a", "b"]).materials["Name"] == ["a", "b"]
    assert same(vfm.hexes(labels=image, arrays=["id"]),
                vfm.hexes(labels=LABELS, spacing=SPACING, origin=ORIGIN))
    image.set_active_scalars("plate")
    assert vfm.hexes(image).materials["Name"] == ["plate"]
    with pytest.raises(ValueError, match="no numeric cell array 'foam'. Its cell arrays: .*'ball'"):
        vfm.hexes(image, arrays=["foam"])
    with pytest.raises(TypeError, match="spacing cannot be given too: the image or file defines"):
        vfm.hexes(image, spacing=2)
    assert same(vfm.hexes(image, arrays=["id"]),
                vfm.hexes(labels=LABELS, spacing=SPACING, origin=ORIGIN))


def test_pyvista_state():
    pyvista = pytest.importorskip("pyvista")
    image = cell_image(pyvista)
    mesh = vfm.hexes(image, arrays=["ball", "plate"], state=["T"], density="density",
                     velocity="velocity")
    arrays = vfm.hexes(
        [BALL, PLATE],
        spacing=SPACING,
        origin=ORIGIN,
        state={"T": STATE["temperature"]},
        density=STATE["density"],
        velocity=STATE["velocity"],
    )
    assert list(mesh.state) == list(arrays.state) == ["T", "density", "velocity"]
    assert all(np.array_equal(mesh.state[name], arrays.state[name]) for name in mesh.state)
    assert mesh.roles == arrays.roles == {"density": "density", "velocity": "velocity"}
    given = vfm.hexes(image, arrays=["ball"],
                      state={"new": STATE["temperature"].transpose(2, 1, 0)})
    assert "new" in given.state


def test_pyvista_points():
    pyvista = pytest.importorskip("pyvista")
    image = point_image(pyvista)
    mesh = vfm.hexes(image, arrays=["ball", "plate"])
    assert np.allclose(mesh.points, PLAIN.points,
                       atol=1e-12) and np.array_equal(mesh.cells, PLAIN.cells)
    image.set_active_scalars("id")
    assert len(vfm.hexes(labels=image))
    image.point_data["bad"] = np.full(N**3, 2.5)
    with pytest.raises(ValueError, match="'bad' holds 2.5 in"):
        vfm.hexes(image, arrays=["bad"])


def test_pyvista_extent_and_direction():
    pyvista = pytest.importorskip("pyvista")
    image = cell_image(pyvista)
    image.SetExtent(2, N + 2, -1, N - 1, 0, N)
    shifted = vfm.hexes(image, arrays=["ball", "plate"])
    assert np.allclose(shifted.points, PLAIN.points + [2 * SPACING[0], -SPACING[1], 0], atol=1e-12)
    image = cell_image(pyvista, direction_matrix=TURN)
    assert same(
        vfm.hexes(image, arrays=["ball", "plate"]),
        vfm.hexes([BALL, PLATE], spacing=SPACING, origin=ORIGIN, direction=TURN),
    )


def test_pyvista_rectilinear():
    pyvista = pytest.importorskip("pyvista")
    nodes = graded(N)
    grid = pyvista.RectilinearGrid(*nodes)
    grid.cell_data["ball"] = BALL.ravel("F")
    assert same(vfm.hexes(grid), vfm.hexes(BALL, coordinates=nodes))
    grid = pyvista.RectilinearGrid(*(x[:-1] for x in nodes))
    grid.point_data["ball"] = BALL.ravel("F")
    with pytest.raises(ValueError, match="is a RectilinearGrid, and point data are chosen"):
        vfm.hexes(grid, arrays=["ball"])


def test_pyvista_images_that_are_refused():
    pyvista = pytest.importorskip("pyvista")
    flat = pyvista.ImageData(dimensions=(4, 4, 1))
    flat.cell_data["a"] = np.ones(9)
    with pytest.raises(ValueError, match="no cells along z"):
        vfm.hexes(flat)
    blanked = cell_image(pyvista)
    blanked.cell_data["vtkGhostType"] = np.full(N**3, 32, np.uint8)
    with pytest.raises(ValueError, match="ghost or blanked"):
        vfm.hexes(blanked, arrays=["ball"])
    with pytest.raises(ValueError, match="The ImageData has no arrays"):
        vfm.hexes(pyvista.ImageData(dimensions=(4, 4, 4)))
    with pytest.raises(TypeError, match="it must be a list of names"):
        vfm.hexes(cell_image(pyvista), arrays="ball")


def test_nibabel():
    nibabel = pytest.importorskip("nibabel")
    affine = np.eye(4)
    affine[:3, :3] = TURN * SPACING
    affine[:3, 3] = ORIGIN
    mesh = vfm.hexes(labels=nibabel.Nifti1Image(LABELS.astype(np.int16), affine), names={1: "ball"})
    check_valid(mesh)
    nodes = [(np.arange(N + 1) - 0.5) * s + o for o, s in zip(ORIGIN, SPACING)]
    plain = vfm.hexes(labels=LABELS, coordinates=nodes)
    assert (
        np.allclose(mesh.points, (plain.points - ORIGIN) @ TURN.T + ORIGIN, atol=1e-6)
        and mesh.materials["Name"][0] == "ball"
    )
    centre = np.array(np.nonzero(LABELS == 1)).mean(axis=1)
    volumes = mesh.volumes() * (mesh.material == 1)
    found = (mesh.points[mesh.cells].mean(axis=1) * volumes[:, None]).sum(axis=0) / volumes.sum()
    assert np.allclose(found, affine[:3, :3] @ centre + affine[:3, 3], atol=0.05)
    flipped = affine @ np.diag([-1, 1, 1, 1])
    check_valid(vfm.hexes(labels=nibabel.Nifti1Image(LABELS.astype(np.int16), flipped)))


def test_nibabel_fractions(tmp_path):
    nibabel = pytest.importorskip("nibabel")
    both = np.stack([BALL, PLATE], axis=3).astype(np.float32)
    nibabel.save(nibabel.Nifti1Image(both, np.diag([0.5, 0.5, 0.5, 1])), tmp_path / "both.nii.gz")
    mesh = vfm.hexes(nibabel.load(tmp_path / "both.nii.gz"))
    nodes = [(np.arange(N + 1) - 0.5) * 0.5] * 3
    assert same(mesh,
                vfm.hexes([BALL.astype(np.float32), PLATE.astype(np.float32)], coordinates=nodes))
    images = [nibabel.Nifti1Image(array, np.eye(4)) for array in (BALL, PLATE)]
    assert vfm.hexes(dict(zip("ab", images))).materials["Name"] == ["a", "b"]
    with pytest.raises(ValueError, match="'a' and 'b' lie on different grids"):
        vfm.hexes({"a": images[0], "b": nibabel.Nifti1Image(PLATE, 2 * np.eye(4))})
    with pytest.raises(TypeError, match="not an image of one array"):
        vfm.hexes({"a": images[0], "b": PLATE})
    sheared = np.eye(4)
    sheared[0, 1] = 0.3
    with pytest.raises(ValueError, match="sheared or scaled"):
        vfm.hexes(nibabel.Nifti1Image(BALL, sheared))
    with pytest.raises(ValueError, match="no names of arrays"):
        vfm.hexes(images[0], arrays=["ball"])


def test_simpleitk():
    sitk = pytest.importorskip("SimpleITK")
    image = sitk.GetImageFromArray(LABELS.transpose(2, 1, 0).astype(np.uint8))
    image.SetSpacing(SPACING)
    image.SetOrigin(ORIGIN)
    nodes = [o - 0.5 * s + np.arange(N + 1) * s for o, s in zip(ORIGIN, SPACING)]
    assert same(vfm.hexes(labels=image), vfm.hexes(labels=LABELS, coordinates=nodes))
    image.SetDirection(TURN.ravel().tolist())
    turned = vfm.hexes(labels=image)
    plain = vfm.hexes(labels=LABELS, coordinates=nodes)
    assert np.allclose(turned.points, (plain.points - ORIGIN) @ TURN.T + ORIGIN, atol=1e-12)
    both = sitk.GetImageFromArray(np.stack([BALL, PLATE], axis=3).transpose(2, 1, 0, 3),
                                  isVector=True)
    assert len(vfm.hexes(both).materials["Name"]) == 2
    flat = image[:, :, 6]
    flat.SetDirection(np.eye(2).ravel().tolist())
    layer = vfm.hexes(labels=flat)
    assert np.isclose(np.ptp(layer.points[:, 2]), SPACING[0])
