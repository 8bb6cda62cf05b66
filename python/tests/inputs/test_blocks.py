"""Tests files of blocks of cells on any number of levels: SpyPlot and AMReX."""

import os
import shutil
import sys

import numpy as np
import pytest

import volume_fraction_mesh as vfm
from fields import BALL, LABELS, N, PLATE, STATE, check_valid, same
from volume_fraction_mesh.__main__ import main

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..")
sys.path.append(os.path.join(ROOT, "Testing", "Python"))
from spyplot import Block, split, with_ghosts, write_spyplot  # noqa: E402

IMPACT = os.path.join(ROOT, "Data", "impact.spcth")
PLOTFILE, SMEARED = (os.path.join(ROOT, "Data", "AMReX", name) for name in ("plt00000", "plt00011"))
VOLUME = "Material volume fraction - %d"
SPACING, ORIGIN = 0.25, (-1.0, 0.5, 2.0)
NODES = [o + SPACING * np.arange(N + 1) for o in ORIGIN]
TIMES = [0.0, 2.5]


def arrays_of(ball):
    given = {VOLUME % 1: ball, VOLUME % 2: np.minimum(PLATE, 1 - ball), "T": STATE["temperature"],
             "id": LABELS}
    return {name: np.asarray(array, np.float32) for name, array in given.items()}


STEPS = [arrays_of(BALL[::-1]), arrays_of(BALL)]


def write(folder, counts=(2, 1, 2), files=2):
    steps = [{name: array.transpose(2, 1, 0) for name, array in step.items()} for step in STEPS]
    return write_spyplot(str(folder), "case", TIMES, split(NODES, steps, counts), files)


def mesh_of(step, **given):
    fractions = {VOLUME % m: step[VOLUME % m] for m in (1, 2)}
    return vfm.hexes(fractions, spacing=SPACING, origin=ORIGIN, **given)


def test_same_as_arrays(tmp_path):
    for counts, files in (((2, 1, 2), 2), ((1, 1, 1), 1), ((1, 2, 1), 2)):
        path = write(tmp_path, counts, files)
        for step, index in ((0, 0), (1, 1), (1, -1)):
            blocks = vfm.read(path, step=index)
            assert len(blocks) == np.prod(
                counts) and blocks.times == TIMES and blocks.time == TIMES[step]
            assert set(blocks.names) == set(STEPS[0]) and blocks.fractions == [
                VOLUME % 1, VOLUME % 2]
            mesh = vfm.hexes(blocks, state=["T"])
            expected = mesh_of(STEPS[step], state={"T": STEPS[step]["T"]})
            assert same(mesh, expected) and np.array_equal(mesh.state["T"], expected.state["T"])


def test_tets_labels_and_chosen_arrays(tmp_path):
    blocks = vfm.read(write(tmp_path), step=1)
    check_valid(vfm.tets(blocks))
    mesh = vfm.hexes(labels=blocks, arrays=["id"], names={1: "ball"})
    assert same(mesh, vfm.hexes(labels=LABELS, spacing=SPACING, origin=ORIGIN))
    ball = vfm.hexes(vfm.read(write(tmp_path), step=1, arrays=[VOLUME % 1]))
    assert same(ball, vfm.hexes({VOLUME % 1: STEPS[1][VOLUME % 1]}, spacing=SPACING, origin=ORIGIN))


def refined(value):
    """Makes eight blocks of level 0, the first of which is eight blocks of level 1."""

    def block(level, lower):
        width = SPACING / 2**level
        nodes = [with_ghosts(o + width * (i + np.arange(5))) for o, i in zip(ORIGIN, lower)]
        middles = [(x[1:] + x[:-1]) / 2 for x in nodes]
        array = np.asarray(value(*np.meshgrid(*middles, indexing="ij")),
                           np.float32).transpose(2, 1, 0)
        return Block(nodes, [{VOLUME % 1: array}], level)

    corners = [(i, j, k) for k in (0, 4) for j in (0, 4) for i in (0, 4)]
    return [block(1, corner) for corner in corners] + [block(0, corner) for corner in corners[1:]]


def test_levels(tmp_path):
    path = write_spyplot(str(tmp_path), "levels", [0.0],
                         refined(lambda x, y, z: (x < 0.2) & (y < 1.7)), 3)
    blocks = vfm.read(path)
    assert len(blocks) == 15
    fine, coarse = vfm.hexes(blocks, fine_interfaces=False), vfm.hexes(blocks, refinement="off")
    check_valid(fine)
    assert 0 < len(coarse.cells) < len(fine.cells)


def test_plotfile():
    blocks = vfm.read(PLOTFILE)
    assert len(blocks) > 1 and blocks.fractions == blocks.names == ["phi"]
    mesh = vfm.hexes(blocks)
    check_valid(mesh)
    assert len(mesh.cells) > 1000
    smeared = vfm.read(SMEARED)  # values leave [0, 1]
    assert smeared.fractions == []
    with pytest.raises(ValueError, match="Name the arrays of .* that hold materials"):
        vfm.hexes(smeared)
    with pytest.warns(vfm.VolumeFractionMeshWarning, match="were clipped"):
        check_valid(vfm.hexes(smeared, arrays=["phi"], fraction_tolerance=0.1))


def test_command(tmp_path, capsys):
    out = str(tmp_path / "out.vtu")
    assert main([IMPACT, out, "--step", "3", "--state", "X velocity", "--quiet"]) == 0
    assert os.path.getsize(out) > 1000
    assert main([IMPACT, out, "--step", "4"]) == 1
    assert "there is no step 4: it has 4, counted from 0" in capsys.readouterr().err


def test_errors(tmp_path):
    path = write(tmp_path)
    blocks = vfm.read(path)
    for error, text, call in (
        (FileNotFoundError, "There is no file", lambda: vfm.read(str(tmp_path / "none.spcth"))),
        (ValueError, "contains no slices: .* not a plotfile of AMReX",
         lambda: vfm.read(str(tmp_path))),
        (ValueError, "it has no array 'none'. Its arrays: '",
         lambda: vfm.read(path, arrays=["none"])),
        (ValueError, "there is no step 2: it has 2", lambda: vfm.read(path, step=2)),
        (ValueError, "there is no step -3", lambda: vfm.read(path, step=-3)),
        (TypeError, "must be a list of names", lambda: vfm.read(path, arrays="T")),
        (TypeError, "spacing cannot be given", lambda: vfm.hexes(blocks, spacing=2)),
        (TypeError, "names cannot be given", lambda: vfm.hexes(blocks, names=["a", "b"])),
        (TypeError, "names of arrays are required", lambda: vfm.hexes(blocks, state={"T": BALL})),
        (TypeError, "names of arrays are required", lambda: vfm.hexes(blocks, density=1.0)),
        (ValueError, "labels are 2 arrays", lambda: vfm.hexes(labels=blocks)),
        (ValueError, "none", lambda: vfm.hexes(blocks, arrays=["none"])),
    ):
        with pytest.raises(error, match=text):
            call()


def test_damaged(tmp_path):
    path = write(tmp_path)
    size = os.path.getsize(path + ".1")
    os.truncate(path + ".1", size - 1)
    vfm.read(path)
    with pytest.raises(ValueError, match="case.spcth.1 is truncated or damaged in '.*' of step 1, "
                       "block 2, plane "):
        vfm.read(path, step=1)
    shutil.copytree(PLOTFILE, tmp_path / "plt")
    os.remove(tmp_path / "plt" / "Level_0" / "Cell_H")
    with pytest.raises(ValueError, match="Level_0/Cell_H cannot be read: No such file"):
        vfm.read(tmp_path / "plt")
