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
    "hexes": "3421ddd337d95ca5ae4a8997f52503f4fc4726f3a3c1be35042422c52a7ed88f",
    "labels": "4c562acf1658f41ef1bc544d76e800aa889d2028ade4c8cd282a48813a77e20b",
    "levels": "9149689c4a718eee03f7cf028029e6ef478f44c7d101e67bd17d780d67ec9584",
    "state": "9a0e9bd9401a20bb49dbefbbd9da38e102f7e2f292824098c1c224ebfdc1b733",
    "tets": "78a304c595841f5e1c33ac20fa9c5ac73fc3e17d37d336bba98c5c108bde5cd8",
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
