"""Tests TIFF stacks, slices and pictures: sizes of voxels, order of slices, colours."""

import warnings

import numpy as np
import pytest

import volume_fraction_mesh as vfm
from images import round_ball
from volume_fraction_mesh.__main__ import main

tifffile = pytest.importorskip("tifffile")

STACK = np.zeros((6, 12, 10), np.uint8)  # a[z, y, x]: two bodies of 96 voxels
STACK[1:5, 2:10, 2:5] = 1
STACK[1:5, 2:10, 5:8] = 2
PICTURE = np.zeros((16, 16), np.uint8)
PICTURE[3:13, 3:8] = 1
PICTURE[3:13, 8:13] = 2
COLOURS = np.array([[0, 0, 0], [255, 0, 0], [0, 0, 255]], np.uint8)
OME = ('<?xml version="1.0"?><OME xmlns="http://www.openmicroscopy.org/Schemas/OME/2016-06">'
       '<Image ID="Image:0"><Pixels ID="Pixels:0" DimensionOrder="XYZCT" Type="uint8" SizeX="10" '
       'SizeY="12" SizeZ="6" SizeC="1" SizeT="1" %s><TiffData/></Pixels></Image></OME>')


def sizes(**given):
    return OME % " ".join('PhysicalSize%s="%s"' % pair for pair in given.items())


def widths(arrays):
    """Returns the widths of the first cell along x, y and z."""
    return [float(x[1] - x[0]) for x in arrays.coordinates]


def check_stack(path, expected, note=None):
    """Checks the widths, the volumes of both bodies, and the note of read()."""
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        arrays = vfm.read(path)
    told = [str(each.message) for each in caught]
    assert (len(told) == 1 and note in told[0]) if note else not told, told
    assert np.allclose(widths(arrays), expected, rtol=1e-6), widths(arrays)
    mesh = vfm.hexes(arrays)
    print(path.name, widths(arrays), mesh.materials["MeshVolume"])
    assert np.allclose(mesh.materials["MeshVolume"], 96 * np.prod(expected), rtol=1e-6)


@pytest.mark.parametrize("meta, resolution, expected, note", [
    (dict(unit="micron", spacing=3.0), (2, 2), (0.5, 0.5, 3), None),
    (dict(unit="\\u00B5m", spacing=3.0), (2, 4), (0.5, 0.25, 3), None),
    (dict(unit="um", spacing=-3.0), (2, 2), (0.5, 0.5, 3), None),
    (dict(unit="nm"), (0.1, 0.1), (10, 10, 10), "along z: 10 is used"),
    (dict(unit="mm", spacing=0.4), (5, 5), (0.2, 0.2, 0.4), None),
    (dict(unit="cm", spacing=0.4), (5, 5), (0.2, 0.2, 0.4), None),
    (dict(unit="inch", spacing=0.2), (10, 10), (0.1, 0.1, 0.2), None),
    (dict(unit="pixel"), None, (1, 1, 1), "has no size of voxels"),
])
def test_imagej(tmp_path, meta, resolution, expected, note):
    path = tmp_path / "a.tif"
    tifffile.imwrite(path, STACK, imagej=True, resolution=resolution,
                     metadata={"axes": "ZYX", **meta})
    check_stack(path, expected, note)


@pytest.mark.parametrize("given, expected, note", [
    (dict(X=0.5, XUnit="um", Y=0.5, YUnit="um", Z=3, ZUnit="um"), (0.5, 0.5, 3), None),
    (dict(X=0.5, Y=0.25, Z=3), (0.5, 0.25, 3), None),  # micrometres are the default of OME
    (dict(X=0.5, XUnit="um", Y=0.5, YUnit="um", Z=3000, ZUnit="nm"), (0.5, 0.5, 3), None),
    (dict(X=0.5, XUnit="cm", Y=0.5, YUnit="cm", Z=7, ZUnit="mm"), (0.5, 0.5, 0.7), None),
    (dict(X=0.5, Y=0.5), (0.5, 0.5, 0.5), "along z: 0.5 is used, as along x"),
    (dict(X=0.5, XUnit="pixel", Y=0.5, YUnit="pixel", Z=3), (1, 1, 1), "no size of voxels"),
])
def test_ome(tmp_path, given, expected, note):
    path = tmp_path / "a.ome.tif"
    tifffile.imwrite(path, STACK, description=sizes(**given), metadata=None)
    check_stack(path, expected, note)


def test_resolution(tmp_path):
    path = tmp_path / "a.tif"
    for unit, length in (("CENTIMETER", 10), ("INCH", 25.4)):
        tifffile.imwrite(path, STACK, resolution=(20, 20), resolutionunit=unit, metadata=None)
        check_stack(path, [length / 20] * 3, "along z")
    assert widths(vfm.read(path, spacing=(1, 2, 3))) == [1, 2, 3]


@pytest.mark.parametrize("given", [
    dict(tile=(16, 16)), dict(compression="zlib"), dict(photometric="minisblack", bigtiff=True),
    dict(byteorder=">"), dict(rowsperstrip=5),
])
def test_storage(tmp_path, given):
    tifffile.imwrite(tmp_path / "a.tif", STACK.astype(np.uint16), metadata=None, **given)
    assert np.array_equal(vfm.read(tmp_path / "a.tif")["Material 1"], STACK)


def test_bits(tmp_path):
    """An image of 1 bit holds one material; for white as 0, its values are inverted."""
    for photometric, mask in (("minisblack", STACK > 0), ("miniswhite", STACK == 0)):
        tifffile.imwrite(tmp_path / "a.tif", mask, photometric=photometric, metadata=None)
        mesh = vfm.hexes(vfm.read(tmp_path / "a.tif"))
        assert np.isclose(mesh.materials["MeshVolume"][0], 192, rtol=1e-6)


def test_channels_and_times(tmp_path):
    both = np.stack([STACK, STACK[:, ::-1]], axis=1)  # ZCYX
    tifffile.imwrite(tmp_path / "a.tif", both, imagej=True, metadata={"axes": "ZCYX"})
    with pytest.raises(ValueError, match="Choose one volume: volume=N"):
        vfm.hexes(vfm.read(tmp_path / "a.tif"))
    assert np.array_equal(vfm.read(tmp_path / "a.tif", volume=1)["Material 1"], STACK[:, ::-1])
    tifffile.imwrite(tmp_path / "b.tif", both.transpose(1, 0, 2, 3), imagej=True,
                     metadata={"axes": "TZYX"})
    assert np.array_equal(vfm.read(tmp_path / "b.tif", step=1)["Material 1"], STACK[:, ::-1])
    with pytest.raises(ValueError, match="there is no step 2: it has 2"):
        vfm.read(tmp_path / "b.tif", step=2)


def test_pages_of_different_sizes(tmp_path):
    with tifffile.TiffWriter(tmp_path / "a.tif") as file:
        for size in (8, 9):
            file.write(np.zeros((size, 8), np.uint8), metadata=None)
    with pytest.raises(ValueError, match="a.tif: its pages differ in size or type: 8 x 8"):
        vfm.read(tmp_path / "a.tif")


def write_slices(folder, names, volume):
    folder.mkdir()
    for name, page in zip(names, volume):
        path = folder / name
        if path.suffix == ".tif":
            tifffile.imwrite(path, page, metadata=None)
        else:
            pytest.importorskip("PIL.Image").fromarray(page).save(path)


@pytest.mark.parametrize("ending", ["tif", "png"])
def test_slices(tmp_path, ending, capsys):
    """Files are slices in the natural order of their names."""
    ball = round_ball().transpose(2, 1, 0)
    ball[:8] = np.where(ball[:8] > 0, 2, 0)  # the order matters
    names = ["slice_%d.%s" % (k, ending) for k in range(len(ball))]
    folder = tmp_path / "slices"
    write_slices(folder, names, ball)
    (folder / ".hidden").write_text("")
    (folder / "notes.txt").write_text("")
    for given in (folder, str(folder / ("*." + ending)), [folder / name for name in names]):
        arrays = vfm.read(given)
        assert np.array_equal(arrays["Material 1"], ball)
    mesh = vfm.hexes(arrays)
    assert np.isclose(mesh.materials["MeshVolume"].sum(), 912)
    out = str(tmp_path / "out.vtk")
    for words in ([str(folder)], [str(folder / "*")], [str(folder / name) for name in names[::-1]]):
        if words[0].endswith("*"):
            words = [words[0] + ending]
        assert main([*words, out, "--spacing", "1"]) == 0
        assert "hexahedra" in capsys.readouterr().out
    assert widths(vfm.read(folder, spacing=(1, 1, 2))) == [1, 1, 2]


def test_slices_that_do_not_fit(tmp_path):
    ball = round_ball()
    write_slices(tmp_path / "a", ["s1.tif", "s2.tif", "s10.tif"], [ball[0], ball[1], ball[2, 1:]])
    with pytest.raises(ValueError, match="s10.tif: the slice has 16 x 15 points of the type uint8, "
                       "and the first slice .*s1.tif has 16 x 16"):
        vfm.read(tmp_path / "a")
    (tmp_path / "a" / "s10.tif").write_bytes(b"text")
    with pytest.raises(ValueError, match="Cannot read .*s10.tif"):
        vfm.read(tmp_path / "a")
    write_slices(tmp_path / "b", ["1.tif", "1.png"], ball[:2])
    with pytest.raises(ValueError, match=r"several formats, .png, .tif: select one format"):
        vfm.read(tmp_path / "b")
    write_slices(tmp_path / "c", ["1.tif", "2.tif"], [ball[:2], ball[:2]])
    with pytest.raises(ValueError, match="1.tif: it has 2 pages"):
        vfm.read(tmp_path / "c")


@pytest.mark.parametrize("names, told", [
    (["slice_001.tif", "slice_002.tif", "slice_004.tif"],
     "numbers without a file: 1, the first between slice_002.tif and slice_004.tif"),
    (["s0.tif", "s10.tif", "s40.tif", "s60.tif"], "without a file: 3, the first between s10.tif"),
    (["s0.tif", "s10.tif", "s20.tif"], None),
    (["z1_t0.tif", "z1_t1.tif", "z2_t0.tif", "z2_t1.tif"], None),
    (["a.tif", "b.tif", "b7.tif"], None),
])
def test_gaps_of_slices(tmp_path, names, told):
    """A number without a file is a warning, also if the spacing is given."""
    write_slices(tmp_path / "a", names, STACK)
    for given in (tmp_path / "a", [tmp_path / "a" / name for name in names]):
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            arrays = vfm.read(given, spacing=1)
        assert np.array_equal(arrays["Material 1"], STACK[:len(names)])
        texts = [str(each.message) for each in caught]
        assert len(texts) == (told is not None) and all(told in text for text in texts), texts


@pytest.mark.parametrize("given", [{}, dict(compression="zlib"), dict(tile=(16, 16))])
def test_slices_that_describe_the_stack(tmp_path, given):
    """ImageJ keeps the description of the stack in each of its slices."""
    described = "ImageJ=1.53t\nimages=6\nslices=6\nunit=micron\nspacing=3.0\nloop=false\n"
    for number, page in enumerate(STACK):
        tifffile.imwrite(tmp_path / ("s%d.tif" % number), page, description=described,
                         metadata=None, resolution=(2, 2), **given)
    arrays = vfm.read(tmp_path)
    assert np.array_equal(arrays["Material 1"], STACK)
    assert np.allclose(widths(arrays), (0.5, 0.5, 3))


def test_folders_of_other_files(tmp_path):
    with pytest.raises(ValueError, match="contains no slices: .* It is empty."):
        vfm.read(tmp_path)
    for name in ("1.dcm", "2.dcm"):
        (tmp_path / name).write_bytes(b"other")
    with pytest.raises(ValueError, match="Its files: 2 .dcm. Convert DICOM files to one .nii"):
        vfm.read(tmp_path)
    write_slices(tmp_path / "a", ["1.tif", "2.tif"], STACK)
    (tmp_path / "a" / "notes.txt").write_text("")
    assert len(vfm.read(str(tmp_path / "a" / "*"))["Material 1"]) == 2


def check_picture(path, names):
    mesh = vfm.hexes(vfm.read(path))
    print(path.name, mesh, mesh.materials["MeshVolume"])
    assert np.allclose(mesh.materials["MeshVolume"], 50, rtol=1e-6)
    assert np.bincount(mesh.material).tolist() == [0, 80, 80]
    assert mesh.materials["Name"] == names


def test_pictures(tmp_path):
    """A picture is one layer of cells; its colours or values are labels."""
    image = pytest.importorskip("PIL.Image")
    labels = ["Material 1", "Material 2"]
    colours = ["rgb 0 0 255", "rgb 255 0 0"]
    alpha = np.where(PICTURE > 0, 255, 0).astype(np.uint8)[..., None]
    palette = image.fromarray(PICTURE, "P")
    palette.putpalette([255, 255, 255, 255, 0, 0, 0, 0, 255] + [0] * 759)
    for name, picture, names in (
        ("grey.png", image.fromarray(PICTURE), labels),
        ("grey.bmp", image.fromarray(PICTURE), labels),
        ("grey.pgm", image.fromarray(PICTURE), labels),
        ("deep.png", image.fromarray(PICTURE.astype(np.uint16)), labels),
        ("grey_rgb.png", image.fromarray(np.repeat(PICTURE[..., None], 3, axis=2)), labels),
        ("colours.png", image.fromarray(COLOURS[PICTURE]), colours),
        ("colours.bmp", image.fromarray(COLOURS[PICTURE]), colours),
        ("palette.png", palette, labels),
        ("transparent.png", image.fromarray(np.concatenate([
            np.where(alpha > 0, COLOURS[PICTURE], 77), alpha], axis=2).astype(np.uint8)), colours),
    ):
        picture.save(tmp_path / name)
        check_picture(tmp_path / name, names)
    for name, page, names in (("labels.tif", PICTURE, labels),
                              ("colours.tif", COLOURS[PICTURE], colours)):
        tifffile.imwrite(tmp_path / name, page, metadata=None)
        check_picture(tmp_path / name, names)


def test_mask_of_one_bit(tmp_path):
    image = pytest.importorskip("PIL.Image")
    image.fromarray(PICTURE > 0).save(tmp_path / "a.png")
    assert np.isclose(vfm.hexes(vfm.read(tmp_path / "a.png")).materials["MeshVolume"][0], 100)


def test_too_many_colours(tmp_path):
    image = pytest.importorskip("PIL.Image")
    values = np.random.default_rng(1).integers(0, 256, (17, 16, 3), dtype=np.uint8)
    image.fromarray(values).save(tmp_path / "a.png")
    with pytest.raises(ValueError, match="a.png: it has 272 colours; at most 255 become labels"):
        vfm.read(tmp_path / "a.png")
