"""Generated lists of the formats of mesh files, from the table of formats."""
import re

from options.table import put, wrap

PAGE = "Documentation/reference/files.md"
WRITERS = "Plugin/VolumeFractionWriters.xml"


def suffixes(row, quote=""):
    return ", ".join(quote + suffix + quote for suffix in row["suffixes"])


def bullet(row, indent, quote=""):
    """Returns the lines of a format in a list."""
    first, *others = wrap("%s (%s): %s" % (suffixes(row, quote), row["name"], row["content"]),
                          indent + "  ")
    return [indent + "- " + first[len(indent) + 2:]] + others


def write_page(text, table):
    """Writes the table of formats, with links to the sections about them."""
    lines = ["", "| file | format | content |", "|---|---|---|"]
    for row in table:
        name = row["name"]
        if "\n## %s\n" % name in text:
            name = "[%s](#%s)" % (name, name.lower().replace(" ", "-"))
        lines.append("| %s | %s | %s |" % (suffixes(row, "`").replace(",", ""), name,
                                           row["content"]))
    return put(text, "formats: generated", "end of formats", lines + [""])


def write_header(text, table):
    """Writes the list of formats in the comment of a call in C."""
    lines = [line for row in table for line in bullet(row, "   * ")]
    return put(text, "The suffix selects the format", "@param path", lines)


def write_docstring(text, table):
    """Writes the list of formats in the documentation of Mesh.save."""
    lines = [""]
    for row in table:
        if not row["per_rank"] and row["in_package"]:
            content = row["content"].split("; N ranks")[0]
            lines += bullet({**row, "content": content + ";"}, "        ", "``")
    return put(text, "The package itself writes", "- ``.npz``: ", lines)


def write_writers(text, table):
    """Writes the suffixes of the writers of the plugin: all of the formats of which it has any."""
    def all_suffixes(match):
        given = match.group(2).split()
        found = [suffix[1:] for row in table for suffix in row["suffixes"]
                 if any("." + one in row["suffixes"] for one in given)]
        return match.group(1) + " ".join(found)
    return re.sub(r'(<WriterFactory extensions=")([^"]*)', all_suffixes, text)


def files(table):
    """Returns, for each generated file, a function that updates its text."""
    return {PAGE: lambda text: write_page(text, table),
            "InSitu/Sculptor.h": lambda text: write_header(text, table),
            "python/volume_fraction_mesh/mesh.py": lambda text: write_docstring(text, table),
            WRITERS: lambda text: write_writers(text, table)}
