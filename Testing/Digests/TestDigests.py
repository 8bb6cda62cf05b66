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
    "labels": "0be9b343ed95ac65a1c77e1e19e89beed3891950dac3ef854f1d2deea5ec5bb3",
    "levels": "fe0771dce2d015f9a9d91be1cbfaf7c1b5ab01801f9816ae256a68ee906e4bb1",
    "state": "469013ad5e57c341ea7acbd53519f97250acad5a7a866ebdf2c10054e2e1de95",
    "tets": "baf8463802a7e04e50a9bf11db7317a01150d436bfe88521b8430b9de0605070",
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
