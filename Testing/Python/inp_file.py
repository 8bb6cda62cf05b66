"""Strict reader of the mesh of an Abaqus input file.

Anything that the writer should not write is an error.
"""
import re

import numpy as np

NAME = re.compile(r"[A-Z][A-Z0-9_]{0,79}\Z")
# Corners of the faces S1, S2, ... as in the manual.
FACES = {"C3D8": [(1, 2, 3, 4), (5, 8, 7, 6), (1, 5, 6, 2), (2, 6, 7, 3), (3, 7, 8, 4),
                  (4, 8, 5, 1)],
         "C3D4": [(1, 2, 3), (1, 4, 2), (2, 4, 3), (3, 4, 1)]}


class InpFile:
    """Contents of an Abaqus input file, with the numbers of the file.

    - heading, comments: lines
    - nodes, velocities: text of coordinates and of components, (n, 3)
    - elements: {number: corners}
    - blocks: {name: numbers} of the sets in which elements are defined
    - element_sets, node_sets: {name: numbers}
    - surfaces: {name: [(element, face)]}, faces from 1
    """

    def __init__(self, path):
        with open(path, encoding="ascii") as file:
            lines = file.read().split("\n")
        assert lines.pop() == "", "the last line has no end"
        self.comments = [line for line in lines if line.startswith("**")]
        self.heading, self.nodes, self.elements, self.type = [], [], {}, None
        self.velocities = []
        self.blocks, self.element_sets, self.node_sets, self.surfaces = {}, {}, {}, {}
        for line in lines:
            assert len(line) <= 256
            if line.startswith("**"):
                continue
            if line.startswith("*"):
                read = self.start(line)
            else:
                read(line)
        self.nodes = np.array(self.nodes)
        assert {*self.blocks, *self.element_sets} & set(
            self.surfaces) == set(), "CalculiX loses loads on surfaces of such names"
        assert not set(self.blocks) & set(self.element_sets)

    def start(self, line):
        """Returns the function that reads the data lines of a keyword."""
        keyword, *options = [part.strip() for part in line.split(",")]
        options = dict((option + "=").split("=")[:2] for option in options)
        if keyword == "*HEADING":
            return self.heading.append
        if keyword == "*NODE":
            self.node_sets[options["NSET"]] = []
            return lambda text: self.read_node(text, self.node_sets[options["NSET"]])
        if keyword == "*ELEMENT":
            assert self.type in (None, options["TYPE"])
            self.type = options["TYPE"]
            numbers = new_set(self.blocks, options["ELSET"])
            return lambda text: self.read_element(text, numbers)
        if keyword == "*INITIAL CONDITIONS":
            assert options == {"TYPE": "VELOCITY"} and not self.velocities
            return self.read_velocity
        if keyword == "*ELSET":
            numbers = new_set(self.element_sets, options["ELSET"])
            read = read_range if "GENERATE" in options else read_numbers
            return lambda text: numbers.extend(read(text))
        if keyword == "*NSET":
            numbers = new_set(self.node_sets, options["NSET"])
            return lambda text: numbers.extend(read_numbers(text))
        assert keyword == "*SURFACE" and options["TYPE"] == "ELEMENT", line
        sides = new_set(self.surfaces, options["NAME"])
        return lambda text: sides.append(read_side(text))

    def read_node(self, text, numbers):
        number, *coordinates = text.split(",")
        self.nodes.append(coordinates)
        numbers.append(int(number))
        assert int(number) == len(self.nodes) and max(map(len, coordinates)) <= 20, text

    def read_velocity(self, text):
        """Reads one component; they are sorted by node, then x, y, z."""
        node, axis, component = text.split(",")
        if axis == "1":
            self.velocities.append([])
        self.velocities[-1].append(component)
        assert (int(node), int(axis)) == (len(self.velocities),
                                          len(self.velocities[-1])) and len(component) <= 20, text

    def read_element(self, text, numbers):
        number, *corners = map(int, text.split(","))
        assert number not in self.elements and len(corners) == int(self.type[-1]), text
        self.elements[number] = corners
        numbers.append(number)

    def side_corners(self, name):
        """Returns the corners of each face of a surface, in ascending order."""
        return [tuple(sorted(self.elements[element][c - 1] for c in FACES[self.type][face - 1]))
                for element, face in self.surfaces[name]]


def new_set(sets, name):
    assert NAME.match(name) and name not in sets, name
    return sets.setdefault(name, [])


def read_numbers(text):
    """Reads up to 15 numbers; a single one must be followed by a comma."""
    numbers = [int(part) for part in text.split(",") if part]
    assert "," in text and 0 < len(numbers) < 16, text
    return numbers


def read_range(text):
    first, last, step = map(int, text.split(","))
    return range(first, last + 1, step)


def read_side(text):
    element, face = text.split(",")
    assert face[0] == "S"
    return int(element), int(face[1:])
