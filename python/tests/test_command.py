"""Tests the command vfmesh."""

import csv
import re
import subprocess
import sys

import numpy as np
import pytest

import volume_fraction_mesh as vfm
from fields import BALL, LABELS, PLATE, STATE
from test_shapes import CUBE, TRIANGLES, write_stl
from volume_fraction_mesh.__main__ import OPTIONS, main, make_parser

pyvista = pytest.importorskip("pyvista")


def read(path):
    return pyvista.read(path)


@pytest.fixture
def run(tmp_path, capsys):
    """Runs the command in a folder; "@name" is a file in it."""

    def run_words(*words, status=0):
        got = main([str(tmp_path / word[1:]) if word.startswith("@") else word for word in words])
        told = capsys.readouterr()
        assert got == status, told.err
        return told.err if status else told.out

    run_words.folder = tmp_path
    return run_words


def test_report(run):
    np.save(run.folder / "labels.npy", LABELS)
    run("@labels.npy", "@out.vtu", "--report", "@out.html", "--quiet")
    page = (run.folder / "out.html").read_text(encoding="utf-8")
    assert "<dt>Input</dt><dd>%s</dd>" % (run.folder / "labels.npy") in page
    assert "give .html" in run("@labels.npy", "@out.vtu", "--report", "@out.txt", "--quiet",
                               status=1)


def test_numpy(run):
    np.save(run.folder / "labels.npy", LABELS)
    told = run("@labels.npy", "@out.vtu", "--label-smoothing", "2", "--spacing", "0.5")
    expected = vfm.hexes(labels=LABELS, label_smoothing=2, spacing=0.5)
    assert told.strip() == repr(expected) and np.array_equal(
        read(run.folder / "out.vtu").points, expected.points)
    np.savez(run.folder / "both.npz", ball=BALL, plate=PLATE, **STATE)
    run(
        "@both.npz",
        "@out.vtu",
        "--tets",
        "--method",
        "cells",
        "--array",
        "ball",
        "--array",
        "plate",
        "--state",
        "temperature",
        "--density",
        "density",
        "--velocity",
        "velocity",
        "--spacing",
        "1",
        "2",
        "1",
        "--origin",
        "0",
        "0",
        "-1",
        "--fragments",
        "@table.csv",
        "--quiet",
        "--no-compute-quality",
    )
    mesh = read(run.folder / "out.vtu")
    assert set(mesh.celltypes) == {pyvista.CellType.TETRA} and {
        "temperature", "density", "velocity"} <= set(
        mesh.cell_data.keys()
    )
    assert "ScaledJacobian" not in mesh.cell_data.keys()
    with open(run.folder / "table.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == 2 and np.isclose(
        float(rows[0]["mass"]) + float(rows[1]["mass"]),
        ((BALL + PLATE) * STATE["density"]).sum() * 2
    )
    assert {"momentum_x", "x_min", "centroid_z", "neighbours"} <= set(rows[0])


def test_nifti(run):
    nibabel = pytest.importorskip("nibabel")
    affine = np.diag([-2.0, 2, 2, 1])
    nibabel.save(nibabel.Nifti1Image(LABELS.astype(np.uint8), affine), run.folder / "in.nii.gz")
    (run.folder / "names.txt").write_text(
        '# label file of ITK-SNAP\n1 255 0 0 1 1 1 "left side"\n2 0 255 0 1 1 1 "right"\n')
    run("@in.nii.gz", "@out.vtu", "--names", "@names.txt", "--mesh-void", "--surfaces",
        "@surfaces.vtp")
    assert read(run.folder / "out.vtu").points[:, 0].max() <= 1
    run("@in.nii.gz", "@solids.stl", "--names", "@names.txt", "--surfaces", "@part_{}.stl")
    solids = (run.folder / "solids.stl").read_text()
    assert solids == "".join((run.folder / ("part_%s.stl" % name)).read_text()
                             for name in ("left side", "right"))
    run("@in.nii.gz", "@solids.obj", "--names", "@names.txt", "--surfaces", "@parts")
    groups = [line[2:] for line in (run.folder / "solids.obj").read_text().splitlines()
              if line[0] == "g"]
    assert groups == ["left_side", "right"]
    for name in ("left side", "right"):
        assert ((run.folder / "parts" / (name + ".stl")).read_bytes()
                == (run.folder / ("part_%s.stl" % name)).read_bytes())
    labels = '<label index="1">left side</label><label index="2">P&#244;le</label>'
    (run.folder / "names.xml").write_text(
        "<atlas><header><type>Label</type></header><data>%s</data></atlas>" % labels)
    run("@in.nii.gz", "@out.inp", "--names", "@names.xml")
    assert "** P_LE: material 2" in (run.folder / "out.inp").read_text()
    nibabel.save(nibabel.Nifti1Image(BALL.astype(np.float32), affine), run.folder / "ball.nii")
    run("@ball.nii", "@out.vtu")
    assert read(run.folder / "out.vtu").n_cells == len(vfm.hexes(BALL.astype(np.float32)))


def test_other_images(run):
    sitk = pytest.importorskip("SimpleITK")
    sitk.WriteImage(sitk.GetImageFromArray(LABELS.astype(np.uint8)), str(run.folder / "in.nrrd"))
    run("@in.nrrd", "@out.vtu")
    assert read(run.folder / "out.vtu").n_cells == len(vfm.hexes(labels=LABELS, order="zyx"))
    image = pyvista.ImageData(dimensions=(13, 13, 13))
    image.cell_data["ball"], image.cell_data["T"] = BALL.ravel("F"), STATE["temperature"].ravel("F")
    image.save(run.folder / "in.vti")
    run("@in.vti", "@out.vtu", "--array", "ball", "--state", "T")
    assert "T" in read(run.folder / "out.vtu").cell_data.keys()


def test_surface(run):
    write_stl(run.folder / "part.stl", CUBE, TRIANGLES, True)
    told = run("@part.stl", "@out.vtu", "--cells", "10", "--sharp-edges", "on")
    assert "hexahedra" in told and np.allclose(read(run.folder / "out.vtu").points.max(axis=0), 1,
                                               atol=0.02)


def test_surfaces(run):
    """Several surfaces are materials; a width without a number of cells is that of the grid."""
    for name, shift in (("one", 0), ("two", 0.5)):
        write_stl(run.folder / (name + ".stl"), CUBE + [shift, 0, 0], TRIANGLES, True)
    run("@one.stl", "@two.stl", "@out.vtu", "--cells", "16")
    mesh = read(run.folder / "out.vtu")
    assert set(mesh["MaterialId"]) == {1, 2} and "one" in mesh.field_data["MaterialNames"]
    run("@one.stl", "@a.vtu", "--cell-width", "0.125")
    run("@one.stl", "@b.vtu", "--cells", "12")
    assert (run.folder / "a.vtu").read_bytes() == (run.folder / "b.vtu").read_bytes()
    np.save(run.folder / "labels.npy", LABELS)
    told = run("@labels.npy", "@one.stl", "@out.vtu", status=1)
    assert "one.stl is a surface and" in told and "labels.npy is not" in told
    assert read(run.folder / "b.vtu").field_data["MaterialNames"].tolist() == ["one"]
    assert "--labels" in run("@one.stl", "@out.vtu", "--labels", status=1)
    assert "is for surfaces" in run("@ball.npy", "@out.vtu", "--cells", "9", status=1)
    assert "at least 5" in run("@one.stl", "@out.vtu", "--cells", "0", status=1)


def test_errors(run):
    np.savez(run.folder / "both.npz", ball=BALL, plate=PLATE + 1)
    np.save(run.folder / "line.npy", BALL[0, 0])
    (run.folder / "names.txt").write_text("one 1\n")
    np.save(run.folder / "labels.npy", LABELS)
    for words, text in (
        (["@both.npz", "@out.vtu", "--array", "plate"], "'plate' holds 2"),
        (["@both.npz", "@out.vtu", "--array", "foam"],
         "no numeric cell array 'foam'. Its cell arrays: 'ball', 'plate'"),
        (["@both.npz", "@out.vtu", "--labels", "--array", "ball", "--array", "plate"],
         "labels are 2 arrays"),
        (["@line.npy", "@out.vtu"], "axes for x, y and z are required"),
        (["@none.npy", "@out.vtu"], "none.npy"),
        (["@none.nii", "@out.vtu"], "There is no file"),
        (["@labels.npy", "@out"], "has no ending"),
        (["@labels.npy", "@out.vtu", "--names", "@names.txt"], "line 1: it begins with 'one'"),
        (["@labels.npy", "@out.vtu", "--label-smoothing", "11"], "label_smoothing is 11"),
    ):
        told = run(*words, status=1)
        assert told.splitlines()[-1].startswith("vfmesh: ") and text in told, told


def test_outputs_need_their_own_names(run):
    np.save(run.folder / "labels.npy", LABELS)
    (run.folder / "names.txt").write_text("1 one\n")
    (run.folder / "link.vtu").symlink_to("out.vtu")
    (run.folder / "slices").mkdir()
    (run.folder / "slices" / "1.png").write_bytes(b"slice")
    before = {path: path.read_bytes() for path in run.folder.rglob("*.*") if path.is_file()}
    for words, one, other in (
        (["@out.vtu", "--fragments", "@out.vtu"], "--fragments", "output"),
        (["@out.vtu", "--fragments", "@link.vtu"], "--fragments", "output"),
        (["@out.vtu", "--fragments", "@slices/../labels.npy"], "--fragments", "input"),
        (["@out.vtu", "--names", "@names.txt", "--fragments", "@names.txt"], "--fragments",
         "--names"),
        (["@out.stl", "--surfaces", "@out.stl"], "--surfaces", "output"),
        (["@out.vtu", "--report", "@out.html", "--fragments", "@out.html"], "--report",
         "--fragments"),
    ):
        told = run("@labels.npy", *words, status=1)
        assert told.startswith("vfmesh: The %s " % one), told
        assert "is the same file as the %s " % other in told and told.count("\n") == 1, told
    assert "the same file as the input" in run(
        "@slices", "@out.vtu", "--fragments", "@slices/1.png", status=1)
    assert before == {path: path.read_bytes() for path in run.folder.rglob("*.*")
                      if path.is_file()}
    run("@labels.npy", "@out.vtu", "--fragments", "/dev/null", "--quiet")


def test_advice_is_taken(run):
    """Options that messages name, in the form in which they name them, are those of vfmesh."""
    np.save(run.folder / "zero.npy", LABELS)
    for word in ("Material", "MATERIAL", "material"):
        assert "hexahedra" in run("@zero.npy", "@out.vtu", "--zero-label", word)
    assert "'void', 'material'" in run("@zero.npy", "@out.vtu", "--zero-label", "Grain", status=1)
    half = np.full((4, 4, 4), 0.5)
    np.savez(run.folder / "sums.npz", a=half + 0.001, b=half + 0.0009)
    told = run("@sums.npz", "@out.vtu", "--array", "a", "--array", "b", status=1)
    advice = re.search(r"\((--clip \S+)\)", told)[1]
    run("@sums.npz", "@out.vtu", "--array", "a", "--array", "b", *advice.split(), "--quiet")
    grains = np.random.default_rng(1).integers(2, 100, (8, 8, 8)).astype(np.uint8)
    np.savez(run.folder / "bytes.npz", grain=grains)
    told = run("@bytes.npz", "@out.vtu", "--array", "grain", status=1)
    advice = re.search(r"\((--labels [^)]*)\)", told)[1]
    assert advice == "--labels --array grain"
    run("@bytes.npz", "@out.vtu", *advice.split(), "--quiet")


def test_every_option():
    words = make_parser().format_help()
    for option in OPTIONS:
        assert "--" + option.name.replace("_", "-") in words
    assert "an integer from 0 to 10" in " ".join(words.split())


def test_module():
    run = subprocess.run(
        [sys.executable, "-m", "volume_fraction_mesh", "--version"], capture_output=True, text=True,
        check=True
    )
    assert run.stdout.strip() == vfm.__version__
