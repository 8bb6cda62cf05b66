"""Tests that a damaged file of any format gives one line with its name, or arrays of numbers."""

import contextlib
import io

import numpy as np
import pytest

import volume_fraction_mesh as vfm
from images import hexahedra, legacy_vtk, two_boxes
from test_read import write_cells, write_mgh, write_segments
from test_stacks import PICTURE, sizes, write_slices

LABELS = two_boxes()


def write_nifti(path):
    nibabel = pytest.importorskip("nibabel")
    nibabel.save(nibabel.Nifti1Image(LABELS, np.eye(4)), path)


def write_sitk(path):
    sitk = pytest.importorskip("SimpleITK")
    sitk.WriteImage(sitk.GetImageFromArray(LABELS), str(path))


def write_image_data(path):
    pyvista = pytest.importorskip("pyvista")
    image = pyvista.ImageData(dimensions=[n + 1 for n in LABELS.shape])
    image.cell_data["ids"] = LABELS.ravel(order="F")
    image.save(path)


def write_tiff(path, **given):
    pytest.importorskip("tifffile").imwrite(path, LABELS, **given)


def write_picture(path):
    pytest.importorskip("PIL.Image").fromarray(PICTURE).save(path)


def write_dream3d(path):
    h5py = pytest.importorskip("h5py")
    with h5py.File(path, "w") as file:
        for name, value in (("DIMENSIONS", LABELS.shape[::-1]), ("SPACING", (1.0, 1, 1)),
                            ("ORIGIN", (0.0, 0, 0))):
            file["DataContainers/G/_SIMPL_GEOMETRY/" + name] = np.array(value)
        file["DataContainers/G/CellData/FeatureIds"] = LABELS[..., None].astype(np.int32)


WRITERS = {
    "a.npy": lambda path: np.save(path, LABELS),
    "a.npz": lambda path: np.savez(path, ids=LABELS),
    "b.npz": lambda path: np.savez_compressed(path, ids=LABELS),
    "a.nii": write_nifti,
    "a.nii.gz": write_nifti,
    "a.mgz": write_mgh,
    "a.nrrd": write_sitk,
    "b.seg.nrrd": lambda path: write_segments(path, [LABELS], [("a", 1, 0)]),
    "a.mha": write_sitk,
    "a.vti": write_image_data,
    "a.vtk": lambda path: legacy_vtk(path, LABELS),
    "b.vtk": lambda path: legacy_vtk(path, LABELS, "RECTILINEAR_GRID"),
    "a.vtu": lambda path: write_cells(path, *hexahedra(LABELS)),
    "c.vtk": lambda path: write_cells(path, *hexahedra(LABELS)),
    "a.tif": write_tiff,
    "b.tif": lambda path: write_tiff(path, compression="zlib"),
    "c.tif": lambda path: write_tiff(path, imagej=True),
    "d.tif": lambda path: write_tiff(path, description=sizes(X=1, Y=1), metadata=None),
    "a.png": write_picture,
    "a.bmp": write_picture,
    "a.dream3d": write_dream3d,
}


def try_file(path):
    """Reads and checks a damaged file. Returns whether it was rejected."""
    told = io.StringIO()
    try:
        with contextlib.redirect_stderr(told):
            found = vfm.read(path)
    except (ValueError, TypeError, MemoryError) as error:
        text = str(error)
        assert text.count("\n") == 0 and text.isprintable() and path.name in text, text
        assert len(text) < 700, text
        return True
    assert all(array.dtype.kind in "iuf" for array in found.values())
    return False


@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize("name", WRITERS)
def test_damaged(tmp_path, name, capfd):
    path = tmp_path / name
    WRITERS[name](path)
    assert not try_file(path)
    whole = path.read_bytes()
    lengths = sorted({0, 1, 7, 60, 350, len(whole) // 4, len(whole) // 2, 3 * len(whole) // 4})
    rejected = []
    if path.suffix == ".vtk":
        lengths = lengths[::3]
    for length in lengths:
        if length < len(whole) // 2 + 1:
            path.write_bytes(whole[:length])
            rejected.append(try_file(path))
    assert all(rejected), list(zip(lengths, rejected))
    random = np.random.default_rng(1)
    trials = 3 if path.suffix == ".vtk" else 60  # a process reads each .vtk
    for _ in range(trials):  # most bytes that describe the file lie at its beginning or end
        data = bytearray(whole)
        place = [random.integers(min(400, len(data))), -1 - random.integers(min(300, len(data))),
                 random.integers(len(data))][random.integers(3)]
        data[place] = random.integers(256)
        path.write_bytes(data)
        try_file(path)
    assert capfd.readouterr().err == ""


def test_cells_that_crash_the_reader_of_vtk(tmp_path):
    """A number of points that is not 8 makes the reader of VTK 9.7 write beyond its memory."""
    pytest.importorskip("vtkmodules")
    points, corners, values = hexahedra(LABELS[:5, :5, :5])
    lines = ["# vtk DataFile Version 3.0", "test", "ASCII", "DATASET UNSTRUCTURED_GRID",
             "POINTS %d float" % len(points), *(" ".join(map(str, point)) for point in points),
             "CELLS %d %d" % (len(corners), 9 * len(corners)),
             *("8 " + " ".join(map(str, cell)) for cell in corners),
             "CELL_TYPES %d" % len(corners), *["12"] * len(corners), "CELL_DATA %d" % len(corners),
             "SCALARS ids int 1", "LOOKUP_TABLE default", *map(str, values.tolist()), ""]
    path = tmp_path / "a.vtk"
    path.write_text("\n".join(lines))
    assert not try_file(path)
    first = 6 + len(points)
    for line, text in ((first, "9" + lines[first][1:]), (first, "-8" + lines[first][1:]),
                       (first + 60, "8 1 2 3 4 5 6 7 8 9 10 11"), (first + 120, "8 1 2 x 4")):
        path.write_text("\n".join([*lines[:line], text, *lines[line + 1:]]))
        assert try_file(path)


def test_damaged_slice(tmp_path):
    pytest.importorskip("tifffile")
    write_slices(tmp_path / "a", ["1.tif", "2.tif"], LABELS[:2])
    whole = (tmp_path / "a" / "2.tif").read_bytes()
    (tmp_path / "a" / "2.tif").write_bytes(whole[:len(whole) // 2])
    with pytest.raises(ValueError, match="Cannot read .*2.tif: "):
        vfm.read(tmp_path / "a")


@pytest.mark.parametrize("name", WRITERS)
def test_text_in_place_of_a_file(tmp_path, name):
    path = tmp_path / name
    path.write_bytes(b"\x1b[31m\x07 no such format\n\n\0" * 20)
    assert try_file(path)
