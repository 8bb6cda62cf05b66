"""Reads a volume from one file per slice."""

from __future__ import annotations

import glob
import os
import re
from collections import Counter
from typing import Any, Callable, List, NamedTuple, Optional, Sequence, Tuple

import numpy as np

from .report import one_message

PATTERN = re.compile(r"[*?\[]")


class Slice(NamedTuple):
    """Values of a slice, shape (rows, columns) or (rows, columns, channels), and widths of its
    voxels along x, y and z; None if the file does not contain them."""

    values: np.ndarray
    widths: Tuple[Optional[float], ...]


def list_slices(path: str, endings: Sequence[str]) -> Optional[List[str]]:
    """Returns the files of a folder or pattern in natural order, None for any other path.

    endings: of files of slices. Other files in a folder are ignored.
    """
    if os.path.isdir(path):
        names = [name for name in os.listdir(path) if not name.startswith(".")]
        files = [os.path.join(path, name) for name in names if name.lower().endswith(endings)]
        place = "The folder"
    elif PATTERN.search(path) and not os.path.exists(path):
        names = [name for name in glob.glob(path) if os.path.isfile(name)]
        files = [name for name in names if name.lower().endswith(tuple(endings))]
        place = "The pattern"
    else:
        return None
    if not files:
        raise ValueError(
            "%s %s %s no slices: files %s.%s%s"
            % (place, path, "contains" if place == "The folder" else "matches",
               ", ".join(endings), " It is not a plotfile of AMReX either: it has no Header."
               if place == "The folder" else "", _describe_others(names)))
    kinds = sorted({os.path.splitext(name)[1].lower().replace(".tiff", ".tif") for name in files})
    if len(kinds) > 1:
        raise ValueError("%s %s has files of several formats, %s: select one format by a pattern, "
                         "such as %r." % (place, path, ", ".join(kinds),
                                          os.path.join(path, "*" + kinds[0])))
    return sorted(files, key=natural_key)


def _describe_others(names: Sequence[str]) -> str:
    """Returns which files there are instead of slices, and what to do with them."""
    counts = Counter(os.path.splitext(name)[1].lower() or "without ending" for name in names)
    if not counts:
        return " It is empty."
    advice = (" Convert DICOM files to one .nii or .nrrd, for instance by 3D Slicer or dcm2niix."
              if {".dcm", ".ima"} & set(counts) else "")
    return " Its files: %s.%s" % (
        ", ".join("%d %s" % (counts[kind], kind) for kind in sorted(counts)), advice)


def natural_key(path: str) -> Any:
    """Returns a key that sorts numbers in names by their value: slice_2 before slice_10."""
    words = re.split(r"([0-9]+)", os.path.basename(path))
    return [int(word) if word.isdigit() else word for word in words], path


def describe_gaps(files: Sequence[str]) -> str:
    """Returns a text if numbers are missing among the names of slices in natural order, or "". The
    usual step of a number is its smallest: 0, 10, 20 lack nothing."""
    names = [os.path.basename(path) for path in files]
    steps = []  # (place of the first number that differs, difference, index of the file)
    for number, (one, other) in enumerate(zip(names, names[1:])):
        first, second = (re.split(r"([0-9]+)", name) for name in (one, other))
        if first[::2] == second[::2]:
            pairs = enumerate(zip(map(int, first[1::2]), map(int, second[1::2])))
            steps += [(place, b - a, number) for place, (a, b) in pairs if a != b][:1]
    usual = {place: min(step for p, step, _ in steps if p == place) for place, _, _ in steps}
    gaps = [(step, usual[place], number) for place, step, number in steps
            if step > usual[place]]
    if not gaps:
        return ""
    missing, first_gap = sum(max((step - 1) // own, 1) for step, own, _ in gaps), gaps[0][2]
    return ("slices may be missing: numbers without a file: %d, the first between %s and %s. The "
            "volume has no gaps: the slices on both sides become neighbours."
            % (missing, *names[first_gap:first_gap + 2]))


def join_slices(files: Sequence[str], read: Callable[[str], Slice]) -> Slice:
    """Returns the volume, shape (slices, rows, columns[, channels]), and the widths of the first
    file. Raises ValueError that names a file whose size or type differs from the first."""
    volume = None
    for number, path in enumerate(files):
        with one_message(path):
            part = read(path)
            if volume is None:
                first = part
                volume = np.empty((len(files), *part.values.shape), part.values.dtype)
            if part.values.shape != first.values.shape or part.values.dtype != volume.dtype:
                raise ValueError(
                    "the slice has %s, and the first slice %s has %s: all slices need one size and "
                    "type." % (_describe(part.values), files[0], _describe(first.values)))
            volume[number] = part.values
    assert volume is not None
    return Slice(volume, first.widths)


def _describe(values: np.ndarray) -> str:
    channels = " in %d channels" % values.shape[2] if values.ndim == 3 else ""
    return "%d x %d points of the type %s%s" % (values.shape[1], values.shape[0], values.dtype,
                                                channels)
