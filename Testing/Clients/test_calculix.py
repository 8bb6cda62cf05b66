"""Tests CalculiX: heat on .inp, and heat through each side by its surface."""

import re
import subprocess

from ball_in_block import SIDES, area_of, check_maximum, need_program, recipe, run_recipe

TOTAL = re.compile(r"total surface heat flux|heat flow", re.IGNORECASE)


def test_recipe(mesh, tmp_path):
    need_program("ccx", "calculix-ccx")
    names = run_recipe("CalculiX", mesh, tmp_path)
    assert len(names["u"]) == len(mesh.points)
    check_maximum(mesh, names["u"])


def test_surfaces(mesh, tmp_path):
    """A flux of 1 through the surface of a side adds up to its area: the reactions of all nodes,
    which are fixed."""
    need_program("ccx", "calculix-ccx")
    mesh.save(tmp_path / "ball.inp")
    deck = recipe("CalculiX")[0][1]
    start = deck.index("*BOUNDARY")
    for side in SIDES:
        (tmp_path / "heat.inp").write_text(
            deck[:start] + "*BOUNDARY\nNALL, 11, 11\n*DFLUX\n%s, S, 1\n" % side.upper()
            + "*NODE PRINT, NSET=NALL, TOTALS=ONLY\nRFL\n*END STEP\n", encoding="ascii")
        run = subprocess.run(["ccx", "heat"], cwd=tmp_path, capture_output=True, text=True,
                             check=True)
        assert "*ERROR" not in run.stdout, run.stdout
        total = float((tmp_path / "heat.dat").read_text().split()[-1])
        assert abs(abs(total) / area_of(side) - 1) < 1e-6, (side, total)
