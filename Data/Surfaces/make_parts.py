#!/usr/bin/env python3
"""Makes the surfaces and the STEP file of this folder.

usage: make_parts.py [FOLDER, default: this one]

Requires NumPy and gmsh 4.15 (PyPI). Lengths are in millimetres, the longest side is 60. The number
of sides of each part is given below; the script compares it with the triangles, and the length of
the sharp edges with that of the curves of the CAD model.
"""
import os
import re
import sys

import gmsh
import numpy as np

SHARP = 40.0  # least angle of sharp edges, degrees
DEFLECTION = 0.13  # largest angle between the segments of a curve, radians
PARTS = {}  # function and number of sides of each part


def part(sides):
    def add(function):
        PARTS[function.__name__] = (function, sides)
        return function
    return add


def box(x, y, z, dx, dy, dz):
    return 3, gmsh.model.occ.addBox(x, y, z, dx, dy, dz)


def cylinder(x, y, z, radius, height):
    return 3, gmsh.model.occ.addCylinder(x, y, z, 0, 0, height, radius)


def cut(body, tools):
    return gmsh.model.occ.cut([body], tools)[0][0]


def fuse(body, others):
    return gmsh.model.occ.fuse([body], others)[0][0]


@part(6 + 7)
def plate_with_holes():
    """Plate, 6 thick, with seven holes of diameters 6 to 18."""
    holes = ((47, 20, 18), (14, 28, 12), (12, 11, 10), (30, 10, 8), (30, 30, 7), (23, 19, 6),
             (32, 20, 6))
    return cut(box(0, 0, 0, 60, 40, 6), [cylinder(x, y, -1, d / 2, 8) for x, y, d in holes])


@part(6 + 9)
def tray():
    """Tray, 2 thick, with a divider that is lower than the rim."""
    room = [box(2, 2, 2, 30, 36, 12), box(34, 2, 2, 24, 36, 12), box(30, 2, 8, 6, 36, 6)]
    return cut(box(0, 0, 0, 60, 40, 12), [fuse(room[0], room[1:])])


@part(15)
def fixed_top():
    """Milled plate with a step, a chamfer, two pockets with floors of 4, and two holes. The
    corners of the rectangular pocket are round."""
    body = cut(box(0, 0, 0, 60, 40, 14), [box(40, -1, 8, 30, 50, 10)])
    profile = [gmsh.model.occ.addPoint(-1, y, z) for y, z in ((-1, 9), (-1, 15), (5, 15))]
    lines = [gmsh.model.occ.addLine(profile[i], profile[(i + 1) % 3]) for i in range(3)]
    face = gmsh.model.occ.addPlaneSurface([gmsh.model.occ.addCurveLoop(lines)])
    chamfer = [some for some in gmsh.model.occ.extrude([(2, face)], 42, 0, 0) if some[0] == 3]
    pocket = gmsh.model.occ.addRectangle(5, 9, 4, 16, 26, roundedRadius=4)
    pocket = [some for some in gmsh.model.occ.extrude([(2, pocket)], 0, 0, 12) if some[0] == 3]
    tools = chamfer + pocket + [cylinder(31, 22, 4, 6, 12), cylinder(50, 10, -1, 4, 10),
                                cylinder(50, 28, -1, 6, 10)]
    return cut(body, tools)


@part(12)
def flange():
    """Ring with six holes, and a hub with a wall of 6."""
    holes = [cylinder(23 * np.cos(a), 23 * np.sin(a), -1, 3.5, 10)
             for a in 2 * np.pi * (np.arange(6) + 0.25) / 6]
    body = fuse(cylinder(0, 0, 0, 30, 8), [cylinder(0, 0, 0, 16, 20)])
    return cut(body, holes + [cylinder(0, 0, -1, 10, 22)])


@part(4)
def tube():
    """Straight tube with a wall of 2."""
    return cut(cylinder(0, 0, 0, 12, 60), [cylinder(0, 0, -1, 10, 62)])


def rib():
    """Returns a triangular prism."""
    model = gmsh.model.occ
    corners = [model.addPoint(x, 17, z) for x, z in ((38, 6), (50, 6), (38, 26))]
    lines = [model.addLine(corners[i], corners[(i + 1) % 3]) for i in range(3)]
    face = model.addPlaneSurface([model.addCurveLoop(lines)])
    return [some for some in model.extrude([(2, face)], 0, 6, 0) if some[0] == 3][0]


# Ten bodies in contact, and the deflection of each: round contacts have different segments, so
# bodies overlap there. The ball is inside of the block, which has no cavity.
ASSEMBLY = {
    "ball": (lambda: (3, gmsh.model.occ.addSphere(12, 12.5, 16, 2.5)), 0.3),
    "base": (lambda: cut(box(0, 0, 0, 60, 40, 6), [cylinder(54, 20, -1, 3, 8)]), 0.6),
    "block": (lambda: cut(box(8, 8, 6, 30, 24, 20), [cylinder(23, 20, 5, 8, 22)]), 0.35),
    "bushing": (lambda: cut(cylinder(23, 20, 6, 8, 20), [cylinder(23, 20, 5, 5, 22)]), 0.2),
    "cover": (lambda: cut(box(8, 8, 26, 30, 24, 3), [cylinder(23, 20, 25, 5, 5)]), 0.5),
    "foot_left": (lambda: box(0, 0, -4, 10, 40, 4), 0.5),
    "foot_right": (lambda: box(50, 0, -4, 10, 40, 4), 0.5),
    "pin": (lambda: cylinder(54, 20, 0, 3, 16), 0.4),
    "rib": (rib, 0.5),
    "shaft": (lambda: cylinder(23, 20, 6, 5, 34), 0.25)}


def bracket():
    """Returns an angle of 6 with two holes in its base and one in its wall."""
    body = fuse(box(0, 0, 0, 60, 30, 6), [box(0, 0, 0, 6, 30, 40)])
    wall = 3, gmsh.model.occ.addCylinder(-1, 15, 25, 8, 0, 0, 8)
    return cut(body, [cylinder(25, 15, -1, 5, 8), cylinder(45, 15, -1, 5, 8), wall])


# Centres of the faces of the bracket.
NAMES = {(0, 15, 20): "back", (60, 15, 3): "end", (30, 15, 0): "bottom", (33, 15, 6): "floor",
         (6, 15, 23): "front", (3, 15, 40): "top", (20, 0, 10): "left", (20, 30, 10): "right",
         (25, 15, 3): "hole_1", (45, 15, 3): "hole_2", (3, 15, 25): "bore"}


def write_step(path, body, names):
    """Writes a body with names of its faces, as CAD programs do. gmsh writes faces without names,
    in the order of their numbers."""
    gmsh.model.occ.synchronize()
    faces = [gmsh.model.occ.getCenterOfMass(2, face)
             for _, face in sorted(gmsh.model.getBoundary([body], oriented=False))]
    nearest = [min(names, key=lambda at, x=x: np.linalg.norm(np.subtract(at, x))) for x in faces]
    assert len(set(nearest)) == len(names) == len(faces)
    gmsh.write(path)
    with open(path, encoding="ascii") as file:
        text = file.read()
    shell = re.search(r"CLOSED_SHELL\('',\(([^)]*)\)\)", text)[1].split(",")
    for entity, at in zip(shell, nearest):
        text = text.replace("%s = ADVANCED_FACE(''" % entity.strip(),
                            "%s = ADVANCED_FACE('%s'" % (entity.strip(), names[at]))
    text = re.sub(r"'\d{4}-\d\d-\d\dT[\d:]+'", "'2026-01-01T00:00:00'", text)
    with open(path, "w", encoding="ascii") as file:
        file.write(text.replace("Open CASCADE STEP translator 7.8 1", "bracket"))


def triangulate(body, deflection=DEFLECTION):
    """Returns points and triangles of the surface of a body, as OpenCASCADE writes them."""
    gmsh.model.occ.synchronize()
    gmsh.option.setNumber("Mesh.StlAngularDeflection", deflection)
    gmsh.option.setNumber("Mesh.StlLinearDeflection", 1.0)
    gmsh.model.mesh.importStl()
    tags, points, _ = gmsh.model.mesh.getNodes()
    order = np.zeros(int(tags.max()) + 1, int)
    order[tags.astype(int)] = np.arange(len(tags))
    triangles = []
    for _, face in gmsh.model.getBoundary([body], oriented=False):
        _, nodes = gmsh.model.mesh.getElementsByType(2, face)
        triangles.append(order[nodes.astype(int)].reshape(-1, 3))
    # Faces have their own points.
    places, first, place = np.unique(np.round(points.reshape(-1, 3), 6), axis=0,
                                     return_index=True, return_inverse=True)
    triangles = place.ravel()[np.concatenate(triangles)]
    distinct = (triangles != np.roll(triangles, 1, 1)).all(1)  # others are at poles of spheres
    points = points.reshape(-1, 3)[first]
    return points, face_outwards(points, triangles[distinct])


def face_outwards(points, triangles):
    """Turns triangles, as OpenCASCADE leaves some turned after cut and fuse; the surface is one
    component."""
    corners = triangles.tolist()
    around = {}
    for t, (a, b, c) in enumerate(corners):
        for edge in ((a, b), (b, c), (c, a)):
            around.setdefault(frozenset(edge), []).append((t, edge))
    turned, waiting = {0: False}, [0]
    while waiting:
        t = waiting.pop()
        a, b, c = corners[t]
        for edge in ((a, b), (b, c), (c, a)):
            for other, its_edge in around[frozenset(edge)]:
                if other not in turned:
                    turned[other] = turned[t] != (its_edge == edge)
                    waiting.append(other)
    is_turned = np.array([turned[t] for t in range(len(corners))])
    triangles = np.where(is_turned[:, None], triangles[:, ::-1], triangles)
    return triangles if np.linalg.det(points[triangles]).sum() > 0 else triangles[:, ::-1]


def length_of_curves(body):
    """Returns the length of the curves of a body between two faces that meet at an angle."""
    total = 0.0
    faces = gmsh.model.getBoundary([body], oriented=False)
    around = {}
    for face in faces:
        for _, curve in gmsh.model.getBoundary([face], oriented=False):
            around.setdefault(curve, []).append(face[1])
    for curve, two in around.items():
        if len(set(two)) != 2:
            continue  # a seam of a closed face
        low, high = (bound[0] for bound in gmsh.model.getParametrizationBounds(1, curve))
        middle = gmsh.model.getValue(1, curve, [0.5 * (low + high)])
        normals = [gmsh.model.getNormal(face, gmsh.model.getParametrization(2, face, middle))
                   for face in two]
        if abs(np.dot(*normals)) < np.cos(np.radians(SHARP)):
            total += gmsh.model.occ.getMass(1, curve)
    return total


def find_sides(points, triangles):
    """Returns the number of pieces between sharp edges, and the length of these."""
    corners = points[triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    edges = np.sort(triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    order = np.lexsort(edges.T)
    pairs = edges[order].reshape(-1, 2, 2)
    assert (pairs[:, 0] == pairs[:, 1]).all(), "The surface is not closed."
    one, other = (order // 3).reshape(-1, 2).T
    sharp = (normals[one] * normals[other]).sum(1) < np.cos(np.radians(SHARP))
    ends = points[pairs[:, 0][sharp]]
    side = np.arange(len(triangles))
    while True:
        least = side.copy()
        np.minimum.at(least, one[~sharp], side[other[~sharp]])
        np.minimum.at(least, other[~sharp], side[one[~sharp]])
        least = least[least]
        if (least == side).all():
            break
        side = least
    return len(np.unique(side)), np.linalg.norm(ends[:, 0] - ends[:, 1], axis=1).sum()


def write_stl(path, points, triangles):
    records = np.zeros(len(triangles), [("normal", "<f4", 3), ("corners", "<f4", (3, 3)),
                                        ("attribute", "<u2")])
    corners = points[triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    records["normal"] = normals / np.linalg.norm(normals, axis=1)[:, None]
    records["corners"] = corners
    with open(path, "wb") as file:
        file.write(b"Made by make_parts.py of VolumeFractionMesh".ljust(80))
        file.write(np.uint32(len(triangles)).tobytes() + records.tobytes())


def make_fan():
    """Returns points and triangles of a body whose wall has three creases: at one the angle fades
    with the height, one is sharp, one is concave. Its top is curved. Sides: two walls, bottom, top.
    """
    radial, around, up = 7, 72, 14
    height, radius = 24.0, 22.0
    angles = 2 * np.pi * np.arange(around) / around
    z = np.linspace(0, 1, up + 1)[:, None]
    wall = np.ones((up + 1, around))
    for at, size, width in ((0, 0.45 * (1 - z) ** 1.5, 1.0), (24, 0.45 + 0 * z, 0.9),
                            (48, -0.32 + 0 * z, 0.8)):
        away = np.abs((angles - angles[at] + np.pi) % (2 * np.pi) - np.pi)
        wall = wall + size * np.clip(1 - away / width, 0, None) ** 2
    top = height * (1 + 0 * angles)
    wall *= radius
    points, rows = [], []
    for level, share in enumerate(z.ravel()):
        rows.append(len(points) + np.arange(around))
        r = wall[level]
        points += list(np.stack([r * np.cos(angles), r * np.sin(angles), share * top], 1))
    triangles = []
    following = np.roll(np.arange(around), -1)
    for a, b in zip(rows, rows[1:]):
        triangles += [np.stack([a, a[following], b[following]], 1),
                      np.stack([a, b[following], b], 1)]
    for row, r, is_top in ((rows[0], wall[0], False), (rows[-1], wall[-1], True)):
        outer = row
        for i in range(radial - 1, 0, -1):
            share = i / radial
            inner = len(points) + np.arange(around)
            bulge = 5.0 * (1 - share ** 2) if is_top else 0.0
            points += list(np.stack([share * r * np.cos(angles), share * r * np.sin(angles),
                                     (height if is_top else 0.0) + bulge + 0 * angles], 1))
            ring = np.concatenate([np.stack([outer, outer[following], inner[following]], 1),
                                   np.stack([outer, inner[following], inner], 1)])
            triangles.append(ring if is_top else ring[:, ::-1])
            outer = inner
        middle = len(points)
        points.append(np.array([0, 0, height + 5.0 if is_top else 0.0]))
        ring = np.stack([outer, outer[following], np.full(around, middle)], 1)
        triangles.append(ring if is_top else ring[:, ::-1])
    return np.array(points), np.concatenate(triangles)


def main(folder):
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    for name, (function, sides) in PARTS.items():
        gmsh.model.add(name)
        body = function()
        points, triangles = triangulate(body)
        length = length_of_curves(body)
        found, sharp = find_sides(points, triangles)
        print("%-18s %5d triangles, %2d sides, sharp edges %.1f (curves %.1f)" % (
            name, len(triangles), found, sharp, length))
        if found != sides or abs(sharp / length - 1) > 0.01:
            sys.exit("%s: expected %d sides" % (name, sides))
        write_stl(os.path.join(folder, name + ".stl"), points, triangles)
    points, triangles = make_fan()
    found, sharp = find_sides(points, triangles)
    print("%-18s %5d triangles, %2d sides, sharp edges %.1f" % ("fan", len(triangles), found,
                                                               sharp))
    write_stl(os.path.join(folder, "fan.stl"), points, triangles)
    os.makedirs(os.path.join(folder, "assembly"), exist_ok=True)
    for name, (function, deflection) in ASSEMBLY.items():
        gmsh.model.add(name)
        write_stl(os.path.join(folder, "assembly", name + ".stl"),
                  *triangulate(function(), deflection))
    gmsh.model.add("bracket")
    write_step(os.path.join(folder, "bracket.step"), bracket(), NAMES)
    gmsh.finalize()


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else os.path.dirname(os.path.abspath(__file__)))
