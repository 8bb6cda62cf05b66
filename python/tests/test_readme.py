"""Tests the code, pictures and links of the READMEs."""

import os
import re
import subprocess
import sys
import types

import numpy as np
import pytest

import volume_fraction_mesh as vfm
from fields import BALL, GRAINS, PLATE, STATE
from test_shapes import CUBE, TRIANGLES, write_stl

FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
README = os.path.join(FOLDER, "README.md")
ROOT_README = os.path.join(FOLDER, "..", "README.md")
pytestmark = pytest.mark.skipif(not os.path.exists(README), reason="the README is not there")


def read(path=README):
    with open(path, encoding="utf-8") as file:
        return file.read()


def blocks():
    """Returns the blocks of Python, each with the indented text after it: the expected output."""
    return re.findall(r"```python\n(.*?)```\n(?:\n((?:    [^\n]*\n)+))?", read(), re.DOTALL)


@pytest.mark.parametrize("number", range(4))
def test_code(number, tmp_path, monkeypatch, capsys):
    nibabel = pytest.importorskip("nibabel")
    pytest.importorskip("meshio")
    for name, shift in (("part", 0), ("shaft", 0), ("housing", 0.5)):
        write_stl(tmp_path / (name + ".stl"), CUBE + shift, TRIANGLES, True)
    for name, array in (("labels", GRAINS), ("steel", BALL), ("copper", PLATE)):
        np.save(tmp_path / (name + ".npy"), array)
    code, printed = blocks()[number]
    brain = nibabel.Nifti1Image(GRAINS.astype(np.int16), np.eye(4))
    names = {"vfm": vfm, "steel": BALL, "copper": PLATE, "water": BALL, "grains": GRAINS, **STATE}
    names["nibabel"] = types.SimpleNamespace(load=lambda path: brain)
    monkeypatch.chdir(tmp_path)
    exec(code, names)
    told = capsys.readouterr().out
    assert not printed or told.split() == printed.split()


def test_code_of_the_root(tmp_path, monkeypatch):
    """The code span of the quick start runs and writes its file."""
    code = re.search(r"^\*\*Python\*\*: `(import volume_fraction_mesh as vfm; [^`]*)`",
                     read(ROOT_README), re.MULTILINE).group(1)
    monkeypatch.chdir(tmp_path)
    exec(code, {})
    assert (tmp_path / "ball.inp").stat().st_size > 10000


def test_pictures():
    found = re.findall(r"\((pictures/\w+\.png)\)", read())
    assert len(found) == 4
    for name in found:
        assert 5000 < os.path.getsize(os.path.join(FOLDER, name)) < 150000


def test_links():
    for name in re.findall(r"\]\(((?!http)[^)]*)\)", read()):
        assert os.path.exists(os.path.join(FOLDER, name.split("#")[0])), name


def test_no_package_is_needed():
    """The package imports no other package than NumPy."""
    code = "import sys, volume_fraction_mesh; print(*{name.split('.')[0] for name in sys.modules})"
    found = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True,
                           check=True).stdout.split()
    assert not {"pyvista", "vtkmodules", "meshio", "nibabel", "SimpleITK", "tifffile", "PIL",
                "h5py", "tqdm"} & set(found)
