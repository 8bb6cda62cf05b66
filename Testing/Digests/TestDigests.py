"""Meshes are bitwise identical in every build: compares the sha256 of all values of five meshes.

Builds by GCC and clang give identical values on x86-64, also on processors without fused
multiply-add: the test runs the program a second time with GLIBC_TUNABLES, which makes glibc behave
as on such a processor. A change that changes meshes must update DIGESTS.

usage: python3 TestDigests.py bin/MeshValues
"""
import hashlib
import os
import platform
import subprocess
import sys
import tempfile

WITHOUT_FMA = "glibc.cpu.hwcaps=-FMA,-AVX2,-FMA4,-AVX"
DIGESTS = {
    "hexes": "59d4777807c1a1934378dd2a9967497a0243fc9f1bac114748a8a3d593853a0a",
    "labels": "4c79bea19aabbbc1dd3d751fbd814340c39ab42628ae8ed3eef13a5c399c7b1e",
    "levels": "6c9f784f05bd625d7c27dd7c8c539e98c623bc5b1995aa6f86fdb5f47b74b956",
    "state": "94c82f2d4ce2db74a22f61f8a2e897039a34a2b0d73f68ffa6c2ed310868ee9c",
    "tets": "ff148fcc35780074fff7dc4d5f1a5f106834c3cb49fa1278c462f6286d6a2a12",
}


def sha256(path):
    with open(path, "rb") as file:
        return hashlib.sha256(file.read()).hexdigest()


def find_digests(program, **variables):
    """Returns the digests of the meshes of a run with more environment variables."""
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([program, folder], check=True, stdout=subprocess.DEVNULL,
                       env={**os.environ, **variables})
        return {name: sha256(os.path.join(folder, name)) for name in sorted(os.listdir(folder))}


def main(program):
    found = find_digests(program)
    for name, digest in found.items():
        print("%-6s %s" % (name, digest))
    if platform.machine() != "x86_64":
        print("not compared: this machine is not x86-64")
        sys.exit(77)
    if found != DIGESTS:
        sys.exit("the values differ from the recorded ones")
    if found != find_digests(program, GLIBC_TUNABLES=WITHOUT_FMA):
        sys.exit("the values depend on the processor's fused multiply-add")


main(sys.argv[1])
