"""The options of hexes() and tets() that are flags, numbers and words, from the table of the core."""

from __future__ import annotations

from typing import Any, NamedTuple, Tuple

from . import _core

KINDS = ("flag", "whole", "real", "word")


class Option(NamedTuple):
    """kind: one of KINDS; allowed: for messages and help; tets: of tets() alone."""

    name: str
    kind: str
    default: Any
    allowed: str
    words: Tuple[str, ...]
    least: float
    most: float
    group: str
    tets: bool
    text: str


OPTIONS = tuple(
    Option(**{**row, "kind": KINDS[row["kind"]], "words": tuple(row["words"])})  # type: ignore[arg-type]
    for row in _core.describe_options()
)
