"""Tests that arrays are used as what they hold: masks, labels, grey values, label 0."""

import warnings

import numpy as np
import pytest

import volume_fraction_mesh as vfm
from fields import BALL, LABELS, PLATE, same
from images import two_boxes
from test_read import check_boxes, volumes
from volume_fraction_mesh.__main__ import main

LIVER, SPLEEN = two_boxes(1, 0), two_boxes(0, 1)
TYPES = [bool, np.uint8, np.int8, np.uint16, np.int32, np.int64, np.float32, np.float64]


@pytest.mark.parametrize("kind", TYPES)
def test_masks(kind):
    """Arrays of 0 and 1 of any type are masks: 1 is full."""
    masks = {"liver": LIVER.astype(kind), "spleen": SPLEEN.astype(kind)}
    for given in (masks, list(masks.values())):
        mesh = vfm.hexes(given)
        check_boxes(mesh)
    assert vfm.hexes(masks).materials["Name"] == ["liver", "spleen"]
    for one in (masks["liver"], [masks["liver"]], {"liver": masks["liver"]}):
        mesh = vfm.hexes(one)
        assert volumes(mesh).keys() == {1} and np.isclose(volumes(mesh)[1], 240)
    assert mesh.materials["Name"] == ["liver"]
    assert vfm.hexes(masks["liver"], names=["organ"]).materials["Name"] == ["organ"]


def test_masks_of_images(tmp_path):
    nibabel = pytest.importorskip("nibabel")
    sitk = pytest.importorskip("SimpleITK")
    pyvista = pytest.importorskip("pyvista")
    images = {}
    for name, mask in (("liver", LIVER), ("spleen", SPLEEN)):
        nibabel.save(nibabel.Nifti1Image(mask, np.eye(4)), tmp_path / (name + ".nii.gz"))
        grid = pyvista.ImageData(dimensions=[n + 1 for n in mask.shape])
        grid.cell_data["mask"] = mask.ravel(order="F")
        images[name] = (nibabel.load(tmp_path / (name + ".nii.gz")),
                        sitk.GetImageFromArray(mask.transpose(2, 1, 0)), grid,
                        vfm.read(tmp_path / (name + ".nii.gz")))
    for liver, spleen in zip(images["liver"], images["spleen"]):
        mesh = vfm.hexes({"liver": liver, "spleen": spleen})
        check_boxes(mesh)
        assert mesh.materials["Name"] == ["liver", "spleen"]


@pytest.mark.parametrize("points", [False, True])
def test_masks_in_a_file_of_vtk(tmp_path, points):
    pyvista = pytest.importorskip("pyvista")
    grid = pyvista.ImageData(dimensions=[n + (not points) for n in LIVER.shape])
    data = grid.point_data if points else grid.cell_data
    data["liver"], data["spleen"] = LIVER.ravel(order="F"), SPLEEN.ravel(order="F")
    grid.save(tmp_path / "a.vti")
    mesh = vfm.hexes(vfm.read(tmp_path / "a.vti"))
    check_boxes(mesh)
    assert mesh.materials["Name"] == ["liver", "spleen"]


@pytest.mark.parametrize("kind", [np.uint8, np.int16, np.uint32, np.int64])
def test_one_array_of_integers_is_labels(kind):
    labels = two_boxes(3, 29, kind)
    mesh = vfm.hexes(labels)
    check_boxes(mesh, (3, 29))
    assert same(mesh, vfm.hexes(labels=labels))
    assert vfm.hexes(labels, names={3: "a"}).materials["Name"] == ["a", "Material 29"]


def test_bytes_up_to_255_are_fractions():
    scaled = np.round(255 * BALL).astype(np.uint8)
    mesh = vfm.hexes(scaled)
    assert np.isclose(mesh.materials["MeshVolume"][0], (scaled / 255.0).sum(), rtol=1e-6)


def test_bytes_that_may_be_both(tmp_path):
    """Bytes above 127 of which none is 255 are labels or fractions: the user has to tell."""
    labels = two_boxes(100, 200)
    np.savez(tmp_path / "a.npz", tissue=labels)
    for given in (labels, {"tissue": labels}, vfm.read(tmp_path / "a.npz")):
        with pytest.raises(ValueError, match="Labels or volume fractions: .*up to 200.*labels="):
            vfm.hexes(given)
    check_boxes(vfm.hexes(labels=labels), (100, 200))
    assert len(vfm.hexes(labels / 255.0)) > 0


def test_bytes_of_a_numpy_file(tmp_path):
    """A .npy is an image of voxels: its bytes are labels; several masks of 255 are materials."""
    np.save(tmp_path / "a.npy", two_boxes(100, 200))
    check_boxes(vfm.hexes(vfm.read(tmp_path / "a.npy")), (100, 200))
    np.save(tmp_path / "a.npy", two_boxes(3, 255))
    check_boxes(vfm.hexes(vfm.read(tmp_path / "a.npy")), (3, 255))
    np.save(tmp_path / "a.npy", 255 * LIVER)
    np.save(tmp_path / "b.npy", 255 * SPLEEN)
    assert volumes(vfm.hexes(vfm.read(tmp_path / "a.npy"))).keys() == {255}
    check_boxes(vfm.hexes({"liver": vfm.read(tmp_path / "a.npy"),
                           "spleen": vfm.read(tmp_path / "b.npy")}))
    np.save(tmp_path / "a.npy", 255 * np.stack([LIVER, SPLEEN]))
    check_boxes(vfm.hexes(vfm.read(tmp_path / "a.npy")))


def test_grey_bytes_in_a_file_of_vtk(tmp_path):
    """Bytes of which most are neither 0 nor 255 are grey values, not fractions of 255."""
    pyvista = pytest.importorskip("pyvista")
    grey = grey_ball()
    grey[0, 0, 0] = 255
    grid = pyvista.ImageData(dimensions=[n + 1 for n in grey.shape])
    grid.cell_data["scan"] = grey.ravel(order="F")
    grid.save(tmp_path / "a.vti")
    arrays = vfm.read(tmp_path / "a.vti")
    with pytest.raises(ValueError, match="'scan' looks like grey values.*hreshold"):
        vfm.hexes(arrays)
    with pytest.warns(vfm.VolumeFractionMeshWarning, match="'scan' looks like grey values"):
        vfm.hexes(arrays, arrays=["scan"])
    assert len(vfm.hexes(arrays, threshold=128)) > 0


@pytest.mark.parametrize("given, text", [
    ([LIVER * 100, SPLEEN], "(integers from 0 to 100)"),
    ([two_boxes(1, 2), SPLEEN], "(integers from 0 to 2)"),
    ({"a": LIVER.astype(int) * 7, "b": SPLEEN}, "'a' (integers from 0 to 7)"),
])
def test_integers_that_are_neither(given, text):
    with pytest.raises(ValueError) as told:
        vfm.hexes(given)
    assert text in str(told.value) and "labels=" in str(told.value), str(told.value)


def test_labels_near_integers():
    labels = two_boxes(1, 2, np.float64)
    for scale in (0.99999999977, 1.0004, 0.9996):
        check_boxes(vfm.hexes(labels=labels * scale))
        check_boxes(vfm.hexes(labels * scale))
    with pytest.raises(ValueError, match="holds 1.01 .*ids are integers"):
        vfm.hexes(labels=labels * 1.01)
    check_boxes(vfm.hexes(two_boxes(17, 53, np.float32)), (17, 53))


def zero_based():
    """Returns grains 0, 1 and 2 that fill a box of 16^3 cells."""
    i = np.indices((16, 16, 16))
    return np.where(i[0] < 8, 0, np.where(i[1] < 8, 1, 2)).astype(np.int32)


def test_zero_label(tmp_path, capsys):
    ids = zero_based()
    with pytest.warns(vfm.VolumeFractionMeshWarning, match="0.*50 %"):
        assert len(volumes(vfm.hexes(labels=ids))) == 2
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        mesh = vfm.hexes(ids, zero_label="material", names={0: "steel", 1: "copper"})
        vfm.hexes(labels=two_boxes())
    found = dict(zip(mesh.materials["Name"], mesh.materials["MeshVolume"]))
    print(found)
    assert np.isclose(found["steel"], 2048) and np.isclose(found["copper"], 1024)
    np.save(tmp_path / "a.npy", ids)
    out = str(tmp_path / "a.vtk")
    assert main([str(tmp_path / "a.npy"), out, "--quiet"]) == 0
    told = capsys.readouterr().err
    assert told.startswith("warning: ") and "50 %" in told
    assert main([str(tmp_path / "a.npy"), out, "--zero-label", "material"]) == 0
    assert "3 materials" in capsys.readouterr().out


def grey_ball():
    """Returns a ball above 128 in a grey image with noise."""
    distance = np.sqrt(((np.indices((24, 24, 24)) - 11.5) ** 2).sum(axis=0))
    values = 40 + 160 / (1 + np.exp((distance - 8) / 0.7))
    values += np.random.default_rng(1).normal(0, 6, values.shape)
    return np.clip(values, 0, 255).astype(np.uint8)


def test_grey_values(tmp_path, capsys):
    tifffile = pytest.importorskip("tifffile")
    grey = grey_ball()
    tifffile.imwrite(tmp_path / "a.tif", grey, metadata=None)
    out = tmp_path / "a.npz"
    words = [str(tmp_path / "a.tif"), str(out), "--spacing", "1", "--quiet"]
    assert main(words) == 1 and not out.exists()
    told = capsys.readouterr().err
    print(told)
    assert told.count("\n") == 1 and "hreshold" in told
    assert main([*words, "--threshold", "128"]) == 0
    mesh = vfm.load(out)
    assert np.isclose(mesh.materials["MeshVolume"][0], (grey > 128).sum(), rtol=1e-6)
    arrays = vfm.read(tmp_path / "a.tif", spacing=1)
    assert same(vfm.hexes(arrays, threshold=128), mesh)
    assert same(vfm.hexes(labels=arrays, threshold="128"), mesh)


@pytest.mark.parametrize("threshold, ranges", [
    ((100, 150), [(100, 150)]), ((None, 60), [(-1, 60)]), ((150, None), [(150, 256)]),
    ("60:120, 120:200", [(60, 120), (120, 200)]),
    (120.5, [(120.5, 256)]),
])
@pytest.mark.parametrize("kind", [np.uint8, np.float32])
def test_threshold(threshold, ranges, kind):
    grey = grey_ball().astype(kind)
    labels = np.zeros(grey.shape, int)
    for number, (low, high) in enumerate(ranges, 1):
        labels[(grey > low) & (grey <= high)] = number
    names = {1: "bone"}
    mesh, expected = (vfm.hexes(labels=array, names=names, **given) for array, given in (
        (grey, dict(threshold=threshold)), (labels, {})))
    assert same(mesh, expected) and mesh.materials["Name"][0] == "bone"
    assert same(vfm.hexes(grey, threshold=threshold), expected)


@pytest.mark.parametrize("threshold, error", [
    ((1, 2, 3), TypeError), ([], TypeError), ((None, None), TypeError), ({}, TypeError),
    ((200, 100), ValueError), ("high", ValueError), ([(0, 10), (5, 20)], ValueError),
])
def test_wrong_threshold(threshold, error):
    with pytest.raises(error, match="(?i)threshold") as told:
        vfm.hexes(grey_ball(), threshold=threshold)
    assert str(told.value).count("\n") == 0


def test_note_of_several_choices(tmp_path):
    np.savez(tmp_path / "a.npz", ball=BALL, plate=PLATE, ids=LABELS)
    arrays = vfm.read(tmp_path / "a.npz")
    with pytest.warns(vfm.VolumeFractionMeshWarning, match="in 'ball', 'plate' .* Not used: 'ids'"):
        mesh = vfm.hexes(arrays)
    assert same(mesh, vfm.hexes([BALL, PLATE]))
    with warnings.catch_warnings():
        warnings.filterwarnings("error", "The materials are in")
        assert same(vfm.hexes(arrays, arrays=["ids"]), vfm.hexes(labels=LABELS))
