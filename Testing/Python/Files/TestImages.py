"""Label images in formats of medical imaging and of grain structures.

With the readers of the plugin and with `sculptor`, the mesh is bitwise identical to the mesh of the
same labels as cells. Rotated images lie where their files say. Damaged files give one message.
"""
import os
import sys

import h5py
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from compare_meshes import difference, merge, read_pieces
from image_files import (
    CARET, STRAIGHT, save, write_dream3d, write_dream3d_nx, write_imagej, write_meta, write_mgh,
    write_nifti, write_nrrd, write_old_dream3d, write_tiff)
from sculptor_program import mesh_file, refused, sculptor
from vfmtest import (
    ORIGIN, SPACING, LabelImageReader, collect, image, in_folder, main, mesh_of, points_of, simple)
from voxels import grains, turned

sys.path.insert(0, os.environ["VFM_WRAPPERS"])
from volumefractionmesh.vtkVolumeFractionMeshIO import vtkVolumeFractionImageReader

LABELS = turned(grains(), "ZYX").astype("u1")
MIDDLE = np.add(ORIGIN, np.multiply(SPACING, 0.5))  # centre of the first voxel
CELLS = image({"Labels": LABELS.astype("i4")})  # the reference input
QUARTER = np.array([[0, 0.25, 0], [-0.25, 0, 0], [0, 0, 0.5]])  # rotated, exact in binary
MIRRORED = np.array([[0.25, 0, 0], [0, 0.25, 0], [0, 0, -0.5]])
OBLIQUE = np.array([[0.6, 0, 0.8], [0.64, 0.6, -0.48],
                    [-0.48, 0.8, 0.36]]) * [[0.25], [0.25], [0.5]]


def straight_files(at):
    """Writes LABELS in all formats where CELLS lies; returns [(path, arguments of sculptor)]."""
    return [
        (write_nifti(at("a.nii"), LABELS, MIDDLE), []),
        (write_nifti(at("b.nii.gz"), LABELS.astype("i2"), MIDDLE, forms="q"), []),
        (write_nifti(at("C.NII"), LABELS.astype("i4"), MIDDLE, forms="sq", order=">"), []),
        (write_nifti(at("real.nii.gz"), LABELS.astype("f4"), MIDDLE), ["--labels", "Values"]),
        (write_nrrd(at("d.nrrd"), LABELS, MIDDLE), []),
        (write_nrrd(at("e.nrrd"), LABELS.astype("i2"), MIDDLE, encoding="raw",
                    space="left-anterior-superior"), []),
        (write_nrrd(at("f.nhdr"), LABELS.astype("u2"), MIDDLE, data="f.values"), []),
        (write_nrrd(at("g.nhdr"), LABELS, MIDDLE, encoding="raw", data="g.values"), []),
        (write_meta(at("h.mha"), LABELS, MIDDLE), []),
        (write_meta(at("i.mhd"), LABELS.astype("u2"), MIDDLE, packed=True), []),
        (write_dream3d(at("j.dream3d"), LABELS.astype("i4"), ORIGIN, SPACING), []),
        (write_dream3d_nx(at("k.dream3d"), LABELS.astype("i4"), ORIGIN, SPACING), []),
        (write_dream3d(at("l.dream3d"), LABELS, ORIGIN, SPACING, more=["Other"]),
         ["--labels", "Other/CellData/FeatureIds"]),
        (write_dream3d(at("m.dream3d"), LABELS.astype("i4"), ORIGIN, SPACING, shape=(-1,)), []),
        (write_dream3d(at("n.dream3d"), LABELS.astype("i4"), ORIGIN, SPACING, shape=(-1, 1)), []),
        (write_mgh(at("o.mgz"), LABELS, MIDDLE), []),
        (write_mgh(at("p.mgh"), LABELS.astype("i2"), MIDDLE), []),
    ]


def read(path, spacing=(0, 0, 0), cell_array="FeatureIds"):
    """Returns the image that the reader class reads."""
    it = vtkVolumeFractionImageReader()
    it.SetFileName(path)
    it.SetSpacing(spacing)
    it.SetCellArray(cell_array)
    errors, _ = collect(it)
    it.Update()
    assert not errors, errors
    return it.GetOutput()


def steps_of(data):
    """Returns the vectors from voxel to voxel along each axis."""
    matrix = data.GetDirectionMatrix()
    return np.array([[matrix.GetElement(c, a) * data.GetSpacing()[a] for c in range(3)]
                     for a in range(3)])


def check_same(mesh, other, what):
    problem = difference(mesh, other)
    assert not problem, "%s: %s" % (what, problem)


def labels_mesh(source, name):
    return merge([mesh_of(source.GetClientSideObject().GetOutputDataObject(0),
                          MaterialIdArray=name).mesh])


GOLD = merge([mesh_of(CELLS, MaterialIdArray="Labels").mesh])


@in_folder
def test_same_mesh_by_the_proxies(at):
    """ParaView opens each file with the right reader; the mesh is the reference."""
    for path, words in straight_files(at):
        options = {"CellArray": words[1]} if "Other/CellData/FeatureIds" in words else {}
        source = simple.OpenDataFile(path, **options)
        kind = "DREAM3DReader" if path.endswith("dream3d") else "LabelImageReader"
        assert type(source).__name__ == kind, (path, source)
        source.UpdatePipeline()
        arrays = source.CellData if kind == "DREAM3DReader" else source.PointData
        name = words[1] if words else "FeatureIds" if kind == "DREAM3DReader" else "Labels"
        assert list(arrays.keys()) == [name], (path, arrays.keys())
        check_same(labels_mesh(source, name), GOLD, path)


@in_folder
def test_same_mesh_by_sculptor(at):
    """sculptor makes the reference mesh of each file on 1 and 3 ranks."""
    for path, words in straight_files(at):
        for ranks in (1, 3):
            printed = mesh_file(path, at("out.vtu"), *words, ranks=ranks)
            place = "" if path.endswith("dream3d") else " of points"
            how = place if "--labels" in words else ", the only array of integers"
            assert "(labels%s)" % how in printed, (path, printed)
            check_same(merge(read_pieces(at("out.vtu"))), GOLD, (path, ranks))


@in_folder
def test_volumes(at):
    """One image of several is selected by its number, also in compressed files and on ranks."""
    other = np.where(LABELS == 2, 5, 0).astype("u1")
    dim = (4, *LABELS.shape[::-1], 2, 1, 1, 1)
    for path in (write_nifti(at("a.nii.gz"), np.stack([LABELS, other]), MIDDLE, dim=dim),
                 write_nifti(at("b.nii"), np.stack([LABELS, other]), MIDDLE, dim=dim),
                 write_mgh(at("c.mgz"), np.stack([LABELS, other]), MIDDLE)):
        for volume, values in enumerate((LABELS, other)):
            gold = merge([mesh_of(image({"Labels": values.astype("i4")}),
                                  MaterialIdArray="Labels").mesh])
            source = simple.OpenDataFile(path, Volume=volume)
            source.UpdatePipeline()
            check_same(labels_mesh(source, "Labels"), gold, (path, volume))
            for ranks in (1, 3):
                mesh_file(path, at("out.vtu"), "--volume", str(volume), ranks=ranks)
                check_same(merge(read_pieces(at("out.vtu"))), gold, (path, volume, ranks))
        refused(2, "but image 2 is requested", path, at("out.vtu"), "--volume", "2", ranks=3)
        refused(2, "from 0 to 1", path, at("out.vtu"))
    refused(2, "it holds 1 image, but image 1",
            write_nrrd(at("a.nrrd"), LABELS, MIDDLE), at("out.vtu"), "--volume", "1")


@in_folder
def test_names_in_nifti(at):
    """Names of the extension of Caret are names of materials; a table of the user replaces them."""
    names = ["liver", "left kidney", "liver (3)", "Material 4"]
    for path in (write_nifti(at("a.nii.gz"), LABELS, MIDDLE, extension=CARET),
                 write_nifti(at("b.nii"), LABELS, MIDDLE, extension=CARET, order=">")):
        source = simple.OpenDataFile(path)
        source.UpdatePipeline()
        mesh = mesh_of(source.GetClientSideObject().GetOutputDataObject(0),
                       MaterialIdArray="Labels").mesh
        found = mesh.GetFieldData().GetAbstractArray("MaterialNames")
        assert [found.GetValue(i) for i in range(found.GetNumberOfValues())] == names, path
        for ranks in (1, 3):
            printed = mesh_file(path, at("out.vtu"), ranks=ranks)
            assert all("%d %s  " % (i + 1, name) in printed
                       for i, name in enumerate(names)), printed
        save(at("table.txt"), b"1 bone\n")
        printed = mesh_file(path, at("out.vtu"), "--label-names", at("table.txt"))
        assert "1 bone  " in printed and "2 Material 2  " in printed, printed
    for text, warning in ((b"<CaretExtension><Label", "its Caret extension is not valid XML"),
                          (None, "one of its header extensions has a length of 2147483632 bytes")):
        path = write_nifti(at("c.nii"), LABELS, MIDDLE, extension=text or CARET)
        if text is None:
            raw = bytearray(open(path, "rb").read())
            raw[352:356] = (2 ** 31 - 16).to_bytes(4, "little")
            save(path, bytes(raw))
        result = sculptor(path, at("out.vtu"), ranks=3)
        assert result.returncode == 0 and warning in result.stderr, result
        check_same(merge(read_pieces(at("out.vtu"))), GOLD, warning)


@in_folder
def test_mgh_directions(at):
    """Each voxel lies where spacing, directions and centre say; without them as in FreeSurfer."""
    for steps in (QUARTER, MIRRORED, OBLIQUE):
        data = read(write_mgh(at("a.mgz"), LABELS, MIDDLE, steps))
        assert np.abs(steps_of(data) - steps).max() < 1e-6
        assert np.abs(np.subtract(data.GetOrigin(), MIDDLE)).max() < 1e-5, data.GetOrigin()
    raw = bytearray(open(write_mgh(at("b.mgh"), LABELS, MIDDLE), "rb").read())
    raw[28:30] = bytes(2)
    data = read(save(at("b.mgh"), bytes(raw)))
    assert np.array_equal(steps_of(data), [[-1, 0, 0], [0, 0, -1], [0, 1, 0]])
    assert data.GetOrigin() == (4.5, -6.5, 5.5), data.GetOrigin()


@in_folder
def test_trusted_dream3d(at):
    """A link to another file is read if the input is trusted."""
    os.makedirs(at("in"))
    path = write_dream3d(at("in/a.dream3d"), LABELS.astype("i4"), ORIGIN, SPACING)
    os.rename(path, at("b.dream3d"))
    with h5py.File(path, "w") as file:
        file["DataContainers"] = h5py.ExternalLink(at("b.dream3d"), "/DataContainers")
    refused(2, "leads to another file. If you trust the file", path, at("out.vtu"))
    source = simple.OpenDataFile(path, TrustInput=1)
    source.UpdatePipeline()
    check_same(labels_mesh(source, "FeatureIds"), GOLD, path)
    mesh_file(path, at("out.vtu"), "--trust-input", ranks=3)
    check_same(merge(read_pieces(at("out.vtu"))), GOLD, path)


@in_folder
def test_old_dream3d(at):
    """A file of DREAM.3D 4 with flat arrays."""
    path = write_old_dream3d(at("a.dream3d"), LABELS.astype("i4"), ORIGIN, SPACING)
    for ranks in (1, 3):
        mesh_file(path, at("out.vtu"), "--labels", "GrainIds", ranks=ranks)
        check_same(merge(read_pieces(at("out.vtu"))), GOLD, ranks)


@in_folder
def test_stack_of_slices(at):
    """TIFF files have no spacing along z; the first voxel lies at 0."""
    gold = image({"Labels": LABELS.astype("i4")})
    gold.SetOrigin([-0.5 * s for s in SPACING])
    gold = merge([mesh_of(gold, MaterialIdArray="Labels").mesh])
    for dtype in ("u1", "u2"):
        path = write_tiff(at(dtype + ".tif"), LABELS.astype(dtype))
        source = LabelImageReader(FileName=[path], Spacing=SPACING)
        source.UpdatePipeline()
        check_same(labels_mesh(source, "Labels"), gold, dtype)
        for ranks in (1, 3):
            mesh_file(path, at("out.vtu"), "--spacing", ",".join(map(str, SPACING)), ranks=ranks)
            check_same(merge(read_pieces(at("out.vtu"))), gold, (dtype, ranks))


@in_folder
def test_turned_images_lie_where_the_file_says(at):
    """The mesh is that of the image in its own axes, rotated and moved, also on ranks."""
    own = image({"Labels": LABELS.astype("i4")})
    own.SetOrigin([-0.5 * s for s in SPACING])
    for name, steps in (("quarter", QUARTER), ("mirrored", MIRRORED), ("oblique", OBLIQUE)):
        for path in (write_nrrd(at("a.nrrd"), LABELS, MIDDLE, steps),
                     write_meta(at("a.mha"), LABELS, MIDDLE, steps)):
            data = read(path)
            assert np.abs(steps_of(data)
                          - steps).max() < 1e-15 and np.allclose(data.GetOrigin(), MIDDLE, 0, 0), (
                              path, name)
            straight, result = mesh_of(own,
                                       MaterialIdArray="Labels"), mesh_of(
                                           data, MaterialIdArray="Labels")
            turn = steps / np.linalg.norm(steps, axis=1)[:, None]
            expected = dict(zip(straight.points("GlobalPointIds"),
                                points_of(straight) @ turn + MIDDLE))
            where = np.array([expected[i] for i in result.points("GlobalPointIds")])
            assert len(expected) == len(where) and np.abs(where
                                                          - points_of(result)).max() < 1e-12, (
                                                              path, name)
            mesh_file(path, at("out.vtu"), ranks=3)
            check_same(merge(read_pieces(at("out.vtu"))), merge([result.mesh]), (path, name))


@in_folder
def test_nifti_forms(at):
    """Each voxel lies where sform or qform say, for any order of slices.

    The sform has priority; a sheared sform is ignored if there is a qform.
    """
    generator = np.random.default_rng(7)
    for name, steps in (("straight", STRAIGHT), ("quarter", QUARTER), ("mirrored", MIRRORED),
                        ("oblique", OBLIQUE)):
        for forms in ("s", "q", "sq"):
            data = read(write_nifti(at("a.nii.gz"), LABELS, MIDDLE, steps, forms))
            values = vtk_to_numpy(data.GetPointData().GetArray("Labels")).reshape(LABELS.shape)
            for index in generator.integers(0, LABELS.shape[::-1], (20, 3)):
                place = [0.0] * 3
                data.TransformIndexToPhysicalPoint(*map(int, index), place)
                i, j, k = np.linalg.solve(steps.T, place - MIDDLE)
                nearest = np.rint([i, j, k]).astype(int)
                assert np.abs(nearest - [i, j, k]).max() < 1e-5, (name, forms)
                assert LABELS[tuple(nearest[::-1])] == values[tuple(index[::-1])], (
                    name, forms, index)
    data = read(write_nifti(at("none.nii"), LABELS, MIDDLE, QUARTER, forms=""))
    assert data.GetOrigin() == (0, 0, 0) and np.allclose(steps_of(data), STRAIGHT)
    raw = bytearray(open(write_nifti(at("both.nii"), LABELS, MIDDLE, STRAIGHT, "sq"), "rb").read())
    raw[280:328] = np.array([[0.25, 0.1, 0, 1], [0, 0.25, 0, 2], [0, 0, 0.5, 3]], "<f4").tobytes()
    data = read(save(at("both.nii"), bytes(raw)))
    assert np.allclose(steps_of(data), STRAIGHT) and np.allclose(data.GetOrigin(), MIDDLE)


@in_folder
def test_left_handed_nifti_on_ranks(at):
    """The order of slices is reversed, also in the parts of ranks."""
    path = write_nifti(at("a.nii.gz"), LABELS, MIDDLE, MIRRORED)
    gold = merge([mesh_of(read(path), MaterialIdArray="Labels").mesh])
    for ranks in (1, 3):
        mesh_file(path, at("out.vtu"), ranks=ranks)
        check_same(merge(read_pieces(at("out.vtu"))), gold, ranks)


@in_folder
def test_volume_fractions(at):
    """Integers with slope and intercept are volume fractions. They are random, so thin parts would
    have other volumes."""
    stored = np.random.default_rng(5).integers(1, 9, LABELS.shape).astype("u1") * (LABELS > 0)
    gold = merge([mesh_of(image({"Values": stored / 8}), VolumeFractionArrays=["Values"],
                          ThinParts=0).mesh])
    path = write_nifti(at("a.nii.gz"), stored + np.uint8(8), MIDDLE, slope=(0.125, -1))
    for ranks in (1, 3):
        printed = mesh_file(path, at("out.vtu"), "--set", "ThinParts=off", ranks=ranks)
        assert "materials from Values (all point arrays with values in [0, 1])" in printed
        check_same(merge(read_pieces(at("out.vtu"))), gold, ranks)
    path = write_nifti(at("b.nii.gz"), stored, MIDDLE, slope=(2.5, 0))
    refused(2, "Its point arrays: Values (double, 0 to 20).", path, at("out.vtu"))


@in_folder
def test_slope_that_is_no_number(at):
    """A slope that is not a number is ignored."""
    path = write_nifti(at("a.nii"), LABELS, MIDDLE, slope=(np.nan, np.nan))
    check_same(merge([mesh_of(read(path), MaterialIdArray="Labels").mesh]), GOLD, path)


@in_folder
def test_values_of_dream3d_keep_their_digits(at):
    """Values of DREAM.3D files keep their type and value."""
    for values in (LABELS + np.uint32(2 ** 31), LABELS + np.int64(2 ** 40), LABELS / 7):
        it = read(write_dream3d(at("a.dream3d"), values, ORIGIN, SPACING))
        assert (vtk_to_numpy(
            it.GetCellData().GetArray("FeatureIds")) == values.ravel()).all(), values.dtype
    refused(2, "labels are at most 2147483647",
            write_dream3d(at("b.dream3d"), LABELS + np.uint32(2 ** 31), ORIGIN, SPACING),
            at("out.vtu"))


@in_folder
def test_list(at):
    """`sculptor --list` shows size, arrays and materials."""
    path = write_nifti(at("a.nii.gz"), LABELS, MIDDLE, OBLIQUE)
    for ranks in (1, 3):
        listed = sculptor("--list", path, ranks=ranks).stdout.splitlines()
        assert listed[2] == "1287 cells around points, 9 x 11 x 13", listed
        assert listed[5].split()[:2] == ["point",
                                         "array"] and listed[6].split() == [
                                             "Labels", "unsigned", "char", "1", "0", "4"]
        assert listed[9].split(None, 1) == ["Labels", "labels: integers from 0 to 4"], listed
        assert listed[11] == "materials from Labels (labels, the only array of integers)" and [
            int(l) for l in listed[12:]] == [1, 2, 3, 4]
    several = write_nifti(at("several.nii"), np.stack([0 * LABELS, LABELS]), MIDDLE,
                          dim=(4, 9, 11, 13, 2, 1, 1, 1))
    for words, volume, least in (([], 0, 0), (["--volume", "1"], 1, 4)):
        listed = sculptor("--list", several, *words).stdout.splitlines()
        assert listed[2] == ("2 volumes, selected by --volume, from 0; the values below are of "
                             "volume %d" % volume), listed
        assert listed[7].split()[-1] == str(least), listed
    listed = sculptor("--list",
                      write_dream3d(at("a.dream3d"), LABELS, ORIGIN, SPACING)).stdout.splitlines()
    assert listed[2] == "1287 cells, 9 x 11 x 13" and listed[
        11] == "materials from FeatureIds (labels, the only array of integers)", listed


@in_folder
def test_chosen_materials(at):
    """--material selects labels of points."""
    kept = np.where(np.isin(LABELS, (2, 3)), LABELS, 0)
    mesh_file(write_nrrd(at("a.nrrd"), LABELS, MIDDLE), at("out.vtu"), "--material", "2,3", ranks=3)
    gold = mesh_of(image({"Labels": kept.astype("i4")}), MaterialIdArray="Labels")
    check_same(merge(read_pieces(at("out.vtu"))), merge([gold.mesh]), "labels")


def cut(path, length):
    with open(path, "r+b") as file:
        file.truncate(length)
    return path


@in_folder
def test_refused(at):
    """Damaged, truncated and unsupported files give one message each."""
    shear = np.array([[0.25, 0.1, 0], [0, 0.25, 0], [0, 0, 0.5]])
    many = LABELS[None].repeat(2, 0)
    for path, text in (
            (at("none.nii"), "No such file"),
            (save(at("empty.mha")), "the file is empty"),
            (save(at("text.nii"), b"hello\n" * 99), "it is not a NIfTI file"),
            (cut(write_nifti(at("cut.nii"), LABELS, MIDDLE), 900),
             "truncated: they have 1287 bytes"),
            (cut(write_nifti(at("cut.nii.gz"), LABELS, MIDDLE), 250),
             "its compressed values are truncated"),
            (write_nifti(at("shear.nii"), LABELS, MIDDLE, shear), "its sform is sheared"),
            (write_nifti(at("many.nii"), many, MIDDLE, dim=(4, 9, 11, 13, 2, 1, 1, 1)),
             "it holds 2 images (times, or maps of several regions). Select one of them by its "
             "number, --volume or Volume, from 0 to 1."),
            (write_nifti(at("long.nii"), LABELS, MIDDLE, dim=(3, 9000, 9000, 9000, 1, 1, 1, 1)),
             "are truncated"),
            (save(at("text.nrrd"), b"hello\n"), "it is not an NRRD file"),
            (cut(write_nrrd(at("cut.nrrd"), LABELS, MIDDLE, encoding="raw"), 900),
             "truncated: they have 1287 bytes"),
            (cut(write_nrrd(at("cut_gzip.nrrd"), LABELS, MIDDLE), 400),
             "its compressed values are truncated"),
            (write_nrrd(at("ascii.nrrd"), LABELS, MIDDLE, encoding="ascii"),
             "its encoding is 'ascii'. Supported encodings: raw and gzip"),
            (write_nrrd(at("shear.nrrd"), LABELS, MIDDLE, shear),
             "its space directions are not at right angles"),
            (save(at("four.nrrd"),
                  b"NRRD0004\ntype: uchar\ndimension: 4\nsizes: 2 3 3 3\nencoding: raw\n\n",
                  bytes(54)),
             "its image has 4 dimensions"),
            (save(at("sizes.nrrd"),
                  b"NRRD0004\ntype: uchar\ndimension: 3\nsizes: 3 x\nencoding: raw\n\n", bytes(27)),
             "its header says 'sizes: 3 x', where 3 integers are required"),
            (save(at("text.mha"), b"hello\n"), "it is not a MetaImage file"),
            (save(at("dims.mhd"),
                  b"ObjectType = Image\nNDims = 999999999\nDimSize = 1 1 1\n"
                  b"ElementDataFile = a.raw\n"),
             "its image has 999999999 dimensions"),
            (cut(write_meta(at("cut.mha"), LABELS, MIDDLE), 900),
             "truncated: they have 1287 bytes"),
            (write_meta(at("shear.mhd"), LABELS, MIDDLE, shear),
             "TransformMatrix is not a rotation"),
            (save(at("text.tif"), b"hello\n"), "it is not a TIFF file"),
            (cut(write_imagej(at("imagej.tif"), LABELS), 900), "truncated: they have 1287 bytes"),
            (save(at("text.mgz"), b"hello\n" * 99), "it is not an MGH file of version 1"),
            (cut(write_mgh(at("cut.mgh"), LABELS, MIDDLE), 900), "truncated: they have 1287 bytes"),
            (write_mgh(at("type.mgh"), LABELS, MIDDLE, kind_of_values=7), "are of type 7 of MGH"),
            (save(at("a.bmp"), b"BM"), "its suffix is not that of an image format"),
            (save(at("text.dream3d"), b"hello\n"), "it is not an HDF5 file, or it is damaged"),
            (cut(write_dream3d(at("cut.dream3d"), LABELS, ORIGIN, SPACING), 3000),
             "it is not an HDF5 file, or it is damaged"),
            (write_dream3d(at("name.dream3d"), LABELS, ORIGIN, SPACING, name="GrainIds"),
             "it holds no cell array 'FeatureIds' with one value per cell. Other arrays: "
             "GrainIds. Arrays of other sizes: EulerAngles (13 x 11 x 9 x 3), Volumes (4 x 1). "
             "Choose one of them: --labels GrainIds (sculptor) or Cell Array (ParaView)."),
            (write_dream3d(at("two.dream3d"), LABELS, ORIGIN, SPACING, more=["Other"]),
             "it holds two cell arrays FeatureIds")):
        it = vtkVolumeFractionImageReader()
        it.SetFileName(path)
        errors, _ = collect(it)
        it.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)
        it.Update()
        assert len(errors) == 1 and "Cannot read %s: " % path in errors[0] and text in errors[0], (
            path, errors)
        assert (it.GetOutput().GetPointData().GetNumberOfArrays()
                == it.GetOutput().GetCellData().GetNumberOfArrays() == 0), path
        if path.endswith(".bmp"):
            refused(1, "Save the picture as .png or .tif", path, at("out.vtu"))
            continue
        for ranks in (1,
                      3) if path.endswith(("text.nii", "cut_gzip.nrrd", "two.dream3d")) else (1,):
            refused(2, text, path, at("out.vtu"), ranks=ranks)


@in_folder
def test_wrong_spacing(at):
    """A negative spacing is rejected."""
    path = write_tiff(at("a.tif"), LABELS)
    it = vtkVolumeFractionImageReader()
    it.SetFileName(path)
    it.SetSpacing(1, 1, -1)
    errors, _ = collect(it)
    it.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)
    it.Update()
    assert len(errors) == 1 and "Spacing must be above 0" in errors[0], errors


main(globals())
