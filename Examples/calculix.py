"""Runs CalculiX (ccx) on a mesh in an .inp file and reads its results, for linear elasticity.

write_deck() writes the input of one static step, which includes the mesh. run() solves it.
read_results() reads displacements, reaction forces and stresses; read_tables() those of several
steps. Examples/ball_under_pressure.py, cube_under_pressure.py and homogenise.py use this module.
"""
import os
import re
import subprocess

import numpy as np

PRINTED = re.compile(r"^ (displacements|total force|stresses) ")  # titles of the tables in .dat
SHORT_EXPONENT = re.compile(r"(\d)([+-]\d{3})\b")  # Fortran writes 1.5E-101 as 1.5-101


def number(value):
    """Returns a number as text of at most 20 characters, the limit of CalculiX."""
    return next(text for text in ("%.*g" % (digits, value) for digits in range(17, 0, -1))
                if len(text) <= 20)


def write_deck(path, mesh, materials, boundary, pressures=(), reactions=()):
    """Writes the input file of a static step.

    Parameters
    ----------
    path : str
        File to write, .inp.
    mesh : str
        File of the mesh, .inp, in the same folder.
    materials : dict
        {element set: (Young's modulus, Poisson's ratio)}.
    boundary : list of tuple
        (node or node set, first direction, last direction, displacement).
    pressures : list of tuple
        (surface, pressure).
    reactions : list of str
        Node sets whose total reaction force is printed.
    """
    lines = ["*INCLUDE, INPUT=" + os.path.basename(mesh)]
    for name, (modulus, ratio) in materials.items():
        lines += ["*MATERIAL, NAME=" + name, "*ELASTIC",
                  "%s, %s" % (number(modulus), number(ratio)),
                  "*SOLID SECTION, ELSET=%s, MATERIAL=%s" % (name, name)]
    lines += ["*STEP", "*STATIC", "*BOUNDARY"]
    lines += ["%s, %d, %d, %s" % (node, first, last, number(value))
              for node, first, last, value in boundary]
    if pressures:
        lines += ["*DSLOAD"] + ["%s, P, %s" % (surface, number(value))
                                for surface, value in pressures]
    lines += ["*NODE PRINT, NSET=NALL", "U", "*EL PRINT, ELSET=EALL", "S"]
    for name in reactions:
        lines += ["*NODE PRINT, NSET=%s, TOTALS=ONLY" % name, "RF"]
    with open(path, "w", encoding="ascii") as file:
        file.write("\n".join(lines + ["*END STEP", ""]))


def run(path, seconds=600, threads=1):
    """Solves the input file at path (.inp). Result files are written into its folder.

    Raises RuntimeError with the output of ccx if it fails."""
    folder, name = os.path.split(os.path.splitext(path)[0])
    result = subprocess.run(["ccx", "-i", name], cwd=folder or ".",
                            env={**os.environ, "OMP_NUM_THREADS": str(threads)},
                            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                            timeout=seconds)
    if result.returncode != 0 or "*ERROR" in result.stdout or "Job finished" not in result.stdout:
        raise RuntimeError("ccx ends with %d: %s" % (result.returncode, result.stdout[-2000:]))
    return result.stdout


class Results:
    """Results of a static step, as printed by CalculiX with seven digits.

    displacements: (nodes, 3). stresses: (elements, integration points, 6), xx yy zz xy xz yz. Both
    are in the order of the node and element numbers. reactions: {node set: total force}."""

    def __init__(self, tables):
        self.reactions = {name: rows[0] for title, name, rows in tables if title == "total force"}
        for title, _, rows in tables:
            if title == "displacements":
                self.displacements = rows[np.argsort(rows[:, 0]), 1:]
            elif title == "stresses":
                rows = rows[np.lexsort((rows[:, 1], rows[:, 0]))]
                self.stresses = rows[:, 2:].reshape(len(np.unique(rows[:, 0])), -1, 6)


def read_tables(path):
    """Returns the title, set and rows of each table that the input file at path (.inp) printed."""
    tables = []
    with open(os.path.splitext(path)[0] + ".dat", encoding="ascii") as file:
        for line in file:
            title = PRINTED.match(line)
            if title:
                rows = []
                tables.append((title.group(1), line.split(" set ")[1].split()[0], rows))
            elif line.strip() and tables:
                rows.append(SHORT_EXPONENT.sub(r"\1E\2", line).split())
    return [(title, name, np.array(rows, dtype=float)) for title, name, rows in tables]


def read_results(path):
    """Returns the Results of the input file at path (.inp)."""
    return Results(read_tables(path))
