"""Runs the script of a figure of Sculptor's report.

usage: pvpython TestReport.py Examples/report/figure_NN.py

It must make the picture and print exactly the rows of Documentation/validation/sculptor-report.md.
"""
import os
import subprocess
import sys
import tempfile

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..")
SCREEN = ["xvfb-run", "-a", "-s", "-screen 0 1280x1024x24 -noreset"]


def main(script):
    with open(os.path.join(ROOT, "Documentation", "validation",
                           "sculptor-report.md"), encoding="utf-8") as file:
        page = set(file.read().splitlines())
    name = os.path.splitext(os.path.basename(script))[0]
    with tempfile.TemporaryDirectory() as out:
        result = subprocess.run([*SCREEN, "pvpython", script, out], stdout=subprocess.PIPE,
                                stderr=subprocess.STDOUT, text=True)
        print(result.stdout)
        assert result.returncode == 0, result.returncode
        assert os.path.getsize(os.path.join(out, name + ".png")) > 10000
        with open(os.path.join(out, name + ".md"), encoding="utf-8") as file:
            rows = file.read().splitlines()[2:]
    assert rows, "the script prints no rows"
    missing = [row for row in rows if row not in page]
    assert not missing, "not in Documentation/validation/sculptor-report.md:\n" + "\n".join(missing)
    assert ("gallery/%s.png" % name) in "\n".join(page), "the page does not show " + name


main(sys.argv[1])
