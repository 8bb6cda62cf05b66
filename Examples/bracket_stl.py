"""Writes a bracket as a closed surface of triangles with edges of 90 and 135 degrees, holes and
fillets, in plain Python.

usage: python3 Examples/bracket_stl.py OUT.stl

The profile is an L of 60 x 50 mm, extruded by 40 mm along y. The inner corner has a fillet of 8 mm,
the outer corner one of 12 mm, and the end of the base a chamfer of 4 mm. Two holes of 11 mm go
through the base and one of 18 mm through the wall. All other edges are sharp.
"""
import math
import struct
import sys

DEPTH = 40.0
BASE, WALL = 12.0, 10.0     # thickness
INNER = (18.0, 20.0, 8.0)   # x, z and radius of the fillets
OUTER = (12.0, 12.0, 12.0)
STEPS = 32                  # number of segments of a quarter circle
HOLES = (  # first and last point of the axis, radius
    ((40.0, 11.0, 0.0), (40.0, 11.0, BASE), 5.5),
    ((40.0, 29.0, 0.0), (40.0, 29.0, BASE), 5.5),
    ((0.0, 20.0, 34.0), (WALL, 20.0, 34.0), 9.0))


def arc(circle, first, last):
    """Returns points (x, z) on a circle (x, z, radius) between two angles in degrees."""
    angles = (math.radians(first + (last - first) * i / STEPS) for i in range(STEPS + 1))
    return [(circle[0] + circle[2] * math.cos(a), circle[1] + circle[2] * math.sin(a))
            for a in angles]


SHARP = ((60.0, 0.0), (60.0, 8.0), (56.0, BASE), (WALL, 50.0), (0.0, 50.0))  # corners of the L
# Counter-clockwise, seen from -y.
OUTLINE = arc(OUTER, 180, 270) + list(SHARP[:3]) + arc(INNER, 270, 180) + list(SHARP[3:])


def rim(hole, end):
    """Returns the circle of a hole at its first (0) or last (1) end."""
    centre, radius = hole[end], hole[2]
    across = [a for a in range(3) if hole[0][a] == hole[1][a]]
    points = []
    for i in range(4 * STEPS):
        angle = 2.0 * math.pi * i / (4 * STEPS)
        point = list(centre)
        point[across[0]] += radius * math.cos(angle)
        point[across[1]] += radius * math.sin(angle)
        points.append(tuple(point))
    return points


def area(a, b, c):
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def crosses(a, b, c, d):
    """Returns whether two segments without a common end intersect."""
    if {a, b} & {c, d}:
        return False
    return area(a, b, c) * area(a, b, d) <= 0 and area(c, d, a) * area(c, d, b) <= 0


def with_holes(outer, holes):
    """Joins a polygon (counter-clockwise) and its holes (clockwise) to one closed line. A cut
    connects each hole to the nearest corner that is visible from it."""
    for hole in sorted(holes, key=lambda points: -max(points)[0]):
        sides = [(line[i - 1], line[i]) for line in [outer] + list(holes) for i in range(len(line))]
        start = hole.index(max(hole))
        for i in sorted(range(len(outer)), key=lambda i: math.dist(outer[i], hole[start])):
            if not any(crosses(outer[i], hole[start], a, b) for a, b in sides):
                outer = outer[:i + 1] + hole[start:] + hole[:start + 1] + outer[i:]
                break
    return outer


def triangulate(line):
    """Divides a simple polygon, counter-clockwise, into triangles. Cuts off the ear with the best
    shape until three corners are left."""
    line, triangles = list(line), []
    while len(line) > 3:
        best, ear = 0.0, None
        for i in range(len(line)):
            a, b, c = line[i - 1], line[i], line[(i + 1) % len(line)]
            double = area(a, b, c)
            fat = double / max(math.dist(a, b), math.dist(b, c), math.dist(c, a)) ** 2
            if fat > best and not any(
                    area(a, b, p) >= 0 and area(b, c, p) >= 0 and area(c, a, p) >= 0 for p in line
                    if p not in (a, b, c)):
                best, ear = fat, i
        triangles.append((line[ear - 1], line[ear], line[(ear + 1) % len(line)]))
        del line[ear]
    return triangles + [tuple(line)]


def fill(outer, holes, axis):
    """Returns the triangles of a plane face between closed lines in space. axis: direction of the
    outer normal, 1 to 3 for x to z, negative for -x to -z."""
    kept = [a for a in range(3) if a != abs(axis) - 1]
    flips = (axis > 0) == (abs(axis) == 2)  # x and z form a left-handed frame
    place = {(p[kept[0]], p[kept[1]]): p for line in [outer] + holes for p in line}
    flat = [[(p[kept[0]], p[kept[1]]) for p in line] for line in [outer] + holes]
    turned = [line if (total_area(line) > 0) == (n == 0) else line[::-1]
              for n, line in enumerate(flat)]
    triangles = triangulate(with_holes(turned[0], turned[1:]))
    return [tuple(place[p] for p in (t[::-1] if flips else t)) for t in triangles]


def total_area(line):
    return sum(line[i - 1][0] * line[i][1] - line[i - 1][1] * line[i][0] for i in range(len(line)))


def strip(first, second):
    """Returns the triangles between two closed lines with equal numbers of points."""
    triangles = []
    for i in range(len(first)):
        triangles += [(first[i - 1], first[i], second[i]), (first[i - 1], second[i], second[i - 1])]
    return triangles


def faces_along():
    """Returns the triangles of the faces along y, with the ends of holes cut out."""
    rims, triangles = [rim(hole, end) for hole in HOLES for end in (0, 1)], []
    for i, (x, z) in enumerate(OUTLINE):
        x0, z0 = OUTLINE[i - 1]
        corners = [(x0, 0.0, z0), (x, 0.0, z), (x, DEPTH, z), (x0, DEPTH, z0)]
        if x == x0:
            triangles += fill(corners, [r for r in rims if all(p[0] == x for p in r)],
                              1 if z > z0 else -1)
        elif z == z0:
            triangles += fill(corners, [r for r in rims if all(p[2] == z for p in r)],
                              -3 if x > x0 else 3)
        else:
            triangles += [(corners[0], corners[2], corners[1]),
                          (corners[0], corners[3], corners[2])]
    return triangles


def bracket():
    """Returns all triangles, each as three points, counter-clockwise from outside; lengths in
    mm."""
    triangles = faces_along()
    for y, axis in ((0.0, -2), (DEPTH, 2)):
        triangles += fill([(x, y, z) for x, z in OUTLINE], [], axis)
    for hole in HOLES:
        triangles += strip(rim(hole, 1), rim(hole, 0))
    return triangles


def straight(a, b, step):
    count = math.ceil(math.dist(a, b) / step)
    return [tuple(p + (q - p) * i / count for p, q in zip(a, b)) for i in range(count + 1)]


def edges(step):
    """Returns points along the sharp edges, at most a step apart: "rims" of holes and all other
    "edges"."""
    lines = [((x, 0.0, z), (x, DEPTH, z)) for x, z in SHARP]
    lines += [((x0, y, z0), (x, y, z)) for y in (0.0, DEPTH)
              for (x0, z0), (x, z) in zip(OUTLINE, OUTLINE[1:] + OUTLINE[:1])]
    rims = [rim(hole, end) for hole in HOLES for end in (0, 1)]
    return {"rims": [p for r in rims for i in range(len(r))
                     for p in straight(r[i - 1], r[i], step)],
            "edges": [p for a, b in lines for p in straight(a, b, step)]}


def from_fillet(point):
    """Returns the distance of a point from the nearest fillet. Returns None if no fillet is near,
    or the point is near the end of one."""
    x, y, z = point
    for cx, cz, radius in (INNER, OUTER):
        along, up = cx - x, cz - z
        distance = abs(math.hypot(along, up) - radius)
        if min(along, up) > 0.0 and distance < 1.0 and 3.0 < y < DEPTH - 3.0:
            return distance
    return None


def write_stl(path, triangles):
    """Writes a binary STL file with normals of 0; readers use the order of the corners."""
    with open(path, "wb") as file:
        file.write(b"bracket".ljust(80) + struct.pack("<I", len(triangles)))
        for triangle in triangles:
            file.write(struct.pack("<12fH", 0.0, 0.0, 0.0,
                                   *(c for point in triangle for c in point), 0))


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    write_stl(sys.argv[1], bracket())
