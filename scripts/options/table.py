"""Reads the tables of options and formats, as printed by describe_options, and converts names for
front ends."""
import json
import os
import re
import subprocess
import textwrap

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")


def read_tables(program):
    """Returns the rows of the tables "options" and "formats". program: describe_options, or a file
    with its output."""
    if program.endswith(".json"):
        with open(program, encoding="utf-8") as file:
            return json.load(file)
    return json.loads(subprocess.run([program], stdout=subprocess.PIPE, check=True).stdout)


def read(path):
    """Returns the text of a file of the tree."""
    with open(os.path.join(ROOT, path), encoding="utf-8") as file:
        return file.read()


def common(table):
    """Returns the rows that apply to hexahedra and tetrahedra."""
    return [row for row in table if not row["tets"]]


def of_tets(table):
    return [row for row in table if row["tets"]]


def of_interfaces(table):
    """Returns the rows of the filter that modifies meshes. FirstLayer is in length units there."""
    return [{**row, "advanced": row["group"].startswith("Perf")} for row in table
            if row["group"] in ("Split interfaces", "Layers") and row["name"] != "FirstLayerUnit"
            or row["name"] == "NumberOfThreads"]


def label(name):
    """Returns a name as panels show it: Iso Value."""
    return re.sub(r"(?<=[a-z])(?=[A-Z])", " ", name)


def allowed(row):
    """Returns the allowed values of an option, without an article."""
    return re.sub("^an? ", "", row["allowed"])


def snake(word):
    """Returns a word as the Python package spells it: quadric_surface."""
    return word.lower().replace(" ", "_")


def wrap(text, indent, width=100):
    """Returns the lines of a paragraph."""
    return textwrap.wrap(text, width, initial_indent=indent, subsequent_indent=indent,
                         break_long_words=False, break_on_hyphens=False)


def put(text, begin, end, lines):
    """Returns the text with new lines between the first line that contains begin and the next line
    that contains end."""
    found = text.split("\n")
    first = next(i for i, line in enumerate(found) if begin in line)
    last = next(i for i, line in enumerate(found) if i > first and end in line)
    return "\n".join(found[:first + 1] + lines + found[last:])
