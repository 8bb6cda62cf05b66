"""Tests that arrays are not copied if their memory has the order of the core."""

import subprocess
import sys

import numpy as np
import pytest

from fields import BALL, LABELS, STATE
from volume_fraction_mesh._arrays import CellArrays, as_fractions, as_numbers, flatten, shaped
from volume_fraction_mesh._images import read_image


def added(array, order, read=as_numbers):
    arrays = CellArrays(order)
    arrays.add("a", read(array, "a"))
    return arrays.items()[0][1]


@pytest.mark.parametrize("kind", ["f8", "f4", "i8", "i4", "i2", "u1"])
def test_views(kind):
    array = BALL.astype(kind)
    for given, order in (
        (np.asfortranarray(array), "xyz"),
        (np.ascontiguousarray(array), "zyx"),
        (np.ascontiguousarray(array).T, "xyz"),
    ):
        flat = added(given, order)
        assert np.shares_memory(flat,
                                given) and flat.flags.c_contiguous and flat.shape == (array.size,)
        assert np.array_equal(flat, given.ravel("F" if order == "xyz" else "C"))


def test_views_of_fractions_and_labels():
    for array in (BALL, BALL.astype(np.float32), (BALL * 255).astype(np.uint8)):
        assert (
            np.shares_memory(added(np.asfortranarray(array), "xyz", as_fractions),
                             np.asfortranarray(array))
            or not array.flags.f_contiguous
        )
    fortran = np.asfortranarray(BALL)
    assert np.shares_memory(added(fortran, "xyz", as_fractions), fortran)
    mask = np.asfortranarray(LABELS == 1)
    assert np.shares_memory(added(mask, "xyz"), mask)
    fortran.flags.writeable = False
    assert np.shares_memory(added(fortran, "xyz"), fortran)


def test_views_of_components():
    zyx = np.arange(5 * 4 * 3 * 2.0).reshape(5, 4, 3, 2)
    flat = added(zyx, "zyx")
    assert np.shares_memory(flat, zyx) and flat.shape == (60, 2)
    assert np.shares_memory(added(zyx.transpose(2, 1, 0, 3), "xyz"), zyx)
    assert np.shares_memory(added(STATE["velocity"], "xyz"), STATE["velocity"])
    assert np.array_equal(shaped(flat, (3, 4, 5), "zyx"), zyx) and np.array_equal(
        shaped(flat, (3, 4, 5), "xyz"), zyx.transpose(2, 1, 0, 3)
    )


def test_copies_where_they_must_be():
    array = np.arange(24.0).reshape(2, 3, 4)
    flat = flatten(array, "xyz")
    assert not np.shares_memory(flat, array) and np.array_equal(flat, array.ravel("F"))


def test_images_are_views():
    nibabel = pytest.importorskip("nibabel")
    array = np.asfortranarray(LABELS.astype(np.int16))
    assert np.shares_memory(read_image(nibabel.Nifti1Image(array, np.eye(4)),
                                       None).arrays["Material 1"], array)
    pyvista = pytest.importorskip("pyvista")
    image = pyvista.ImageData(dimensions=(13, 13, 13))
    image.cell_data["a"] = np.arange(12.0**3)
    assert np.shares_memory(read_image(image, ["a"]).arrays["a"], image.cell_data["a"])


MEMORY = """
import sys
import numpy as np
import volume_fraction_mesh as vfm

def peak():  # kilobytes
    with open("/proc/self/status") as file:
        return next(int(line.split()[1]) for line in file if line.startswith("VmHWM"))

array = np.zeros((400, 400, 100), np.float64, order=sys.argv[1])
array[:40, :40, :20] = 1
before = peak()
vfm.hexes(array, stair_step=True, compute_quality=False, threads=1)
print((peak() - before) / (array.nbytes / 1024))
"""


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="the memory is read from /proc")
def test_memory():
    """Measures the memory of a run in sizes of the array: a copy adds one."""
    grown = [
        float(subprocess.run([sys.executable, "-c", MEMORY, order], check=True,
                             capture_output=True).stdout)
        for order in "FC"
    ]
    assert grown[1] - grown[0] > 0.8, grown
