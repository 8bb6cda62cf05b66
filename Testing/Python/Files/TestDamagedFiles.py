"""Damaged files of each kind that `sculptor` reads: no crash, no hang, one message per file.

The program Testing/Fuzz/FuzzFiles damages the files. VFM_SEEDS=first:count selects other seeds. An
argument is a folder that receives the intact files, to repeat a seed by hand:

    VFM_FUZZ_FILES FOLDER --seed S --keep
"""
import os
import subprocess
import sys
import tempfile

import numpy as np

from amr_files import make_amr, write_plotfile, write_vthb
from exodus_grids import hexes, write_exodus
from image_files import (
    CARET, write_dream3d, write_dream3d_nx, write_meta, write_mgh, write_nifti, write_nrrd,
    write_pages, write_png, write_tiff)
from spyplot import split, write_spyplot
from spyplot_cases import NODES, TIMES, steps
from vfmtest import image, main, write
from voxels import grains, turned, write_numpy, write_text
from vtk_files import cells_of, structured, write_blocks, write_legacy, write_pieces, write_xml

SEEDS, COUNT = (int(x) for x in os.environ.get("VFM_SEEDS", "0:200").split(":"))
SIDE = 6  # cells along each axis of grids other than AMR


def fields():
    """Returns two fractions (z, y, x)."""
    ball = np.random.default_rng(3).random((SIDE,) * 3)
    return {"ball": ball, "rest": 1 - ball}


def small_steps():
    return [{name: value[:SIDE, 3:3 + SIDE, 3:3 + SIDE] for name, value in step.items()}
            for step in steps()]


def write_exodus_grid(path):
    coordinates = [np.arange(SIDE + 1.0)] * 3
    return write_exodus(path,
                        lambda step: {"cells": hexes(fields(), np.arange(SIDE ** 3), coordinates)},
                        TIMES)


def write_all(folder):
    """Writes the intact files and the list of them that FuzzFiles reads."""
    amr, flat = make_amr(levels=2, roots=(2, 2, 2)), make_amr(levels=1, roots=(2, 2, 1))
    labels = grains()[:SIDE, :SIDE, :SIDE]
    size = ["--dimensions", ",".join([str(SIDE)] * 3)]
    nodes = [x[:SIDE + 1] for x in NODES]
    inputs = []

    def add(name, file, words, make):
        os.makedirs(os.path.join(folder, name))
        make(os.path.join(folder, name, file))
        inputs.append(" ".join([name, file, *words]))

    add("spn", "a.spn", size, lambda path: write_text(path, labels))
    add("npy-labels", "a.npy", [], lambda path: write_numpy(path, labels))
    add("npy-wide", "a.npy", [],
        lambda path: write_numpy(path, labels, np.dtype(">i8"), fortran=True))
    add("npy-fractions", "a.npy", [], lambda path: np.save(path, np.stack(list(fields().values()))))
    for counts, files, name in (((1, 1, 2), 1, "spcth"), ((2, 1, 1), 2, "spcth-flat")):
        add(name, "a.spcth", [], lambda path: write_spyplot(
            os.path.dirname(path), "a", TIMES, split(nodes, small_steps(), counts), files))
    add("exodus", "a.exo", [], write_exodus_grid)
    add("plotfile", "plt", [], lambda path: write_plotfile(path, flat))
    add("plotfile-levels", "plt", [], lambda path: write_plotfile(path, amr))
    add("vthb", "a.vthb", [], lambda path: write_vthb(path, amr))
    add("vti", "a.vti", [], lambda path: write(image(fields()), path))
    chosen, cells = ["--labels", "GrainID"], turned(labels, "ZYX").astype("i2")
    for name, data, binary, version in (("image", image({"GrainID": cells}), False, 42),
                                        ("grid", structured(cells), True, 51),
                                        ("cells", cells_of(cells), True, 42),
                                        ("offsets", cells_of(cells), False, 51)):
        add("legacy-" + name, "a.vtk", chosen,
            lambda path: write_legacy(path, data, binary, version))
    for mode in ("raw", "zlib", "inline"):
        add("vtu-" + mode, "a.vtu", chosen, lambda path: write_xml(path, cells_of(cells), mode))
    add("vts", "a.vts", chosen, lambda path: write_xml(path, structured(cells), "ascii"))
    add("pvtu", "a.pvtu", chosen, lambda path: write_pieces(path, cells))
    add("vtm", "a.vtm", chosen, lambda path: write_blocks(path, image({"GrainID": cells})))
    voxels, origin, spacing = turned(labels, "ZYX").astype("u1"), (0, 0, 0), (1, 1, 1)
    add("nifti", "a.nii", [], lambda path: write_nifti(path, voxels.astype("i2"), origin))
    add("nifti-gzip", "a.nii.gz", [], lambda path: write_nifti(path, voxels, origin, forms="sq"))
    add("nrrd", "a.nrrd", [], lambda path: write_nrrd(path, voxels, origin, encoding="raw"))
    add("nrrd-gzip", "a.nhdr", [], lambda path: write_nrrd(path, voxels, origin, data="a.values"))
    add("mha", "a.mha", [], lambda path: write_meta(path, voxels, origin))
    add("mhd", "a.mhd", [], lambda path: write_meta(path, voxels, origin, packed=True))
    add("tiff", "a.tif", [], lambda path: write_tiff(path, voxels))
    add("tiff-tiles", "a.tif", [], lambda path: write_pages(path, voxels, tile=16, bits=4))
    add("tiff-imagej", "a.tif", [],
        lambda path: write_pages(path, voxels, resolution=2, description="ImageJ=1.53t\n"
                                 "images=%d\nunit=um\nspacing=2\n" % len(voxels)))
    add("png", "a.png", [], lambda path: write_png(path, voxels[len(voxels) // 2]))
    add("mgz", "a.mgz", [], lambda path: write_mgh(path, voxels, origin))
    add("nifti-names", "a.nii", [],
        lambda path: write_nifti(path, voxels, origin, extension=CARET))
    add("dream3d", "a.dream3d", [],
        lambda path: write_dream3d(path, voxels.astype("i4"), origin, spacing))
    add("dream3d-nx", "a.dream3d", [],
        lambda path: write_dream3d_nx(path, voxels.astype("i4"), origin, spacing))
    with open(os.path.join(folder, "inputs"), "w") as out:
        out.write("\n".join(inputs) + "\n")


def run_fuzzer(folder):
    """Checks that all intact files can be meshed, then runs FuzzFiles on damaged copies."""
    fuzzer = [os.environ["VFM_FUZZ_FILES"], folder]
    for line in open(os.path.join(folder, "inputs")).read().splitlines():
        name, file, *words = line.split()
        subprocess.run([os.environ["VFM_SCULPTOR"], "--input", os.path.join(folder, name, file),
                        "--output", os.path.join(folder, "out.vtu"), "--quiet", *words], check=True)
    result = subprocess.run(fuzzer + ["--seed", str(SEEDS), "--count", str(COUNT)],
                            capture_output=True, text=True, errors="replace")
    print(result.stdout, result.stderr)
    assert result.returncode == 0, result.stdout


def test_damaged_files():
    """FuzzFiles finds no crash and no hang."""
    if len(sys.argv) > 1:
        write_all(sys.argv[1])
        run_fuzzer(sys.argv[1])
        return
    with tempfile.TemporaryDirectory() as folder:
        write_all(folder)
        run_fuzzer(folder)


main(globals())
