"""Refined input (AMR) on several ranks, with randomly distributed blocks.

usage: mpiexec -n P pvbatch --sym TestAMRRanks.py FOLDER

A run on one rank stores its meshes in FOLDER. Runs on any number of ranks must give bitwise
identical meshes, and the same message on all ranks for invalid input.
"""
import os
import sys

from amr_cases import N, fields, multiblock, nested
from gold_meshes import RANK, RANKS, check_gold, dealt, make_folder
from vfmtest import VolumeFractionToHex, VolumeFractionToTet, check_error, main, producer, uniform

FOLDER = os.path.join(sys.argv[1], "amr")
FIELDS = fields(2)
CASES = {
    "uniform": uniform(-1), "averaged": {"Refinement": "Off"},
    "one level": {"Refinement": "Input Levels", "MaximumLevel": 1},
    "beyond": {**uniform(3), "StairStep": 1}, "parent": {**uniform(-1), "ChildFractions": "Parent"},
    "coarsen": {"Refinement": "Coarsen"},
    "long cells": {**uniform(-1), "MaximumAspectRatio": 1.5},
    "long cells in tets": {"MaximumAspectRatio": 1.2, "Refinement": "Off", "Method": "Lattice"},
    "tets": {**uniform(-1), "Method": "Lattice"}}


def test_same_mesh():
    make_folder(FOLDER)
    for name, properties in CASES.items():
        for seed in (0, 1) if RANKS > 1 else (0,):
            make = VolumeFractionToTet if "Method" in properties else VolumeFractionToHex
            data = multiblock(FIELDS, dealt(nested(), seed))
            check_gold(make(Input=producer(data), StateArrays=["number"],
                            VolumeFractionArrays=["ball", "plate"], **properties),
                       FOLDER, name, seed == 0)


def test_errors():
    blocks, whole = nested(), ((0, N),) * 3
    deal = lambda blocks: [block for i, block in enumerate(blocks) if i % RANKS == RANK]
    check_error(multiblock(FIELDS, deal(blocks[1:])), "leave a gap", "cell (0, 0, 0) of level 0")
    check_error(multiblock(FIELDS, deal([(0, whole), (1, ((2, 5), (2, 6), (2, 6)))])),
                "Finer blocks cover only a part of cell (1, 1, 2)")
    check_error(multiblock(FIELDS, deal(blocks + blocks[-1:])), "overlap")
    less = [FIELDS[0], {"ball": FIELDS[1]["ball"]}]
    check_error(multiblock(less, deal([(0, whole), (1, ((2, 6),) * 3)])),
                "has no numeric cell array 'plate'")
    bad = [FIELDS[0], {**FIELDS[1], "ball": FIELDS[1]["ball"] + 1.5}]
    check_error(multiblock(bad, deal([(0, whole), (1, ((2, 6),) * 3)])),
                "Volume fraction array 'ball' holds")


main(globals())
