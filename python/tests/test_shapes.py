"""Tests the exact fractions of shapes and of closed surfaces."""

import pickle
import struct

import numpy as np
import pytest

import volume_fraction_mesh as vfm
from fields import check_valid, same

BOUNDS = [-1, 1] * 3
CUBE = np.array([[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)], dtype=float)
TRIANGLES = np.array(
    [
        [0, 2, 1],
        [1, 2, 3],
        [4, 5, 6],
        [5, 7, 6],
        [0, 1, 4],
        [1, 5, 4],
        [2, 6, 3],
        [3, 6, 7],
        [0, 4, 2],
        [2, 4, 6],
        [1, 3, 5],
        [3, 7, 5],
    ]
)


def write_stl(path, points, triangles, binary):
    if not binary:
        lines = ["solid part"]
        for triangle in triangles:
            lines += [
                "facet normal 0 0 0",
                "outer loop",
                *("vertex %r %r %r" % tuple(points[c].tolist()) for c in triangle),
                "endloop",
                "endfacet",
            ]
        path.write_text("\n".join(lines + ["endsolid part"]))
        return
    records = [struct.pack("<12fH", 0, 0, 0, *points[triangle].ravel(), 0)
               for triangle in triangles]
    path.write_bytes(b"solid" + bytes(75) + struct.pack("<I", len(triangles)) + b"".join(records))


def test_shapes():
    found = vfm.shapes(
        "sphere radius=0.5 # a ball\nhalfspace point=0,0,-0.6 normal=0,0,1 material=2",
        (16, 12, 10), bounds=BOUNDS
    )
    assert list(found) == ["Material1", "Material2"] and found["Material1"].shape == (16, 12, 10)
    volume = 8 / (16 * 12 * 10)
    assert np.isclose(found["Material1"].sum() * volume, np.pi / 6, rtol=1e-3) and np.isclose(
        found["Material2"].sum() * volume, 1.6, rtol=1e-12
    )
    mesh = vfm.hexes(found)
    check_valid(mesh)
    assert np.allclose(mesh.materials["MeshVolume"], [np.pi / 6, 1.6],
                       rtol=1e-3) and mesh.points.min() == -1


def test_grids_of_shapes():
    text = "box size=1,1,0.7 rotation=10,20,30"
    expected = vfm.shapes(text, 10, bounds=BOUNDS)
    for grid in ({"spacing": 0.2, "origin": (-1, -1, -1)}, {"coordinates": expected.coordinates}):
        found = vfm.shapes(text, 10, **grid)
        assert np.allclose(found["Material1"], expected["Material1"], atol=1e-12)
    turned = vfm.shapes(text, 10, bounds=BOUNDS, order="zyx")
    assert np.array_equal(turned["Material1"].T,
                          expected["Material1"]) and same(vfm.hexes(turned), vfm.hexes(expected))
    given = vfm.hexes(dict(expected), coordinates=expected.coordinates)
    assert same(given,
                vfm.hexes(expected)) and same(vfm.hexes(pickle.loads(pickle.dumps(expected))),
                                              given)
    assert expected["Material1"].flags.f_contiguous and turned["Material1"].flags.c_contiguous
    many = vfm.shapes(text, 10, bounds=BOUNDS, threads=3)
    assert np.array_equal(many["Material1"], expected["Material1"])


@pytest.mark.parametrize(
    "given, error, text",
    [
        (dict(text="ball radius=1"), ValueError, "ball"),
        (dict(text="sphere radius=0.5\nsphere size=1"), ValueError, "ine 2"),
        (dict(text=3), TypeError, "text is a int"),
        (dict(cells=0), ValueError, "cells is 0"),
        (dict(cells=(3, 4)), TypeError, "cells is (3, 4)"),
        (dict(cells=3.5), TypeError, "cells is 3.5"),
        (dict(tolerance=0), ValueError, "tolerance is 0"),
        (dict(bounds=[1, 0] * 3), ValueError, "bounds is"),
        (dict(spacing=0), ValueError, "spacing is 0"),
        (dict(order="yxz"), ValueError, "order is 'yxz'"),
        (dict(threads=-1), ValueError, "threads is -1"),
        (dict(bounds=BOUNDS, coordinates=[[0, 1]] * 3), ValueError, "one or the other"),
    ],
)
def test_wrong_shapes(given, error, text):
    with pytest.raises(error) as told:
        vfm.shapes(**{"text": "sphere radius=0.5", "cells": 4, **given})
    assert text in str(told.value), str(told.value)


@pytest.mark.parametrize("binary", [False, True])
def test_stl(tmp_path, binary):
    path = tmp_path / "part.STL"
    write_stl(path, CUBE, TRIANGLES, binary)
    found = vfm.surface(path, 10)
    widths = [np.diff(x)[0] for x in found.coordinates]
    assert np.allclose(widths, 1 / 6) and found["Material1"].shape == (10, 10, 10)
    assert np.isclose(found["Material1"].sum() / 216, 1, rtol=1e-12)
    mesh = vfm.hexes(found, sharp_edges="on")
    assert mesh.surfaces.surface_id.max() == 6 and len(mesh.vertices.points) == 8
    assert np.isclose(mesh.volumes().sum(), 1, rtol=1e-6)


def test_ways_to_give_surfaces():
    expected = vfm.surface(CUBE, (8, 9, 10), triangles=TRIANGLES)
    assert expected["Material1"].shape == (8, 9, 10)
    inside_out = vfm.surface((CUBE, TRIANGLES[:, ::-1]), (8, 9, 10))
    assert np.array_equal(inside_out["Material1"], expected["Material1"])
    assert list(vfm.surface({"steel": (CUBE, TRIANGLES), "lead": (CUBE + 2, TRIANGLES)},
                            12)) == ["steel", "lead"]
    fixed = vfm.surface((CUBE, TRIANGLES), 4, bounds=[-0.5, 1.5] * 3)
    assert np.isclose(fixed["Material1"].sum(), 8) and np.isclose(fixed["Material1"][1, 1, 1], 1)
    flat = vfm.surface((CUBE * [4, 2, 1], TRIANGLES), 12)
    assert flat["Material1"].shape == (12, 8, 6)


def test_first_surface_keeps_its_volume():
    nodes = np.linspace(-0.6, 2.6, 13), np.linspace(-0.3, 1.3, 9), [-0.5, -0.1, 0.3, 0.8, 1.4]
    first, second = (CUBE, TRIANGLES), (CUBE + [0.5, 0, 0], TRIANGLES)
    found = vfm.surface({"first": first, "second": second}, coordinates=nodes)
    alone = vfm.surface({"second": second}, coordinates=nodes)["second"]
    assert [list(x) for x in found.coordinates] == [list(x) for x in nodes]
    assert np.array_equal(found["first"], vfm.surface(first, coordinates=nodes)["Material1"])
    assert (found["second"] <= np.minimum(alone, 1 - found["first"]) + 1e-12).all()
    assert (alone > found["second"]).sum() > 10
    cells = [np.diff(x) for x in nodes]
    volumes = cells[0][:, None, None] * cells[1][:, None] * cells[2]
    assert np.isclose((alone * volumes).sum(), 1) and np.isclose(
        (found["second"] * volumes).sum(), 0.5, rtol=0.01)
    with pytest.raises(ValueError, match="second: .*open"):
        vfm.surface({"first": first, "second": (CUBE, TRIANGLES[1:])}, 8)


def test_surfaces_of_others(tmp_path):
    pyvista = pytest.importorskip("pyvista")
    meshio = pytest.importorskip("meshio")
    ball = pyvista.Sphere(radius=1, theta_resolution=24, phi_resolution=24)
    found = vfm.surface(ball, 16)
    volume = found["Material1"].sum() * np.prod([np.diff(x)[0] for x in found.coordinates])
    assert np.isclose(volume, ball.volume, rtol=1e-5)
    ball.save(tmp_path / "ball.stl")
    assert np.allclose(vfm.surface(tmp_path / "ball.stl", 16)["Material1"], found["Material1"],
                       atol=1e-4)
    assert np.isclose(vfm.surface(pyvista.Cube(), 8)["Material1"].sum(), 64)
    quads = meshio.Mesh(
        CUBE, [("quad",
                [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2],
                 [1, 3, 7, 5]])]
    )
    meshio.write(tmp_path / "cube.ply", quads)
    for value in (quads, tmp_path / "cube.ply"):
        assert np.isclose(vfm.surface(value, 8)["Material1"].sum(), 64)


def test_wrong_surfaces(tmp_path):
    (tmp_path / "no.stl").write_text("nothing of the kind")
    (tmp_path / "short.stl").write_bytes(bytes(80) + struct.pack("<I", 7) + bytes(60))
    for value, error, text in (
        ((CUBE, TRIANGLES[1:]), ValueError, "open"),
        ((CUBE, TRIANGLES + 1), ValueError, "triangle"),
        (CUBE, TypeError, "points and triangles"),
        ((CUBE, TRIANGLES[:0]), ValueError, "no polygons"),
        ((CUBE[:, :2], TRIANGLES), ValueError, "(n, 3) is required"),
        ((CUBE, TRIANGLES * 0.5), ValueError, "(m, 3) integers"),
        (tmp_path / "no.stl", ValueError, "is not an STL file"),
        (tmp_path / "short.stl", ValueError, "is not an STL file"),
        (tmp_path / "none.stl", FileNotFoundError, "none.stl"),
        ({}, ValueError, "empty"),
        ({3: (CUBE, TRIANGLES)}, TypeError, "name of a surface is 3"),
        ({"": (CUBE, TRIANGLES)}, TypeError, "name of a surface is ''"),
        ((CUBE * np.nan, TRIANGLES), ValueError, "finite"),
    ):
        with pytest.raises(error) as told:
            vfm.surface(value, 8)
        assert text in str(told.value), (text, str(told.value))
    with pytest.raises(ValueError, match="at least 5"):
        vfm.surface((CUBE, TRIANGLES), 4)


PART = CUBE * [1, 0.7, 0.4] + [0.03, 0.02, 0.01]


def test_surfaces_go_with_fractions():
    """They change the mesh unless the option is off, survive pickling, and get lost with a new
    dict."""
    found = vfm.surface({"steel": (PART, TRIANGLES)}, 14)
    assert found.surfaces.names == ["steel"] and len(found.surfaces) == 1
    mesh = vfm.hexes(found)
    assert mesh.materials["Name"] == ["steel"]
    assert same(vfm.hexes(pickle.loads(pickle.dumps(found))), mesh)
    assert same(vfm.hexes(found.copy()), mesh)
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
        (dict(cell_width=1e-12), ValueError, "too large"),
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
