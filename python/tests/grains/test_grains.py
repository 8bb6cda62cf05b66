"""Tests orientations and phases of grains: conversions, files of DREAM.3D, tables for solvers."""

import re

import numpy as np
import pytest

import volume_fraction_mesh as vfm

LABELS = np.ones((6, 5, 4), int)
LABELS[3:] = 2
LABELS[:, 3:] += 3  # 1, 2, 4, 5
IDS = (1, 2, 4, 5)
EULER = np.radians([[30, 40, 50], [350, 90, 10], [0, 0, 0], [10, 180, 0], [123, 12, 321]])


@pytest.fixture(scope="module")
def mesh():
    return vfm.tets(labels=LABELS)


def grains():
    return vfm.Grains(EULER, phases=[1, 2, 1, 2, 1], phase_names={1: "Ni-base", 2: "2nd phase"})


def turn(axis, angle):
    """Returns the matrix that turns vectors by an angle."""
    c, s = np.cos(angle), np.sin(angle)
    return np.array({"x": [[1, 0, 0], [0, c, -s], [0, s, c]],
                     "z": [[c, -s, 0], [s, c, 0], [0, 0, 1]]}[axis])


def test_conversions():
    """Axes of the crystal: those of the sample, turned about z, the new x and the new z."""
    own = grains()
    for axes, (first, middle, last) in zip(own.axes(), EULER):
        assert np.allclose(axes.T, turn("z", first) @ turn("x", middle) @ turn("z", last))
    assert np.allclose(np.linalg.norm(own.quaternions, axis=1), 1)
    again = vfm.Grains(quaternions=-3 * own.quaternions)
    assert np.allclose(again.quaternions, own.quaternions)
    assert np.allclose(again.axes(), own.axes())
    assert np.allclose(again.euler_angles[[0, 1, 2, 4]], EULER[[0, 1, 2, 4]])
    assert np.allclose(vfm.Grains(again.euler_angles).axes(), own.axes())
    random = np.random.default_rng(1).normal(size=(500, 4))
    random[:3] = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 0, 1]]
    turned = vfm.Grains(quaternions=random)
    assert np.allclose(vfm.Grains(turned.euler_angles).axes(), turned.axes())
    assert (turned.euler_angles >= 0).all() and (turned.euler_angles < 2 * np.pi).all()


def test_rows_are_sorted():
    own = vfm.Grains(EULER[:3], ids=[7, 2, 5], phases=[3, 1, 1])
    assert own.ids.tolist() == [2, 5, 7] and own.phases.tolist() == [1, 1, 3]
    assert np.array_equal(own.euler_angles, EULER[[1, 2, 0]])
    assert own.phase_names == {1: "phase 1", 3: "phase 3"} and len(own) == 3


@pytest.mark.parametrize("given, error, text", [
    ({}, TypeError, "either"),
    ({"euler_angles": EULER, "quaternions": np.ones((5, 4))}, TypeError, "either"),
    ({"euler_angles": EULER[0]}, ValueError, r"euler_angles has the shape \(3,\)"),
    ({"euler_angles": [[0, np.nan, 0]]}, ValueError, "Row 0 of euler_angles is not finite"),
    ({"quaternions": [[1, 0, 0, 0], [0, 0, 0, 0]]}, ValueError, "quaternion of row 1 is 0"),
    ({"euler_angles": EULER, "ids": [1, 2]}, ValueError, "ids must be 5 integers"),
    ({"euler_angles": EULER, "ids": [0, 1, 2, 3, 4]}, ValueError, "label 0 in ids"),
    ({"euler_angles": EULER, "ids": [9, 1, 2, 3, 9]}, ValueError, "label 9 occurs twice"),
    ({"euler_angles": EULER, "phases": [0.5] * 5}, ValueError, "phases must be 5 integers"),
])
def test_wrong_values(given, error, text):
    with pytest.raises(error, match=text):
        vfm.Grains(**given)


def test_arrays(mesh, tmp_path):
    arrays = grains().arrays(mesh)
    for number in IDS:
        has = mesh.material == number
        assert np.allclose(arrays["EulerAngles"][has], np.degrees(EULER[number - 1]))
        assert (arrays["Phase"][has] == (2 if number in (2, 4) else 1)).all()
        assert np.allclose(arrays["Quaternion"][has], grains().quaternions[number - 1])
    with pytest.raises(ValueError, match="material 4, which is none of the 3 grains"):
        vfm.Grains(EULER[:3]).arrays(mesh)
    with pytest.warns(vfm.VolumeFractionMeshWarning, match="Label 0"):
        void = vfm.tets(labels=np.where(LABELS == 4, 0, LABELS), mesh_void=True)
    assert (grains().arrays(void)["Phase"][void.material == 0] == 0).all()


def test_exodus(tmp_path):
    netcdf = pytest.importorskip("netCDF4")
    mesh = vfm.tets(labels=LABELS)
    mesh.state.update(grains().arrays(mesh))
    mesh.save(tmp_path / "grains.e")
    with netcdf.Dataset(tmp_path / "grains.e") as data:
        names = list(netcdf.chartostring(data["name_elem_var"][:]))
        for block, number in enumerate(data["eb_prop1"][:].tolist(), 1):
            read = {name: data["vals_elem_var%deb%d" % (names.index(name) + 1, block)][0]
                    for name in names}
            angles = np.degrees(EULER[number - 1])
            for axis, angle in zip("XYZ", angles):
                assert np.allclose(read["EulerAngles_" + axis], angle)
            assert (read["Phase"] == grains().phases[number - 1]).all()


def test_abaqus(mesh, tmp_path):
    own = grains()
    mesh.save(tmp_path / "mesh.inp")
    own.save(tmp_path / "orientations.inp", mesh)
    text = (tmp_path / "orientations.inp").read_text()
    rows = re.findall(r"\*ORIENTATION, NAME=GRAIN_(\d+), SYSTEM=RECTANGULAR\n(.*)", text)
    axes = {int(number): np.array(row.split(","), float).reshape(2, 3) for number, row in rows}
    sections = re.findall(
        r"\*SOLID SECTION, ELSET=EB(\d+), MATERIAL=(\w+), ORIENTATION=GRAIN_(\d+)", text)
    assert sorted(axes) == [1, 2, 4, 5] == [int(elset) for elset, _, _ in sections]
    for elset, material, orientation in sections:
        number = int(elset)
        assert elset == orientation
        assert material == {1: "NI_BASE", 2: "S_2ND_PHASE"}[own.phases[number - 1]]
        assert np.allclose(axes[number], own.axes()[number - 1, :2], rtol=0, atol=1e-14)
    sets = re.findall(r"^\*ELEMENT, .*ELSET=EB(\d+)", (tmp_path / "mesh.inp").read_text(), re.M)
    assert [int(number) for number in sets] == [1, 2, 4, 5]


def test_moose(mesh, tmp_path):
    grains().save(tmp_path / "grains.txt", mesh)
    lines = (tmp_path / "grains.txt").read_text().splitlines()[4:]
    rows = np.array([line.split() for line in lines], float)
    assert rows.shape == (5, 4) and (rows[:, 3] == 1).all() and (rows[2, :3] == 0).all()
    assert np.allclose(rows[[0, 1, 3, 4], :3], np.degrees(EULER[[0, 1, 3, 4]]))
    grains().save(tmp_path / "grains.csv")
    assert np.allclose(np.loadtxt(tmp_path / "grains.csv", delimiter=","), np.degrees(EULER))


def test_damask(mesh, tmp_path):
    """Cells with the number k of .msh have the entry k, from 0."""
    own = grains()
    own.save(tmp_path / "material.yaml", mesh)
    text = (tmp_path / "material.yaml").read_text()
    entries = re.findall(r"- phase: (.*)\n        v: 1.0\n        O: \[(.*)\]", text)
    assert len(entries) == 6 and entries[3] == ("'Ni-base'", "1.0, 0.0, 0.0, 0.0")
    for number in IDS:
        phase, turned = entries[number]
        assert phase == "'%s'" % own.phase_names[own.phases[number - 1]]
        assert np.array_equal(np.array(turned.split(","), float), own.quaternions[number - 1])


def test_unwritable(mesh, tmp_path):
    with pytest.raises(ValueError, match="must be one of .inp, .yaml, .txt, .csv"):
        grains().save(tmp_path / "grains.dat")
    with pytest.raises(ValueError, match="no grains to write"):
        vfm.Grains(np.zeros((0, 3))).save(tmp_path / "grains.csv")
    with pytest.raises(ValueError, match="material 2, which is none"):
        vfm.Grains(EULER[:1]).save(tmp_path / "grains.csv", mesh)
    assert not list(tmp_path.iterdir())


def write_dream3d(h5py, path, arrays, is_new=False):
    """Writes a file of DREAM.3D 6, or of DREAM3D-NX, with arrays of the grains."""
    with h5py.File(path, "w") as file:
        group = file.create_group("DataStructure/Image" if is_new else "DataContainers/Image")
        values = (("DIMENSIONS", LABELS.shape), ("SPACING", (1.0, 1, 1)), ("ORIGIN", (0.0, 0, 0)))
        for name, value in values:
            if is_new:
                group.attrs["_" + name] = np.array(value)
            else:
                group["_SIMPL_GEOMETRY/" + name] = np.array(value)
        group["CellData/FeatureIds"] = LABELS.transpose(2, 1, 0).astype(np.int32)[..., None]
        group["CellData/EulerAngles"] = np.full((*LABELS.shape[::-1], 3), 9, np.float32)
        for name, value in arrays.items():
            group["CellFeatureData/" + name] = np.concatenate([np.zeros_like(value[:1]), value])
        group["CellEnsembleData/CrystalStructures"] = np.array([[999], [1], [0]], np.uint32)
        group["CellEnsembleData/PhaseName"] = np.array(["Unknown", "Nickel", "Titanium"], "S")


@pytest.mark.parametrize("is_new", [False, True])
def test_dream3d(tmp_path, is_new):
    h5py = pytest.importorskip("h5py")
    phases = np.array([[1], [2], [1], [2], [1]], np.int32)
    path = tmp_path / "a.dream3d"
    write_dream3d(h5py, path, {"AvgEulerAngles": EULER, "Phases": phases}, is_new)
    read = vfm.read_grains(path)
    assert np.array_equal(read.euler_angles, EULER) and read.ids.tolist() == [1, 2, 3, 4, 5]
    assert read.phases.tolist() == [1, 2, 1, 2, 1]
    assert read.phase_names == {1: "Nickel", 2: "Titanium"}
    w, x, y, z = read.quaternions.T
    write_dream3d(h5py, path, {"AvgQuats": np.stack([-x, -y, -z, w], axis=1)}, is_new)
    again = vfm.read_grains(path)
    assert np.allclose(again.axes(), read.axes()) and again.phase_names == {1: "Nickel"}
    mesh = vfm.tets(labels=vfm.read(path), arrays=["FeatureIds"])
    assert set(read.arrays(mesh)) == {"EulerAngles", "Quaternion", "Phase"}


def test_dream3d_without_orientations(tmp_path):
    h5py = pytest.importorskip("h5py")
    path = tmp_path / "a.dream3d"
    write_dream3d(h5py, path, {"Phases": np.ones((5, 1), np.int32)})
    with pytest.raises(ValueError, match="a.dream3d: it has no orientations of grains"):
        vfm.read_grains(path)
    write_dream3d(h5py, path, {"AvgEulerAngles": np.zeros((5, 2))})
    with pytest.raises(ValueError, match="AvgEulerAngles does not have 3 numbers per grain"):
        vfm.read_grains(path)
    with pytest.raises(FileNotFoundError, match="There is no file"):
        vfm.read_grains(tmp_path / "b.dream3d")
    path.write_bytes(b"no HDF5")
    with pytest.raises(ValueError, match="Cannot read .*a.dream3d"):
        vfm.read_grains(path)


def test_dream3d_of_other_files(tmp_path):
    """Values in another file are read only on request."""
    h5py = pytest.importorskip("h5py")
    write_dream3d(h5py, tmp_path / "out.dream3d", {"AvgEulerAngles": EULER})
    (tmp_path / "in").mkdir()
    path = tmp_path / "in" / "a.dream3d"
    write_dream3d(h5py, path, {})
    with h5py.File(path, "a") as file:
        file["DataContainers/Image/CellFeatureData"] = h5py.ExternalLink(
            str(tmp_path / "out.dream3d"), "DataContainers/Image/CellFeatureData")
    with pytest.raises(ValueError, match="leads to another file"):
        vfm.read_grains(path)
    assert len(vfm.read_grains(path, trust_input=True)) == 5
