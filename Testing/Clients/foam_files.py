"""Reads and writes files of OpenFOAM, and runs its programs."""

import os
import re
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Examples"))
from openfoam import CHECKS, MPI_RUN, find_problems, is_installed, run, write

MESH = "polyMesh"


def set_entry(case, name, key, value):
    """Replaces the value of an entry in a dictionary."""
    path = os.path.join(case, name)
    with open(path) as file:
        text = file.read()
    text, count = re.subn(r"\b%s\s[^;]*;" % key, "%s %s;" % (key, value), text)
    assert count == 1, (name, key)
    with open(path, "w") as file:
        file.write(text)


def word(name):
    """Returns the name of a zone of a material without special characters."""
    return name.replace(" ", "_")


def read_field(path):
    """Reads the values in the cells of a field of scalars, as text."""
    with open(path) as file:
        text = file.read()
    values = re.search(r"internalField\s+nonuniform[^(]*\(([^)]*)\)", text).group(1)
    return np.array(values.split(), float)


def read_numbers(path, columns=1):
    """Reads the first list of a file of labels, scalars or vectors, as text or binary."""
    with open(path, "rb") as file:
        data = file.read()
    kind = re.search(rb"class\s+(\w+);", data).group(1)
    is_label = kind in (b"labelList", b"faceList")
    match = re.compile(rb"\n(\d+)\s*(?:\n|$)").search(data, data.index(b"}\n"))
    count = int(match.group(1))
    if b"binary" in data[:200] and count:
        begin = data.index(b"(", match.end()) + 1
        numbers = np.frombuffer(data, "<i4" if is_label else "<f8", count * columns, begin)
    else:
        text = data[match.end():].replace(b"(", b" ").replace(b")", b" ").split()
        numbers = np.array(text[:count * columns], int if is_label else float)
    return numbers.reshape(-1, columns) if columns > 1 else numbers


def read_faces(path):
    """Reads faces, as text or binary: shape (faces, corners), or a list if faces have different
    numbers of corners."""
    with open(path, "rb") as file:
        data = file.read()
    if b"faceCompactList" not in data:
        body = data[data.index(b"}\n"):]
        count = int(re.search(rb"\n(\d+)\n", body).group(1))
        lines = re.findall(rb"\d+\(([\d ]+)\)", body)
        assert len(lines) == count
        faces = [line.split() for line in lines]
        if len(set(map(len, faces))) > 1:
            return [np.array(face, int) for face in faces]
        return np.array(faces, int)
    begin, lists = data.index(b"}\n"), []
    for _ in range(2):
        match = re.compile(rb"\n(\d+)\n").search(data, begin)
        count = int(match.group(1))
        lists.append(np.frombuffer(data, "<i4", count, match.end() + 1) if count else
                     np.zeros(0, "<i4"))
        begin = match.end() + (4 * count + 1 if count else -1)
    offsets, corners = lists
    if len(set(np.diff(offsets))) > 1:
        return np.split(corners, offsets[1:-1])
    return corners.reshape(len(offsets) - 1, -1)


def read_boundary(path):
    """Reads the patches: a dict of dicts of words."""
    with open(path) as file:
        text = file.read()
    patches = {}
    for name, body in re.findall(r"\n\s+(\S+)\s*\{([^}]*)\}", text[text.index("("):]):
        patches[name] = dict(re.findall(r"(\w+)\s+([^;]*);", body))
    return patches


class PolyMesh:
    """Points, faces, owners, neighbours and patches of a case or of a processor's folder."""

    def __init__(self, case):
        folder = os.path.join(case, "constant", MESH)
        self.points = read_numbers(os.path.join(folder, "points"), 3)
        self.faces = read_faces(os.path.join(folder, "faces"))
        self.owner = read_numbers(os.path.join(folder, "owner"))
        self.neighbour = read_numbers(os.path.join(folder, "neighbour"))
        self.patches = read_boundary(os.path.join(folder, "boundary"))
        self.addressing = {}
        for name in ("point", "face", "cell", "boundary"):
            path = os.path.join(folder, name + "ProcAddressing")
            if os.path.exists(path):
                self.addressing[name] = read_numbers(path)
