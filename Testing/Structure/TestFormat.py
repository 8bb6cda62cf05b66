"""All sources are formatted by clang-format, version 14 as in Debian 12."""
import os
import re
import shutil
import subprocess
import sys

from structure_rules import CODE, read_tree

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
MAJOR = "14"
SKIPPED = 77


def find_formatter():
    """Returns the name of the program, or None if it is not installed in this version."""
    for name in ("clang-format-" + MAJOR, "clang-format"):
        if shutil.which(name):
            version = subprocess.run([name, "--version"], stdout=subprocess.PIPE, text=True,
                                     check=True).stdout
            if re.search(r"version %s\." % MAJOR, version):
                return name
    return None


def main():
    formatter = find_formatter()
    if not formatter:
        print("skipped: no clang-format %s (package clang-format of Debian 12)" % MAJOR)
        sys.exit(SKIPPED)
    wrong = "int  main( ){}\n"
    tidy = subprocess.run([formatter], cwd=ROOT, input=wrong, stdout=subprocess.PIPE, text=True,
                          check=True).stdout
    assert tidy != wrong, "clang-format formats nothing"
    sources = sorted(path for path in read_tree(ROOT) if path.endswith(CODE))
    sys.exit(subprocess.run([formatter, "--dry-run", "-Werror", *sources], cwd=ROOT).returncode)


main()
