"""Tests that every public function and class has an example, and that all examples run."""

import doctest
import importlib
import inspect
import os
import pkgutil
import shutil

import numpy as np
import pytest

import volume_fraction_mesh as vfm

DATA = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Data")
FLAGS = doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE
# Packages and files that examples need; without them an example is skipped.
PACKAGES = {"to_pyvista": "pyvista", "to_meshio": "meshio", "to_skfem": "skfem",
            "plot": "pyvista"}
FILES = {"read": ["impact.spcth", "impact"]}


def list_modules():
    names = [module.name for module in pkgutil.iter_modules(vfm.__path__)]
    names += ["_grains.grains", "_grains.grain_table"]
    return [vfm, *(importlib.import_module("volume_fraction_mesh." + name) for name in names
                   if name not in ("_core", "__main__"))]


def list_examples():
    finder = doctest.DocTestFinder(exclude_empty=True)
    return [test for module in list_modules() for test in finder.find(module) if test.examples]


def list_public():
    """Returns the public functions, classes and methods of the package by name."""
    found = {}
    for name in vfm.__all__:
        thing = getattr(vfm, name)
        if not getattr(thing, "__module__", "").startswith("volume_fraction_mesh.") or (
                thing in (vfm.Blocks, vfm.Bodies)):  # compiled
            continue
        found[name] = thing
        if inspect.isclass(thing):
            found.update(("%s.%s" % (name, own), value) for own, value in vars(thing).items()
                         if not own.startswith("_")
                         and (inspect.isfunction(value) or isinstance(value, property)))
    return found


NOTHING = ("Grains.save", "Mesh.report", "Mesh.save")  # functions that return nothing
EXAMPLES = list_examples()
PUBLIC = list_public()


@pytest.mark.filterwarnings("ignore::volume_fraction_mesh.VolumeFractionMeshWarning")
@pytest.mark.parametrize("example", EXAMPLES, ids=[example.name for example in EXAMPLES])
def test_example(example, tmp_path, monkeypatch):
    name = example.name.split(".")[-1]
    if name in PACKAGES:
        pytest.importorskip(PACKAGES[name])
    for file in FILES.get(name, []):
        path = os.path.join(DATA, file)
        if not os.path.exists(path):
            pytest.skip("there is no file %s" % path)
        copy = shutil.copytree if os.path.isdir(path) else shutil.copy
        copy(path, tmp_path / file)
    monkeypatch.chdir(tmp_path)
    example.globs = {"vfm": vfm, "np": np}
    printed = []
    doctest.DocTestRunner(optionflags=FLAGS).run(example, out=printed.append)
    assert not printed, "".join(printed)


@pytest.mark.parametrize("name", PUBLIC)
def test_has_an_example(name):
    assert {"hexes", "fragments", "Mesh.save", "Geometry"} <= set(PUBLIC)
    examples = doctest.DocTestParser().get_examples(inspect.getdoc(PUBLIC[name]) or "")
    assert examples, "%s has no example" % name


@pytest.mark.parametrize("name", [name for name in PUBLIC if inspect.isfunction(PUBLIC[name])])
def test_describes_all_arguments(name):
    """Every parameter of a function has an entry in numpydoc form."""
    text = inspect.getdoc(PUBLIC[name])
    entries = {word.strip("* ") for line in text.splitlines() if " : " in line or line[:2] == "**"
               for word in line.split(" : ")[0].split(",")}
    parameters = set(inspect.signature(PUBLIC[name]).parameters) - {"self"}
    assert parameters <= entries, parameters - entries
    assert "Examples\n--------" in text and ("Returns\n-------" in text or name in NOTHING)
