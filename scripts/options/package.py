"""The signatures and parameters of hexes() and tets() of the Python package, the class Options of its core, and its README's table."""

from options.table import allowed, common, label, of_tets, put, snake, wrap

WIDTH = 100


def in_python(table):
    return [row for row in table if row["python"]]


def value(row, number=None):
    """As Python writes the default."""
    if row["kind"] == "switch":
        return str(bool(row["number"]))
    if row["kind"] == "choice":
        return '"%s"' % snake(row["words"][row["number"]])
    return repr(float(row["number"]) if row["kind"] == "real" else row["number"])


def type_of(row):
    if row["kind"] == "choice":
        return "Literal[%s]" % ", ".join('"%s"' % snake(word) for word in row["words"])
    return {"switch": "bool", "integer": "int", "real": "float"}[row["kind"]]


def explain(row, table):
    """The text of the table; options that it names as panels do by their names here."""
    text = row["text"]
    for other in sorted(in_python(table), key=lambda other: -len(other["name"])):
        if " " in label(other["name"]):
            text = text.replace(label(other["name"]), other["python"])
    return text


def signature(rows):
    return ["    %s: %s = %s," % (row["python"], type_of(row), value(row)) for row in rows]


def handed_on(rows):
    """Keyword arguments of the core's Options."""
    return wrap(" ".join("%s=%s," % (row["python"], row["python"]) for row in rows), "        ", width=WIDTH)


def parameters(rows, table):
    """Of a docstring."""
    lines = []
    for row in rows:
        words = "{%s}" % type_of(row)[8:-1] if row["kind"] == "choice" else type_of(row)
        lines.append("    %s : %s, default %s" % (row["python"], words, value(row)))
        takes = "" if row["kind"] in ("switch", "choice") else row["allowed"][0].upper() + row["allowed"][1:] + ". "
        lines += wrap(takes + explain(row, table), "        ", width=WIDTH)
    return lines


def write_functions(text, table):
    for function, rows in (("hexes", common(table)), ("tets", table)):
        rows = in_python(rows)
        text = put(text, "# options of %s: generated" % function, "# end of options", signature(rows))
        text = put(text, "# arguments of %s: generated" % function, "# end of arguments", handed_on(rows))
        start = text.index("def %s(" % function)
        own = rows if function == "hexes" else in_python(of_tets(table))
        text = text[:start] + put(text[start:], "    ----------------", "    Returns", parameters(own, table) + [""])
    return text


def write_stub(text, table):
    lines = ["    %s: %s" % (row["python"], type_of(row)) for row in in_python(table)]
    return put(text, "# options: generated", "# end of options", lines)


def readme_row(row, table):
    bold = "**%s**" % (value(row) if row["kind"] in ("switch", "choice") else "%g" % row["number"])
    if row["kind"] == "switch":
        words = bold + ", " + str(not row["number"])
    elif row["kind"] == "choice":
        words = ", ".join('"%s"' % snake(word) for word in row["words"]).replace(value(row), bold)
    else:
        words = allowed(row) + ", " + bold
    return "| `%s` | %s | %s%s |" % (row["python"], words, "of `tets`: " if row["tets"] else "", explain(row, table))


def write_readme(text, table):
    rows = [readme_row(row, table) for row in in_python(table)]
    return put(text, "options: generated", "end of options",
               ["", "| option | takes, **default** | |", "|---|---|---|"] + rows + [""])


def files(table):
    return {"python/volume_fraction_mesh/_mesher.py": lambda text: write_functions(text, table),
            "python/volume_fraction_mesh/_core.pyi": lambda text: write_stub(text, table),
            "python/README.md": lambda text: write_readme(text, table)}
