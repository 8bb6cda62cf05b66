#!/usr/bin/env pvpython
"""Figure 8: the geometry of a mesh: surfaces in colour, curves and vertices.

usage: pvpython figure_08.py OUT
"""
import os

from paraview import simple

import report
from rank_meshes import field_value
from rank_pictures import colour_by_number, join, pictures

# A ball of two halves, partly sunk into a plate that reaches the sides of the domain.
SHAPES = """
sphere    material=1 center=12,12,12 radius=7 cut=12,12,12,1,0.3,0
sphere    material=2 center=12,12,12 radius=7
halfspace material=3 point=0,0,9 normal=0,0,1
"""
INK = (0.1, 0.1, 0.1)


def draw(parts, surfaces, hidden, path):
    """Saves a picture of the geometry. hidden: origin and normal of a plane; surfaces in front of
    it are not shown."""
    view = pictures.make_view((1000, 850))
    shown = simple.Clip(Input=parts["Surfaces"], ClipType="Plane", Crinkleclip=1, Invert=0)
    shown.ClipType.Origin, shown.ClipType.Normal = hidden
    colour_by_number(pictures.show(shown, view), "SurfaceId", 1, surfaces)
    pictures.show(simple.Tube(Input=parts["Curves"], Radius=0.12), view, INK, edges=False)
    balls = simple.Glyph(Input=parts["Vertices"], GlyphType="Sphere", ScaleFactor=0.8,
                         GlyphMode="All Points")
    pictures.show(balls, view, INK, edges=False)
    pictures.aim(view, (0, 24, 0, 24, 0, 19), (0.5, -1.0, 0.7), 1.05, sink=0.0)
    pictures.save(view, path)


def main(out):
    field = report.make_field(os.path.join(out, "halves.vti"), Shapes=SHAPES,
                              Dimensions=[24, 24, 20], Bounds=[0, 24, 0, 24, 0, 20])
    geometry = os.path.join(out, "figure_08.vtm")
    meshes = report.mesh_field(field, os.path.join(out, "figure_08.pvtu"), "--geometry", geometry)
    reader = simple.XMLMultiBlockDataReader(FileName=[geometry])
    parts = {name: simple.ExtractBlock(Input=reader, Selectors=["/Root/" + name])
             for name in ("Surfaces", "Curves", "Vertices")}
    surfaces = field_value(meshes, "NumberOfSurfaces")
    panels = [os.path.join(out, "figure_08_%s.png" % name) for name in ("outside", "inside")]
    for y, panel in zip((-1.0, 12.0), panels):
        draw(parts, surfaces, ((12.0, y, 12.0), (0.0, 1.0, 0.0)), panel)
    join(panels, os.path.join(out, "figure_08.png"), 2)
    return [("volumes", report.number(field_value(meshes, "NumberOfFragments")), "")] + [
        (name.lower(), report.number(field_value(meshes, "NumberOf" + name)), "")
        for name in ("Surfaces", "Curves", "Vertices")]


report.run(main)
