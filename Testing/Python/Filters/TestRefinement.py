"""Meshes of several levels: from the input, by criteria, or coarser away from interfaces."""
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from amr_files import make_amr, vtk_amr
import exodus_dump
from compare_meshes import difference, merge, read_pieces
from mesh_sets import find_sets
from sculptor_program import check_same, mesh_file
from vfmtest import (
    VolumeFractionShapes, VolumeFractionToHex, check_hexes, digest, elements,
    exodus_parts, facets, hex_volumes,
    image, in_folder, main, mesh_of, points_of, producer, rectilinear, run, save_data, simple)

COARSEN = {"Refinement": "Coarsen"}
AUTOMATIC = {"Refinement": "Automatic", "MaximumLevel": 1}


def fractions(text, n, names=("ball",)):
    """Returns {name: exact fractions (z, y, x)} of shapes in a box from -1 to 1.

    n: cells along each axis, or a list for x, y, z.
    """
    cells = [n] * 3 if isinstance(n, int) else n
    preset = {"Preset": text} if text[0].isupper() else {"Shapes": text}
    proxy = VolumeFractionShapes(Dimensions=cells, **preset)
    proxy.UpdatePipeline()
    arrays = proxy.GetClientSideObject().GetOutputDataObject(0).GetCellData()
    return {name: vtk_to_numpy(arrays.GetArray("Material%d" % (m + 1))).reshape(cells[::-1]).copy()
            for m, name in enumerate(names)}


def cubes(arrays, widths=1.0):
    """Makes an image of cubes from the origin on."""
    data = image(arrays)
    data.SetOrigin(0, 0, 0)
    data.SetSpacing([widths] * 3)
    return data


def interfaces(result):
    """Returns ids, coordinates and SurfaceId of the facets between materials or next to void.

    They are sorted by the ids of their points.
    """
    data = result.surfaces.GetCellData()
    inner = vtk_to_numpy(data.GetArray("DomainSide")) < 0
    quads = facets(result)[inner]
    ids = vtk_to_numpy(result.surfaces.GetPointData().GetGlobalIds())[quads]
    order = np.lexsort(np.sort(ids, axis=1).T)
    points = vtk_to_numpy(result.surfaces.GetPoints().GetData())[quads]
    return ids[order], points[order], vtk_to_numpy(data.GetArray("SurfaceId"))[inner][order]


def check_same_interfaces(one, other):
    for mine, its in zip(interfaces(one), interfaces(other)):
        assert mine.shape == its.shape and np.array_equal(mine, its)
    assert len(interfaces(one)[0]) > 0
    for name in ("TargetVolume", "MeshVolume", "FragmentTargetVolume", "FlippedCells",
                 "NumberOfFragments", "MaterialNames"):
        assert one.field(name) == other.field(name), name


def number_of_hexes(result):
    return result.mesh.GetNumberOfCells()


def least(result):
    return result.field("MinimumScaledJacobian")[0]


def check_levels(result, levels):
    """Checks that the counts of the levels add up."""
    counts = result.field("LevelCells")
    assert len(counts) == levels + 1 and sum(counts) + result.field("TransitionCells")[
        0] == number_of_hexes(result), counts
    for name in ("RefinedCells", "CellsAddedForBalance"):
        assert len(result.field(name)) == levels + 1 and min(result.field(name)) >= 0
    assert all(a <= b
               for a, b in zip(result.field("CellsAddedForBalance"), result.field("RefinedCells")))


def refined_mesh(data, levels, **properties):
    """Returns a checked mesh with `levels` levels above the coarsest."""
    result = mesh_of(data, **properties)
    check_hexes(result)
    check_levels(result, levels)
    return result


# ---- levels of the input

def test_levels_of_the_input():
    """MaximumLevel omits the finest levels; 0 is Off."""
    data = lambda: vtk_amr(make_amr(3, 2, (2, 2, 2)))
    inputs = {"VolumeFractionArrays": ["ball", "rest"]}
    finest = mesh_of(data(), Refinement="Uniform", **inputs)
    levels = refined_mesh(data(), 2, **inputs)
    check_same_interfaces(levels, finest)
    assert number_of_hexes(levels) < number_of_hexes(finest)
    check_same_interfaces(refined_mesh(data(), 1, MaximumLevel=1, **inputs),
                          mesh_of(data(), Refinement="Uniform", MaximumLevel=1, **inputs))
    assert digest(mesh_of(data(), MaximumLevel=0,
                          **inputs)) == digest(mesh_of(data(), Refinement="Off", **inputs))
    # Coarsening ignores the levels of the input and continues above its level 0.
    check_same_interfaces(refined_mesh(data(), 3, MaximumLevel=3, **COARSEN, **inputs), finest)


def test_image_has_one_level():
    """An image has one level, for any MaximumLevel."""
    data = cubes(fractions("sphere radius=0.6", 12))
    for properties in ({}, {"MaximumLevel": 3}, {"FineLayers": 5}):
        result = mesh_of(data, VolumeFractionArrays=["ball"], **properties)
        assert not result.mesh.GetFieldData().HasArray("LevelCells")
        assert digest(result) == digest(mesh_of(data, VolumeFractionArrays=["ball"],
                                                Refinement="Off"))


# ---- coarsening

BALL_AND_PLATE = {"VolumeFractionArrays": ["ball", "plate"]}
THICK = "sphere radius=0.4 center=0,0,0.1; halfspace point=0,0,-0.1 normal=0,0,1 material=2"


def two_materials(n, shapes="Ball and Plate"):
    return cubes(fractions(shapes, n, ("ball", "plate")))


def test_coarsening_keeps_interfaces():
    """Coarsening leaves the interfaces unchanged."""
    data = two_materials(24, THICK)
    for void in (0, 1):
        off = mesh_of(data, MeshVoid=void)
        results = [refined_mesh(data, levels, **COARSEN, MaximumLevel=maximum, MeshVoid=void)
                   for maximum, levels in
                   ((1, 1), (2, 2), (3, 3))]
        results.append(refined_mesh(data, 3, **COARSEN, FineLayers=5, MeshVoid=void))
        for result in results:
            check_same_interfaces(result, off)
            assert least(result) > 0.5 or least(result) == least(off), (least(result), least(off))
        counts = list(map(number_of_hexes, results))
        print("ball on a block, 24^3, void %d: %d hexes; with 1, 2, 3 levels and with 5 fine "
              "layers %s" % (void, number_of_hexes(off), counts))
        assert number_of_hexes(off) > counts[0] >= counts[1] >= counts[2] < counts[3]
        assert digest(mesh_of(data, **COARSEN, MeshVoid=void)) == digest(results[2])


def test_fine_layers():
    """FineLayers of the finest cells lie between an interface and larger cells."""
    n = 32
    inside = np.zeros((n, n, n))
    inside[:n // 2] = 1  # the nodes do not move at a flat interface
    data = cubes({"low": inside})
    counts = []
    for layers in (2, 3, 5):
        result = refined_mesh(data, 2, VolumeFractionArrays=["low"], MeshVoid=1, MaximumLevel=2,
                              FineLayers=layers, **COARSEN)
        z = points_of(result)[elements(result)][:, :, 2]
        large = np.abs(z - n / 2).min(axis=1)[hex_volumes(points_of(result),
                                                          elements(result)) > 1.1]
        assert large.min() >= layers - 1e-9, (layers, large.min())
        counts.append(number_of_hexes(result))
    assert counts[0] <= counts[1] < counts[2], counts


def test_sizes_that_do_not_divide():
    """A warning names the number of cells that cannot be divided further."""
    data = lambda n: cubes(fractions("sphere radius=0.6", n))
    off = mesh_of(data([24, 20, 24]), VolumeFractionArrays=["ball"])
    for maximum, levels, warned in ((2, 2, False), (3, 2, True), (-1, 2, False)):
        result = refined_mesh(data([24, 20, 24]), levels, VolumeFractionArrays=["ball"],
                              MaximumLevel=maximum, **COARSEN)
        check_same_interfaces(result, off)
        assert len(result.warnings) == warned and all("20 cells along y" in text
                                                      for text in result.warnings), result.warnings
    odd = mesh_of(data([24, 24, 23]), VolumeFractionArrays=["ball"], MaximumLevel=1, **COARSEN)
    assert len(odd.warnings) == 1 and "23 cells along z" in odd.warnings[0], odd.warnings
    assert digest(odd) == digest(mesh_of(data([24, 24, 23]), VolumeFractionArrays=["ball"]))


def test_rectilinear_grid():
    """Uneven cells are joined in pairs if they are halves of wider cells."""
    wide = np.concatenate([[0.0], np.cumsum(1.03 ** np.arange(12))])
    halves = np.sort(np.concatenate([wide, (wide[1:] + wide[:-1]) / 2]))
    arrays = fractions("sphere radius=0.6", 24)
    uneven = lambda x: rectilinear(arrays, [np.arange(25.0), x, np.arange(25.0)])
    result = refined_mesh(uneven(halves), 1, VolumeFractionArrays=["ball"], MaximumLevel=1,
                          MeshVoid=1, **COARSEN)
    off = mesh_of(uneven(halves), VolumeFractionArrays=["ball"], MeshVoid=1)
    check_same_interfaces(result, off)
    print("uneven cells: %d hexes, coarsened %d, min SJ %.3f"
          % (number_of_hexes(off), number_of_hexes(result), least(result)))
    assert not result.warnings and number_of_hexes(result) < number_of_hexes(off)
    for maximum in (1, 2):
        other = uneven(1.02 ** np.arange(25) if maximum == 1 else halves)
        result = mesh_of(other, VolumeFractionArrays=["ball"], MaximumLevel=maximum, **COARSEN)
        named = [text for text in result.warnings if "24 cells along y" in text]
        assert len(named) == 1 and "widths that vary" in named[0], result.warnings


# ---- criteria

def test_thick_ball_asks_for_nothing():
    """A thick body is not refined by the default criteria."""
    data = cubes(fractions("sphere radius=0.6", 20))
    off = digest(mesh_of(data, VolumeFractionArrays=["ball"], Refinement="Off"))
    for maximum in (-1, 0, 1, 2):
        result = mesh_of(data, VolumeFractionArrays=["ball"], Refinement="Automatic",
                         MaximumLevel=maximum)
        assert digest(result) == off and not result.mesh.GetFieldData().HasArray("LevelCells")
    assert digest(mesh_of(data, VolumeFractionArrays=["ball"], ThinCells=0, **AUTOMATIC)) == off


def test_every_criterion():
    """Each criterion refines the expected cells."""
    small, large = cubes(fractions("sphere radius=0.4",
                                   16)), cubes(fractions("sphere radius=0.75", 16))
    inputs = {"VolumeFractionArrays": ["ball"]}
    # The radius is 3.2 cells.
    curved = refined_mesh(small, 1, CurvaturePerCell=0.2, **AUTOMATIC, **inputs)
    check_same_interfaces(curved, mesh_of(small, Refinement="Uniform", **inputs))
    # The radius is 6 cells.
    assert digest(mesh_of(large, CurvaturePerCell=0.3, **AUTOMATIC,
                          **inputs)) == digest(mesh_of(large, **inputs))
    two = refined_mesh(large, 2, Refinement="Automatic", MaximumLevel=2, InterfaceLayers=1,
                       StairStep=1, **inputs)
    check_same_interfaces(two,
                          mesh_of(large, Refinement="Uniform", MaximumLevel=2, StairStep=1,
                                  **inputs))
    flat = np.zeros((20, 20, 20))
    flat[:10] = 1
    counts = [number_of_hexes(refined_mesh(cubes({"ball": flat}), 1, InterfaceLayers=layers,
                                           **AUTOMATIC, **inputs)) for layers in (1, 3, 5)]
    print("block of 10 layers: %s hexes with 1, 3, 5 halved" % counts)
    assert 4000 < counts[0] < counts[1] < counts[2] < 8 * 4000, counts
    noise = cubes({"id": np.random.default_rng(3).choice([0, 2, 3], (8, 8, 8)).astype(np.int32)})
    labels = {"MaterialIdArray": "id", "ThinCells": 0}
    assert mesh_of(noise, **labels).field("FlippedCells")[0] > 0
    refined_mesh(noise, 1, RefineFlippedCells=1, **AUTOMATIC, **labels)
    assert digest(mesh_of(noise, **AUTOMATIC, **labels)) == digest(mesh_of(noise, **labels))


def test_criteria_on_levels_of_the_input():
    """A film thinner than two of the finest input cells gets a further level."""
    film = fractions("plate thickness=0.07 normal=1,2,3", 32, ("film",))
    amr = make_amr(2, 2, (4, 4, 4), film, np.array([2.0] * 3))
    inputs = {"VolumeFractionArrays": ["film"]}
    plain, finer = (refined_mesh(vtk_amr(amr), levels, Refinement=mode, MaximumLevel=levels,
                                 **inputs) for mode, levels in
                    (("Input Levels", 1), ("Automatic", 2)))
    print("film on two levels: %d hexes, %d with one more"
          % (number_of_hexes(plain), number_of_hexes(finer)))
    assert finer.field("NumberOfFragments") == [1] and number_of_hexes(finer) > 2 * number_of_hexes(
        plain)


# ---- other properties, files

def test_other_properties():
    data = two_materials(16)
    for properties in ({"StairStep": 1}, {"Smoothing": "Off"}, {"Smoothing": "Geometry Based"},
                       {"ConserveVolume": 0, "IsoValue": 0.3},
                       {"ComputeQuality": 0, "TargetScaledJacobian": 0.3, "MinimumRegionCells": 5}):
        result = refined_mesh(data, 3, MeshVoid=1, **BALL_AND_PLATE, **COARSEN, **properties)
        check_same_interfaces(result, mesh_of(data, MeshVoid=1, **BALL_AND_PLATE, **properties))
    stairs = {"InterfaceLayers": 1, "StairStep": 1, **BALL_AND_PLATE}
    check_same_interfaces(refined_mesh(data, 1, **AUTOMATIC, **stairs),
                          mesh_of(data, Refinement="Uniform", **stairs))


def test_labels():
    arrays = fractions("Ball and Plate", 24, ("ball", "plate"))
    ids = np.where(arrays["ball"] + arrays["plate"] < 0.5, 0,
                   np.where(arrays["ball"] >= arrays["plate"], 7, 3)).astype(np.int32)
    for properties in ({}, {"LabelSmoothing": 3}):
        result = refined_mesh(cubes({"id": ids}), 3, MaterialIdArray="id", **COARSEN, **properties)
        check_same_interfaces(result,
                              mesh_of(cubes({"id": ids}), MaterialIdArray="id", **properties))
        assert result.field("MaterialIds") == [3, 7]
    noise = np.random.default_rng(5).choice([0, 2, 3, 5], (12, 12, 12)).astype(np.int32)
    noise[:, :, 8:] = 2
    result = refined_mesh(cubes({"id": np.pad(noise, ((0, 0), (0, 0), (0, 20)), mode="edge")}), 2,
                          MaterialIdArray="id", **COARSEN)
    assert least(result) >= 0.35, least(result)


def test_threads():
    data = two_materials(16)
    assert len({digest(mesh_of(data, NumberOfThreads=threads, MeshVoid=1, **COARSEN))
                for threads in (1, 2, 5)}) == 1


def test_state_arrays():
    """Large elements have the state of the cell at their centroid.

    Elements near interfaces have the same state as in a mesh of one level.
    """
    n = 24
    arrays = fractions("Ball and Plate", n, ("ball", "plate"))
    number = np.arange(n ** 3, dtype=np.int64).reshape(n, n, n)
    data = cubes({**arrays, "number": number,
                  "vector": np.stack([number, -number, 2 * number], axis=3).astype(float)})
    result, off = (mesh_of(data, StateArrays=["number", "vector"], MeshVoid=1, Refinement=mode)
                   for mode in ("Coarsen", "Off"))
    at = dict(zip(off.cells("GlobalCellIds").tolist(), off.cells("number").tolist()))
    near = np.isin(result.cells("GlobalCellIds"), off.cells("GlobalCellIds"))
    ids = result.cells("GlobalCellIds")[near].tolist()
    assert near.sum() == result.field("LevelCells")[-1] and not near.all()
    i, j, k = np.floor(points_of(result)[elements(result)].mean(axis=1) + 1e-9).astype(int).T
    # Some elements next to a transition lie in another cell.
    differs = result.cells("number")[near] != [at[i] for i in ids]
    assert differs.sum() < 0.01 * len(differs) and np.array_equal(
        result.cells("number")[near][differs], number[k, j, i][near][differs])
    assert np.array_equal(result.cells("number")[~near], number[k, j, i][~near])
    assert np.array_equal(result.cells("vector")[:, 1], -result.cells("number"))


@in_folder
def test_files(at):
    data = two_materials(24, THICK)
    result = refined_mesh(data, 3, **COARSEN)
    assert result.field("LevelCells")[-1] < number_of_hexes(result)
    hexes = VolumeFractionToHex(Input=producer(data), **BALL_AND_PLATE, **COARSEN)
    save_data(at("mesh.vtu"), hexes)
    assert not difference(merge(read_pieces(at("mesh.vtu"))), merge([result.mesh]))
    simple.SaveData(at("mesh.exo"), proxy=hexes)
    cells = {}
    for name, part in exodus_parts(at("mesh.exo")):
        cells[name] = cells.get(name, 0) + part.GetNumberOfCells()
    assert cells == {name: (result.cells("MaterialId") == m).sum()
                     for m, name in ((1, "ball"), (2, "plate"))}, cells
    sides, nodes = find_sets(result.mesh)
    read = exodus_dump.join([exodus_dump.Dump(at("mesh.exo"))])
    assert read["sides"] == sides and read["node sets"] == nodes
    assert {"ball_to_plate", "plate_to_ball", "plate_to_Void", "x_min",
            "z_min"} <= {name for _, name in sides}
    simple.SaveData(at("mesh.inp"), proxy=hexes)
    with open(at("mesh.inp")) as file:
        assert file.read().count("\n") > number_of_hexes(result)


@in_folder
def test_sculptor(at):
    """Properties set by sculptor give the mesh of the filter."""
    data = two_materials(16)
    simple.SaveData(at("data.vti"), proxy=producer(data), DataMode="Binary")
    for words, properties in ((["Refinement=Coarsen"], COARSEN),
                              (["Refinement=Coarsen", "MaximumLevel=2", "FineLayers=3"], {
            **COARSEN, "MaximumLevel": 2, "FineLayers": 3}),
            (["Refinement=Automatic", "InterfaceLayers=1"], {
            **AUTOMATIC, "InterfaceLayers": 1})):
        options = [word for pair in words for word in ("--set", pair)]
        result = mesh_of(data, **properties)
        mesh_file(at("data.vti"), at("out.vtu"), "--fractions", "ball,plate", *options, ranks=2)
        check_same(at("out.vtu"), result.mesh)


def test_malformed_values():
    """Unknown words are errors; numbers out of range are clamped."""
    data = two_materials(8)
    for name, value in (("Refinement", "Coarse"), ("ChildFractions", "Plane"),
                        ("MaximumLevel", "many"), ("FineLayers", None)):
        try:
            run(data, **{name: value})
        except (ValueError, TypeError):
            continue
        raise AssertionError("no error for " + name)
    # clamped to 2, the minimum of the property
    clamped = mesh_of(data, MaximumLevel=1, FineLayers=-3, **COARSEN)
    assert digest(clamped) == digest(mesh_of(data, MaximumLevel=1, **COARSEN))
    result = mesh_of(data, MaximumLevel=99, **COARSEN)
    assert len(result.warnings) == 1 and "not 10" in result.warnings[0], result.warnings


main(globals())
