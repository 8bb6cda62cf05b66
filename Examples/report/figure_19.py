#!/usr/bin/env pvpython
"""Figure 19: eight shapes of eight materials as hexahedra.

usage: pvpython figure_19.py OUT
"""
import os

import report
from rank_meshes import values
from rank_pictures import draw, with_rank


def main(out):
    meshes = report.mesh_field(report.eight_shapes(out), os.path.join(out, "figure_19.pvtu"))
    draw(with_rank(meshes), "MaterialId", 1, 8, os.path.join(out, "figure_19.png"))
    return [
        ("materials", report.number(len(set(values(meshes, "MaterialId").tolist()))), "8"),
        ("hexahedra", report.number(meshes[0].GetNumberOfCells()), ""),
        report.quality_row(meshes)]


report.run(main)
