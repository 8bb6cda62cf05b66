"""Tests that read() and vfmesh take files of all formats, and give the meshes of their arrays."""

import pickle
import struct

import numpy as np
import pytest

import volume_fraction_mesh as vfm
from fields import BALL, PLATE, STATE, same
from images import BOX, CELLS, ELEMENTS, hexahedra, legacy_vtk, round_ball, two_boxes
from volume_fraction_mesh.__main__ import main

LABELS = two_boxes()
CARET = (b'<?xml version="1.0"?><CaretExtension><VolumeInformation Index="0"><LabelTable>%s'
         b'</LabelTable></VolumeInformation></CaretExtension>')


def volumes(mesh):
    """Returns the volume of each material by its id."""
    return dict(zip(mesh.materials["MaterialId"].tolist(), mesh.materials["MeshVolume"].tolist()))


def check_boxes(mesh, ids=(1, 2), volume=BOX, elements=ELEMENTS):
    found = volumes(mesh)
    print(mesh, found)
    assert len(mesh) == elements and set(found) == set(ids)
    assert all(np.isclose(value, volume, rtol=1e-6) for value in found.values())


@pytest.fixture
def run(tmp_path, capsys):
    """Runs vfmesh with a file of tmp_path; returns the mesh, or the message of an error."""

    def run_words(name, *words):
        out = tmp_path / "out.npz"
        out.unlink(missing_ok=True)
        status = main([str(tmp_path / name), str(out), *words, "--quiet"])
        told = capsys.readouterr().err
        if status:
            assert not out.exists() and told.startswith("vfmesh: ")
            assert told.count("\n") == 1, told
            return told
        return vfm.load(out)

    return run_words


@pytest.mark.parametrize("grid", ["STRUCTURED_POINTS", "RECTILINEAR_GRID"])
def test_legacy_vtk(tmp_path, run, grid):
    pytest.importorskip("vtkmodules")
    legacy_vtk(tmp_path / "a.vtk", LABELS, grid, (0.5, 1, 2))
    arrays = vfm.read(tmp_path / "a.vtk")
    assert [float(x[-1]) for x in arrays.coordinates] == [7, 12, 20] and list(arrays) == ["ids"]
    mesh = vfm.hexes(arrays)
    check_boxes(mesh)
    assert same(mesh, vfm.hexes(labels=LABELS, spacing=(0.5, 1, 2)))
    check_boxes(run("a.vtk"))


def write_cells(path, points, corners, values, kind=12):
    pyvista = pytest.importorskip("pyvista")
    grid = pyvista.UnstructuredGrid({kind: corners}, points)
    grid.cell_data["ids"] = values
    grid.save(path)
    return grid


@pytest.mark.parametrize("name", ["a.vtk", "a.vtu"])
@pytest.mark.parametrize("kind", [12, 11])
def test_hexahedra_of_a_grid(tmp_path, run, name, kind):
    """The order of cells and corners, and the numbers of points, do not matter."""
    plain = vfm.hexes(labels=LABELS, spacing=(0.5, 1, 2))
    for seed in (0, 1):
        given = hexahedra(LABELS, (0.5, 1, 2), seed, kind)
        grid = write_cells(tmp_path / name, *given, kind)
        assert same(vfm.hexes(vfm.read(tmp_path / name)), plain)
        assert same(vfm.hexes(grid, arrays=["ids"]), plain)
    check_boxes(run(name))


def test_structured_grid(tmp_path):
    pyvista = pytest.importorskip("pyvista")
    nodes = [np.arange(n + 1) * 0.5 for n in CELLS]
    grid = pyvista.StructuredGrid(*np.meshgrid(*nodes, indexing="ij"))
    grid.cell_data["ids"] = LABELS.ravel(order="F")
    grid.save(tmp_path / "a.vts")
    check_boxes(vfm.hexes(vfm.read(tmp_path / "a.vts")), volume=BOX / 8)


def shifted(points, corners, values):
    points = points.copy()
    points[corners[7][3]] += 0.2
    return points, corners, values


def turned(points, corners, values):
    return points @ np.array([[0.6, -0.8, 0], [0.8, 0.6, 0], [0, 0, 1.0]]), corners, values


def twice(points, corners, values):
    return points, corners[[*range(len(corners)), 5]], values[[*range(len(corners)), 5]]


def with_hole(points, corners, values):
    keep = np.arange(len(corners)) != 20
    return points, corners[keep], values[keep]


def flat(points, corners, values):
    return points * [1, 1, 0], corners, values


def halved(points, corners, values):
    """One cell is two cells of half its height."""
    own = points[corners[0]]
    own[:, 2] /= 2
    points = np.concatenate([points, own])
    corners = corners.copy()
    corners[0] = len(points) - 8 + np.arange(8)
    return points, corners, values


@pytest.mark.parametrize("change, text", [
    (shifted, "distorted or rotated"), (turned, "distorted or rotated"),
    (twice, "lies in the place of another"),
    (with_hole, r"leave holes in the box of 14 x 12 x 10 cells, the first at cell \(0, 2, 0\)"),
    (flat, "is flat"), (halved, "extends over several layers of other hexahedra along z"),
])
def test_hexahedra_of_no_grid(tmp_path, run, change, text):
    write_cells(tmp_path / "a.vtu", *change(*hexahedra(LABELS)))
    with pytest.raises(ValueError, match=text) as told:
        vfm.read(tmp_path / "a.vtu")
    assert "a.vtu" in str(told.value) and "Resample To Image" in str(told.value)
    assert "Resample To Image" in run("a.vtu")


def test_tetrahedra(tmp_path):
    pyvista = pytest.importorskip("pyvista")
    grid = pyvista.UnstructuredGrid({10: np.array([[0, 1, 2, 3]])}, np.eye(4)[:, :3])
    grid.cell_data["ids"] = [1]
    grid.save(tmp_path / "a.vtu")
    with pytest.raises(ValueError, match="cell 0 is a tetrahedron: .* Resample To Image"):
        vfm.read(tmp_path / "a.vtu")


def test_negative_ids(tmp_path, run):
    pytest.importorskip("vtkmodules")
    legacy_vtk(tmp_path / "a.vtk", two_boxes(1, -7, np.int32))
    told = run("a.vtk")
    assert "from -7 to 1" in told and "renumber negative ids" in told and "--threshold" in told


def test_arrays_of_a_file(tmp_path):
    arrays = {"ball": BALL, "plate": PLATE, **STATE}
    np.savez(tmp_path / "a.npz", **arrays)
    found = vfm.read(tmp_path / "a.npz", spacing=0.5)
    assert set(found) == set(arrays) and found.order == "xyz"
    mesh = vfm.hexes(found, arrays=["ball", "plate"], state=["temperature"], density="density")
    plain = vfm.hexes({"ball": BALL, "plate": PLATE}, spacing=0.5, density=STATE["density"],
                      state={"temperature": STATE["temperature"]})
    assert same(mesh, plain) and set(mesh.state) == set(plain.state)
    assert np.array_equal(mesh.state["temperature"], plain.state["temperature"])
    assert list(vfm.read(tmp_path / "a.npz", arrays=["plate"])) == ["plate"]
    assert same(vfm.hexes(pickle.loads(pickle.dumps(found)), arrays=["ball"]),
                vfm.hexes(BALL, spacing=0.5))
    np.save(tmp_path / "a.npy", np.stack([BALL, PLATE]))
    assert same(vfm.hexes(vfm.read(tmp_path / "a.npy")), vfm.hexes([BALL, PLATE]))
    np.save(tmp_path / "a.npy", LABELS.transpose(2, 1, 0))
    check_boxes(vfm.hexes(vfm.read(tmp_path / "a.npy", order="zyx", origin=(1, 2, 3))))


def test_names_in_nifti(tmp_path, run):
    nibabel = pytest.importorskip("nibabel")
    labels = [(1, "liver"), (2, "left kidney"), (0, "???"), (5, "liver")]
    table = CARET % b"".join(b'<Label Key="%d"><![CDATA[%s]]></Label>' % (key, name.encode())
                             for key, name in labels)
    for code in (0, 30):
        image = nibabel.Nifti1Image(LABELS, np.eye(4))
        image.header.extensions.append(nibabel.nifti1.Nifti1Extension(code, table))
        nibabel.save(image, tmp_path / "a.nii.gz")
        assert vfm.read(tmp_path / "a.nii.gz").names == {1: "liver", 2: "left kidney",
                                                         5: "liver (5)"}
        mesh = run("a.nii.gz")
        check_boxes(mesh)
        assert mesh.materials["Name"] == ["liver", "left kidney"]
        read = nibabel.load(tmp_path / "a.nii.gz")
        assert vfm.hexes(labels=read, names={2: "liver"}).materials["Name"] == ["Material 1",
                                                                                "liver"]
    (tmp_path / "names.txt").write_text("1 one\n")
    assert run("a.nii.gz", "--names", str(tmp_path / "names.txt")).materials["Name"] == [
        "one", "left kidney"]


def write_segments(path, layers, segments, is_last=False):
    """Writes layers a[x, y, z] as a .seg.nrrd of 3D Slicer. is_last: the axis of layers is last."""
    several = len(layers) > 1
    values = np.stack(layers, -1 if is_last else 0) if several else layers[0]
    before, after = several and not is_last, several and is_last
    lines = ["NRRD0004", "type: unsigned char", "dimension: %d" % values.ndim,
             "space: left-posterior-superior", "sizes: " + " ".join(map(str, values.shape)),
             "space directions: %s(1,0,0) (0,1,0) (0,0,1)%s" % (
                 "none " if before else "", " none" if after else ""),
             "kinds: %sdomain domain domain%s" % (
                 "list " if before else "", " list" if after else ""),
             "encoding: raw", "space origin: (0,0,0)"]
    for number, (name, value, layer) in enumerate(segments):
        lines += ["Segment%d_%s:=%s" % (number, key, text) for key, text in (
            ("ID", "Segment_%d" % number), ("Name", name), ("LabelValue", value),
            ("Layer", layer))]
    path.write_bytes(("\n".join(lines) + "\n\n").encode() + values.tobytes(order="F"))


def test_segments_of_slicer(tmp_path, run):
    pytest.importorskip("SimpleITK")
    path = tmp_path / "a.seg.nrrd"
    write_segments(path, [LABELS], [("left lobe", 1, 0), ("right lobe", 2, 0)])
    mesh = run("a.seg.nrrd")
    check_boxes(mesh)
    assert mesh.materials["Name"] == ["left lobe", "right lobe"]
    first, second = two_boxes(1, 0), two_boxes(0, 1)
    data = path.read_bytes()
    path.write_bytes(data.replace(b"left lobe", b"P\xf4le"))  # Latin-1
    assert run("a.seg.nrrd").materials["Name"] == ["P\xf4le", "right lobe"]
    segments = [("a", 1, 0), ("b", 1, 1)]
    for is_last in (False, True):
        write_segments(path, [first, second], segments, is_last)
        mesh = run("a.seg.nrrd")
        check_boxes(mesh)
        assert mesh.materials["Name"] == ["a", "b"]
        assert run("a.seg.nrrd", "--volume", "1").materials["Name"] == ["b"]
    write_segments(path, [first, two_boxes(1, 1)], segments)
    assert "segments 'a' and 'b' share 240 voxels" in run("a.seg.nrrd")


def test_several_volumes(tmp_path, run):
    nibabel = pytest.importorskip("nibabel")
    both = np.stack([two_boxes(1, 2), two_boxes(0, 3)], axis=-1)
    nibabel.save(nibabel.Nifti1Image(both, np.eye(4)), tmp_path / "a.nii.gz")
    told = run("a.nii.gz")
    assert "'Material 2' (integers from 0 to 3)" in told and "--volume N" in told
    check_boxes(run("a.nii.gz", "--volume", "0"))
    check_boxes(run("a.nii.gz", "--volume", "1"), [3], elements=ELEMENTS // 2)
    assert "there is no volume 2: it has 2" in run("a.nii.gz", "--volume", "2")
    with pytest.raises(ValueError, match="Choose one volume"):
        vfm.hexes(nibabel.load(tmp_path / "a.nii.gz"))
    masks = np.stack([two_boxes(1, 0), two_boxes(0, 1)], axis=-1)
    nibabel.save(nibabel.Nifti1Image(masks, np.eye(4)), tmp_path / "masks.nii")
    check_boxes(run("masks.nii"))
    parts = np.stack([BALL, PLATE], axis=-1).astype(np.float32)
    nibabel.save(nibabel.Nifti1Image(parts, np.eye(4)), tmp_path / "parts.nii")
    assert len(run("parts.nii")) == len(vfm.hexes([parts[..., 0], parts[..., 1]]))


def write_mgh(path):
    """Writes labels as .mgz of FreeSurfer."""
    nibabel = pytest.importorskip("nibabel")
    nibabel.save(nibabel.MGHImage(LABELS.astype(np.int32), np.diag([2.0, 2, 2, 1])), path)


def test_mgz(tmp_path, run):
    write_mgh(tmp_path / "a.mgz")
    check_boxes(run("a.mgz"), volume=8 * BOX)


def test_scaled_labels(tmp_path, run):
    nibabel = pytest.importorskip("nibabel")
    nibabel.save(nibabel.Nifti1Image(two_boxes(17, 53, np.float32), np.eye(4)), tmp_path / "f.nii")
    check_boxes(run("f.nii"), (17, 53))
    image = nibabel.Nifti1Image(two_boxes(257, 514, np.int16), np.eye(4))
    image.header.set_slope_inter(1, 0)
    nibabel.save(image, tmp_path / "s.nii")
    data = bytearray((tmp_path / "s.nii").read_bytes())
    struct.pack_into("<f", data, 112, 1 / 257)
    (tmp_path / "s.nii").write_bytes(data)
    check_boxes(run("s.nii"), (1, 2))


def test_missing_slices_of_metaimage(tmp_path, run):
    pytest.importorskip("SimpleITK")
    (tmp_path / "a.mhd").write_text("NDims = 3\nDimSize = 2 2 2\nElementType = MET_UCHAR\n"
                                    "ElementDataFile = part_%03d.raw 1 2 1\n")
    (tmp_path / "part_001.raw").write_bytes(b"\1\0\0\1")
    assert "there is no file %s, which" % (tmp_path / "part_002.raw") in run("a.mhd")


@pytest.mark.parametrize("flat", [False, True])
def test_dream3d(tmp_path, run, flat):
    h5py = pytest.importorskip("h5py")
    with h5py.File(tmp_path / "a.dream3d", "w") as file:
        group = file.create_group("DataContainers/Grains")
        geometry = group.create_group("_SIMPL_GEOMETRY")
        for name, value in (("DIMENSIONS", CELLS), ("SPACING", (0.5, 0.5, 0.5)),
                            ("ORIGIN", (0.0, 0, 0))):
            geometry[name] = np.array(value)
        values = LABELS.transpose(2, 1, 0).astype(np.int32)
        group["CellData/FeatureIds"] = values.reshape(-1, 1) if flat else values[..., None]
        group["CellData/Phases"] = np.ones_like(values)[..., None]
    check_boxes(run("a.dream3d"), volume=BOX / 8)


def test_formats(tmp_path, run):
    (tmp_path / "a.xyz").write_text("text")
    for name, text in (("a.xyz", "is of an unknown format. Supported: .npy, .npz, .nii"),
                       ("b.nii", "There is no file"), ("", "contains no slices"),
                       ("*.bmp", "matches no slices")):
        assert text in run(name)
    (tmp_path / "a.stl").write_text("solid")
    with pytest.raises(ValueError, match=r"vfm.surface\(path, cells\)"):
        vfm.read(tmp_path / "a.stl")


def test_wrong_arguments(tmp_path):
    np.save(tmp_path / "a.npy", round_ball())
    for error, text, given in (
        (ValueError, "there is no step 1", dict(step=1)),
        (ValueError, "there is no volume 1", dict(volume=1)),
        (ValueError, "holds one array without a name", dict(arrays=["ball"])),
        (ValueError, "order is 'yxz'", dict(order="yxz")),
        (ValueError, "greater than 0", dict(spacing=-1)),
    ):
        with pytest.raises(error, match=text):
            vfm.read(tmp_path / "a.npy", **given)


def test_missing_package(tmp_path, monkeypatch):
    """A missing package is named in one line."""
    import sys

    for module, package, name in (("nibabel", "nibabel", "a.nii"),
                                  ("SimpleITK", "SimpleITK", "a.nrrd"),
                                  ("tifffile", "tifffile", "a.tif"), ("h5py", "h5py", "a.dream3d"),
                                  ("PIL.Image", "pillow", "a.png"),
                                  ("vtkmodules.vtkCommonCore", "vtk", "a.vti")):
        (tmp_path / name).write_text("text")
        monkeypatch.setitem(sys.modules, module, None)
        with pytest.raises(ImportError, match="pip install %s$" % package):
            vfm.read(tmp_path / name)


def test_empty_mesh(tmp_path, run):
    np.save(tmp_path / "a.npy", np.full((5, 5, 5), 0.2))
    assert "has no elements" in run("a.npy")
