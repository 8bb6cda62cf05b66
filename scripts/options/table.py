"""The rows of the table of options, as describe_options prints it, and how front ends name them."""
import json
import os
import re
import subprocess
import textwrap

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")


def read_table(program):
    """The rows. program: describe_options, or a file of what it prints."""
    if program.endswith(".json"):
        with open(program, encoding="utf-8") as file:
            return json.load(file)
    return json.loads(subprocess.run([program], stdout=subprocess.PIPE, check=True).stdout)


def read(path):
    """The text of a file of the tree."""
    with open(os.path.join(ROOT, path), encoding="utf-8") as file:
        return file.read()


def common(table):
    """Rows of both kinds of elements."""
    return [row for row in table if not row["tets"]]


def of_tets(table):
    return [row for row in table if row["tets"]]


def label(name):
    """As panels show it: Iso Value."""
    return re.sub(r"(?<=[a-z])(?=[A-Z])", " ", name)


def allowed(row):
    """What a value may be, without an article."""
    return re.sub("^an? ", "", row["allowed"])


def snake(word):
    """As Python has it: quadric_surface."""
    return word.lower().replace(" ", "_")


def wrap(text, indent, width=100):
    """Lines of a paragraph."""
    return textwrap.wrap(text, width, initial_indent=indent, subsequent_indent=indent, break_long_words=False, break_on_hyphens=False)


def put(text, begin, end, lines):
    """The text with other lines between the one that holds begin and the next that holds end."""
    found = text.split("\n")
    first = next(i for i, line in enumerate(found) if begin in line)
    last = next(i for i, line in enumerate(found) if i > first and end in line)
    return "\n".join(found[:first + 1] + lines + found[last:])
