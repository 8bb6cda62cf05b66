#!/usr/bin/env python3
"""Generated files are current, and a new row of the table of options appears in all of them.

usage: TestGenerated.py DESCRIBE_OPTIONS
"""
import json
import os
import subprocess
import sys
import tempfile
import unittest

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
GENERATE = [sys.executable, os.path.join(ROOT, "scripts", "generate"), "--table"]
TABLE = sys.argv.pop(1)
# Files in which the new row must appear, and the text.
# SetOptions.AnAddedRowIsAnOption tests the C interface and the help.
PLACES = {"Plugin/VolumeFractionSurface.xml": 'command="SetNewOption"',
          "Filters/vtkVolumeFractionMeshAlgorithm.h": "vfmNumberOption(NewOption, double);",
          "python/volume_fraction_mesh/_hexes.py": "    new_option: float = 0.5,",
          "python/volume_fraction_mesh/_tets.py": "    new_option: float = 0.5,",
          "python/volume_fraction_mesh/_core.pyi": "    new_option: float\n",
          "Documentation/user/command-line.md":
              "| `--new V` | [NewOption](../reference/options.md#newoption) "
              "| number above 0 and below 1 | 0.5 | What is new. |",
          "Documentation/reference/options.md":
              "| NewOption *advanced* | `new_option` | `--new V` | `NewOption` "
              "| number above 0 and below 1 | 0.5 |"}


class Generated(unittest.TestCase):
    def test_files_are_current(self):
        made = subprocess.run([*GENERATE, TABLE, "--check"], stderr=subprocess.PIPE,
                              universal_newlines=True)
        self.assertEqual(made.stderr, "")

    def test_an_added_row_is_everywhere(self):
        tables = json.loads(subprocess.run([TABLE], stdout=subprocess.PIPE, check=True).stdout)
        rows = tables["options"]
        row = next(row for row in rows if row["name"] == "IsoValue")
        rows.append({**row, "name": "NewOption", "python": "new_option", "argument": "--new V",
                     "text": "What is new.", "group": "Surface"})
        with tempfile.TemporaryDirectory() as folder:
            table = os.path.join(folder, "table.json")
            with open(table, "w", encoding="utf-8") as file:
                json.dump(tables, file)
            subprocess.run([*GENERATE, table, "--into", folder], check=True)
            for path, text in PLACES.items():
                with open(os.path.join(folder, path), encoding="utf-8") as file:
                    self.assertIn(text, file.read(), path)


if __name__ == "__main__":
    unittest.main()
