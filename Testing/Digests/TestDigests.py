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
    "hexes": "921678314ae09af66911aa98d66224c49ce9884cd099881d4f0331aa08bd5d71",
    "labels": "4689603fd4089e06c635bd249a638d71102ec3f034d3c859c2d721fd2610d233",
    "levels": "e4dc618ae10176b0ada05230f0284113eab97261cb17856cabe8ac95bce08ea3",
    "state": "28562183fcbb1cdb3fa95bf939fc7579daab8beed567887d012ab85cfba24dd8",
    "tets": "79a99307e27802df7f32e335a90397410c9eaef97c402308ef963bee6f44abc6",
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
