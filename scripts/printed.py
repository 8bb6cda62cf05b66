"""Compares printed text with text that a page shows: equal words and shape, numbers within 2 %.

The 2 % are of the range of the numbers. With VFM_ACCEPT=1 (scripts/test --accept), the page takes
the printed text instead.
"""
import os
import re

NUMBER = re.compile(r"(?<![\w.])[-+]?\d[\d,]*(?:\.\d+)?(?:[eE][-+]?\d+)?")
PART = 0.02  # of the range


def agree(a, b):
    """Returns whether two numbers agree. The range of integers is their value, else at least 1."""
    least = 0.0 if re.fullmatch(r"[-+]?[\d,]+", a + b) else 1.0
    one, other = (float(text.rstrip(",").replace(",", "")) for text in (a, b))
    return abs(one - other) <= PART * max(least, abs(one), abs(other))


def is_equal(shown, printed):
    """Returns whether the words of two texts are equal and their numbers agree."""
    words = [" ".join(NUMBER.sub("#", text).split()) for text in (shown, printed)]
    return words[0] == words[1] and all(map(agree, NUMBER.findall(shown), NUMBER.findall(printed)))


def accepts():
    return os.environ.get("VFM_ACCEPT") == "1"


def replace_in(path, shown, printed):
    """Replaces a text that a file has once."""
    with open(path, encoding="utf-8") as file:
        text = file.read()
    if text.count(shown) != 1:
        raise ValueError("%s does not have this text once:\n%s" % (path, shown))
    with open(path, "w", encoding="utf-8") as file:
        file.write(text.replace(shown, printed))
