"""The meshes are the same bits in every build: the sha256 of all values of five, in a line each.

With GCC 12 and glibc 2.36, and with GCC 14 and glibc 2.41, the bits are the same on x86-64; other architectures, compilers and C libraries may differ in the
last ones, and then in more. So do processors without fused multiply-add, for which glibc has another exp: GLIBC_TUNABLES=glibc.cpu.hwcaps=-FMA,-AVX2,-FMA4,-AVX
shows it. A change that is to change meshes changes these lines.

usage: python3 TestDigests.py bin/MeshValues
"""
import hashlib
import os
import platform
import subprocess
import sys
import tempfile

DIGESTS = {
    "hexes": "8939f02e5eb6d89ee005224345d5a93ba0cf0a48c9b73b06bd243b4c8867a390",
    "labels": "af3acf70cddb205893397076b8a341c13236f998125a56416c694070e5aa4d1b",
    "levels": "0a1f46b0593fb42796eef700822cc1f15a4ae57cfffd6576123822e499f81f29",
    "state": "b1f4b79004e91f444f912b8af3f23ddb1cccc34c6e7e795c7ef0278f4062d07d",
    "tets": "3a078e3fbc048c2f89dbafac78330f0d440734b7e045c7ea27f2a2f05fb87686",
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
        print("not compared: this is no x86-64")
        sys.exit(77)
    sys.exit("other bits than those recorded" if found != DIGESTS else 0)


main(sys.argv[1])
