"""deal.II: .msh without faces between elements gives materials and sides by number."""

import glob

import numpy as np
import pytest

from ball_in_block import SIDES, area_of, check_maximum, check_volumes, need_program, run_recipe


def test_heat(hexes, tmp_path):
    need_program("cmake", "cmake")
    if not glob.glob("/usr/include/deal.II/grid/grid_in.h"):
        pytest.skip("there is no deal.II: install Debian's libdeal.ii-dev")
    run_recipe("deal.II", hexes, tmp_path)
    greatest, *measures = np.loadtxt(tmp_path / "u.txt")
    check_maximum(hexes, greatest)
    check_volumes(hexes, dict(enumerate(measures[:2], 1)))
    assert np.allclose(measures[2:], [area_of(name) for name in SIDES], rtol=1e-9, atol=0)
