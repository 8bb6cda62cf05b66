"""What the README tells is so."""

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
from volume_fraction_mesh._core import list_options

FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
README = os.path.join(FOLDER, "README.md")
pytestmark = pytest.mark.skipif(not os.path.exists(README), reason="the tests are alone")


def read():
    with open(README, encoding="utf-8") as file:
        return file.read()


def blocks():
    """Of Python, with the text that follows, if that is what they print."""
    return re.findall(r"```python\n(.*?)```\n(?:\n((?:    [^\n]*\n)+))?", read(), re.DOTALL)


def test_table_of_options():
    rows = dict(re.findall(r"^\| `(\w+)` \| (.*?) \|", read(), re.MULTILINE))
    for option in list_options():
        expected = '"%s"' % option.default if option.kind == "word" else "%g" % option.default
        expected = str(option.default) if option.kind == "flag" else expected
        assert option.name in rows, option.name
        assert "**%s**" % expected in rows[option.name], (option.name, expected, rows[option.name])
        assert all('"%s"' % word in rows[option.name] for word in option.words), option.name


@pytest.mark.parametrize("number", range(3))
def test_code(number, tmp_path, monkeypatch, capsys):
    nibabel = pytest.importorskip("nibabel")
    pytest.importorskip("meshio")
    write_stl(tmp_path / "part.stl", CUBE, TRIANGLES, True)
    code, printed = blocks()[number]
    brain = nibabel.Nifti1Image(GRAINS.astype(np.int16), np.eye(4))
    names = {"vfm": vfm, "steel": BALL, "copper": PLATE, "water": BALL, "grains": GRAINS, **STATE}
    names["nibabel"] = types.SimpleNamespace(load=lambda path: brain)
    monkeypatch.chdir(tmp_path)
    exec(code, names)
    told = capsys.readouterr().out
    assert not printed or told.split() == printed.split()


def test_pictures():
    found = re.findall(r"\((pictures/\w+\.png)\)", read())
    assert len(found) == 4
    for name in found:
        assert 5000 < os.path.getsize(os.path.join(FOLDER, name)) < 150000


def test_links():
    for name in re.findall(r"\]\(((?!http)[^)]*)\)", read()):
        assert os.path.exists(os.path.join(FOLDER, name)), name


def test_no_package_is_needed():
    """But numpy."""
    code = "import sys, volume_fraction_mesh; print(*{name.split('.')[0] for name in sys.modules})"
    found = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True,
                           check=True).stdout.split()
    assert not {"pyvista", "vtkmodules", "meshio", "nibabel", "SimpleITK", "tqdm"} & set(found)
