#!/usr/bin/env pvpython
"""Figure 20: the eight shapes of figure 19 as tetrahedra.

usage: pvpython figure_20.py OUT
"""
import os

import report
from rank_pictures import draw, with_rank


def main(out):
    field = report.eight_shapes(out)
    meshes = report.mesh_field(field, os.path.join(out, "figure_20.pvtu"), "--tetmesh", "Lattice")
    draw(with_rank(meshes), "MaterialId", 1, 8, os.path.join(out, "figure_20.png"))
    return [
        ("tetrahedra", report.number(meshes[0].GetNumberOfCells()), "about 259,000"),
        report.positive_row(meshes, "0"),
        report.quality_row(meshes),
        report.angles_row(meshes)]


report.run(main)
