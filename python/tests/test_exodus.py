"""Tests Exodus files as input: hexahedra that form a Cartesian grid."""

import os

import numpy as np
import pytest

import volume_fraction_mesh as vfm
from fields import BALL, PLATE, same
from volume_fraction_mesh.__main__ import main

SPACING, ORIGIN = 0.25, (-1.0, 0.5, 2.0)
GRID = dict(spacing=SPACING, origin=ORIGIN)
FRACTIONS = {"ball": BALL, "plate": np.minimum(PLATE, 1 - BALL)}
STATE = {"f_" + name: values for name, values in FRACTIONS.items()}  # in the file


@pytest.fixture
def path(tmp_path):
    """Writes the cells of the grid as hexahedra, one element block per material."""
    cells = vfm.hexes(FRACTIONS, stair_step=True, mesh_void=True, state=STATE, **GRID)
    assert len(cells) == BALL.size
    cells.save(tmp_path / "cells.e", time=2.5)
    return str(tmp_path / "cells.e")


def test_same_as_arrays(path):
    blocks = vfm.read(path, arrays=list(STATE))
    assert len(blocks) > 3 and blocks.times == [2.5] and blocks.time == 2.5
    assert blocks.names == blocks.fractions == list(STATE)
    assert same(vfm.hexes(blocks), vfm.hexes(FRACTIONS, **GRID))
    assert set(STATE) < set(vfm.read(path, step=-1).names)


def test_parts(path):
    """FILE.1.0 is part 0 of 1; a part that is missing is reported."""
    part = os.path.join(os.path.dirname(path), "any.1.0")
    os.rename(path, part)
    assert same(vfm.hexes(vfm.read(part), arrays=list(STATE)), vfm.hexes(FRACTIONS, **GRID))
    other = part.replace(".1.0", ".2.0")
    os.rename(part, other)
    with pytest.raises(ValueError, match=r"any\.2\.1 \(one of 2 files\): No such file"):
        vfm.read(other)


def test_blocks_are_materials(path):
    blocks = vfm.read(path, arrays=["object_id"])
    mesh = vfm.hexes(labels=blocks, arrays=["object_id"])
    ids = vfm.hexes(FRACTIONS, stair_step=True, mesh_void=True, **GRID)
    assert set(mesh.materials["MaterialId"]) == set(np.where(ids.material == 0, 3, ids.material))


def test_what_is_missing(path):
    for wrong, text in (({"arrays": ["heat"]}, "no array 'heat'"),
                        ({"step": 1}, "no step 1: it has 1")):
        with pytest.raises(ValueError, match=text):
            vfm.read(path, **wrong)
    with pytest.raises(FileNotFoundError):
        vfm.read(path.replace("cells", "none"))
    with pytest.raises(TypeError, match="do not apply"):
        vfm.read(path, spacing=0.5)


def test_damaged(path):
    with open(path, "rb") as file:
        data = file.read()
    for wrong, text in ((data[:-9], "truncated"), (data[:200], "truncated"), (b"", "empty"),
                        (b"text" * 9, "not a netCDF file"), (b"\x89HDF\r\n" * 9, "HDF5")):
        with open(path, "wb") as file:
            file.write(wrong)
        with pytest.raises(ValueError, match="Cannot read .*" + text):
            vfm.read(path)


def test_other_cells(path):
    vfm.tets(FRACTIONS, **GRID).save(path)
    with pytest.raises(ValueError, match="cell 0 is of the type 'TETRA'"):
        vfm.read(path)
    vfm.hexes(FRACTIONS, **GRID).save(path)
    with pytest.raises(ValueError, match="Block 0: cell .* is not a box"):
        vfm.read(path)


def test_command(path, capsys):
    output = path.replace("cells.e", "out.vtu")
    assert main([path, output, "--array", "f_ball", "--array", "f_plate", "--quiet"]) == 0
    assert os.path.getsize(output) > 0 and capsys.readouterr().err == ""
