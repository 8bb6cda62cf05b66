"""Meshes are bitwise identical in every build: compares the sha256 of all values of five meshes.

Builds by GCC and clang give identical values on x86-64 and ARM, also on processors without fused
multiply-add: on x86-64 the test runs the program a second time with GLIBC_TUNABLES, which makes
glibc behave as on such a processor. For a change that changes
meshes, scripts/test --accept (VFM_ACCEPT=1) rewrites digests.txt.

usage: python3 TestDigests.py [EMULATOR OPTIONS] bin/MeshValues
"""
import hashlib
import os
import platform
import subprocess
import sys
import tempfile

WITHOUT_FMA = "glibc.cpu.hwcaps=-FMA,-AVX2,-FMA4,-AVX"
DIGESTS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "digests.txt")


def sha256(path):
    with open(path, "rb") as file:
        return hashlib.sha256(file.read()).hexdigest()


def find_digests(command, **variables):
    """Returns the digests of the meshes of a run with more environment variables."""
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([*command, folder], check=True, stdout=subprocess.DEVNULL,
                       env={**os.environ, **variables})
        return {name: sha256(os.path.join(folder, name)) for name in sorted(os.listdir(folder))}


def main(*command):
    found = find_digests(command)
    for name, digest in found.items():
        print("%-6s %s" % (name, digest))
    text = "".join("%s %s\n" % item for item in found.items())
    if os.environ.get("VFM_ACCEPT") == "1":
        with open(DIGESTS, "w", encoding="ascii") as file:
            file.write(text)
    with open(DIGESTS, encoding="ascii") as file:
        recorded = file.read()
    if text != recorded:
        sys.exit("the values differ from the recorded ones")
    if platform.machine() == "x86_64" and len(command) == 1:
        if found != find_digests(command, GLIBC_TUNABLES=WITHOUT_FMA):
            sys.exit("the values depend on the processor's fused multiply-add")


main(*sys.argv[1:])
