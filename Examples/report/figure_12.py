#!/usr/bin/env pvpython
"""Figure 12: two boxes of full cells, the test that is built in.

usage: pvpython figure_12.py OUT
"""
import os

import report
from rank_meshes import values
from rank_pictures import draw, with_rank


def main(out):
    verdict, meshes = report.built_in_test(os.path.join(out, "figure_12.pvtu"), "--refine", "0")
    fragments, quality = values(meshes, "FragmentId"), values(meshes, "ScaledJacobian")
    draw(with_rank(meshes), "FragmentId", 1, 2, os.path.join(out, "figure_12.png"))
    return [
        ("what the test says of itself", verdict, ""),
        ("hexahedra of the boxes", "%d, %d" % tuple((fragments == box).sum() for box in (1, 2)), ""),
        ("smallest, mean scaled Jacobian", report.pair(quality.min(), quality.mean()), "")]


report.run(main)
