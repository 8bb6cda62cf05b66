#!/usr/bin/env pvpython
"""Figure 17: a half sphere, and the half cylinder of the caption. Their buffer layers end at a side
of the domain.

usage: pvpython figure_17.py OUT
"""
import os

import numpy as np

import report
from rank_meshes import points_of, values
from rank_pictures import draw_quality, join, with_rank

RADIUS, MIDDLE = 8.0, (12.0, 12.0, 12.0)  # cells have width 1; the side is z = 12
BODIES = {
    "half sphere": ("sphere radius=%g center=%g,%g,%g" % (RADIUS, *MIDDLE), (0, 1, 2)),
    "half cylinder": ("cylinder radius=%g height=40 center=%g,%g,%g rotation=90,0,0"
                      % (RADIUS, *MIDDLE), (0, 2)),
}


def main(out):
    rows, panels = [], []
    for name, (shapes, axes) in BODIES.items():
        stem = os.path.join(out, "figure_17_" + name.replace(" ", "_"))
        field = report.make_field(stem + ".vti", Shapes=shapes, Dimensions=[24, 24, 12],
                                  Bounds=[0, 24, 0, 24, 0, 12])
        meshes = report.mesh_field(field, stem + ".pvtu")
        points = points_of(meshes[0])
        rim = points[(points[:, 2] == 12.0) & (values(meshes, "GeometryDimension", "Point") < 2)]
        # Excludes nodes at the ends of the cylinder, which lie on two sides.
        rim = rim[(rim[:, 1] > 0) & (rim[:, 1] < 24)]
        off = np.abs(np.linalg.norm(rim[:, axes] - np.take(MIDDLE, axes), axis=1) - RADIUS)
        rows += [
            (name + ": hexahedra", report.number(meshes[0].GetNumberOfCells()), ""),
            report.quality_row(meshes, name + ": "),
            (name + ": nodes where the surface meets the side", report.number(len(rim)), ""),
            (name + ": their distance from the true circle or lines, rms, largest [cells]",
             "%.4f, %.4f" % (np.sqrt((off ** 2).mean()), off.max()), "")]
        panels.append(stem + ".png")
        draw_quality(with_rank(meshes), 0.7, panels[-1], camera=(0.6, -1.0, 0.9), zoom=1.0)
    join(panels, os.path.join(out, "figure_17.png"), 2)
    return rows


report.run(main)
