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
    "hexes": "a1c30d71a4c9a18425855403546e42aa95937778b3452b21154da8e6994a702a",
    "labels": "6cd58f225f88b1523cdfbcf1ce2b07816d34f4d691a776bd845cd3d04f13d650",
    "levels": "0fc80b670de3612d66b80ed184d3a78a89ac0bb9138929fdfb9abf85377f68fc",
    "state": "4a9b20a3659366775835a49170ca97d3b78bdc4c5778ab75611fba51a8136d1a",
    "tets": "fa85dd00c8f127ed291fb5db7d02cc6ba0b4ceb9101a5dbba6df9ee3ae73b487",
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
