"""Files that a user's script writes on several ranks.

usage: mpiexec -n P pvbatch TestRankOutputs.py FOLDER

FOLDER is the folder of TestRanks.py. Without --sym only
rank 0 runs this script; ParaView drives the other ranks.
"""
import csv
import os
import sys

import numpy as np
from paraview import simple
from vtkmodules.vtkIOLegacy import vtkDataSetReader
from vtkmodules.vtkParallelCore import vtkMultiProcessController

from compare_meshes import merge, read_pieces
from inp_file import InpFile
from vfmtest import ghost_cells, main, save_data, VolumeFractionToHex

FOLDER = sys.argv[1]
RANKS = vtkMultiProcessController.GetGlobalController().GetNumberOfProcesses()
READER = simple.XMLImageDataReader(FileName=[os.path.join(FOLDER, "ball_and_plate.vti")])
HEXES = VolumeFractionToHex(Input=READER, VolumeFractionArrays=["ball", "plate"])
RUNS = []
HEXES.GetClientSideObject().AddObserver("StartEvent", lambda *_: RUNS.append(1))


def save(name, proxy):
    path = os.path.join(FOLDER, name)
    save_data(path, proxy)
    return path


def test_pieces():
    pieces = read_pieces(save("outputs.pvtu", HEXES))
    assert len(pieces) == RANKS and sum(piece.GetNumberOfCells() > 0 for piece in pieces) > 1
    mesh = merge(pieces)
    information = HEXES.GetDataInformation()
    assert len(mesh["cells"]) == information.GetNumberOfCells() == sum(
        piece.GetNumberOfCells() for piece in pieces)
    # Points between ranks are in both pieces.
    assert len(mesh["points"]) < information.GetNumberOfPoints()
    assert not any(piece.GetCellData().HasArray("vtkGhostType") for piece in pieces)


def test_geometry():
    """Each facet, edge and vertex is in one piece; all pieces hold the same tables of geometry."""
    for port, name, least in ((1, "surfaces", 100), (2, "curves", 20), (3, "vertices", 4)):
        whole = merge(read_pieces(save(name + ".pvtp", simple.OutputPort(HEXES, port))))
        assert len(whole["cells"]) == simple.OutputPort(
            HEXES, port).GetDataInformation().GetNumberOfCells() >= least
        assert len(np.unique(whole["cells"], axis=0)) == len(whole["cells"]), name


def test_materials():
    """Only rank 0 has rows; otherwise the spreadsheet would repeat them."""
    table = simple.OutputPort(HEXES, "Materials")
    assert table.GetDataInformation().GetNumberOfRows() == 2
    with open(save("materials.csv", table), newline="") as file:
        rows = list(csv.DictReader(file))
    assert [(row["Name"], row["MaterialId"])
            for row in rows] == [("ball", "1"), ("plate", "2")], rows
    assert sum(int(row["Elements"])
               for row in rows) == HEXES.GetDataInformation().GetNumberOfCells()


def test_one_file():
    mesh = merge(read_pieces(os.path.join(FOLDER, "outputs.pvtu")))
    reader = vtkDataSetReader()
    reader.SetFileName(save("outputs.vtk", HEXES))
    reader.Update()
    assert reader.GetOutput().GetNumberOfCells() == len(mesh["cells"])
    gathered = simple.AggregateDataset(Input=HEXES, NumberOfTargetProcesses=1)
    pieces = read_pieces(save("gathered.pvtu", gathered))
    assert len(pieces) == 1 and pieces[0].GetNumberOfPoints() == len(mesh["points"])
    assert (merge(pieces)["cells"] == mesh["cells"]).all()


def test_abaqus():
    path = os.path.join(FOLDER, "outputs.inp")
    simple.SaveData(path, proxy=HEXES)
    file, mesh = InpFile(path), merge(read_pieces(os.path.join(FOLDER, "outputs.pvtu")))
    assert len(file.nodes) == len(mesh["points"]) and len(file.elements) == len(mesh["cells"])


def test_ghost_cells_made_downstream():
    ghosts = ghost_cells(HEXES)
    ghosts.UpdatePipeline()
    assert (ghosts.GetDataInformation().GetNumberOfCells()
            > HEXES.GetDataInformation().GetNumberOfCells())


def test_the_filter_ran_once():
    assert len(RUNS) == 1, len(RUNS)


main(globals())
