"""Checks where programs and libraries of a folder search for their libraries (RPATH, RUNPATH).

usage: check_built_files.py FOLDER

Each entry must be an absolute path or begin with $ORIGIN, the folder of the file: an empty or relative
entry is searched in the working folder. Nobody except its owner may be able to put a file there.
Checked are all files in the format ELF that the loader loads, except virtual environments of Python.
"""

import os
import re
import stat
import subprocess
import sys

LOADED = (2, 3)  # ELF types: program, shared object


def elf_type(path):
    """Returns the type in the ELF header of a file, or 0."""
    with open(path, "rb") as file:
        header = file.read(18)
    order = "big" if header[5:6] == b"\2" else "little"
    return int.from_bytes(header[16:18], order) if header[:4] == b"\x7fELF" else 0


def loaded_files(folder):
    """Yields the paths of programs and shared libraries below a folder, without links."""
    for at, folders, names in os.walk(folder):
        folders[:] = [] if "pyvenv.cfg" in names else [f for f in folders if f != "CMakeFiles"]
        for path in (os.path.join(at, name) for name in names):
            if not os.path.islink(path) and os.path.isfile(path) and elf_type(path) in LOADED:
                yield path


def dynamic_section(path):
    return subprocess.run(["readelf", "--dynamic", "--wide", path], check=True, text=True,
                          stdout=subprocess.PIPE, env={**os.environ, "LC_ALL": "C"}).stdout


def is_open_to_others(folder):
    """Returns whether another user can put a file into a folder or create the folder."""
    while not os.path.exists(folder):
        folder = os.path.dirname(folder)
    return bool(os.stat(folder).st_mode & stat.S_IWOTH)


def run_path_errors(path, section):
    """Returns what is wrong with the RPATH and RUNPATH of a file."""
    found = []
    for value in re.findall(r"\((?:RPATH|RUNPATH)\).*\[(.*)\]", section):
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
    folder = os.path.realpath(sys.argv[1])
    errors, count = [], 0
    for path in loaded_files(folder):
        count += 1
        errors += run_path_errors(path, dynamic_section(path))
    print("%d programs and libraries in %s" % (count, folder))
    assert count > 2, "too few programs and libraries were found"
    assert not errors, "\n" + "\n".join(errors)


if __name__ == "__main__":
    main()
