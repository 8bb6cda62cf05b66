"""Meshes are bitwise identical in every build: compares the sha256 of all values of five meshes.

GCC 12 with glibc 2.36 and GCC 14 with glibc 2.41 give identical values on x86-64. Other
architectures, compilers and C libraries may round differently, which can change a mesh. Processors
without fused multiply-add also differ, because glibc uses another exp for them:
GLIBC_TUNABLES=glibc.cpu.hwcaps=-FMA,-AVX2,-FMA4,-AVX shows this. A change that changes meshes must
update DIGESTS.

usage: python3 TestDigests.py bin/MeshValues
"""
import hashlib
import os
import platform
import subprocess
import sys
import tempfile

DIGESTS = {
    "hexes": "1c71d1d3bb91bb493031100089b34b3b8d0c8ce461cd1abe4b61654aaad6299c",
    "labels": "af3acf70cddb205893397076b8a341c13236f998125a56416c694070e5aa4d1b",
    "levels": "d0f1ac5141ee4df6610a2d8a1b60ea07189bdc01841b15094f10ce003f230708",
    "state": "94af51237f9145c53ffd3a327f21268c27ab9f267b97511994164fd3fb0ce7e7",
    "tets": "6321e25e1fd88e9915e9fd35941cac4a984fd7fb58ae3ba58f1e18ece5be296f",
}


def sha256(path):
    with open(path, "rb") as file:
        return hashlib.sha256(file.read()).hexdigest()


def main(program):
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([program, folder], check=True, stdout=subprocess.DEVNULL)
        found = {name: sha256(os.path.join(folder, name)) for name in sorted(os.listdir(folder))}
    for name, digest in found.items():
        print("%-6s %s" % (name, digest))
    if platform.machine() != "x86_64":
        print("not compared: this machine is not x86-64")
        sys.exit(77)
    sys.exit("the values differ from the recorded ones" if found != DIGESTS else 0)


main(sys.argv[1])
