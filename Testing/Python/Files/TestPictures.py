"""Pictures and slices of labels: TIFF and PNG, in one file or several.

With the readers of the plugin and with `sculptor`, the mesh is bitwise identical to the mesh of the
same labels as cells. The size of voxels is read from ImageJ, OME and the resolution.
"""
import os
import sys

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from compare_meshes import difference, merge, read_pieces
from image_files import save, write_imagej, write_pages, write_png
from sculptor_program import mesh_file, refused, rows, sculptor
from vfmtest import LabelSlicesReader, collect, image, in_folder, main, mesh_of
from voxels import grains, turned

sys.path.insert(0, os.environ["VFM_WRAPPERS"])
from volumefractionmesh.vtkVolumeFractionMeshIO import vtkVolumeFractionImageReader

LABELS = turned(grains(), "ZYX").astype("u1")
UNIT = ["--spacing", "1,1,1"]
IMAGEJ = "ImageJ=1.53t\nimages=13\nslices=13\nunit=micron\nspacing=3.0\nloop=false\n"
OME = ('<?xml version="1.0" encoding="UTF-8"?><OME xmlns="http://www.openmicroscopy.org/Schemas/'
       'OME/2016-06"><Image ID="Image:0"><Pixels ID="Pixels:0" DimensionOrder="%s" Type="uint8" '
       'SizeX="9" SizeY="11" SizeZ="%d" SizeC="%d" SizeT="%d" %s><TiffData/></Pixels></Image>'
       '</OME>')
SIZES = ('PhysicalSizeX="0.5" PhysicalSizeXUnit="\u00b5m" PhysicalSizeY="0.5" '
         'PhysicalSizeYUnit="um" PhysicalSizeZ="%s" PhysicalSizeZUnit="%s"')


def gold_of(values, spacing=(1, 1, 1)):
    """Returns the mesh of labels whose first voxel has its centre at 0. One layer is a picture and
    becomes a mesh of a plane."""
    data = image({"Labels": values.astype("i4")})
    data.SetSpacing(spacing)
    data.SetOrigin([-0.5 * s for s in spacing])
    return merge([mesh_of(data, MaterialIdArray="Labels", Flat=len(values) == 1).mesh])


def check_same(mesh, other, what):
    problem = difference(mesh, other)
    assert not problem, "%s: %s" % (what, problem)


def read(files, spacing=(0, 0, 0), volume=-1):
    """Returns the image that the reader class reads, and its warnings."""
    it = vtkVolumeFractionImageReader()
    for file in files:
        it.AddSlice(file)
    it.SetSpacing(spacing)
    it.SetVolume(volume)
    errors, warnings = collect(it)
    it.Update()
    assert not errors, errors
    return it.GetOutput(), warnings


def check_readers(path, values, words=UNIT, spacing=(1, 1, 1), ranks=(3,), names=()):
    """The plugin reads the values and their place, and sculptor makes their mesh.

    names: texts in the printed table; the names in the mesh are then not compared.
    """
    gold = gold_of(values, spacing)
    given = [float(s) for s in words[1].split(",")] if "--spacing" in words else (0, 0, 0)
    data, _ = read([path], given)
    assert (vtk_to_numpy(data.GetPointData().GetArray("Labels")) == values.ravel()).all(), path
    assert data.GetSpacing() == spacing and data.GetOrigin() == (0, 0, 0), path
    assert data.GetDimensions() == values.shape[::-1], path
    for count in ranks:
        printed = mesh_file(path, at_of(path, "out.vtu"), *words, ranks=count)
        assert all(name in printed for name in names), printed
        mesh = merge(read_pieces(at_of(path, "out.vtu")))
        check_same({**mesh, "field": gold["field"]} if names else mesh, gold, (path, count))


def at_of(path, name):
    return os.path.join(os.path.dirname(path.rstrip("/")), name)


@in_folder
def test_storage_of_tiff(at):
    """Strips, tiles, BigTIFF, both byte orders, few bits, and a stack without pages of ImageJ."""
    few = np.minimum(LABELS, 3)
    mask = (LABELS > 1).astype("u1")
    for name, values, options in (
            ("strips", LABELS, {}), ("big", LABELS, {"big": True}),
            ("big_endian", LABELS.astype("u2"), {"bits": 16, "order": ">"}),
            ("tiles", LABELS, {"tile": 16}),
            ("tiles_16", LABELS.astype("i2"), {"tile": 16, "bits": 16, "order": ">"}),
            ("int", LABELS.astype("i4"), {"bits": 32}),
            ("long", LABELS.astype("i8"), {"bits": 64}),
            ("four_bits", LABELS, {"bits": 4}), ("two_bits", few, {"bits": 2}),
            ("four_bits_tiles", LABELS, {"bits": 4, "tile": 16}),
            ("one_bit", mask, {"bits": 1}),
            ("one_bit_white", mask, {"bits": 1, "white_first": True}),
            ("one_bit_reverse", mask, {"bits": 1, "reverse_bits": True}),
            ("white", LABELS, {"white_first": True})):
        check_readers(write_pages(at(name + ".tif"), values, **options), values)
    check_readers(write_imagej(at("imagej.tif"), LABELS), LABELS)


@in_folder
def test_size_of_voxels(at):
    """ImageJ and OME give all three widths, in their unit."""
    spacing = (0.5, 0.5, 3.0)
    for name, options in (
            ("imagej", {"description": IMAGEJ, "resolution": 2}),
            ("micrometres per centimetre", {"description": IMAGEJ, "resolution": 20000,
                                            "unit": 3}),
            ("ome", {"description": OME % ("XYZCT", 13, 1, 1, SIZES % ("3", "\u03bcm"))}),
            ("ome_nm", {"description": OME % ("XYCTZ", 13, 1, 1, SIZES % ("3000", "nm"))})):
        path = write_pages(at(name + ".tif"), LABELS, **options)
        check_readers(path, LABELS, [], spacing)
        assert not read([path])[1]
    path = write_pages(at("a.tif"), LABELS, description=IMAGEJ, resolution=2)
    check_readers(path, LABELS)  # --spacing has priority
    for unit, number in (("inch", 2), ("cm", 3), ("mm", 1)):  # in the unit of the file
        path = write_pages(at("unit.tif"), LABELS, description=IMAGEJ.replace("micron", unit),
                           resolution=2, unit=number)
        assert read([path])[0].GetSpacing() == (0.5, 0.5, 3.0)


@in_folder
def test_missing_distance(at):
    """A warning says which width is assumed; never are voxels 1 : 2000."""
    for name, options, spacing, text in (
            ("cm", {"resolution": 20000, "unit": 3}, (5e-4,) * 3,
             "it contains the size of pixels, 5e-4 x 5e-4, but not the distance of slices; 5e-4 is "
             "assumed. Set --spacing or Spacing."),
            ("none", {}, (1, 1, 1), "it contains no size of voxels; 1 x 1 x 1 is assumed."),
            ("ome", {"description": OME % ("XYZCT", 13, 1, 1, SIZES % ("2", "pixel"))},
             (0.5,) * 3, "0.5 is assumed")):
        path = write_pages(at(name + ".tif"), LABELS, **options)
        data, warnings = read([path])
        assert np.allclose(data.GetSpacing(), spacing, 1e-12, 0), data.GetSpacing()
        assert len(warnings) == 1 and text in warnings[0], warnings
        for ranks in (1, 3):
            result = sculptor(path, at("out.vtu"), ranks=ranks)
            printed = [line for line in result.stderr.splitlines() if "Label 0" not in line]
            assert result.returncode == 0 and len(printed) == 1, result
            assert "sculptor: warning: %s: " % path in printed[0] and text in printed[0], printed
        assert not read([path], (1, 1, 2))[1]
    path = write_pages(at("page.tif"), LABELS[:1], resolution=20000, unit=3)
    data, warnings = read([path])
    assert np.allclose(data.GetSpacing(), (5e-4,) * 3) and not warnings, warnings


@in_folder
def test_volumes_of_tiff(at):
    """Channels and times are volumes; images along one axis only are slices."""
    other = np.where(LABELS == 2, 5, 0).astype("u1")
    fast = np.stack([LABELS, other], 1).reshape(-1, *LABELS.shape[1:])  # channels fastest
    slow = np.concatenate([LABELS, other])
    hyper = "ImageJ=1.53t\nimages=26\nslices=13\n%s=2\nhyperstack=true\n"
    for name, values, text in (("channels", fast, hyper % "channels"),
                               ("frames", slow, hyper % "frames"),
                               ("ome_channels", fast, OME % ("XYCZT", 13, 2, 1, "")),
                               ("ome_times", slow, OME % ("XYZCT", 13, 1, 2, ""))):
        path = write_pages(at(name + ".tif"), values, description=text)
        refused(2, "Select one of them by its number, --volume or Volume, from 0 to 1", path,
                at("out.vtu"), ranks=3)
        for volume, part in enumerate((LABELS, other)):
            data, _ = read([path], volume=volume)
            assert (vtk_to_numpy(data.GetPointData().GetArray("Labels")) == part.ravel()).all()
            mesh_file(path, at("out.vtu"), *UNIT, "--volume", str(volume), ranks=3)
            check_same(merge(read_pieces(at("out.vtu"))), gold_of(part), (name, volume))
    text = "ImageJ=1.53t\nimages=13\nframes=13\n"
    check_readers(write_pages(at("t.tif"), LABELS, description=text), LABELS)


def write_slices(folder, values, write, pattern):
    os.makedirs(folder)
    for number, page in enumerate(values):
        write(os.path.join(folder, pattern % number), page)
    return folder


@in_folder
def test_slices(at):
    """A folder, a pattern and a list of files are one volume, in natural order of the names."""
    gold = gold_of(LABELS)
    tiff = lambda path, page: write_pages(path, page[None])
    for name, write, pattern in (("tiff", tiff, "slice_%d.tif"), ("png", write_png, "%d_a.PNG")):
        folder = write_slices(at(name), LABELS, write, pattern)
        for other in (".hidden.tif", "Thumbs.db", "notes.txt"):
            save(os.path.join(folder, other), b"other")
        files = [os.path.join(folder, pattern % k) for k in range(len(LABELS))]
        glob = os.path.join(folder, pattern.replace("%d", "*"))
        for given in ([folder], [glob], files, files[::-1]):
            source = LabelSlicesReader(FileNames=given, Spacing=[1, 1, 1])
            source.UpdatePipeline()
            data = source.GetClientSideObject().GetOutputDataObject(0)
            assert data.GetDimensions() == LABELS.shape[::-1]
            assert (vtk_to_numpy(data.GetPointData().GetArray("Labels")) == LABELS.ravel()).all()
        check_same(merge([mesh_of(data, MaterialIdArray="Labels").mesh]), gold, name)
        for given in (folder, folder + "/", glob, os.path.join(folder, pattern)):
            for ranks in (1, 3):
                mesh_file(given, at("out.vtu"), *UNIT, ranks=ranks)
                check_same(merge(read_pieces(at("out.vtu"))), gold, (given, ranks))
    ball = (np.sum((np.indices((16, 16, 16)) - 7.5) ** 2, 0) < 36).astype("u1")
    folder = write_slices(at("ball"), ball, tiff, "s_%04d.tif")
    printed = rows(mesh_file(folder, at("out.vtu"), *UNIT))
    assert printed["all"][0] == 1584 and abs(printed["all"][4] - 912) < 1e-3, printed


@in_folder
def test_refused_slices(at):
    """A slice of another size or type, with pages, or that is damaged, is named."""
    for name, damage, text in (
            ("size", lambda path: write_pages(path, LABELS[:1, 1:]), "has 9 x 10 pixels"),
            ("type", lambda path: write_pages(path, LABELS[:1].astype("u2"), bits=16),
             "(unsigned short, 1 value), but the first slice, s_0.tif, has 9 x 11 pixels"),
            ("pages", lambda path: write_pages(path, LABELS[:2]), "it has 2 pages"),
            ("text", lambda path: save(path, b"hello"), "it is not a TIFF file")):
        folder = write_slices(at(name), LABELS, lambda path, page: write_pages(path, page[None]),
                              "s_%d.tif")
        damage(os.path.join(folder, "s_7.tif"))
        for ranks in (1, 3):
            refused(2, text, folder, at("out.vtu"), *UNIT, ranks=ranks)
            refused(2, "slice s_7.tif", folder, at("out.vtu"), *UNIT, ranks=ranks)
        it = vtkVolumeFractionImageReader()
        it.SetFileName(folder)
        errors, _ = collect(it)
        it.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)
        it.Update()
        assert len(errors) == 1 and text in errors[0] and "s_7.tif" in errors[0], errors
    refused(2, "the pattern matches no file", at("none*.tif"), at("out.vtu"))
    os.makedirs(at("empty"))
    refused(2, "the folder contains no file of a slice (.tif, .tiff, .png) and is no plotfile of "
            "AMReX, which has a file Header. Its files: none.", at("empty"), at("out.vtu"))


@in_folder
def test_folders_of_other_files(at):
    """A message names the files and the way on, in sculptor and the readers."""
    for name, files, texts in (
            ("jpg", ["a.jpg", "b.JPG"], ["Its files: 2 .jpg.", "Save pictures as .png or .tif"]),
            ("dcm", ["1.dcm", "2.dcm", ".x"], ["Its files: 2 .dcm.", "Convert DICOM files to one"]),
            ("mixed", ["a.tif", "b.tiff", "preview.png"],
             ["several formats, .png, .tif", 'such as "%s/*.tif"' % at("mixed")])):
        os.makedirs(at(name))
        for file in files:
            save(os.path.join(at(name), file), b"other")
        for text in texts:
            refused(2, text, at(name), at("out.vtu"))
            it = vtkVolumeFractionImageReader()
            it.AddSlice(at(name))
            errors, _ = collect(it)
            it.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)
            it.Update()
            assert len(errors) == 1 and text in errors[0] and at(name) in errors[0], errors
    refused(2, "Its files: 2 .jpg", at("jpg/*"), at("out.vtu"))
    write_slices(at("good"), LABELS, lambda path, page: write_pages(path, page[None]), "s_%d.tif")
    mesh_file(at("good/s_*"), at("out.vtu"), *UNIT)
    check_same(merge(read_pieces(at("out.vtu"))), gold_of(LABELS), "pattern without suffix")


@in_folder
def test_gaps_of_slices(at):
    """A number without a file is a warning; the usual step is the smallest one."""
    text = "slices may be missing: numbers without a file: 2, the first between s_3.tif and s_5.tif"
    page = lambda path, values: write_pages(path, values[None])
    whole = write_slices(at("whole"), LABELS, page, "s_%d.tif")
    assert not read([whole], (1, 1, 1))[1]
    for number in (4, 9):
        os.remove(os.path.join(whole, "s_%d.tif" % number))
    kept = np.delete(LABELS, (4, 9), 0)
    for given in ([whole], [os.path.join(whole, name) for name in os.listdir(whole)]):
        data, warnings = read(given, (1, 1, 1))
        assert len(warnings) == 1 and text in warnings[0], warnings
        assert (vtk_to_numpy(data.GetPointData().GetArray("Labels")) == kept.ravel()).all()
    for ranks in (1, 3):
        assert text in sculptor(whole, at("out.vtu"), *UNIT, ranks=ranks).stderr
    os.makedirs(at("tens"))
    for number, values in enumerate(LABELS[:4]):
        page(at("tens/z%02d_t%d.tif" % (10 * (number // 2), number % 2)), values)
    assert not read([at("tens")], (1, 1, 1))[1]


@in_folder
def test_slices_that_describe_the_stack(at):
    """ImageJ keeps the description of the stack in each of its slices."""
    for name, options in (("raw", {}), ("tiles", {"tile": 16})):
        folder = write_slices(at(name), LABELS, lambda path, values: write_pages(
            path, values[None], description=IMAGEJ, resolution=2, **options), "s_%d.tif")
        check_readers(folder, LABELS, [], (0.5, 0.5, 3.0))


@in_folder
def test_pictures(at):
    """Grey values and palette indices are labels of one layer; 50 cells and 80 elements each."""
    page = np.zeros((16, 16), "u1")
    page[3:13, 3:8], page[3:13, 8:13] = 1, 2
    palette = [255, 255, 255, 9, 9, 9, 1, 2, 3]
    for path in (write_png(at("a.png"), page), write_png(at("b.png"), page.astype("u2")),
                 write_png(at("c.png"), page, palette), write_png(at("d.png"), page, palette, 2),
                 write_png(at("e.png"), page, depth=4), write_pages(at("f.tif"), page[None])):
        check_readers(path, page[None], [])
        printed = rows(mesh_file(path, at("out.vtu")))
        for name in ("1 Material 1", "2 Material 2"):
            assert printed[name][0] == 80 and abs(printed[name][4] - 50) < 1e-4, printed


@in_folder
def test_colours(at):
    """Black and transparent pixels are void; other colours are labels in ascending order."""
    page = np.zeros((16, 16), "u1")
    page[3:13, 3:8], page[3:13, 8:13] = 2, 1
    colours = np.array([[0, 0, 0], [0, 0, 255], [255, 0, 0]], "u1")[page]
    names = ["1 rgb 0 0 255", "2 rgb 255 0 0"]
    seen = np.dstack([np.where(page[..., None] > 0, colours, 77), 255 * (page > 0)]).astype("u1")
    wide = ["1 rgb 0 0 65535", "2 rgb 65535 0 0"]
    for path, expected in (
            (write_png(at("a.png"), colours), names), (write_png(at("b.png"), seen), names),
            (write_png(at("c.png"), colours.astype("u2") * np.uint16(257)), wide),
            (write_pages(at("d.tif"), colours[None], colours=3), names),
            (write_pages(at("e.tif"), seen[None], colours=4, tile=16), names)):
        check_readers(path, page[None], [], names=expected)
    grey = np.dstack([page + np.uint8(40), np.where(page > 0, 255, 0)]).astype("u1")
    check_readers(write_png(at("g.png"), grey), np.where(page > 0, page + 40, 0)[None], [])
    stack = np.stack([colours, colours[::-1]])
    check_readers(write_pages(at("stack.tif"), stack, colours=3), np.stack([page, page[::-1]]),
                  names=names)
    many = np.arange(768, dtype="u2").reshape(16, 16, 3).astype("u1")
    many[..., 1] = np.arange(256).reshape(16, 16)
    refused(2, "it has more than 255 colours", write_png(at("many.png"), many + np.uint8(1)),
            at("out.vtu"), ranks=3)
    save(at("cut.png"), open(at("a.png"), "rb").read()[:-25])
    refused(2, "truncated or damaged", at("cut.png"), at("out.vtu"))
    whole = open(write_pages(at("whole.tif"), LABELS), "rb").read()
    for share in (0.5, 0.75):
        refused(2, "list of pages is damaged or truncated",
                save(at("cut.tif"), whole[:int(share * len(whole))]), at("out.vtu"))
    few = write_pages(at("few.tif"), LABELS[:5], description=IMAGEJ)
    refused(2, "ImageJ describes 13 images, but it has 5 pages", few, at("out.vtu"))
    refused(2, "it is not a PNG file", save(at("text.png"), b"hello"), at("out.vtu"))
    refused(2, "it has 2 values of 8 bits per point",
            write_pages(at("two.tif"), colours[None, ..., :2], colours=2), at("out.vtu"))
    refused(2, "of 16 bits per point (format 3",
            write_pages(at("half.tif"), page[None].astype("f2"), bits=16), at("out.vtu"))


main(globals())
