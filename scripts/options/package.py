"""Generates the options in the Python package: the signatures and docstrings of hexes() and tets(),
and the class Options of the stub of the core."""
import re

from options.table import common, label, of_tets, put, snake, wrap

WIDTH = 100
# Labels of the panels without a generated option in Python, with what replaces them.
NAMES = {"Density Arrays": "`density`", "Energy Array": "`energy`",
         "Rotated Arrays": "`rotated_arrays`", "Volume Fraction To Hex": "`hexes`"}
# Choices that texts of other options refer to.
WORDS = ("Automatic", "Coarsen", "Conserve", "Copy", "Uniform")


def in_python(table):
    return [row for row in table if row["python"]]


def value(row):
    """Returns the default as a Python literal."""
    if row["kind"] == "switch":
        return str(bool(row["number"]))
    if row["kind"] == "choice":
        return '"%s"' % snake(row["words"][row["number"]])
    if row["kind"] in ("pairs", "sizes"):
        return '""' if row["default"] == "None" else '"%s"' % row["default"]
    if row["kind"] == "widths":
        return repr(float(row["default"]))
    return repr(float(row["number"]) if row["kind"] == "real" else row["number"])


def type_of(row):
    if row["kind"] == "choice":
        return "Literal[%s]" % ", ".join('"%s"' % snake(word) for word in row["words"])
    return {"switch": "bool", "integer": "int", "real": "float", "pairs": "str",
            "widths": "Triple", "sizes": "Sizes"}[row["kind"]]


def replace_choices(text, row, table):
    """Writes the choices in a text as Python strings: Refinement Automatic becomes
    ``refinement="automatic"``, and Automatic becomes "automatic"."""
    for other in in_python(table):
        for word in other["words"]:
            text = text.replace("%s %s" % (label(other["name"]), word),
                                '``%s="%s"``' % (other["python"], snake(word)))
    for word in sorted({*row["words"], *WORDS}, key=len, reverse=True):
        # TetGen is also the name of a library; "Automatic (-1)" is a number.
        end = ":" if word == "TetGen" else r"\b(?! \()"
        text = re.sub(r"(?<![\w\"])%s(?=%s)" % (word, end), '"%s"' % snake(word), text)
    return text


def explain(row, table, text):
    """Returns a text of the table of options with the names of options and choices in Python."""
    text = replace_choices(text, row, table)
    if row["kind"] == "switch":
        text = text.replace("Off:", "False:")
    for other in sorted(in_python(table), key=lambda other: -len(other["name"])):
        if label(other["name"]) != other["name"]:
            for name in (label(other["name"]), other["name"]):
                text = re.sub(r"\b%s\b" % name, "`%s`" % other["python"], text)
    for name, replacement in NAMES.items():
        text = text.replace(name, replacement)
    return text


def signature(rows):
    return ["    %s: %s = %s," % (row["python"], type_of(row), value(row)) for row in rows]


def pass_on(rows):
    """Returns the keyword arguments of the core's Options."""
    return wrap(" ".join("%s=%s," % (row["python"], row["python"]) for row in rows), "        ",
                width=WIDTH)


def parameter(row, table, text):
    """Returns the lines of an option in a numpydoc section."""
    words = "{%s}" % type_of(row)[8:-1] if row["kind"] == "choice" else type_of(row)
    words = {"widths": "float or three of them", "sizes": "str or dict"}.get(row["kind"], words)
    allowed = row["allowed"][0].upper() + row["allowed"][1:] + ". "
    allowed = "" if row["kind"] in ("switch", "choice", "widths") else allowed
    return ["    %s : %s, default %s" % (row["python"], words, value(row)),
            *wrap(allowed + explain(row, table, text), "        ", width=WIDTH)]


def parameters_of_hexes(table):
    return [line for row in in_python(common(table))
            for line in parameter(row, table, row["text"])]


def parameters_of_tets(table):
    """Returns the options of tetrahedra, then the options with another text than in hexes(), then
    the names of all others."""
    rows = in_python(common(table))
    lines = [line for row in in_python(of_tets(table))
             for line in parameter(row, table, row["text"])]
    lines += [line for row in rows if row["text_of_tets"]
              for line in parameter(row, table, row["text_of_tets"])]
    names = ", ".join(row["python"] for row in rows if not row["text_of_tets"])
    for line in wrap(names, "    ", width=WIDTH - len(" : see hexes")):
        lines += [line.rstrip(",") + " : see hexes",
                  "        Option of `hexes`, with the same default."]
    return lines


def write_function(text, function, table):
    """Writes the options into the signature, the docstring and the call of a function."""
    rows = in_python(common(table) if function == "hexes" else table)
    text = put(text, "# options of %s: generated" % function, "# end of options", signature(rows))
    text = put(text, "# arguments of %s: generated" % function, "# end of arguments",
               pass_on(rows))
    make = parameters_of_hexes if function == "hexes" else parameters_of_tets
    return put(text, "    ----------------", "    Returns", make(table) + [""])


def write_stub(text, table):
    types = {"Triple": "Union[str, float, Sequence[float]]",
             "Sizes": "Union[str, Mapping[Union[str, int], float]]"}
    lines = ["    %s: %s" % (row["python"], types.get(type_of(row), type_of(row)))
             for row in in_python(table)]
    return put(text, "# options: generated", "# end of options", lines)


def files(table):
    """Returns the functions that update the text of a file, by path."""
    return {"python/volume_fraction_mesh/_hexes.py":
                lambda text: write_function(text, "hexes", table),
            "python/volume_fraction_mesh/_tets.py":
                lambda text: write_function(text, "tets", table),
            "python/volume_fraction_mesh/_core.pyi": lambda text: write_stub(text, table)}
