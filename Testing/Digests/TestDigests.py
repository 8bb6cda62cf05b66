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
    "hexes": "bf96eecad3efcf6728e97f80788966b03fbc9064a02eb0da29f981fa0a7e638d",
    "labels": "33398d9d917fbbc7dfa6243b4dd4baf0aad81e312bd7cf66d97d59783d4c033e",
    "levels": "0113a5a374e2ad20a5771305b635c066c133fa5f97215967d14e28946bdfe8d9",
    "state": "cc43e2584e6689cbbca221663d4e43d4b30a441d034823ef94d8c4ed55b39d44",
    "tets": "8524198071cd2788c3bb3a3863324fea000daaa83f5ec4147be87d0c5b4d7f47",
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
