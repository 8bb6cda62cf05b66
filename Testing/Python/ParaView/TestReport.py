"""Runs the script of a figure of Sculptor's report.

usage: pvpython TestReport.py Examples/report/figure_NN.py

It must make the picture and print the rows of Documentation/validation/results/sculptor-report,
numbers to 2 % of their range.
"""
import os
import subprocess
import sys
import tempfile

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..")
sys.path.insert(0, os.path.join(ROOT, "scripts"))
import printed
from options import figures

SCREEN = ["xvfb-run", "-a", "-s", "-screen 0 1280x1024x24 -noreset"]


def main(script):
    with open(os.path.join(ROOT, "Documentation", "validation",
                           "sculptor-report.md"), encoding="utf-8") as file:
        page = file.read()
    name = os.path.splitext(os.path.basename(script))[0]
    with tempfile.TemporaryDirectory() as out:
        result = subprocess.run([*SCREEN, "pvpython", script, out], stdout=subprocess.PIPE,
                                stderr=subprocess.STDOUT, text=True)
        print(result.stdout)
        assert result.returncode == 0, result.returncode
        assert os.path.getsize(os.path.join(out, name + ".png")) > 10000
        with open(os.path.join(out, name + ".md"), encoding="utf-8") as file:
            rows = figures.read_table_of(file.read())[2:]
    table = "sculptor-report/figure-%d" % int(name.rsplit("_", 1)[1])
    stored = [row[:-len(figures.ORIGIN)] for row in figures.read_rows(table)[1:]]
    shown, found = ("\n".join(" | ".join(row) for row in rows) for rows in (stored, rows))
    if not printed.is_equal(shown, found):
        assert printed.accepts(), "results/%s.csv has:\n%s" % (table, shown)
        figures.replace_all(table, rows)
    assert ("gallery/%s.png" % name) in page, "the page does not show " + name


main(sys.argv[1])
