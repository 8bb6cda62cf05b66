#!/usr/bin/env pvpython
"""Figures 9 to 11 and 16: a ball on four ranks. The subdomains are shown apart and together, and
the surface is continuous across them.

usage: pvpython figure_09.py OUT
"""
import os

import report
from rank_meshes import surface_angles
from rank_pictures import draw, join, with_rank

RANKS = 4
CELLS = 24


def main(out):
    field = report.make_field(
        os.path.join(out, "ball.vti"), Preset="Sphere", Dimensions=[CELLS] * 3,
        Bounds=[0, CELLS] * 3)
    one = report.mesh_field(field, os.path.join(out, "figure_09_1.pvtu"))
    meshes = report.mesh_field(field, os.path.join(out, "figure_09.pvtu"), ranks=RANKS)
    whole, apart = with_rank(meshes), with_rank(meshes, apart=0.5)
    panels = [os.path.join(out, "figure_09_%s.png" % name)
              for name in ("apart", "together", "surface")]
    for mesh, panel, edges in zip((apart, whole, whole), panels, (True, True, False)):
        draw(mesh, "Rank", 0, RANKS - 1, panel, edges=edges, camera=(1.0, -0.35, 0.5),
             size=(800, 700), zoom=1.4)
    join(panels, os.path.join(out, "figure_09.png"), 3)
    inside, between = surface_angles(meshes)
    return [
        report.counts_row("hexahedra of the ranks", meshes),
        report.shared_row(meshes),
        ("largest angle between facets of the surface, inside ranks", "%.1f degrees" % inside.max(),
         ""),
        ("the same between ranks", "%.1f degrees" % between.max(), ""),
        report.same_row("the mesh", meshes, one)]


report.run(main)
