"""Tests surfaces that go with their fractions to the mesher."""

import pickle

import numpy as np
import pytest

import volume_fraction_mesh as vfm
from fields import same
from test_shapes import CUBE, TRIANGLES, write_stl

PART = CUBE * [1, 0.7, 0.4] + [0.03, 0.02, 0.01]


def test_surfaces_go_with_fractions():
    """They change the mesh unless the option is off, survive pickling, and get lost with a new
    dict."""
    found = vfm.surface({"steel": (PART, TRIANGLES)}, 14)
    assert found.surfaces.names == ["steel"] and len(found.surfaces) == 1
    mesh = vfm.hexes(found)
    assert mesh.materials["Name"] == ["steel"]
    assert same(vfm.hexes(pickle.loads(pickle.dumps(found))), mesh)
    plain = vfm.hexes(dict(found), coordinates=found.coordinates)
    assert same(vfm.hexes(found, surface_targets="off"), plain) and not same(mesh, plain)
    bare = vfm.Fractions(found, found.coordinates, found.order)
    assert bare.surfaces is None and same(vfm.hexes(bare), plain)
    renamed = vfm.hexes(found, names=["lead"])
    assert renamed.materials["Name"] == ["lead"] and np.array_equal(renamed.points, mesh.points)


def test_bodies():
    patches = np.arange(12) // 2
    names = ["bottom", "top", "front", "back", "left", "right"]
    bodies = vfm.Bodies([("one", PART, TRIANGLES, patches.astype(np.int32), names),
                         ("two", PART + 2, TRIANGLES[::-1], None, [""])])
    one = bodies["one"]
    assert one["points"].shape == (8, 3) and one["triangles"].shape == (12, 3)
    assert one["patch_names"] == names and np.bincount(one["patches"]).tolist() == [2] * 6
    again = pickle.loads(pickle.dumps(bodies))
    assert again.names == ["one", "two"]
    for name in again.names:
        for key, value in bodies[name].items():
            assert np.array_equal(again[name][key], value), (name, key)
    with pytest.raises(KeyError, match="three"):
        bodies["three"]
    with pytest.raises(ValueError, match="two: .*open"):
        vfm.Bodies([("one", PART, TRIANGLES, None, [""]), ("two", PART, TRIANGLES[1:], None, [""])])


def test_files_and_priority(tmp_path):
    """Materials of a list of files have the names of the files; the first one keeps its volume."""
    shaft, housing = tmp_path / "shaft.stl", tmp_path / "housing.v2.stl"
    write_stl(shaft, CUBE, TRIANGLES, True)
    write_stl(housing, CUBE + [0.5, 0, 0], TRIANGLES, False)
    found = vfm.surface([shaft, str(housing)], 16)
    assert list(found) == ["shaft", "housing.v2"] == found.surfaces.names
    assert np.allclose([array.sum() for array in found.values()], [512, 256], rtol=1e-12)
    mesh = vfm.hexes(found)
    assert np.allclose(mesh.materials["TargetVolume"], [1, 0.5], rtol=1e-12)
    del found["shaft"]
    assert vfm.hexes(found).materials["Name"] == ["housing.v2"]
    (tmp_path / "more").mkdir()
    same_name = tmp_path / "more" / "shaft.stl"
    write_stl(same_name, CUBE, TRIANGLES, True)
    with pytest.raises(ValueError, match="would both be the material shaft: rename"):
        vfm.surface([shaft, same_name])


def test_width_of_cells():
    for width, counts in ((0.1, (14, 11, 8)), ((0.1, 0.05, 0.2), (14, 18, 6))):
        found = vfm.surface((PART, TRIANGLES), cell_width=width)
        assert found["Material1"].shape == counts
        assert np.allclose([np.diff(x)[0] for x in found.coordinates], width)
    for given, error, text in (
        (dict(cell_width=0), ValueError, "cell_width is 0"),
        (dict(cell_width=[1, 2]), TypeError, "cell_width is [1, 2]"),
        (dict(cell_width="wide"), TypeError, "cell_width is 'wide'"),
        (dict(cell_width=1e-12), ValueError, "too many"),
        (dict(cell_width=0.1, cells=20), ValueError, "one or the other"),
    ):
        with pytest.raises(error) as told:
            vfm.surface((PART, TRIANGLES), **given)
        assert text in str(told.value), str(told.value)


def test_options_of_surfaces():
    with pytest.raises(ValueError, match="surface_targets is 'maybe': it must be 'off', 'on'"):
        vfm.hexes(np.ones((3, 3, 3)), surface_targets="maybe")
    for angle in (0.5, 180, float("nan")):
        with pytest.raises(ValueError, match="edge_angle is"):
            vfm.hexes(np.ones((3, 3, 3)), edge_angle=angle)


def test_files_of_vtk(tmp_path):
    """Field data of a file, as ParaView's filter writes them, are the surfaces."""
    pyvista = pytest.importorskip("pyvista")
    found = vfm.surface((PART, TRIANGLES), 14)
    body = found.surfaces["Material1"]
    image = pyvista.ImageData(
        dimensions=[len(x) for x in found.coordinates],
        spacing=[x[1] - x[0] for x in found.coordinates],
        origin=[x[0] for x in found.coordinates])
    image.cell_data["Material1"] = found["Material1"].ravel("F")
    plain = vfm.hexes(image)
    for name, values in (("Points", body["points"]), ("Triangles", body["triangles"]),
                         ("Bodies", np.zeros(12, np.int32)), ("Patches", body["patches"]),
                         ("Names", ["Material1"]), ("PatchNames", body["patch_names"])):
        image.add_field_data(values, "InputSurface" + name)
    mesh = vfm.hexes(image)
    assert not same(mesh, plain) and same(vfm.hexes(image, surface_targets="off"), plain)
    image.save(tmp_path / "part.vti")
    read = vfm.read(tmp_path / "part.vti")
    assert same(vfm.hexes(read), mesh)
    assert same(vfm.hexes(pickle.loads(pickle.dumps(read))), mesh)


def test_patches_of_polydata():
    pyvista = pytest.importorskip("pyvista")
    cube = pyvista.Cube()
    cube.cell_data["STLSolidLabeling"] = np.arange(6, dtype=np.float32)
    patches = vfm.surface(cube, 8).surfaces["Material1"]["patches"]
    assert np.bincount(patches).tolist() == [2] * 6
