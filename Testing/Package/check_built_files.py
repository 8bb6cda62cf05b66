"""Checks the programs and libraries of a folder for what protects them.

usage: check_built_files.py [--debug] PATH ..

PATH: a build folder or an installed tree, of which all files in the format ELF that the loader
loads are checked, in its folders bin and lib; or one such file.
--debug: not the checks of copies, which builds for debugging and with sanitizers do not have

- RPATH and RUNPATH, the folders in which they search for their libraries: each entry must be an
  absolute path or begin with $ORIGIN, the folder of the file, because an empty or relative entry is
  searched in the working folder. Nobody except its owner may be able to put a file there.
- Addresses of functions are bound at the start (BIND_NOW) and then read-only (GNU_RELRO).
- Programs are position-independent (PIE).
- Buffers on the stack are guarded (-fstack-protector-strong): all but small files call
  __stack_chk_fail, which ends the program.
- Copies and texts are checked (-D_FORTIFY_SOURCE=2): no file calls functions that then always have
  a checked version, such as __printf_chk, and large files call some checked version.
"""

import argparse
import itertools
import os
import re
import stat
import subprocess
import sys

SMALL, LARGE = 50_000, 1_000_000  # bytes of a file
ALWAYS_CHECKED = {"printf", "fprintf", "sprintf", "longjmp"}
PROGRAM, SHARED = 2, 3  # ELF types; programs that are position-independent are shared objects


def elf_type(path):
    """Returns the type in the ELF header of a file, or 0."""
    with open(path, "rb") as file:
        header = file.read(18)
    order = "big" if header[5:6] == b"\2" else "little"
    return int.from_bytes(header[16:18], order) if header[:4] == b"\x7fELF" else 0


def loaded_files(place):
    """Yields the paths of programs and shared libraries in bin and lib, without links, or of the
    file itself."""
    if os.path.isfile(place):
        yield place
    walks = (os.walk(os.path.join(place, part)) for part in ("bin", "lib"))
    for at, _, names in itertools.chain(*walks):
        for path in (os.path.join(at, name) for name in names):
            is_file = os.path.isfile(path) and not os.path.islink(path)
            if is_file and elf_type(path) in (PROGRAM, SHARED):
                yield path


def read_headers(path):
    """Returns the dynamic section and the program headers as text."""
    return subprocess.run(["readelf", "--dynamic", "--program-headers", "--wide", path], check=True,
                          text=True, stdout=subprocess.PIPE,
                          env={**os.environ, "LC_ALL": "C"}).stdout


def called_functions(path):
    """Returns the names of the functions that a file takes from other libraries."""
    text = subprocess.run(["readelf", "--dyn-syms", "--wide", path], check=True, text=True,
                          stdout=subprocess.PIPE, env={**os.environ, "LC_ALL": "C"}).stdout
    return set(re.findall(r"\bUND ([^@\s]+)", text))


def guard_errors(path, is_debug):
    """Returns which guards of the stack and of copies a file lacks."""
    found, called, size = [], called_functions(path), os.path.getsize(path)
    if size > SMALL and "__stack_chk_fail" not in called:
        found.append("%s: buffers on the stack are not guarded (__stack_chk_fail)" % path)
    if is_debug:
        return found
    if called & ALWAYS_CHECKED:
        found.append("%s: not the checked version is called of %s" %
                     (path, ", ".join(sorted(called & ALWAYS_CHECKED))))
    if size > LARGE and not any(re.fullmatch(r"__\w+_chk", name) for name in called):
        found.append("%s: copies are not checked (__..._chk)" % path)
    return found


def hardening_errors(path, headers):
    found = []
    if not re.search(r"\(BIND_NOW\)|\(FLAGS\).*BIND_NOW|\(FLAGS_1\).*\bNOW\b", headers):
        found.append("%s: addresses of functions are not bound at the start (BIND_NOW)" % path)
    if "GNU_RELRO" not in headers:
        found.append("%s: addresses of functions stay writable (GNU_RELRO)" % path)
    if elf_type(path) == PROGRAM:
        found.append("%s: the program is not position-independent (PIE)" % path)
    return found


def is_open_to_others(folder):
    """Returns whether another user can put a file into a folder or create the folder."""
    while not os.path.exists(folder):
        folder = os.path.dirname(folder)
    return bool(os.stat(folder).st_mode & stat.S_IWOTH)


def run_path_errors(path, headers):
    """Returns what is wrong with the RPATH and RUNPATH of a file."""
    found = []
    for value in re.findall(r"\((?:RPATH|RUNPATH)\).*\[(.*)\]", headers):
        for entry in value.split(":"):
            place = re.sub(r"\$(ORIGIN\b|{ORIGIN})", lambda _: os.path.dirname(path), entry)
            if not os.path.isabs(place):
                found.append("%s: the entry '%s' of RUNPATH %s is a relative folder" %
                             (path, entry, value))
            elif is_open_to_others(os.path.normpath(place)):
                found.append("%s: everybody can write into the entry '%s' of RUNPATH %s" %
                             (path, entry, value))
    return found


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--debug", action="store_true")
    parser.add_argument("paths", nargs="+", type=os.path.realpath)
    words = parser.parse_args()
    errors, count = [], 0
    for path in itertools.chain.from_iterable(map(loaded_files, words.paths)):
        count += 1
        headers = read_headers(path)
        errors += run_path_errors(path, headers) + hardening_errors(path, headers)
        errors += guard_errors(path, words.debug)
    print("%d programs and libraries in %s" % (count, ", ".join(words.paths)))
    assert count > 2 or all(map(os.path.isfile, words.paths)), "too few files were found"
    assert not errors, "\n" + "\n".join(errors)


if __name__ == "__main__":
    main()
