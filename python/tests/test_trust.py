"""Tests that files outside of the folder of a header are read only if the input is trusted."""

import numpy as np
import pytest

import volume_fraction_mesh as vfm
from images import two_boxes
from volume_fraction_mesh.__main__ import main

LABELS = two_boxes()


def write_mhd(folder, outside):
    sitk = pytest.importorskip("SimpleITK")
    sitk.WriteImage(sitk.GetImageFromArray(LABELS), str(folder / "a.mhd"))
    (folder / "a.raw").replace(outside / "a.raw")
    return folder / "a.mhd", "ElementDataFile = a.raw", "ElementDataFile = "


def write_nhdr(folder, outside):
    sitk = pytest.importorskip("SimpleITK")
    sitk.WriteImage(sitk.GetImageFromArray(LABELS), str(folder / "a.nhdr"))
    (folder / "a.raw").replace(outside / "a.raw")
    return folder / "a.nhdr", "data file: a.raw", "data file: "


@pytest.mark.parametrize("write", [write_mhd, write_nhdr])
def test_data_files(tmp_path, write, capsys):
    folder = tmp_path / "in"
    folder.mkdir()
    path, old, new = write(folder, tmp_path)
    text = path.read_text()
    assert old in text, text
    path.write_text(text.replace(old, new + "../a.raw"))
    with pytest.raises(ValueError, match="outside of its folder.*trust_input=True"):
        vfm.read(path)
    assert np.array_equal(vfm.read(path, trust_input=True)["Material 1"], LABELS)
    words = [str(path), str(tmp_path / "out.vtk"), "--quiet"]
    assert main(words) == 1 and "--trust-input" in capsys.readouterr().err
    assert main([*words, "--trust-input"]) == 0
    (tmp_path / "a.raw").replace(folder / "a.raw")
    path.write_text(text)
    assert np.array_equal(vfm.read(path)["Material 1"], LABELS)


def test_pieces_of_vtk(tmp_path):
    pyvista = pytest.importorskip("pyvista")
    grid = pyvista.ImageData(dimensions=[n + 1 for n in LABELS.shape])
    grid.cell_data["id"] = LABELS.ravel(order="F")
    grid.save(tmp_path / "a.vti")
    (tmp_path / "in").mkdir()
    extent = " ".join("0 %d" % n for n in LABELS.shape)
    (tmp_path / "in" / "a.pvti").write_text(
        '<VTKFile type="PImageData" version="0.1" byte_order="LittleEndian">'
        '<PImageData WholeExtent="%s" GhostLevel="0" Origin="0 0 0" Spacing="1 1 1"><PCellData>'
        '<PDataArray type="%s" Name="id"/></PCellData><Piece Extent="%s" Source="../a.vti"/>'
        '</PImageData></VTKFile>' % (extent, "UInt8", extent))
    with pytest.raises(ValueError, match="'../a.vti', which is outside of its folder"):
        vfm.read(tmp_path / "in" / "a.pvti")
    arrays = vfm.read(tmp_path / "in" / "a.pvti", trust_input=True)
    assert np.array_equal(arrays["id"].transpose(2, 1, 0), LABELS)


@pytest.mark.parametrize("kind", ["link", "external"])
def test_dream3d(tmp_path, kind):
    h5py = pytest.importorskip("h5py")
    (tmp_path / "in").mkdir()
    values = np.ascontiguousarray(LABELS.transpose(2, 1, 0).astype(np.int32))
    with h5py.File(tmp_path / "in" / "a.dream3d", "w") as file:
        group = file.create_group("DataContainers/A")
        shape = group.create_group("_SIMPL_GEOMETRY")
        shape["DIMENSIONS"] = np.array(LABELS.shape)
        shape["SPACING"], shape["ORIGIN"] = np.ones(3), np.zeros(3)
        cells = group.create_group("CellData")
        if kind == "link":
            cells["FeatureIds"] = h5py.ExternalLink(str(tmp_path / "b.h5"), "/ids")
        else:
            (tmp_path / "b.raw").write_bytes(values.tobytes())
            cells.create_dataset("FeatureIds", values.shape, np.int32,
                                 external=[(str(tmp_path / "b.raw"), 0, values.nbytes)])
    with h5py.File(tmp_path / "b.h5", "w") as file:
        file["ids"] = values
    with pytest.raises(ValueError, match="trust_input=True"):
        vfm.read(tmp_path / "in" / "a.dream3d")
    assert np.array_equal(vfm.read(tmp_path / "in" / "a.dream3d",
                                   trust_input=True)["FeatureIds"], values)


def test_case_of_cth(tmp_path):
    (tmp_path / "in").mkdir()
    (tmp_path / "b.spcth").write_bytes(b"other")
    (tmp_path / "in" / "a.spcth").write_text("spycase\n../b.spcth\n")
    with pytest.raises(ValueError, match="outside of its folder.*trust_input=True"):
        vfm.read(tmp_path / "in" / "a.spcth")
    with pytest.raises(ValueError) as told:
        vfm.read(tmp_path / "in" / "a.spcth", trust_input=True)
    assert "outside" not in str(told.value), told.value
