"""Finds the arrays of materials by the rules of the core, which all front ends use."""

from __future__ import annotations

from typing import Dict, List, NamedTuple, Sequence, Tuple

import numpy as np

from . import _core

LABELS_HINT = (
    "Labels are one array of integers from 0, labels=.. (--labels): renumber negative ids. Ranges "
    "of other numbers become materials by threshold=(LOW, HIGH) (--threshold LOW:HIGH). Fractions "
    "are real numbers in [0, 1], bytes that reach 255, or masks of 0 and 1.")
CHOOSE_HINT = "arrays=[..] (--array NAME) selects the arrays that hold the materials."

NamedArrays = Sequence[Tuple[str, np.ndarray]]


class Contents(NamedTuple):
    """What is known about arrays. others: names with another purpose. tolerance: largest distance
    of fractions from [0, 1]. has_labels: bytes are labels. has_threshold: ranges are given."""

    others: Sequence[str]
    tolerance: float
    has_labels: bool
    has_threshold: bool


class Found(NamedTuple):
    """Content of arrays that are given as fractions. labels: name of the array that holds labels
    instead. problem: reason if they are neither."""

    labels: str
    problem: str


def _ask(arrays: NamedArrays, known: Contents) -> _core.MaterialChoice:
    return _core.choose_materials(list(arrays), list(known.others), known.tolerance,
                                  known.has_labels, known.has_threshold)


def has_materials(arrays: Dict[str, np.ndarray]) -> bool:
    """Returns whether some of the arrays can hold materials."""
    return not _ask(list(arrays.items()), Contents((), 1e-6, False, False)).problem


def _is_mask_of_255(array: np.ndarray) -> bool:
    """Returns whether an array holds bytes 0 and 255 only."""
    return array.dtype == np.uint8 and bool(np.all((array == 0) | (array == 255)))


def list_contents(arrays: NamedArrays, known: Contents) -> Found:
    """Returns the content of arrays that are given as fractions."""
    are_real = all(array.dtype.kind == "f" for _, array in arrays)
    if known.has_threshold:
        return Found(arrays[0][0], "") if len(arrays) == 1 else Found(
            "", "threshold applies to one array, and %d are given." % len(arrays))
    if are_real and len(arrays) != 1:
        return Found("", "")
    choice = _ask(arrays, known._replace(others=(), has_threshold=False))
    contents = [content for content, _ in choice.contents]
    if len(arrays) == 1:
        if choice.labels:
            return Found(choice.labels, "")
        return Found("", "" if are_real or contents == ["fraction"] else choice.problem)
    wrong = [(name, reason) for (name, array), (content, reason) in zip(arrays, choice.contents)
             if array.dtype.kind != "f" and content not in ("fraction", "mask")
             and not _is_mask_of_255(array)]
    return Found("", "" if not wrong else "Arrays of integers are neither fractions nor masks: %s."
                 % ", ".join("%r (%s)" % pair for pair in wrong))


def choose(arrays: NamedArrays, known: Contents, one: bool) -> Tuple[List[str], str]:
    """Returns the names of the arrays that hold materials, and a note if others are possible.

    one: only one array is possible. Raises ValueError if no array can hold materials.
    """
    if one and len(arrays) == 1:
        return [arrays[0][0]], ""
    choice = _ask(arrays, known)
    chosen = [choice.labels] if choice.labels else list(choice.fractions)
    if not chosen:
        raise ValueError("%s %s" % (choice.problem,
                                    LABELS_HINT if len(arrays) == 1 else CHOOSE_HINT))
    rest = ["%r (%s)" % (name, reason) for (name, _), (_, reason) in zip(arrays, choice.contents)
            if name not in chosen and name not in known.others]
    note = "" if choice.is_clear or not rest else (
        "The materials are in %s (%s). Not used: %s. %s" % (
            ", ".join(map(repr, chosen)), choice.how, ", ".join(rest), CHOOSE_HINT))
    return chosen, note
