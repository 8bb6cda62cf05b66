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
    "hexes": "f1870fb51e67562837268e09d92dea6ff75bc14cc5832c337c20f00f19666ff5",
    "labels": "2592fed446a54ecf2b881113a8351b0811ac7745bd29d93c534bff8a795086aa",
    "levels": "16f8a12d8126218ed82a02965e297a09bcf9cfa2d62bced5e348e1f8184de929",
    "state": "abd07727b874f98196b5ffd777a66ff7b9097b95ba4ca6094c780fa39374dc22",
    "tets": "93540a4d464554a91d1382e25f2afdce1519ede989ac1d19cc793faec6a63bbe",
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
