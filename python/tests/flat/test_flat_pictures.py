"""Pictures of one slice become meshes of a plane by themselves; other layers of cells by flat."""

import numpy as np
import pytest

import volume_fraction_mesh as vfm
from volume_fraction_mesh.__main__ import main

PICTURE = np.zeros((14, 18), np.uint8)  # a[y, x]
PICTURE[2:11, 3:9], PICTURE[2:11, 9:15] = 1, 2
AREA = 54


def write_pictures(folder):
    """Returns the paths of the picture in several formats."""
    image, tifffile = pytest.importorskip("PIL.Image"), pytest.importorskip("tifffile")
    paths = [folder / name for name in ("a.png", "a.bmp", "b.tif", "slice_1.tif")]
    for path in paths[:2]:
        image.fromarray(PICTURE).save(path)
    for path in paths[2:]:
        tifffile.imwrite(path, PICTURE, metadata=None)
    return paths


def check(mesh):
    assert mesh.is_flat and mesh.kind in ("quad", "triangle")
    np.testing.assert_allclose(mesh.materials["MeshVolume"], AREA, rtol=1e-6)
    np.testing.assert_allclose(
        np.bincount(mesh.material, mesh.volumes())[1:], AREA, rtol=1e-6)


def test_one_picture_is_a_plane(tmp_path):
    for path in write_pictures(tmp_path):
        arrays = vfm.read(path)
        assert arrays.is_picture
        check(vfm.hexes(arrays))
        check(vfm.tets(labels=arrays))
    check(vfm.hexes(labels=vfm.read([path])))


def test_jpeg_is_a_plane(tmp_path):
    image = pytest.importorskip("PIL.Image")
    image.fromarray(np.where(PICTURE > 0, 255, 0).astype(np.uint8)).resize(
        (72, 56), image.NEAREST).save(tmp_path / "a.jpg", quality=95)
    mesh = vfm.hexes(vfm.read(tmp_path / "a.jpg"), threshold=(128, None))
    assert mesh.is_flat
    np.testing.assert_allclose(mesh.volumes().sum(), 2 * AREA * 16, rtol=1e-6)


def test_layers_of_solid_elements_of_pictures(tmp_path):
    path = write_pictures(tmp_path)[0]
    arrays = vfm.read(path)
    arrays.is_picture = False
    mesh = vfm.hexes(arrays)
    assert mesh.kind == "hexahedron" and mesh.volumes().sum() == pytest.approx(2 * AREA)
    assert vfm.hexes(labels=vfm.read(path)["Material 1"], order="zyx").kind == "hexahedron"


def test_stacks_are_no_planes(tmp_path):
    write_pictures(tmp_path)
    tifffile = pytest.importorskip("tifffile")
    tifffile.imwrite(tmp_path / "two.tif", np.stack([PICTURE] * 3), photometric="minisblack",
                     metadata=None)
    for given in (tmp_path / "two.tif", [tmp_path / "b.tif", tmp_path / "slice_1.tif"]):
        with pytest.warns(vfm.VolumeFractionMeshWarning, match="no size of voxels"):
            arrays = vfm.read(given)
        assert not arrays.is_picture and vfm.hexes(arrays).kind == "hexahedron"


def write_layer(path):
    """Writes the picture as one layer of cells, in a format that is not one of pictures."""
    layer = PICTURE.T[:, :, None].astype(np.int32)
    if path.suffix == ".vti":
        pyvista = pytest.importorskip("pyvista")
        grid = pyvista.ImageData(dimensions=np.array(layer.shape) + 1, spacing=(0.5, 0.5, 2.0))
        grid.cell_data["FeatureIds"] = layer.ravel(order="F")
        grid.save(path)
        return
    h5py = pytest.importorskip("h5py")
    with h5py.File(path, "w") as file:
        group = file.create_group("DataContainers/EBSD")
        geometry = group.create_group("_SIMPL_GEOMETRY")
        for name, value in (("DIMENSIONS", layer.shape), ("SPACING", (0.5, 0.5, 2.0)),
                            ("ORIGIN", (0.0, 0, 0))):
            geometry[name] = np.array(value)
        group["CellData/FeatureIds"] = layer.transpose(2, 1, 0)[..., None]


@pytest.mark.parametrize("name", ["a.vti", "a.dream3d"])
def test_layers_by_name(name, tmp_path, capsys):
    write_layer(tmp_path / name)
    arrays = vfm.read(tmp_path / name)
    assert not arrays.is_picture and vfm.hexes(labels=arrays).kind == "hexahedron"
    for make in (vfm.hexes, vfm.tets):
        mesh = make(labels=arrays, flat=True)
        assert mesh.is_flat
        np.testing.assert_allclose(mesh.materials["MeshVolume"], AREA / 4, rtol=1e-6)
    assert main([str(tmp_path / name), str(tmp_path / "a.e"), "--labels", "--flat"]) == 0
    assert "quadrilaterals" in capsys.readouterr().out


@pytest.mark.parametrize("words, kind", [
    ((), "quadrilaterals"), (("--flat",), "quadrilaterals"), (("--tets",), "triangles"),
    (("--no-flat",), "hexahedra")])
def test_command(words, kind, tmp_path, capsys):
    path = write_pictures(tmp_path)[0]
    assert main([str(path), str(tmp_path / "a.vtu"), *words]) == 0
    assert kind in capsys.readouterr().out
