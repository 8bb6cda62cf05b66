#!/usr/bin/env pvpython
"""Figure 14: tetrahedra made in parallel, a colour a rank.

usage: pvpython figure_14.py OUT
"""
import os

import report
from rank_meshes import digest, field_value, shared_points, values
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
    shared, moved = shared_points(meshes)
    return [
        ("tetrahedra of the ranks", ", ".join(report.number(mesh.GetNumberOfCells()) for mesh in meshes), ""),
        ("not positive", report.number(int((values(meshes, "ScaledJacobian") <= 0).sum())), ""),
        ("dihedral angles", "%.1f to %.1f degrees" % tuple(
            field_value(meshes, name + "DihedralAngle") for name in ("Minimum", "Maximum")), ""),
        ("points of several ranks, of these not at one place", "%s, %s" % (report.number(shared), report.number(moved)), ""),
        ("the mesh", "the same bits as on one rank" if digest(meshes) == digest(one) else "ANOTHER than on one rank", "")]


report.run(main)
