#!/usr/bin/env pvpython
"""Figure 12: two boxes of full cells, the built-in test.

usage: pvpython figure_12.py OUT
"""
import os

import report
from rank_pictures import draw, with_rank


def main(out):
    verdict, meshes = report.built_in_test(os.path.join(out, "figure_12.pvtu"), "--refine", "0")
    draw(with_rank(meshes), "FragmentId", 1, 2, os.path.join(out, "figure_12.png"))
    return [
        ("result of the test", verdict, ""),
        report.boxes_row(meshes),
        report.quality_row(meshes)]


report.run(main)
