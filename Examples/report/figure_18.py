#!/usr/bin/env pvpython
"""Figure 18: a ball strikes a plate at an angle, two materials on two ranks, at four times.

usage: pvpython figure_18.py OUT

The simulation is Examples/impact, which meshes its fields with the C interface while it runs.
"""
import os

import report
from rank_meshes import field_value, read_ranks
from rank_pictures import draw, join, with_rank

RANKS = 2
STEPS = (0, 120, 360, 480)


def main(out):
    folder = os.path.join(out, "figure_18")
    report.run_program(report.IMPACT, "--every", "120", "--steps", "481", "--sculptor", folder,
                       ranks=RANKS)
    rows, panels = [], []
    for step in STEPS:
        meshes = read_ranks(os.path.join(folder, "impact_%04d.pvtu" % step))
        elements = sum(mesh.GetNumberOfCells() for mesh in meshes)
        rows.append(("step %d: hexahedra, fragments" % step,
                     "%s, %d" % (report.number(elements), field_value(meshes, "NumberOfFragments")),
                     ""))
        rows.append(report.quality_row(meshes, "step %d: " % step))
        panels.append(os.path.join(out, "figure_18_%d.png" % step))
        draw(with_rank(meshes), "MaterialId", 1, 2, panels[-1], camera=(0.35, -1.0, 0.45), zoom=1.3)
    join(panels, os.path.join(out, "figure_18.png"), 2)
    return rows


report.run(main)
