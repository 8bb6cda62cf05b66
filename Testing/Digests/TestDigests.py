"""Meshes are bitwise identical in every build: compares the sha256 of all values of five meshes.

Builds by GCC and clang give identical values on x86-64 and ARM, also on processors without fused
multiply-add: on x86-64 the test runs the program a second time with GLIBC_TUNABLES, which makes
glibc behave as on such a processor. A change that changes meshes must update DIGESTS.

usage: python3 TestDigests.py [EMULATOR OPTIONS] bin/MeshValues
"""
import hashlib
import os
import platform
import subprocess
import sys
import tempfile

WITHOUT_FMA = "glibc.cpu.hwcaps=-FMA,-AVX2,-FMA4,-AVX"
DIGESTS = {
    "hexes": "d316d5a2e1f4d3908936965104d6774c95e284832a532ff535a5861e27771acf",
    "labels": "b4a9102150b3e44dd5bc16af7af0e6a53c36c04fabefab62f77430dfc5cf150d",
    "levels": "df242b50df3a54f1fb4b48c545fa4390c9f75eff6e9874097b13cfe94a1cfb91",
    "state": "03aec8cf8e1c0eaccc4f9ddfa13c4a515095a1c9eaa912d3b7b1633ff32e037d",
    "tets": "4969e99ce13858951aee4ed9e711579de80c878fad6ce2725a3fcf218a945f73",
}


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
    if found != DIGESTS:
        sys.exit("the values differ from the recorded ones")
    if platform.machine() == "x86_64" and len(command) == 1:
        if found != find_digests(command, GLIBC_TUNABLES=WITHOUT_FMA):
            sys.exit("the values depend on the processor's fused multiply-add")


main(*sys.argv[1:])
