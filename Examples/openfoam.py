"""Runs programs of OpenFOAM, and writes and reads files of its cases."""
import os
import re
import shutil
import subprocess

HEADER = "FoamFile\n{ version 2.0; format ascii; class %s; object %s; }\n"
MPI_RUN = ["mpirun", "--oversubscribe", "-np"]
CHECKS = "checkMesh -constant -allGeometry -allTopology"


def find_settings():
    """Returns the folder with OpenFOAM's settings: of the loaded environment, or of Debian."""
    for folder in (os.environ.get("WM_PROJECT_DIR", ""), "/usr/share/openfoam"):
        if os.path.isfile(os.path.join(folder, "etc", "controlDict")):
            return folder
    return None


def is_installed():
    return bool(find_settings() and shutil.which("checkMesh"))


def run(command, case, ranks=1):
    """Runs a program in a case and returns its output, which must not report an error."""
    environment = dict(os.environ, WM_PROJECT_DIR=find_settings(), OMPI_ALLOW_RUN_AS_ROOT="1",
                       OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
    words = command.split()
    if ranks > 1:
        words = [*MPI_RUN, str(ranks), *words, "-parallel"]
    done = subprocess.run(words, cwd=case, env=environment, text=True, check=False,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    assert done.returncode == 0 and "FATAL" not in done.stdout, done.stdout
    return done.stdout


def write(case, name, text, kind="dictionary"):
    """Writes a dictionary or field."""
    path = os.path.join(case, name)
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w", encoding="ascii") as file:
        file.write(HEADER % (kind, os.path.basename(name)) + text)


def find_problems(report):
    """Returns the checks that fail in a report of checkMesh."""
    return re.findall(r"\*\*\*(.*)", report)
