"""Colour maps of MaterialId and MaterialPair: categories with the names of the materials.

Choices of the user are kept. No view is rendered: colour maps are made when a mesh is shown, and
follow it when its representation is updated.
"""
import os
import tempfile

import numpy as np
from paraview import simple
from vfmtest import (
    VolumeFractionShapes, VolumeFractionToHex, ball_and_plate, image, labels, main, producer,
    save_data)

BALL, PLATE = ball_and_plate()


def show(mesh, array="MaterialId", port=0):
    view = simple.CreateRenderView()
    display = simple.Show(simple.OutputPort(mesh, port), view)
    simple.ColorBy(display, ("CELLS", array))
    return view


def names(array="MaterialId"):
    """Returns {id: name} as in the legend, or None if the colours are continuous."""
    table = simple.GetColorTransferFunction(array)
    texts = list(table.Annotations)
    return dict(zip(map(int, texts[::2]),
                    texts[1::2])) if table.InterpretValuesAsCategories else None


def colours(array="MaterialId"):
    table = simple.GetColorTransferFunction(array)
    return dict(zip(names(array), np.reshape(table.IndexedColors, (-1, 3)).tolist()))


def mesh():
    grid = producer(image({"ball": BALL, "plate": PLATE}))
    return VolumeFractionToHex(Input=grid, VolumeFractionArrays=["ball", "plate"], StairStep=1)


def forget():
    """Deletes all that is shown, with its colour maps."""
    simple.ResetSession()


def test_names_where_shown():
    show(mesh())
    assert names() == {1: "ball", 2: "plate"}, names()
    assert len({tuple(c) for c in colours().values()}) == 2, colours()


def test_pairs():
    show(mesh(), "MaterialPair", 1)
    table = simple.GetColorTransferFunction("MaterialPair")
    assert names("MaterialPair") == {0: "Void", 1: "ball", 2: "plate"}, names("MaterialPair")
    assert (table.VectorMode, table.VectorComponent) == ("Component", 1), table.VectorMode


def test_names_follow_the_data():
    hexes = mesh()
    view = show(hexes)
    before = colours()
    hexes.VolumeFractionArrays, hexes.MeshVoid = ["plate", "ball"], 1
    view.Update()
    assert names() == {0: "Void", 1: "plate", 2: "ball"}, names()
    assert {m: colours()[m] for m in (1, 2)} == before  # a material keeps its colour


def test_all_that_comes_of_a_mesh():
    """Data derived from a mesh, or read from its file, have the names."""
    hexes = mesh()
    show(simple.Threshold(Input=hexes, Scalars=["CELLS", "MaterialId"], LowerThreshold=2,
                          UpperThreshold=2))
    assert names() == {1: "ball", 2: "plate"}, names()
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "mesh.vtu")
        save_data(path, hexes)
        forget()
        show(simple.OpenDataFile(path))
        assert names() == {1: "ball", 2: "plate"}, names()


def test_times_of_other_materials():
    hexes = mesh()
    with tempfile.TemporaryDirectory() as folder:
        paths = [os.path.join(folder, "mesh_%d.vtu" % time) for time in (0, 1)]
        for path, arrays in zip(paths, (["ball"], ["plate", "ball"])):
            hexes.VolumeFractionArrays = arrays
            save_data(path, hexes)
        forget()
        view = show(simple.OpenDataFile(paths))
        assert names() == {1: "ball"}, names()
        view.ViewTime = 1
        view.Update()
        assert names() == {1: "plate", 2: "ball"}, names()


def test_labels_shown_before():
    grid = producer(image({"MaterialId": labels()}))
    simple.Show(grid, simple.CreateRenderView())
    assert names() is None
    show(VolumeFractionToHex(Input=grid, MaterialIdArray="MaterialId", StairStep=1))
    assert set(names()) == {1, 2}, names()


def test_choices_of_the_user_stay():
    hexes = mesh()
    view = show(hexes)
    table = simple.GetColorTransferFunction("MaterialId")
    table.Annotations = ["1", "steel", "2", "plate"]
    table.IndexedColors = [1, 0, 0, 0, 1, 0]
    hexes.MeshVoid = 1
    view.Update()
    assert names() == {0: "Void", 1: "steel", 2: "plate"}, names()
    assert colours()[1] == [1, 0, 0] and colours()[2] == [0, 1, 0], colours()
    table.InterpretValuesAsCategories = 0
    hexes.MeshVoid = 0
    view.Update()
    assert names() is None


def test_saved_states():
    """Names of the user and of the plugin are restored; a new material gets a name."""
    shapes = VolumeFractionShapes(Dimensions=[12, 12, 12])
    hexes = VolumeFractionToHex(Input=shapes, VolumeFractionArrays=["Material1", "Material2"],
                                StairStep=1)
    show(hexes)
    simple.GetColorTransferFunction("MaterialId").Annotations = ["1", "steel", "2", "Material2"]
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "state.pvsm")
        simple.SaveState(path)
        forget()
        simple.LoadState(path)
    hexes = next(proxy for (name, _), proxy in simple.GetSources().items() if "ToHex" in name)
    view = simple.GetViews()[0]
    view.Update()
    assert names() == {1: "steel", 2: "Material2"}, names()
    hexes.MeshVoid = 1
    view.Update()
    assert names() == {0: "Void", 1: "steel", 2: "Material2"}, names()


def test_a_colour_map_of_the_user_stays():
    table = simple.GetColorTransferFunction("MaterialId")
    table.ApplyPreset("Black-Body Radiation", True)
    show(mesh())
    assert names() is None and not table.Annotations


def test_a_palette_of_the_user_stays():
    table = simple.GetColorTransferFunction("MaterialId")
    table.ApplyPreset("KAAMS", True)
    palette = np.reshape(table.IndexedColors, (-1, 3)).tolist()
    show(mesh())
    assert names() == {1: "ball", 2: "plate"}, names()
    assert list(colours().values()) == palette[:2] and len(table.IndexedColors) == 3 * len(palette)


def test_many_labels_are_numbers():
    """Many labels are shown as numbers, from the start or after a change."""
    many = np.arange(1, 12**3 + 1).reshape(12, 12, 12)
    grid = producer(image({"many": many, "few": many % 5}))
    hexes = VolumeFractionToHex(Input=grid, MaterialIdArray="many", StairStep=1)
    show(hexes)
    assert names() is None
    forget()
    grid = producer(image({"many": many, "few": many % 5}))
    hexes = VolumeFractionToHex(Input=grid, MaterialIdArray="few", StairStep=1)
    view = show(hexes)
    assert set(names()) == {1, 2, 3, 4}, names()
    hexes.MaterialIdArray = "many"
    view.Update()
    assert names() is None


def test_separate_colour_maps():
    """Two meshes with different names of an id have separate colour maps."""
    view = simple.CreateRenderView()
    for arrays in (["ball"], ["plate"]):
        hexes = mesh()
        hexes.VolumeFractionArrays = arrays
        display = simple.Show(hexes, view)
        simple.ColorBy(display, ("CELLS", "MaterialId"), separate=True)
        assert list(display.LookupTable.Annotations) == ["1",
                                                         arrays[0]], list(
                                                             display.LookupTable.Annotations)


def test_other_data():
    view = simple.CreateRenderView()
    simple.ColorBy(simple.Show(simple.Wavelet(), view), ("POINTS", "RTData"))
    assert names("RTData") is None


def test_particles_are_round():
    """Particles are shown as spheres of Point Gaussian, the mesh with its surface."""
    ball = BALL.copy()
    ball[-1, -1, -1] = 0.3
    made = VolumeFractionToHex(Input=producer(image({"ball": ball, "plate": 0 * PLATE})),
                               VolumeFractionArrays=["ball", "plate"], StairStep=1,
                               UnmeshedMaterial="Particles")
    view = simple.CreateRenderView()
    shown = [str(simple.Show(simple.OutputPort(made, port), view).Representation).strip("'")
             for port in (0, 6)]
    assert shown == ["Surface", "Point Gaussian"], shown


def run_afresh(test):
    return lambda: (forget(), test())


main({name: run_afresh(test) for name, test in list(globals().items()) if name.startswith("test_")})
