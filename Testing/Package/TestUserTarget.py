"""The target `user` builds everything that `cmake --install` installs.

usage: TestUserTarget.py BUILD

Reads the installed files from the scripts cmake_install.cmake, and the files that `user` builds
from Ninja. Files that Ninja does not build must exist since CMake has run.
"""

import os
import re
import subprocess
import sys

SKIPPED = 77


def installed_files(build):
    """Returns the paths in the build folder that are installed, without repetition."""
    found, scripts = set(), [os.path.join(build, "cmake_install.cmake")]
    for script in scripts:  # each appends those that it includes
        with open(script, encoding="utf-8") as file:
            text = file.read()
        scripts += re.findall(r'include\("([^"]*cmake_install\.cmake)"\)', text)
        commands = re.findall(r"file\(INSTALL ([^)]*)\)", text)
        paths = (path for command in commands for path in re.findall('"([^"]*)"', command))
        found.update(path for path in paths if path.startswith(build + os.sep))
    return found


def list_outputs(build):
    """Returns the lists of absolute paths that a command of build.ninja makes together."""
    with open(os.path.join(build, "build.ninja"), encoding="utf-8") as file:
        lines = re.findall(r"^build ([^:]*):", file.read(), re.MULTILINE)
    return [{os.path.join(build, path) for path in line.split() if path != "|"} for line in lines]


def list_needed(build, target):
    """Returns the absolute paths that a target of Ninja needs."""
    graph = subprocess.run(["ninja", "-C", build, "-t", "graph", target], check=True, text=True,
                           stdout=subprocess.PIPE).stdout
    return {os.path.join(build, path) for path in re.findall(r'\[label="([^"]*)"', graph)}


def main():
    build = os.path.realpath(sys.argv[1])
    if not os.path.exists(os.path.join(build, "build.ninja")):
        print("SKIPPED: the build is not by Ninja.")
        sys.exit(SKIPPED)
    installed, outputs, needed = installed_files(build), list_outputs(build), list_needed(
        build, "user")
    by_user = {path for paths in outputs if paths & needed for path in paths}
    built = sorted(installed & {path for paths in outputs for path in paths})
    print("%d files of the build folder are installed, %d of them are built" %
          (len(installed), len(built)))
    assert len(built) > 5, "too few installed files were found: %s" % sorted(installed)
    left_out = [path for path in built if path not in by_user]
    assert not left_out, "`user` does not build %s, which is installed" % ", ".join(left_out)
    missing = [path for path in sorted(installed - set(built)) if not os.path.lexists(path)]
    assert not missing, "neither Ninja nor CMake makes %s, which is installed" % ", ".join(missing)


main()
