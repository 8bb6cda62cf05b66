#!/usr/bin/env pvpython
"""Figure 14: tetrahedra made in parallel, one colour per rank.

usage: pvpython figure_14.py OUT
"""
import os

import report
from rank_pictures import draw, join, with_rank

RANKS = 4


def main(out):
    field = os.path.join(report.ROOT, "Data", "ball_and_plate.vti")
    options = ("--tetmesh", "Lattice")
    one = report.mesh_field(field, os.path.join(out, "figure_14_1.pvtu"), *options)
    meshes = report.mesh_field(field, os.path.join(out, "figure_14.pvtu"), *options, ranks=RANKS)
    panels = [os.path.join(out, "figure_14_%s.png" % name) for name in ("together", "apart")]
    for distance, panel in zip((0.0, 0.4), panels):
        draw(with_rank(meshes, distance), "Rank", 0, RANKS - 1, panel)
    join(panels, os.path.join(out, "figure_14.png"), 2)
    return [
        report.counts_row("tetrahedra of the ranks", meshes),
        report.positive_row(meshes),
        report.angles_row(meshes),
        report.shared_row(meshes),
        report.same_row("the mesh", meshes, one)]


report.run(main)
