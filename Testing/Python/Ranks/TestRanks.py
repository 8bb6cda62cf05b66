"""The same mesh on any number of ranks, however the input is split.

usage: mpiexec -n P pvbatch --sym TestRanks.py FOLDER

A run on one rank meshes each case from one whole image and stores the result in FOLDER. All other
runs must give bitwise identical meshes. With TetGen only the surfaces are compared.
"""
import os
import pickle
import sys
import traceback

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkMultiBlockDataSet
from vtkmodules.vtkIOExodus import vtkExodusIIReader
from vtkmodules.vtkIOXML import vtkXMLImageDataReader, vtkXMLImageDataWriter
from vtkmodules.vtkParallelCore import vtkCommunicator, vtkMultiProcessController
from vtkmodules.util.numpy_support import vtk_to_numpy

from compare_meshes import difference, joined, merge, piece_of, read_pieces
from vfmtest import (
    GHOST, ORIGIN, SPACING, TET_METHODS, at_points, ball_and_plate, collect, image, main, producer,
    reduced, save_data, surface_faces,
    table_of, tet_volumes, uniform, VolumeFractionToHex, VolumeFractionToTet, simple)


CONTROLLER = vtkMultiProcessController.GetGlobalController()
RANK, RANKS = CONTROLLER.GetLocalProcessId(), CONTROLLER.GetNumberOfProcesses()
FOLDER = sys.argv[1]
SPLASH = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..", "Data",
                      "splash_3500us.vti")


def sphere(n=16):
    s = 4
    z, y, x = np.meshgrid(*[(np.arange(n * s) + 0.5) / s] * 3, indexing="ij")
    inside = (x - 0.5 * n) ** 2 + (y - 0.45 * n) ** 2 + (z - 0.55 * n) ** 2 < (0.36 * n) ** 2
    return {"ball": inside.reshape(n, s, n, s, n, s).mean(axis=(1, 3, 5))}


def grains(n=14, count=9):
    """Returns a polycrystal: fractions of the cells nearest to each of `count` random points."""
    s = 3
    centres = np.random.default_rng(5).random((count, 3)) * n
    z, y, x = np.meshgrid(*[(np.arange(n * s) + 0.5) / s] * 3, indexing="ij")
    nearest = np.argmin([(x - c[0]) ** 2 + (y - c[1]) ** 2 + (z - c[2]) ** 2 for c in centres],
                        axis=0)
    return {"grain%d" % g: (nearest == g).reshape(n, s, n, s, n, s).mean(axis=(1, 3, 5))
            for g in range(count)}


def noise(n=9):
    return {"id": np.random.default_rng(7).choice([0, 2, 3, 5, 11],
                                                  (n + 2, n, n + 1)).astype(np.int32)}


def splash():
    """Returns a part of a real flow field with drops and a crown."""
    reader = vtkXMLImageDataReader()
    reader.SetFileName(SPLASH)
    reader.Update()
    water = vtk_to_numpy(reader.GetOutput().GetCellData().GetArray("water")).reshape(56, 64, 64)
    return {"water": water[4:26, 20:44, 22:44].copy()}


def with_state(arrays):
    """Adds random state arrays."""
    size, random = next(iter(arrays.values())).shape, np.random.default_rng(9)
    return {**arrays, "velocity": random.normal(size=(*size, 3)).astype(np.float32),
            "number": random.integers(2 ** 60, size=size)}


STATE = ["velocity", "number"]  # state arrays
CASES = {
    "sphere": sphere(), "ball_and_plate": dict(zip(("ball", "plate"), ball_and_plate(16))),
    "grains": grains(), "noise": noise(), "splash": splash()}
CASES = {case: with_state(arrays) for case, arrays in CASES.items()}
# Fractions and labels. Tests with several threads check the meshes themselves.
SPLIT_CASES = ["ball_and_plate", "noise"][:1 if RANKS > 3 else 2]
MIRROR = [[0.6, 0.8, 0], [0.8, -0.6, 0], [0, 0, 1]]  # a direction matrix
TINY = "fewer cells than ranks"
TET_CASES = [("ball_and_plate", "Cells", "scattered"), ("sphere", "Lattice", "slabs")]
CLEARED = [("noise", {"MinimumRegionCells": 8, "LabelSmoothing": 7}),
           ("splash", {"MinimumRegionCells": 20})]
ALL_CASES = {**CASES, TINY: {"id": np.array([[[1, 2, 0]]], np.int32)}}


def part(arrays, box, ghosts=0):
    """Returns the image of a box ((z0, z1), (y0, y1), (x0, x1)).

    Ghost layers are marked and hold invalid values.
    """
    size = next(iter(arrays.values())).shape
    wide = [(max(lower - ghosts, 0), min(upper + ghosts, size[a]))
            for a, (lower, upper) in enumerate(box)]
    window = tuple(slice(*span) for span in wide)
    values = {name: array[window].copy() for name, array in arrays.items()}
    if ghosts:
        inside = np.zeros(size, bool)
        inside[tuple(slice(*span) for span in box)] = True
        for array in values.values():
            array[~inside[window]] = 77
        values["vtkGhostType"] = np.where(inside[window], 0, GHOST).astype(np.uint8)
    data = image(values)
    data.SetOrigin([ORIGIN[a] + wide[2 - a][0] * SPACING[a] for a in range(3)])
    return data


def cut(size, counts):
    """Returns the boxes of a grid cut into `counts` parts along z, y, x."""
    spans = [[(n * i // c, n * (i + 1) // c) for i in range(c)] for n, c in zip(size, counts)]
    return [(z, y, x) for z in spans[0] for y in spans[1] for x in spans[2]]


def full(boxes):
    return [box for box in boxes if all(lower < upper for lower, upper in box)]


def deal(split, size):
    """Returns the boxes of this rank and the number of ghost layers."""
    slabs = cut(size, (RANKS, 1, 1))
    if split == "boxes":
        grid = {1: (1, 1, 1), 2: (1, 1, 2), 3: (1, 3, 1), 4: (2, 1, 2),
                8: (2, 2, 2)}.get(RANKS, (RANKS, 1, 1))
        return full([cut(size, grid)[RANK]]), 0
    if split == "scattered":
        order = np.random.default_rng(3).permutation(8)
        dealt = [box for i, box in zip(order, cut([n - 3 for n in size], (2, 2, 2)))
                 if i % RANKS == RANK]
        grow = lambda span, n: (span[0], n if span[1] == n - 3 else span[1])
        return [tuple(grow(span, n) for span, n in zip(box, size)) for box in dealt][::-1], 0
    if split == "one rank empty":
        filled = cut(size, (max(RANKS - 1, 1), 1, 1))
        return full(filled[RANK:RANK + 1]), 0
    if split == "all on one rank":
        return ([] if RANK < RANKS - 1 else cut(size, (1, 1, 1))), 0
    return full([slabs[RANK]]), 2 if split == "ghosts" else 0


def split_input(arrays, split):
    boxes, ghosts = deal(split, next(iter(arrays.values())).shape)
    blocks = vtkMultiBlockDataSet()
    for i, box in enumerate(boxes):
        blocks.SetBlock(i, part(arrays, box, ghosts))
    return producer(blocks)


def mesh_and_surfaces(source, case, **properties):
    """Runs the filter for hexahedra, or for tetrahedra if a Method is given.

    Returns the pieces of mesh and surfaces, which are empty except on rank 0, and the table of
    materials, whose rows only rank 0 has.
    """
    arrays = ALL_CASES[case]
    fractions = [name for name in arrays if name not in STATE]
    chosen = {"MaterialIdArray": "id"} if "id" in arrays else {"VolumeFractionArrays": fractions}
    chosen["StateArrays"] = [name for name in STATE if name in arrays]
    make = VolumeFractionToTet if "Method" in properties else VolumeFractionToHex
    mesher = make(Input=source, **chosen, **properties)
    errors, _ = collect(mesher.GetClientSideObject())
    result = []
    for port, kind in enumerate((".pvtu", ".pvtp")):
        path = os.path.join(FOLDER, "ranks%d%s" % (RANKS, kind))
        save_data(path, simple.OutputPort(mesher, port))
        assert not errors, errors
        pieces = read_pieces(path) if RANK == 0 else []
        assert RANK > 0 or RANKS == 1 or case == TINY or sum(
            piece.GetNumberOfCells() > 0 for piece in pieces) > 1
        result.append(pieces)
        CONTROLLER.Barrier()  # the next mesh overwrites the files
    table = mesher.GetClientSideObject().GetOutputDataObject(4)
    assert (table.GetNumberOfRows() > 0) == (RANK == 0)
    simple.Delete(mesher)
    simple.Delete(source)
    return result, table_of(table)


def compare_with_gold(outputs, table, name, label):
    """Returns a description of the first difference from the stored mesh, or an empty text.

    The run of the whole image on one rank stores the mesh first.
    """
    path = os.path.join(FOLDER, name + ".gold")
    result = [merge(pieces) for pieces in outputs] + [table]
    if RANKS == 1 and label == "whole":
        with open(path, "wb") as file:
            pickle.dump(result, file)
    with open(path, "rb") as file:
        gold = pickle.load(file)
    assert len(gold[0]["cells"]) > (0 if name == TINY else 100)
    if repr(result[-1]) != repr(gold[-1]):
        return "%s, %s: materials %s instead of %s" % (name, label, result[-1], gold[-1])
    for port, (one, other) in enumerate(zip(result[:-1], gold[:-1])):
        problem = difference(one, other)
        if problem:
            return "%s, %s, output %d: %s" % (name, label, port, problem)
    return ""


def on_first_rank(work):
    """Calls work() on rank 0; a problem that it returns fails on all ranks."""
    try:
        problem = work() if RANK == 0 else ""
    except Exception:
        problem = traceback.format_exc()
    assert reduced(int(bool(problem)), vtkCommunicator.MAX_OP) == 0, problem or "see rank 0"


def check(case, source, label, kind=None, **properties):
    outputs, table = mesh_and_surfaces(source, case, **properties)
    parts = [case, kind, properties.get("Method"),
             "with void" if properties.get("MeshVoid") else None,
             "refined" if properties.get("MaximumLevel") else None,
             "cleared" if properties.get("MinimumRegionCells") else None]
    on_first_rank(lambda: compare_with_gold(outputs, table, " ".join(filter(None, parts)), label))


def write_inputs():
    """Writes the whole images, which readers split, with the values in cells and at points."""
    for case, arrays in ALL_CASES.items():
        for data, name in ((image(arrays), case), (at_points(image(arrays)), case + " points"),
                           (at_points(image(arrays), MIRROR), case + " turned")):
            writer = vtkXMLImageDataWriter()
            writer.SetDataModeToBinary()
            writer.SetInputData(data)
            writer.SetFileName(os.path.join(FOLDER, name + ".vti"))
            writer.Write()


def test_whole():
    if RANKS == 1:
        os.makedirs(FOLDER, exist_ok=True)
        write_inputs()
        for case, arrays in ALL_CASES.items():
            check(case, producer(image(arrays)), "whole")
        check("ball_and_plate", producer(image(CASES["ball_and_plate"])), "whole", MeshVoid=1)
        check("ball_and_plate", producer(image(CASES["ball_and_plate"])), "whole", **uniform(1))
        for case, properties in CLEARED:
            check(case, producer(image(CASES[case])), "whole", **properties)
        check("ball_and_plate", producer(at_points(image(CASES["ball_and_plate"]), MIRROR)),
              "whole", "turned")
        for case, method, _ in TET_CASES:
            check(case, producer(image(CASES[case])), "whole", Method=method)


def test_image_pieces():
    for case in [*SPLIT_CASES, TINY]:
        check(case, simple.XMLImageDataReader(FileName=[os.path.join(FOLDER, case + ".vti")]),
              "image pieces")


def check_split(split):
    if RANKS == 1 and split != "scattered":
        return  # one block, as in test_whole
    for case in SPLIT_CASES:
        check(case, split_input(CASES[case], split), split)


def test_slabs():
    check_split("slabs")


def test_boxes():
    check_split("boxes")


def test_scattered():
    check_split("scattered")


def test_one_rank_empty():
    check_split("one rank empty")


def test_all_on_one_rank():
    check_split("all on one rank")


def test_ghosts():
    check_split("ghosts")


def point_blocks(arrays, split):
    """Returns the blocks of this rank with the values at points.

    The blocks are adjacent, share planes, or have ghost points.
    """
    size = next(iter(arrays.values())).shape
    boxes, ghosts = deal("ghosts" if split == "ghosts" else "scattered", size)
    blocks = vtkMultiBlockDataSet()
    for i, box in enumerate(boxes):
        more = split == "shared planes"
        blocks.SetBlock(i,
                        at_points(part(arrays,
                                       [(lower, min(upper + more, n))
                                        for (lower, upper), n in zip(box, size)], ghosts)))
    return producer(blocks)


def test_points():
    """Images of points give the mesh of the same values in cells."""
    for case in [*SPLIT_CASES, TINY]:
        reader = simple.XMLImageDataReader(FileName=[os.path.join(FOLDER, case + " points.vti")])
        check(case, reader, "pieces of points")
    for case in ("noise", "splash"):
        for split in ("beside each other", "shared planes", "ghosts"):
            check(case, point_blocks(CASES[case], split), "points, " + split)
    turned = simple.XMLImageDataReader(FileName=[os.path.join(FOLDER, "ball_and_plate turned.vti")])
    check("ball_and_plate", turned, "pieces of points", "turned")
    whole = at_points(image(CASES["ball_and_plate"]), MIRROR)
    check("ball_and_plate", producer(whole if RANK == RANKS - 1 else vtkImageData()),
          "a whole and empty images", "turned")
    for case, method, _ in TET_CASES:
        check(case, point_blocks(CASES[case], "shared planes"), "points", Method=method)


def test_options():
    arrays = CASES["ball_and_plate"]
    check("ball_and_plate", split_input(arrays, "scattered"), "void", MeshVoid=1)
    check("grains", split_input(CASES["grains"], "scattered"), "two threads", NumberOfThreads=2)


def test_refinement():
    check("ball_and_plate", split_input(CASES["ball_and_plate"], "scattered"), "scattered",
          **uniform(1))


def test_regions_and_label_smoothing():
    for case, properties in CLEARED:
        check(case, split_input(CASES[case], "scattered"), "scattered", **properties)


def test_tets():
    for case, method, split in TET_CASES:
        check(case, split_input(CASES[case], split), split, Method=method)


def check_conforming(meshes, surfaces):
    """Checks all pieces together.

    No tetrahedron is inverted; the surfaces are the faces between materials and on the boundary.
    """
    points, cells = (joined(parts)
                     for parts in zip(*[piece_of(mesh) for mesh in meshes
                                        if mesh.GetNumberOfCells() > 0]))
    ids, first = np.unique(points["GlobalPointIds"], return_index=True)
    assert tet_volumes(points["Points"][first],
                       np.searchsorted(ids, cells["Connectivity"])).min() > 0
    facets = joined([piece_of(surface)[1] for surface in surfaces
                     if surface.GetNumberOfCells() > 0])["Connectivity"]
    assert set(map(tuple,
                   np.sort(facets,
                           axis=1).tolist())) == set(
                               surface_faces(cells["Connectivity"], cells["MaterialId"]))


def test_tetgen():
    if "TetGen" not in TET_METHODS:
        return
    case = "ball_and_plate"
    (meshes, surfaces), _ = mesh_and_surfaces(split_input(CASES[case], "scattered"), case,
                                              Method="TetGen")
    on_first_rank(lambda: check_conforming(meshes, surfaces))
    on_first_rank(lambda: compare_with_gold([surfaces], {}, case + " TetGen",
                                            "whole" if RANKS == 1 else "scattered"))


def test_fewer_cells_than_ranks():
    check(TINY, split_input(ALL_CASES[TINY], "all on one rank"), "all on one rank")


def test_exodus_in_pieces():
    hexes = VolumeFractionToHex(
        Input=split_input(CASES["ball_and_plate"], "scattered"),
        VolumeFractionArrays=["ball", "plate"])
    hexes.UpdatePipeline()
    mesh = hexes.GetClientSideObject().GetOutputDataObject(0)
    path = os.path.join(FOLDER, "mesh%d.e" % RANKS)
    simple.SaveData(path, proxy=producer(mesh))
    CONTROLLER.Barrier()
    if RANK > 0:
        return
    found = {"ball": [], "plate": []}
    for rank in range(RANKS):
        reader = vtkExodusIIReader()
        reader.SetFileName(path + (".%d.%d" % (RANKS, rank) if RANKS > 1 else ""))
        reader.UpdateInformation()
        reader.GenerateGlobalElementIdArrayOn()
        reader.SetAllArrayStatus(vtkExodusIIReader.ELEM_BLOCK, 1)
        reader.Update()
        blocks = reader.GetOutput().GetBlock(0)
        assert blocks.GetNumberOfBlocks() == 2
        for i in range(2):
            name, block = blocks.GetMetaData(i).Get(blocks.NAME()), blocks.GetBlock(i)
            if block and block.GetNumberOfCells() > 0:
                found[name] += list(vtk_to_numpy(block.GetCellData().GetArray("GlobalElementId")))
    with open(os.path.join(FOLDER, "ball_and_plate.gold"), "rb") as file:
        cells = pickle.load(file)[0]["cells"]
    ids = found["ball"] + found["plate"]
    assert found["ball"] and found["plate"] and len(ids) == len(set(ids)) == len(cells)


# Runs on more ranks test only the ways to split the input.
DEALS = ("image_pieces", "slabs", "boxes", "scattered", "one_rank_empty", "all_on_one_rank",
         "ghosts", "fewer_cells_than_ranks")
main({"test_" + name: globals()["test_" + name] for name in DEALS} if RANKS > 3 else globals())
