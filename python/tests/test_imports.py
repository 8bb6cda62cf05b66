"""Tests that each module of the package can be imported alone, in any order."""

import importlib
import pkgutil
import sys
import types
from unittest import mock

import pytest

import volume_fraction_mesh as vfm

PACKAGE = "volume_fraction_mesh"
PROGRAM = "convert_legacy_vtk"  # is run, not imported
MODULES = [each.name for each in pkgutil.walk_packages(vfm.__path__, PACKAGE + ".")
           if not each.name.endswith(("._core", "." + PROGRAM, ".__main__"))
           and "._plugins." not in each.name]  # which other packages import


@pytest.mark.parametrize("name", MODULES)
def test_module_alone(name):
    """The package is a stub, whose own imports do not load other modules first."""
    stub = types.ModuleType(PACKAGE)
    stub.__path__ = vfm.__path__
    with mock.patch.dict(sys.modules):
        for other in [each for each in sys.modules if each.startswith(PACKAGE + ".")]:
            if other != PACKAGE + "._core":
                del sys.modules[other]
        sys.modules[PACKAGE] = stub
        stub._core = sys.modules[PACKAGE + "._core"]
        importlib.import_module(name)
