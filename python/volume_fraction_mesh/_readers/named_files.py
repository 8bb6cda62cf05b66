"""Checks the files that a header names."""

from __future__ import annotations

import os
import re
from typing import List

TRUST = "If you trust the file, give trust_input=True (--trust-input)."
LARGEST_HEADER = 1 << 20  # bytes


def check_inside(header: str, names: List[str]) -> None:
    """Raises ValueError if a file is outside of the folder of the header, links followed."""
    top = os.path.realpath(os.path.dirname(header) or ".")
    for name in names:
        place = os.path.realpath(os.path.join(top, name))
        if os.path.commonpath([top, place]) != top:
            raise ValueError("it names the file %r, which is outside of its folder. Move the file "
                             "into the folder. %s" % (name, TRUST))


def read_header(path: str) -> str:
    """Returns the first part of a file as text."""
    with open(path, "rb") as file:
        return file.read(LARGEST_HEADER).decode("utf-8", "replace")


def list_nrrd_files(text: str) -> List[str]:
    """Returns the files that the header of an NRRD file names; a pattern stands for its files."""
    head, _, _ = text.replace("\r", "").partition("\n\n")
    found = re.search(r"^data ?file: *(.*?) *$((?:\n.*)*)", head, re.MULTILINE | re.IGNORECASE)
    if not found:
        return []
    if found.group(1).upper().startswith("LIST"):
        return [line.strip() for line in found.group(2).splitlines() if line.strip()]
    words = found.group(1).split()
    return [words[0]] if words and "%" in words[0] else [found.group(1)]
