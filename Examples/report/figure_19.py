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
    quality = values(meshes, "ScaledJacobian")
    draw(with_rank(meshes), "MaterialId", 1, 8, os.path.join(out, "figure_19.png"))
    return [
        ("materials", report.number(len(set(values(meshes, "MaterialId").tolist()))), "8"),
        ("hexahedra", report.number(len(quality)), ""),
        ("smallest, mean scaled Jacobian", report.pair(quality.min(), quality.mean()), "")]


report.run(main)
