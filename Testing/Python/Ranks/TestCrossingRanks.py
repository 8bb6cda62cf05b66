"""Meshes whose interfaces cross levels, on several ranks with randomly distributed blocks.

usage: mpiexec -n P pvbatch --sym TestCrossingRanks.py FOLDER

A run on one rank stores its meshes in FOLDER. Runs on
any number of ranks must give bitwise identical meshes.
"""
import os
import sys

import numpy as np

from amr_cases import cut, fields, multiblock, nested
from crossing_cases import CROSSING, ball_with_film
from gold_meshes import RANKS, check_gold, dealt, make_folder
from vfmtest import VolumeFractionToHex, main, producer

FOLDER = os.path.join(sys.argv[1], "crossing")
TWO = {"VolumeFractionArrays": ["ball", "plate"], "FineInterfaces": 0}


def film(n, fin):
    return [{"body": ball_with_film(n, fin)[0], "number": np.arange(n ** 3).reshape(n, n, n)}]


def noise():
    ids = np.random.default_rng(7).choice([0, 2, 3], (8, 8, 8))
    return [{"id": ids.astype(np.int32), "number": np.arange(512).reshape(8, 8, 8)}]


BLOCKS = [(0, box) for box in cut(20, 3)]
CASES = {  # fields, blocks, properties
    "film beside": (film(20, False), BLOCKS, CROSSING),
    "fin": (film(20, True), BLOCKS, {**CROSSING, "MeshVoid": 1}),
    "input levels": (fields(2), nested(), {**TWO, "MeshVoid": 1}),
    "two more levels": (fields(1), nested(1),
                        {**TWO, "Refinement": "Automatic", "MaximumLevel": 2,
                         "CurvaturePerCell": 0.8}),
    "noise": (noise(), [(0, box) for box in cut(8, 2)], {
        "MaterialIdArray": "id", "FineInterfaces": 0, "Refinement": "Automatic", "ThinCells": 0,
        "RefineFlippedCells": 1}),
    "coarsened": (fields(0, 20), BLOCKS, {**TWO, "Refinement": "Coarsen", "MaximumLevel": 2}),
}


def test_same_mesh():
    make_folder(FOLDER)
    for name, (all_fields, blocks, properties) in CASES.items():
        for seed in (0, 1) if RANKS in (2, 3) else (0,):
            data = multiblock(all_fields, dealt(blocks, seed))
            check_gold(VolumeFractionToHex(Input=producer(data), StateArrays=["number"],
                                           **properties), FOLDER, name, seed == 0)


main(globals())
