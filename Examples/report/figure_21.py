#!/usr/bin/env pvpython
"""Figure 21: the eight shapes of figure 19 on 4, 8 and 33 MPI ranks, one colour per rank.

usage: pvpython figure_21.py OUT
"""
import os

import report
from rank_pictures import draw, join, with_rank


def main(out):
    field = report.eight_shapes(out)
    one = report.mesh_field(field, os.path.join(out, "figure_21_1.pvtu"))
    rows, panels = [], []
    for ranks in (4, 8, 33):
        stem = os.path.join(out, "figure_21_%d" % ranks)
        meshes = report.mesh_field(field, stem + ".pvtu", ranks=ranks)
        counts = [mesh.GetNumberOfCells() for mesh in meshes]
        rows += [report.same_row("%d ranks" % ranks, meshes, one),
                 ("%d ranks: hexahedra of a rank" % ranks,
                  "%s to %s" % (report.number(min(counts)), report.number(max(counts))), ""),
                 report.shared_row(meshes, "%d ranks: " % ranks)]
        panels.append(stem + ".png")
        draw(with_rank(meshes), "Rank", 0, ranks - 1, panels[-1], size=(800, 700), zoom=1.05)
    join(panels, os.path.join(out, "figure_21.png"), 3)
    return rows


report.run(main)
