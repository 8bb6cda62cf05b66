"""Converts ranges of values that are materials to the text of the option Threshold."""

from __future__ import annotations

from numbers import Real
from typing import Any


def write_ranges(threshold: Any) -> str:
    """Returns the text for a number, a pair, a list of pairs, or a text; empty for None."""
    if threshold is None:
        return ""
    if isinstance(threshold, str):
        return threshold
    if isinstance(threshold, Real):
        return _write_range((threshold, None), threshold)
    if isinstance(threshold, tuple) and len(threshold) == 2 and all(map(_is_limit, threshold)):
        return _write_range(threshold, threshold)
    if not isinstance(threshold, (tuple, list)) or not threshold:
        _reject(threshold)
    return ", ".join(_write_range(pair, threshold) for pair in threshold)


def _is_limit(value: Any) -> bool:
    return value is None or (isinstance(value, Real) and not isinstance(value, bool))


def _write_range(pair: Any, whole: Any) -> str:
    if not isinstance(pair, (tuple, list)) or len(pair) != 2 or not all(map(_is_limit, pair)) or (
            pair[0] is None and pair[1] is None):
        _reject(whole)
    low, high = ("" if limit is None else repr(float(limit)).removesuffix(".0") for limit in pair)
    return "%s:%s" % (low, high) if high else low


def _reject(threshold: Any) -> None:
    raise TypeError("threshold is %r: a number, (low, high), a list of such pairs, or a text such "
                    "as '100:200' is required." % (threshold,))
