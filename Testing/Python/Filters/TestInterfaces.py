"""Interfaces split, and layers cut, in an existing mesh: as by the options of the mesher."""
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkUnstructuredGrid

from interface_cases import (
    BOTH, GRAINS, LAYERS, SPLIT, WALLS, arrays_of, compare, hexes, modify, run, tets)
from vfmtest import (
    VolumeFractionInterfaces, box_along_axes, failure_of, image, in_folder, main, producer,
    save_data, simple)


def test_hexes():
    for options in (SPLIT, LAYERS, BOTH, WALLS):
        for case in (GRAINS, {**GRAINS, "Periodic": "XYZ"}):
            compare(run(modify(hexes(**case), **options)), run(hexes(**case, **options)))


def test_options_of_layers():
    """Pairs, sides, growth and thickness, next to void, with and without sharp edges."""
    n = 10
    box = box_along_axes((2.3, 2.4, 2.2), (7.6, 7.3, 7.4), n)
    case = {"data": image({"box": box, "rest": (1 - box) * (np.arange(n) < 6)}),
            "VolumeFractionArrays": ["box", "rest"], "SharpEdges": "On"}
    for options in ({"LayerInterfaces": "box/Void"}, {"LayerInterfaces": "box/rest",
                    "LayersOn": "First Material"}, {"LayerSides": "XYZ", "FirstLayer": 0.03}):
        options = {"Layers": 3, "LayerGrowth": 1.2, **options}
        expected = run(hexes(**case, **options))
        assert "SurfaceParts" in arrays_of(expected[0])["field"]
        compare(run(modify(hexes(**case), **options)), expected)


def test_tets():
    for method in ("Lattice", "Cells"):
        compare(run(modify(tets(**GRAINS, Method=method), **SPLIT)),
                run(tets(**GRAINS, Method=method, **SPLIT)))


def test_one_after_the_other():
    """Layers, then a split, in two filters."""
    layers = {name: value for name, value in BOTH.items() if name in LAYERS}
    split = {name: value for name, value in BOTH.items() if name not in LAYERS}
    compare(run(modify(modify(hexes(**GRAINS), **layers), **split)),
            run(hexes(**GRAINS, **BOTH)))


@in_folder
def test_files(at):
    """A mesh that was read from a file."""
    for make, options in ((hexes, BOTH), (tets, SPLIT)):
        save_data(at("mesh.vtu"), make(**GRAINS))
        mesh = simple.XMLUnstructuredGridReader(FileName=[at("mesh.vtu")])

        compare(run(modify(mesh, **options)), run(make(**GRAINS, **options)))


def test_state():
    """Cell arrays follow; extensive ones are divided. Point arrays follow a split."""
    n = 8
    random = np.random.default_rng(3)
    case = {"data": image({"id": np.arange(n ** 3).reshape(n, n, n) // 256 + 1,
                           "mass": random.random((n, n, n)),
                           "flag": random.integers(0, 9, (n, n, n)).astype(np.uint8),
                           "velocity": random.random((n, n, n, 3))}),
            "MaterialIdArray": "id", "StateArrays": ["mass", "flag", "velocity"]}
    layers = {"Layers": 4}
    plain = run(hexes(**case))[0]
    alike = arrays_of(run(modify(hexes(**case), **layers))[0])["cell"]
    expected = arrays_of(run(hexes(**case, **layers))[0])["cell"]
    assert list(alike) == list(expected)
    shared = arrays_of(run(modify(hexes(**case), ExtensiveArrays=["mass"], **layers))[0])["cell"]
    for name in ("mass", "flag", "velocity"):
        assert np.array_equal(alike[name], expected[name]), name
    total = vtk_to_numpy(plain.GetCellData().GetArray("mass")).sum()
    assert np.isclose(shared["mass"].sum(), total) and alike["mass"].sum() > 1.5 * total
    named = vtkUnstructuredGrid()
    named.ShallowCopy(plain)
    ids = vtk_to_numpy(plain.GetPointData().GetArray("GlobalPointIds"))
    array = numpy_to_vtk(np.stack([ids, -ids], 1).astype(np.float32), deep=1)
    array.SetName("signed")
    named.GetPointData().AddArray(array)
    points = arrays_of(run(modify(producer(named), **SPLIT))[0])["point"]
    before = points["OriginalPointIds"].astype(np.float32)
    assert len(before) > len(ids)
    assert np.array_equal(points["signed"], np.stack([before, -before], 1))
    check_refused(hexes(**case), "must be of type double", ExtensiveArrays=["flag"], **layers)
    check_refused(producer(named), "has the point array signed", **layers)


def check_refused(mesh, words, **options):
    outputs, errors = run(modify(mesh, **options), fails=True)
    assert len(errors) == 1 and words in errors[0], errors
    assert outputs[0].GetNumberOfCells() == 0 and words in failure_of(outputs[0])


def without(mesh, association, name):
    """Returns a mesh without an array."""
    grid = vtkUnstructuredGrid()
    grid.ShallowCopy(mesh)
    {"cell": grid.GetCellData, "point": grid.GetPointData}[association]().RemoveArray(name)
    return producer(grid)


def test_refusals():
    mesh = run(hexes(**GRAINS))[0]
    for association, name in (("cell", "MaterialId"), ("cell", "FragmentId"),
                              ("point", "GeometryDimension"), ("point", "GeometryId")):
        check_refused(without(mesh, association, name), "has no array " + name, **SPLIT)
    for association, name in (("cell", "GlobalCellIds"), ("point", "GlobalPointIds")):
        check_refused(without(mesh, association, name), name, **SPLIT)
    check_refused(tets(**GRAINS, Method="Lattice"), "Layers are for hexahedra", **LAYERS)
    check_refused(modify(hexes(**GRAINS), **SPLIT), "split already", **SPLIT)
    check_refused(modify(hexes(**GRAINS), **SPLIT), "split already", **LAYERS)
    check_refused(hexes(**GRAINS, **LAYERS), "has layers already", **LAYERS)
    check_refused(hexes(**GRAINS, ElementOrder="Quadratic"), "second order", **SPLIT)
    check_refused(hexes(**GRAINS, Periodic="X", PeriodicSides="Joined"), "joined", **LAYERS)
    check_refused(hexes(**GRAINS), "not a pair of two different materials",
                  SplitInterfaces="1/99")
    check_refused(hexes(**GRAINS), "no state array mass", ExtensiveArrays=["mass"], **LAYERS)
    some = simple.Threshold(Input=hexes(**GRAINS), Scalars=["CELLS", "MaterialId"],
                            ThresholdMethod="Between", LowerThreshold=1, UpperThreshold=3)
    check_refused(some, "parts of it are missing", **LAYERS)


def test_nothing_to_do():
    compare(run(modify(hexes(**GRAINS))), run(hexes(**GRAINS)))
    assert VolumeFractionInterfaces(Input=hexes(**GRAINS)).SplitInterfaces == "None"


main(globals())
