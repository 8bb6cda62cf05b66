#!/usr/bin/env pvpython
"""Runs the Python blocks of a document, one after the other as one script, in a folder where they leave their files.

usage: pvpython run_document.py DOCUMENT FOLDER [PLUGIN, default build/lib/VolumeFractionMesh.so]

The blocks find Data there, and PLUGIN under the name that documents give it. Pictures need an X server.
"""
import os
import re
import sys

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
sys.path.insert(0, os.path.join(ROOT, "Examples"))
from need_files import need_files

PLUGIN = "build/lib/VolumeFractionMesh.so"
BLOCK = re.compile(r"^```python\n(.*?)^```$", re.DOTALL | re.MULTILINE)


def read_blocks(document):
    """The code of each block, on the lines that it has in the document, so that errors name these."""
    with open(document, encoding="utf-8") as file:
        text = file.read()
    return ["\n" * text[:block.start(1)].count("\n") + block[1] for block in BLOCK.finditer(text)]


def main(document, folder, plugin=os.path.join(ROOT, PLUGIN)):
    need_files(document, plugin)
    blocks = read_blocks(document)
    if not blocks:
        sys.exit(document + " has no Python")
    plugin = os.path.abspath(plugin)
    os.makedirs(folder, exist_ok=True)
    os.chdir(folder)
    if not os.path.exists("Data"):
        os.symlink(os.path.join(ROOT, "Data"), "Data")
    names = {"__name__": "__main__"}
    for block in blocks:
        exec(compile(block.replace(PLUGIN, plugin), document, "exec"), names)


if __name__ == "__main__":
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__)
    main(*sys.argv[1:])
