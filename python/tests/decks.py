"""Strict readers of input files of solvers, by the columns of their manuals.

Each reader returns a Deck. Anything that the writers should not write is an error.
"""

import re
from types import SimpleNamespace

import numpy as np

# Corners of the faces S1, S2, .. in the manual of Abaqus.
ABAQUS_FACES = {
    8: [(1, 2, 3, 4), (5, 8, 7, 6), (1, 5, 6, 2), (2, 6, 7, 3), (3, 7, 8, 4), (4, 8, 5, 1)],
    4: [(1, 2, 3), (1, 4, 2), (2, 4, 3), (3, 4, 1)],
}
EDGES = [(1, 2), (2, 3), (3, 4), (4, 1)]  # of a quadrilateral; the last one of a triangle is (3, 1)


def new_deck():
    """Returns an empty deck.

    - nodes: {number: coordinates}; elements: {number: corners}; parts: {id: (name, elements)}
    - node_sets: {name: (id, nodes)}; surfaces: {name: (id, [corners of a face])}
    - velocities: {node: vector}; states: {element: numbers}
    - constants: {material: (density, modulus, Poisson's ratio)}; part_sets: {name: (id, parts)}
    """
    return SimpleNamespace(nodes={}, elements={}, parts={}, node_sets={}, surfaces={},
                           velocities={}, states={}, constants={}, part_sets={})


def fields(line, *widths):
    """Returns the texts of fields of these widths, which must fill the line."""
    assert len(line) <= sum(widths), line
    ends = np.cumsum(widths)
    return [line[end - width:end].strip() for end, width in zip(ends, widths) if line[end - width:]]


def numbers(line, width):
    """Returns the integers of fields of equal width."""
    assert len(line) % width == 0, line
    return [int(line[i:i + width]) for i in range(0, len(line), width)]


def add_new(table, key, value):
    assert key not in table, key
    table[key] = value


def sections(path, mark, comment):
    """Returns [keyword, data lines] of a file with keywords that begin with a mark."""
    with open(path, encoding="ascii") as file:
        lines = file.read().split("\n")
    assert lines.pop() == ""
    found = []
    for line in lines:
        if line.startswith(comment):
            continue
        if line.startswith(mark):
            found.append((line, []))
        else:
            found[-1][1].append(line)
    return found


def corners_of(ids):
    """Returns corners without those that repeat the last one."""
    return tuple(ids[:next((i for i in (2, 3) if ids[i] == ids[i - 1]), 4)])


def read_keyword_file(path):
    """Reads a file of LS-DYNA."""
    deck, found = new_deck(), sections(path, "*", "$")
    assert found[0] == ("*KEYWORD", []) and found[-1] == ("*END", [])
    for keyword, lines in found[1:-1]:
        if keyword == "*NODE":
            for line in lines:
                number, *x = fields(line, 8, 16, 16, 16)
                add_new(deck.nodes, int(number), list(map(float, x)))
        elif keyword == "*SECTION_SOLID":
            deck.form = numbers(lines[0], 10)
        elif keyword == "*SECTION_SHELL":
            deck.form = numbers(lines[0], 10)
            assert fields(lines[1], 10, 10, 10, 10) == ["1"] * 4 and len(lines) == 2
        elif keyword == "*PART":
            part, section, material = numbers(lines[1], 10)
            assert len(lines) == 2 and (section, material) == (1, part) and len(lines[0]) <= 70
            add_new(deck.parts, part, (lines[0], []))
        elif keyword == "*ELEMENT_SOLID":
            for line in lines:
                number, part, *corners = numbers(line, 8)
                assert len(corners) == 8
                is_tet = len(set(corners[3:])) == 1
                add_new(deck.elements, number, corners[:4] if is_tet else corners)
                deck.parts[part][1].append(number)
        elif keyword == "*ELEMENT_SHELL":
            for line in lines:
                number, part, *corners = numbers(line, 8)
                assert len(corners) == 4
                add_new(deck.elements, number, list(corners_of(corners)))
                deck.parts[part][1].append(number)
        elif keyword == "*MAT_ELASTIC":
            number, *constants = fields(lines[0], 10, 10, 10, 10)
            add_new(deck.constants, int(number), tuple(map(float, constants)))
        elif keyword == "*SET_PART_LIST_TITLE":
            parts = [n for line in lines[2:] for n in numbers(line, 10)]
            assert all(len(line) <= 80 for line in lines[2:])
            add_new(deck.part_sets, lines[0], (int(lines[1]), parts))
        elif keyword == "*SET_NODE_LIST_TITLE":
            nodes = [n for line in lines[2:] for n in numbers(line, 10)]
            assert all(len(line) <= 80 for line in lines[2:])
            add_new(deck.node_sets, lines[0], (int(lines[1]), nodes))
        elif keyword == "*SET_SEGMENT_TITLE":
            faces = [corners_of(numbers(line, 10)) for line in lines[2:]]
            add_new(deck.surfaces, lines[0], (int(lines[1]), faces))
        elif keyword == "*INITIAL_VELOCITY_NODE":
            for line in lines:
                number, *v = fields(line, 10, 10, 10, 10)
                add_new(deck.velocities, int(number), list(map(float, v)))
        elif keyword == "*INITIAL_STRESS_SHELL":
            for head, first, second in zip(lines[::3], lines[1::3], lines[2::3]):
                number, *rest = numbers(head, 10)
                place, *stresses = fields(first, *[16] * 5)
                assert rest == [1, 1, 0, 0, 1] and float(place) == 0
                add_new(deck.states, number,
                        list(map(float, (*stresses, *fields(second, 16, 16, 16)))))
        else:
            assert keyword == "*INITIAL_STRESS_SOLID", keyword
            for head, first, second in zip(lines[::3], lines[1::3], lines[2::3]):
                number, *rest = numbers(head, 10)
                assert rest == [1, 0, 1]
                add_new(deck.states, number, list(map(float, (*fields(first, *[16] * 5),
                                                              *fields(second, 16, 16)))))
    return deck


def read_radioss(path):
    """Reads a starter file of OpenRadioss."""
    deck, found = new_deck(), sections(path, "/", "#")
    keyword, lines = found[0]
    assert keyword == "/BEGIN" and lines[2] == lines[3] and numbers(lines[1], 10) == [2019, 0]
    assert found[-1] == ("/END", [])
    for keyword, lines in found[1:-1]:
        name, ident = re.fullmatch(r"(/[A-Z0-9_/]+?)(?:/(\d+))?", keyword).groups()
        if name == "/ANALY":
            deck.analysis = fields(lines[0], 10, 20, 10)
        elif name == "/NODE":
            for line in lines:
                number, *x = fields(line, 10, 20, 20, 20)
                add_new(deck.nodes, int(number), list(map(float, x)))
        elif name == "/PROP/SOLID":
            assert ident == "1" and len(lines) == 4
        elif name == "/MAT/ELAST":
            (density,), constants = fields(lines[1], 20), fields(lines[2], 20, 20)
            add_new(deck.constants, int(ident), tuple(map(float, (density, *constants))))
        elif name == "/PART":
            assert numbers(lines[1], 10) == [1, int(ident), 0] and len(lines) == 2
            add_new(deck.parts, int(ident), (lines[0], []))
        elif name in ("/BRICK", "/TETRA4", "/QUAD"):
            for line in lines:
                number, *corners = numbers(line, 10)
                assert len(corners) == (8 if name == "/BRICK" else 4)
                add_new(deck.elements, number, corners)
                deck.parts[int(ident)][1].append(number)
        elif name == "/GRNOD/NODE":
            nodes = [n for line in lines[1:] for n in numbers(line, 10)]
            assert all(len(line) <= 100 for line in lines)
            add_new(deck.node_sets, lines[0], (int(ident), nodes))
        elif name == "/SURF/SEG":
            rows = [numbers(line, 10) for line in lines[1:]]
            assert [row[0] for row in rows] == list(range(1, len(rows) + 1))
            add_new(deck.surfaces, lines[0], (int(ident), [
                tuple(row[1:]) if len(row) == 3 else corners_of(row[1:]) for row in rows]))
        elif name == "/INIVEL/NODE":
            for first, second in zip(lines[1::2], lines[2::2]):
                number, skew, *v = fields(first, 10, 10, 20, 20, 20)
                assert skew == "0" and fields(second, 20, 20, 20, 20) == ["", "0", "0", "0"]
                add_new(deck.velocities, int(number), list(map(float, v)))
        elif name.startswith("/INIQUA/"):
            count = 4 if name == "/INIQUA/STRESS" else 1
            for line in lines:
                number, *values = fields(line, 10, *[20] * count)
                deck.states.setdefault(int(number), {})[name[8:]] = list(map(float, values))
        else:
            assert name == "/INIBRI/STRS_FGLO", keyword
            for i in range(0, len(lines), 5):
                number, *rest = numbers(lines[i], 10)
                assert rest == [1, len(deck.elements[number]), 1, 1, 1, 1]
                texts = [text for line, count in zip(lines[i + 1:i + 5], (2, 3, 3, 1))
                         for text in fields(line, *[20] * count)]
                add_new(deck.states, number, list(map(float, texts)))
    return deck


def real(text):
    """Returns a real number of Nastran, in which an exponent needs no letter."""
    assert "." in text, text
    return float(re.sub(r"(?<=[\d.])([+-]\d+)$", r"e\1", text))


def read_nastran(path):
    """Reads bulk data of Nastran. Faces are their two corners of PLOAD4."""
    deck = new_deck()
    with open(path, encoding="ascii") as file:
        lines = iter(file.read().split("\n"))
    for line in lines:
        head = line[:8].strip()
        if line.startswith("$"):
            words = re.fullmatch(r"\$ (Material|Nodes|Surface) (\d+): (.*)", line)
            if words:
                kind, ident, name = words.group(1), int(words.group(2)), words.group(3)
                table = {"Material": deck.parts, "Nodes": deck.node_sets,
                         "Surface": deck.surfaces}[kind]
                items = []
                add_new(table, *((ident, (name, items)) if kind == "Material"
                                 else (name, (ident, items))))
        elif head == "GRID*":
            _, number, system, x, y = fields(line, 8, 16, 16, 16, 16)
            star, z = fields(next(lines), 8, 16)
            assert star == "*" and system == ""
            add_new(deck.nodes, int(number), [real(x), real(y), real(z)])
        elif head == "PSOLID":
            assert numbers(line[8:], 8) == [ident, ident]
        elif head == "PSHELL":
            own, material, thickness, *rest = fields(line[8:], *[8] * 4)
            assert int(own) == int(material) == ident and real(thickness) == 1
            deck.planes = "strain" if rest == ["-1"] else "stress"
        elif head in ("CQUAD4", "CTRIA3"):
            number, part, *corners = numbers(line[8:], 8)
            assert part == ident and len(corners) == (4 if head == "CQUAD4" else 3)
            add_new(deck.elements, number, corners)
            items.append(number)
        elif head == "MAT1*":
            number, modulus, shear, poisson = fields(line[8:], 16, 16, 16, 16)
            star, density = fields(next(lines), 8, 16)
            assert int(number) == ident and shear == "" and star == "*"
            add_new(deck.constants, ident, (real(density), real(modulus), real(poisson)))
        elif head in ("CHEXA", "CTETRA"):
            number, part, *corners = numbers(line[8:], 8)
            if head == "CHEXA":
                rest = next(lines)
                assert rest[:8].strip() == "+"
                corners += numbers(rest[8:], 8)
            assert part == ident and len(corners) == (8 if head == "CHEXA" else 4)
            add_new(deck.elements, number, corners)
            items.append(number)
        elif head == "SET1" or head == "+":
            items += numbers(line[8:], 8)
            assert len(line) <= 72
        elif head == "PLOAD4":
            load, element, pressure, *blanks, first, second = fields(line[8:], *[8] * 8)
            assert (int(load), real(pressure), blanks) == (ident, 1, [""] * 3)
            items.append((int(element), int(first), int(second)))
        else:
            assert line == "", line
    for ident, nodes in deck.node_sets.values():
        assert nodes.pop(0) == ident
    return deck


def read_abaqus(path):
    """Reads a file of Abaqus. Parts are the sets of elements EB and their id."""
    deck, found = new_deck(), sections(path, "*", "**")
    deck.element_sets, deck.types = {}, set()
    for keyword, lines in found[1:]:
        name, *options = keyword.split(", ")
        options = dict((option + "=").split("=")[:2] for option in options)
        rows = [line.rstrip(",").split(",") for line in lines]
        if name == "*NODE":
            deck.nodes = {int(row[0]): list(map(float, row[1:])) for row in rows}
        elif name == "*ELEMENT":
            part = re.fullmatch(r"EB(\d+)", options["ELSET"]).group(1)
            block = {int(row[0]): list(map(int, row[1:])) for row in rows}
            deck.types.add(options["TYPE"])
            deck.elements.update(block)
            add_new(deck.parts, int(part), (None, list(block)))
        elif name == "*ELSET":
            listed = [int(text) for row in rows for text in row]
            if "GENERATE" in options:
                listed = list(range(listed[0], listed[1] + 1, listed[2]))
            add_new(deck.element_sets, options["ELSET"], listed)
        elif name == "*NSET":
            listed = [int(text) for row in rows for text in row]
            add_new(deck.node_sets, options["NSET"], (None, listed))
        elif name == "*MATERIAL":
            material = options["NAME"]
        elif name == "*ELASTIC":
            (elastic,) = rows
        elif name == "*DENSITY":
            add_new(deck.constants, material, tuple(map(float, (rows[0][0], *elastic))))
        elif name == "*SOLID SECTION":
            part = int(re.fullmatch(r"EB(\d+)", options["ELSET"]).group(1))
            assert options["MATERIAL"] == material and deck.parts[part][1] == deck.element_sets[
                material]
            deck.parts[part] = (material, deck.parts[part][1])
        elif name == "*SURFACE":
            is_flat = deck.types <= {"CPE4", "CPE3", "CPS4", "CPS3"}
            faces = []
            for element, face in rows:
                corners, place = deck.elements[int(element)], int(face[1:]) - 1
                sides = EDGES if is_flat else ABAQUS_FACES[len(corners)]
                faces.append(tuple(corners[(c - 1) % len(corners)] for c in sides[place]))
            add_new(deck.surfaces, options["NAME"], (None, faces))
        else:
            assert keyword == "*INITIAL CONDITIONS, TYPE=VELOCITY", keyword
            for node, axis, value in rows:
                velocity = deck.velocities.setdefault(int(node), [])
                assert int(axis) == len(velocity) + 1
                velocity.append(float(value))
    return deck
