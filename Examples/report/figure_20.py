#!/usr/bin/env pvpython
"""Figure 20: the eight shapes of figure 19 as tetrahedra.

usage: pvpython figure_20.py OUT
"""
import os

import report
from rank_meshes import field_value, values
from rank_pictures import draw, with_rank


def main(out):
    field = report.eight_shapes(out)
    meshes = report.mesh_field(field, os.path.join(out, "figure_20.pvtu"), "--tetmesh", "Lattice")
    quality = values(meshes, "ScaledJacobian")
    draw(with_rank(meshes), "MaterialId", 1, 8, os.path.join(out, "figure_20.png"))
    return [
        ("tetrahedra", report.number(len(quality)), "about 259,000"),
        ("not positive", report.number(int((quality <= 0).sum())), "0"),
        ("smallest, mean scaled Jacobian", report.pair(quality.min(), quality.mean()), ""),
        ("dihedral angles", "%.1f to %.1f degrees" % tuple(
            field_value(meshes, name + "DihedralAngle") for name in ("Minimum", "Maximum")), "")]


report.run(main)
