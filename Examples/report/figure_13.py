#!/usr/bin/env pvpython
"""Figure 13: the boxes of figure 12 with a few chosen cells refined, in a conforming mesh.

usage: pvpython figure_13.py OUT
"""
import os

import report
from rank_meshes import field_value
from rank_pictures import draw, join, with_rank


def main(out):
    rows, panels = [], []
    for name, option in (("smoothed", "--smooth=1"), ("not smoothed", "--no-smooth")):
        stem = os.path.join(out, "figure_13_" + name.replace(" ", "_"))
        verdict, meshes = report.built_in_test(stem + ".pvtu", "--refine-cells", option)
        panels.append(stem + ".png")
        draw(with_rank(meshes), "FragmentId", 1, 2, panels[-1])
        rows += [
            (name + ": result of the test", verdict, ""),
            (name + ": chosen cells", report.number(field_value(meshes, "ChosenCells")), ""),
            report.boxes_row(meshes, name + ": "),
            report.quality_row(meshes, name + ": ")]
    join(panels, os.path.join(out, "figure_13.png"), 2)
    return rows


report.run(main)
