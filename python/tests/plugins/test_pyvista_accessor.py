"""Tests the accessor of PyVista's data sets."""

import subprocess
import sys
from importlib.metadata import entry_points

import numpy as np
import pytest

import volume_fraction_mesh as vfm
from fields import BALL, LABELS, N

pyvista = pytest.importorskip("pyvista", "0.48")


def image():
    made = pyvista.ImageData(dimensions=(N + 1,) * 3, spacing=(0.5, 0.25, 0.5))
    made.cell_data["ball"] = BALL.ravel("F")
    made.cell_data["id"] = LABELS.ravel("F")
    return made


@pytest.fixture(autouse=True)
def accessor():
    """The module that PyVista imports by the entry point."""
    from volume_fraction_mesh._plugins import pyvista_accessor
    return pyvista_accessor


@pytest.mark.parametrize("kind", ["hexes", "tets"])
def test_images(kind):
    for source in (image(), image().cast_to_rectilinear_grid(),
                   image().cast_to_unstructured_grid()):
        made = getattr(source.volume_fraction_mesh, kind)(arrays=["id"], label_smoothing=2)
        known = getattr(vfm, kind)(source, arrays=["id"], label_smoothing=2)
        assert np.array_equal(made.points, known.points)
        assert np.array_equal(made.cell_data["MaterialId"], known.material)
    assert getattr(image().volume_fraction_mesh, kind)(arrays=["ball"]).n_cells > 100


def test_surface():
    ball = pyvista.Sphere(radius=1.0)
    made = ball.volume_fraction_mesh.hexes(cells=16, edge_angle=60)
    known = vfm.hexes(vfm.surface(ball, 16), edge_angle=60)
    assert np.array_equal(made.points, known.points) and made.n_cells > 1000
    assert np.isclose(made.volume, ball.volume, rtol=1e-4)
    # Other filters of PyVista continue.
    assert 0 < made.threshold([0.0, 0.9], scalars="ScaledJacobian").n_cells < made.n_cells


def test_errors():
    with pytest.raises(ValueError, match="no numeric cell array 'foam'"):
        image().volume_fraction_mesh.hexes(arrays=["foam"])
    with pytest.raises(TypeError):
        image().volume_fraction_mesh.hexes(cells=16)


def test_found_without_import(accessor):
    """The entry point names the module."""
    found = [entry.value for entry in entry_points(group="pyvista.accessors")
             if entry.name == "volume_fraction_mesh"]
    assert found[:1] == [accessor.__name__]
    code = ("import pyvista; image = pyvista.ImageData(dimensions=(4, 4, 4)); "
            "image.cell_data['label'] = [1] * 27; "
            "print(image.volume_fraction_mesh.hexes(arrays=['label']).n_cells)")
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert run.stdout == "27\n", run.stderr
