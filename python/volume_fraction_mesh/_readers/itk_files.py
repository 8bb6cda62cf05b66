"""Reads NRRD, MetaImage and other images by SimpleITK."""

from __future__ import annotations

import os
import re
from typing import Any

from .named_files import check_inside, list_nrrd_files, read_header
from .report import load_library, quiet

# The reader of each format is selected, because SimpleITK otherwise tries all of them, and some
# print many lines.
READERS = {".nrrd": "NrrdImageIO", ".nhdr": "NrrdImageIO", ".mha": "MetaImageIO",
           ".mhd": "MetaImageIO", ".gipl": "GiplImageIO", ".gipl.gz": "GiplImageIO",
           ".mrc": "MRCImageIO", ".dcm": "GDCMImageIO"}


def read(path: str, is_trusted: bool) -> Any:
    """Returns an image of SimpleITK. is_trusted: the header may name files outside of its
    folder."""
    sitk = load_library("SimpleITK", path)
    ending = next(end for end in READERS if path.lower().endswith(end))
    if ending == ".mhd":
        _check_data_files(path, is_trusted)
    if ending in (".nrrd", ".nhdr") and not is_trusted:
        check_inside(path, list_nrrd_files(read_header(path)))
    reader = sitk.ImageFileReader()
    reader.SetFileName(path)
    reader.SetImageIO(READERS[ending])
    with quiet():
        return reader.Execute()


def _check_data_files(path: str, is_trusted: bool) -> None:
    """Raises ValueError that names a file that is missing or outside of the folder of a header of
    MetaImage."""
    text = read_header(path)
    found = re.search(r"^\s*ElementDataFile\s*=\s*(.*?)\s*$", text, re.MULTILINE | re.IGNORECASE)
    if not found:
        raise ValueError("its header has no ElementDataFile.")
    words = found.group(1).split()
    if not words or words[0].upper() == "LOCAL":
        return
    if words[0].upper() == "LIST":
        names = [line.strip() for line in text[found.end():].splitlines() if line.strip()]
    elif "%" in words[0] and len(words) >= 3 and all(word.isdigit() for word in words[1:]):
        first, last, step = (int(word) for word in (words[1:] + ["1"])[:3])
        names = [words[0] % k for k in range(first, last + 1, max(step, 1))]
    else:
        names = [found.group(1)]
    if not is_trusted:
        check_inside(path, names)
    for name in names:
        place = os.path.join(os.path.dirname(path), name)
        if not os.path.isfile(place):
            raise ValueError("there is no file %s, which its ElementDataFile lists." % place)
