"""Fills the tables of figures in Documentation/validation from Documentation/validation/results.

A page marks a table by "<!-- table: PAGE/NAME -->" and "<!-- end of table -->". PAGE/NAME.csv has a
row per case, whose last three columns are the version, the date and the machine of the measurement.
"""
import csv
import datetime
import glob
import io
import os
import platform
import re

from options.table import ROOT, read

FOLDER = "Documentation/validation"
RESULTS = FOLDER + "/results"
ORIGIN = ("version", "date", "machine")  # the last columns of each file
MARKED = re.compile(r"(<!-- table: ([\w/-]+) -->\n).*?(<!-- end of table -->)", re.DOTALL)


def read_rows(name):
    """Returns the rows of a file of results, the header first."""
    return list(csv.reader(io.StringIO(read("%s/%s.csv" % (RESULTS, name)))))


def write_rows(name, rows):
    path = os.path.join(ROOT, RESULTS, name + ".csv")
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w", encoding="utf-8", newline="") as file:
        csv.writer(file, lineterminator="\n").writerows(rows)


def read_table_of(text):
    """Returns the rows of all tables in a text."""
    rows = [re.split(r"(?<!\\)\|", line.strip()[1:-1]) for line in text.splitlines()
            if line.startswith("|") and line.rstrip().endswith("|")]
    return [[cell.strip().replace("\\|", "|") for cell in row] for row in rows]


def replace_rows(name, text):
    """Replaces the rows of the cases in a printed table of the same columns, or all rows if as many
    are printed; returns how many."""
    header, *rows = read_rows(name)
    count = len(header) - len(ORIGIN)
    printed = read_table_of(text)
    if header[:count] not in printed:
        return 0
    new = [row + find_origin() for row in printed[printed.index(header[:count]) + 1:]
           if len(row) == count and not set("".join(row)) <= set("-: ")]
    if len(new) == len(rows):
        write_rows(name, [header] + new)
        return len(new)
    by_key = {key_of(row[:count]): row for row in new}
    write_rows(name, [header] + [by_key.get(key_of(row[:count]), row) for row in rows])
    return sum(key_of(row[:count]) in by_key for row in rows)


def find_origin():
    """Returns the version, the date and the machine of a measurement made now."""
    version = re.search(r"VERSION (\d+\.\d+)", read("CMakeLists.txt").split("project(")[1])[1]
    model = None
    if os.path.exists("/proc/cpuinfo"):
        with open("/proc/cpuinfo", encoding="utf-8") as file:
            model = re.search(r"^model name\s*: (.*)", file.read(), re.MULTILINE)
    return [version, datetime.date.today().isoformat(),
            "%s, %d cores" % (model[1] if model else platform.machine(), os.cpu_count())]


def replace_all(name, rows):
    """Replaces all rows of a table by rows measured now."""
    write_rows(name, read_rows(name)[:1] + [row + find_origin() for row in rows])


def key_of(row):
    """Returns the name of a case: the first cell, and the second if that is an option's value."""
    return tuple(row[:2]) if row[1:] and re.fullmatch(r"[0-9]", row[1]) else row[0]


def write_pages():
    for path, write in files().items():
        text = read(path)
        with open(os.path.join(ROOT, path), "w", encoding="utf-8") as file:
            file.write(write(text))


def make_table(name):
    """Returns the text of a table, with what its rows were measured with."""
    header, *rows = read_rows(name)
    shown = [row[:-len(ORIGIN)] for row in [header] + rows]
    lines = ["| %s |" % " | ".join(cell.replace("|", "\\|") for cell in row) for row in shown]
    lines.insert(1, "|" + "---|" * len(shown[0]))
    origins = dict.fromkeys(tuple(row[-len(ORIGIN):]) for row in rows)
    lines += ["", "; ".join("Version %s, %s, %s" % origin for origin in origins) + "."]
    return "\n" + "\n".join(lines) + "\n\n"


def fill(text):
    """Returns the text of a page with current tables."""
    return MARKED.sub(lambda mark: mark[1] + make_table(mark[2]) + mark[3], text)


def files():
    """Returns how the pages become current, as functions of their texts."""
    pages = sorted(glob.glob(os.path.join(ROOT, FOLDER, "*.md")))
    return {os.path.relpath(path, ROOT): fill for path in pages}
