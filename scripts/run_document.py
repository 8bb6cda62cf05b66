#!/usr/bin/env pvpython
"""Runs the Python blocks of a document in order, as one script, in a folder. An indented text after
a block that prints must match the output, numbers to 2 % (scripts/printed.py).

usage: pvpython run_document.py DOCUMENT FOLDER [LIB]

LIB is the folder of the plugin and the Python classes, by default build/lib. FOLDER receives links
to Data and, as build/lib, to LIB, and the files that the blocks write. Use python3 instead of
pvpython for a document with plain VTK. Pictures need an X server.
"""
import contextlib
import io
import os
import re
import sys

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
sys.path.insert(0, os.path.join(ROOT, "Examples"))
sys.path.insert(0, os.path.join(ROOT, "scripts"))
import printed
from need_files import need_files

LIB = "build/lib"
BLOCK = re.compile(r"^```python\n(.*?)^```\n(?:\n((?: {4}[^\n]*\n)+))?", re.DOTALL | re.MULTILINE)


def read_blocks(document):
    """Yields the code of each block and its expected output. Blank lines before the code give it
    the line numbers of the document in error messages."""
    with open(document, encoding="utf-8") as file:
        text = file.read()
    for block in BLOCK.finditer(text):
        shown = re.sub("^ {4}", "", block[2] or "", flags=re.MULTILINE)
        yield ("\n" * text[:block.start(1)].count("\n") + block[1],
               shown if "print(" in block[1] else "")


def indent(text):
    return re.sub("^", "    ", text, flags=re.MULTILINE).rstrip(" ")


def run_block(code, shown, names, document):
    stream = io.StringIO()
    with contextlib.redirect_stdout(stream):
        exec(code, names)
    output = stream.getvalue()
    print(output, end="")
    if shown and not printed.is_equal(shown, output):
        if not printed.accepts():
            sys.exit("the output differs from the document, which shows:\n" + shown)
        printed.replace_in(document, indent(shown), indent(output))


def main(document, folder, lib=os.path.join(ROOT, LIB)):
    need_files(document, lib)
    document = os.path.abspath(document)
    blocks = list(read_blocks(document))
    if not blocks:
        sys.exit(document + " has no Python block")
    targets = {"Data": os.path.join(ROOT, "Data"), LIB: lib}
    targets = {name: os.path.realpath(target) for name, target in targets.items()}
    os.makedirs(os.path.join(folder, os.path.dirname(LIB)), exist_ok=True)
    os.chdir(folder)
    for name, target in targets.items():
        if os.path.islink(name):
            os.remove(name)
        if not os.path.exists(name):
            os.symlink(target, name)
    names = {"__name__": "__main__"}
    for code, shown in blocks:
        run_block(compile(code, document, "exec"), shown, names, document)


if __name__ == "__main__":
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__)
    main(*sys.argv[1:])
