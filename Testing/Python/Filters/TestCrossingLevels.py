"""Meshes whose interfaces cross levels: fine cells only where required."""
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

import exodus_dump
from amr_cases import doubled, fields, multiblock, nested, overlapping
from crossing_cases import AUTOMATIC, CROSSING, ball_with_film
from mesh_sets import find_sets
from sculptor_program import check_same, mesh_file
from vfmtest import (
    VolumeFractionFragments, VolumeFractionToHex, check_hexes, digest, elements, exodus_parts,
    facets, hex_volumes, image, in_folder, main, mesh_of, points_of, producer, simple)

N = 20


def cubes(arrays):
    """Makes an image of unit cubes from the origin on."""
    data = image(arrays)
    data.SetOrigin(0, 0, 0)
    data.SetSpacing(1, 1, 1)
    return data


def number_of_hexes(result):
    return result.mesh.GetNumberOfCells()


def pieces(result, material):
    return len(np.unique(result.cells("FragmentId")[result.cells("MaterialId") == material]))


def check_mesh(result, levels, least=0.5):
    check_hexes(result)
    counts = result.field("LevelCells")
    assert len(counts) == levels + 1 and sum(counts) + result.field("TransitionCells")[
        0] == number_of_hexes(result), counts
    assert np.allclose(result.field("MeshVolume"), result.field("TargetVolume"), rtol=1e-6, atol=0)
    assert result.field("MinimumScaledJacobian")[0] >= least, result.field("MinimumScaledJacobian")


def inner_facets(result):
    """Returns the corners of the facets inside the domain and the points of the surfaces."""
    inside = vtk_to_numpy(result.surfaces.GetCellData().GetArray("DomainSide")) < 0
    return facets(result)[inside], vtk_to_numpy(result.surfaces.GetPoints().GetData())


def widths_at_interface(result):
    """Returns the square root of the area of each facet between materials or next to void."""
    quads, points = inner_facets(result)
    a, b, c, d = (points[quads[:, corner]] for corner in range(4))
    return np.sqrt(np.linalg.norm(np.cross(c - a, d - b), axis=1) / 2)


def distances_to_ball(result, centre, radius):
    """Returns the distances of interface points to the ball, in cells.

    The points have a lower x than the centre: they are closest to the ball.
    """
    quads, points = inner_facets(result)
    x = points[np.unique(quads)]
    return np.abs(np.linalg.norm(x[x[:, 0] < centre[0]] - centre, axis=1) - radius)


def check_film(fin):
    body, centre, radius = ball_with_film(N, fin)
    data = lambda: cubes({"body": body})
    for void in (0, 1) if fin else (0,):
        result, fine = mesh_of(data(), MeshVoid=void,
                               **CROSSING), mesh_of(data(), MeshVoid=void, **AUTOMATIC)
        check_mesh(result, 1)
        bodies = 1 if fin else 2
        assert pieces(result, 1) == bodies and pieces(result, 0) == void
        distance = distances_to_ball(result, centre, radius)
        print("%s, void %d: %d hexes, %d with fine interfaces, min SJ %.3f, ball within %.3f cells"
              % (
            "fin" if fin else "film beside", void, number_of_hexes(result), number_of_hexes(fine),
            result.field("MinimumScaledJacobian")[0], distance.max()))
        assert number_of_hexes(result) < 0.75 * number_of_hexes(fine)
        assert distance.max() < 0.1, distance.max()
        widths = widths_at_interface(result)
        # facets of the film and of the ball
        assert (widths < 0.6).sum() > 100 and (widths
                                               > 0.75).sum() > 100, np.percentile(
                                                   widths, range(0, 101, 10))
    # The film breaks if it is neither refined nor gets the cells of thin parts.
    pieces_of_coarse = [mesh_of(data(), **{**AUTOMATIC, "Refinement": "Off"}, ThinParts=thin).field(
        "NumberOfFragments")[0] for thin in (0, 1)]
    assert pieces_of_coarse[0] > bodies == pieces_of_coarse[1], pieces_of_coarse


def test_film_beside_a_ball():
    """The film next to a ball gets fine cells; the ball keeps coarse ones."""
    check_film(False)


def test_fin_of_a_ball():
    """The transition between the levels lies on the interface."""
    check_film(True)


def test_levels_of_the_input():
    """AMR input keeps its levels at interfaces, which takes fewer elements."""
    inputs = {"VolumeFractionArrays": ["ball", "plate"]}
    for void in (0, 1):
        make = lambda **properties: mesh_of(overlapping(fields(2), nested()), MeshVoid=void,
                                            **inputs, **properties)
        result = make(FineInterfaces=0)
        check_mesh(result, 2)
        assert [pieces(result, material) for material in (0, 1, 2)] == [void, 1, 1]
        assert number_of_hexes(result) < 0.6 * number_of_hexes(make())
        assert digest(mesh_of(multiblock(fields(2), nested()), MeshVoid=void, FineInterfaces=0,
                              **inputs)) == digest(result)


def test_other_properties():
    body, _, _ = ball_with_film(N, True)
    for properties in ({"StairStep": 1}, {"Smoothing": "Off"}, {"Smoothing": "Geometry Based"},
                       {"ConserveVolume": 0}, {"FineLayers": 4}):
        result = mesh_of(cubes({"body": body}), **CROSSING, **properties)
        check_hexes(result)
        assert result.field("NumberOfFragments") == [1] and result.field("LevelCells")[0] > 0
    assert len({digest(mesh_of(cubes({"body": body}), NumberOfThreads=threads, **CROSSING))
                for threads in (1, 3)}) == 1


# ---- state arrays

def centroids(result):
    return points_of(result)[elements(result)].mean(axis=1)


def test_state_of_the_input():
    """State on AMR data, with the fractions of the finest level.

    If the cell at the centroid holds at least half of the material, the element has its state.
    Otherwise it has the state of a cell that holds more of the material.
    """
    all_fields, blocks = fields(2), nested()
    result = mesh_of(multiblock(all_fields, blocks), StateArrays=["number"], MeshVoid=1,
                     FineInterfaces=0, ChildFractions="Parent")
    finest = {name: doubled(doubled(all_fields[0][name])) for name in all_fields[0]}
    for level, box in [block for block in blocks if block[0] > 0]:
        window = tuple(slice(a << (2 - level), b << (2 - level)) for a, b in box)
        for name, whole in finest.items():
            own = all_fields[level][name][tuple(slice(*span) for span in box)]
            whole[window] = own if level == 2 else doubled(own)
    finest["void"] = 1 - finest["ball"] - finest["plate"]
    spacing = np.array([0.25, 0.25, 0.5]) / 4
    i, j, k = np.floor((centroids(result) - [-1.0, 0.5, 2.0]) / spacing + 1e-9).astype(int).T
    fractions = np.stack([finest[name] for name in ("void", "ball", "plate")])
    material, number = result.cells("MaterialId"), result.cells("number")
    there = fractions[material, k, j, i]
    assert np.array_equal(number[there >= 0.5],
                          finest["number"][k, j, i][there >= 0.5]) and (there < 0.5).sum() > 0
    flat = fractions.reshape(3, -1)
    order = np.argsort(finest["number"].ravel(), kind="stable")
    taken = order[np.searchsorted(finest["number"].ravel()[order], number)]
    assert (flat[material, taken] >= there).all()


def test_state_of_large_cells():
    """State of elements eight times as wide as the input cells.

    An element has the state of a cell of its material, if possible of the cell at its centroid.
    """
    labels = np.random.default_rng(5).choice([1, 2, 3], (24, 24, 24),
                                             p=(0.6, 0.2, 0.2)).astype(np.int32)
    labels[:, :, 12:] = np.where(labels[:, :, 12:] == 1, 2, labels[:, :, 12:])
    labels[16:] = 1
    number = np.arange(labels.size).reshape(labels.shape)
    for stairs in (0, 1):
        result = mesh_of(cubes({"id": labels, "number": number}), MaterialIdArray="id",
                         StateArrays=["number"], StairStep=stairs,
                         Refinement="Coarsen", MaximumLevel=3, FineInterfaces=0)
        assert result.field("LevelCells")[0] == number_of_hexes(result)
        taken, material = result.cells("number"), result.cells("MaterialId")
        assert np.array_equal(labels.ravel()[taken], material)
        i, j, k = np.floor(centroids(result) + 1e-9).astype(int).T
        own = labels[k, j, i] == material
        assert np.array_equal(taken[own], number[k, j, i][own]) and own.sum() > 10


def test_state_of_large_transitions():
    """Away from fine interfaces, each element has the state of the cell at its centroid."""
    full = np.zeros((64, 16, 16))
    full[:4] = 1
    number = np.arange(full.size).reshape(full.shape)
    result = mesh_of(cubes({"ball": full, "number": number}), VolumeFractionArrays=["ball"],
                     MeshVoid=1, StateArrays=["number"], Refinement="Coarsen", MaximumLevel=3)
    assert min(result.field("LevelCells")[0], result.field("TransitionCells")[0]) > 0
    cells = np.stack([result.cells("number") // step % 16 if step < 256
                      else result.cells("number") // step for step in (1, 16, 256)], axis=1)
    # Centroids may lie on faces of cells by rounding.
    assert np.abs(centroids(result) - cells - 0.5).max() < 0.5 + 1e-9


# ---- files, command-line tool

@in_folder
def test_files(at):
    """Blocks, side sets, node sets and the table of fragments agree with the mesh."""
    data = multiblock(fields(2), nested())
    inputs = {"VolumeFractionArrays": ["ball", "plate"], "FineInterfaces": 0}
    result = mesh_of(data, **inputs)
    hexes = VolumeFractionToHex(Input=producer(data), **inputs)
    simple.SaveData(at("mesh.exo"), proxy=hexes)
    cells = {}
    for name, part in exodus_parts(at("mesh.exo")):
        cells[name] = cells.get(name, 0) + part.GetNumberOfCells()
    assert cells == {name: (result.cells("MaterialId") == m).sum()
                     for m, name in ((1, "ball"), (2, "plate"))}, cells
    read = exodus_dump.join([exodus_dump.Dump(at("mesh.exo"))])
    sides, nodes = find_sets(result.mesh)
    assert read["sides"] == sides and read["node sets"] == nodes
    assert {"ball_to_plate", "plate_to_ball", "plate_to_Void",
            "z_min"} <= {name for _, name in sides}
    table = VolumeFractionFragments(Input=hexes)
    table.UpdatePipeline()
    rows = table.GetClientSideObject().GetOutputDataObject(0)
    volumes = hex_volumes(points_of(result), elements(result))
    expected = [volumes[result.cells("FragmentId") == f].sum() for f in (1, 2)]
    assert np.allclose(vtk_to_numpy(rows.GetColumnByName("MeshVolume")), expected, rtol=1e-9)


@in_folder
def test_sculptor(at):
    body, _, _ = ball_with_film(16, True)
    data = cubes({"body": body})
    simple.SaveData(at("data.vti"), proxy=producer(data), DataMode="Binary")
    mesh_file(at("data.vti"), at("out.vtu"), "--fractions", "body", "--set", "Refinement=Automatic",
              "--set", "FineInterfaces=off", ranks=2)
    check_same(at("out.vtu"), mesh_of(data, **{**CROSSING, "MaximumLevel": -1}).mesh)


main(globals())
