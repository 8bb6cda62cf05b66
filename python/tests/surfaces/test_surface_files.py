"""Tests files of surfaces: formats, notes, and solids of CAD."""

import gzip
import re
import sys
import warnings
import zipfile

import numpy as np
import pytest

import volume_fraction_mesh as vfm
from test_shapes import CUBE, TRIANGLES, write_stl

OFF = "OFF\n8 12 0\n%s%s" % ("".join("%g %g %g\n" % tuple(p) for p in CUBE),
                             "".join("3 %d %d %d\n" % tuple(t) for t in TRIANGLES))
MODEL = ('<model><resources><object id="1" name="cube"><mesh><vertices>%s</vertices><triangles>%s'
         "</triangles></mesh></object></resources><build>%s</build></model>") % (
    "".join('<vertex x="%g" y="%g" z="%g"/>' % tuple(p) for p in CUBE),
    "".join('<triangle v1="%d" v2="%d" v3="%d"/>' % tuple(t) for t in TRIANGLES),
    '<item objectid="1"/><item objectid="1" transform="1 0 0 0 1 0 0 0 1 2 0 0"/>')


def volumes(found):
    width = np.prod([x[1] - x[0] for x in found.coordinates])
    return {name: round(float(array.sum() * width), 9) for name, array in found.items()}


def test_packed_files(tmp_path):
    (tmp_path / "a.off").write_text(OFF)
    (tmp_path / "a.off.gz").write_bytes(gzip.compress(OFF[:50].encode()) +
                                        gzip.compress(OFF[50:].encode()))
    (tmp_path / "short.off.gz").write_bytes(gzip.compress(OFF.encode())[:-12])
    (tmp_path / "bad.off.gz").write_bytes(b"\x1f\x8b" + b"no gzip at all")
    for name in ("a.off", "a.off.gz"):
        assert volumes(vfm.surface(tmp_path / name, 8)) == {"Material1": 1}
    for name, text in (("short.off.gz", "truncated"), ("bad.off.gz", "damaged")):
        with pytest.raises(ValueError, match="Cannot read .*%s.*%s" % (name, text)):
            vfm.surface(tmp_path / name, 8)


def test_bodies_of_3mf(tmp_path):
    with zipfile.ZipFile(tmp_path / "a.3mf", "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("3D/3dmodel.model", MODEL)
    found = vfm.surface(tmp_path / "a.3mf", 16)
    assert volumes(found) == {"cube": 1, "cube 2": 1}


def test_notes_are_warnings(tmp_path):
    write_stl(tmp_path / "long.stl", CUBE, TRIANGLES, True)
    with open(tmp_path / "long.stl", "ab") as file:
        file.write(b"more")
    with pytest.warns(vfm.VolumeFractionMeshWarning, match="4 bytes behind") as caught:
        vfm.surface(tmp_path / "long.stl", 8)
    assert [one.filename for one in caught] == [__file__]
    twice = np.concatenate([TRIANGLES, TRIANGLES])
    with pytest.warns(vfm.VolumeFractionMeshWarning, match="12 repeated triangles") as caught:
        assert volumes(vfm.surface((CUBE, twice), 8)) == {"Material1": 1}
    assert [one.filename for one in caught] == [__file__]


def write_step(gmsh, path):
    """Writes a plate, whose faces have names, and a ball."""
    gmsh.initialize(interruptible=False)
    gmsh.option.setNumber("General.Terminal", 0)
    plate = gmsh.model.occ.addBox(0, 0, 0, 4, 3, 1)
    hole = gmsh.model.occ.addCylinder(2, 1.5, -1, 0, 0, 3, 1)
    gmsh.model.occ.cut([(3, plate)], [(3, hole)])
    gmsh.model.occ.addSphere(8, 1, 1, 1)
    gmsh.model.occ.synchronize()
    gmsh.write(str(path))
    gmsh.finalize()
    names = iter("abcdefgh")
    text = re.sub(r"ADVANCED_FACE\(''", lambda _: "ADVANCED_FACE('%s'" % next(names),
                  path.read_text())
    path.write_text(text)


def test_step(tmp_path):
    gmsh = pytest.importorskip("gmsh")
    path = tmp_path / "two.step"
    write_step(gmsh, path)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        found = vfm.surface(path, 24)
    exact = [12 - np.pi, 4 / 3 * np.pi]
    assert np.allclose(list(volumes(found).values()), exact, rtol=2e-3)
    first, second = (found.surfaces[name] for name in found.surfaces.names)
    assert sorted(first["patch_names"]) == list("abcdefg") and second["patch_names"] == ["h"]
    assert not gmsh.isInitialized()


def test_step_leaves_the_session_of_gmsh(tmp_path):
    gmsh = pytest.importorskip("gmsh")
    path = tmp_path / "two.step"
    write_step(gmsh, path)
    gmsh.initialize(interruptible=False)
    try:
        gmsh.option.setNumber("General.Terminal", 0)
        gmsh.model.add("mine")
        gmsh.model.occ.addBox(0, 0, 0, 1, 1, 1)
        gmsh.model.occ.synchronize()
        before = gmsh.option.getNumber("Mesh.StlAngularDeflection")
        vfm.surface(path, 8)
        assert gmsh.model.getCurrent() == "mine" and len(gmsh.model.getEntities(3)) == 1
        assert gmsh.option.getNumber("Mesh.StlAngularDeflection") == before
        assert "volume_fraction_mesh" not in gmsh.model.list()
    finally:
        gmsh.finalize()


def test_damaged_step(tmp_path):
    pytest.importorskip("gmsh")
    path = tmp_path / "bad.stp"
    path.write_text("no file of CAD")
    with pytest.raises(ValueError, match="bad.stp: it is no CAD file"):
        vfm.surface(path)


def test_step_without_gmsh(tmp_path, monkeypatch):
    path = tmp_path / "a.stp"
    path.write_text("no file of CAD")
    with pytest.raises(FileNotFoundError):
        vfm.surface(tmp_path / "none.step")
    monkeypatch.setitem(sys.modules, "gmsh", None)
    with pytest.raises(ImportError, match="requires gmsh: pip install gmsh"):
        vfm.surface(path)
