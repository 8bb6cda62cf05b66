"""Writers that ParaView selects by file extension.

Meshes go to the writers of the plugin, other data to ParaView's writers as without the plugin.

usage: pvpython TestSaving.py
       pvpython TestSaving.py NAMES

The second form runs without the plugin. It writes to NAMES
which writer ParaView selects for OTHERS, for each of ENDS.
"""
import json
import os
import subprocess
import sys

from paraview import servermanager, simple

EXODUS = ["e", "ex2", "exo"]  # extensions of the plugin's writer
ENDS = EXODUS + ["g", "vtu", "csv"]
SIZE = 8
OTHERS = {
    "image": lambda: simple.Wavelet(WholeExtent=[0, 2] * 3),
    "tetrahedra": lambda: simple.Tetrahedralize(Input=simple.Wavelet(WholeExtent=[0, 2] * 3)),
    "surface": lambda: simple.Sphere(),
}


def factory():
    it = servermanager.vtkSMProxyManager.GetProxyManager().GetWriterFactory()
    it.UpdateAvailableWriters()
    return it


def kinds_of(source):
    """Returns [description, extensions] of each file type, in the order of the GUI."""
    source.UpdatePipeline()
    listed = factory().GetSupportedFileTypes(source.SMProxy, source.Port).split(";;")
    return [[kind.split("(")[0], kind.split("(")[1][:-1].replace("*.", "").split()]
            for kind in listed]


def writers_of(source):
    """Returns {extension: name of the writer} for the extensions that some writer supports."""
    ends = {end for _, ends in kinds_of(source) for end in ends}
    return {end: simple.CreateWriter("file." + end, source).GetXMLName() for end in ENDS
            if end in ends}


def writers_of_others():
    return {name: writers_of(make()) for name, make in OTHERS.items()}


if len(sys.argv) == 2:
    with open(sys.argv[1], "w") as names:
        json.dump(writers_of_others(), names)
    sys.exit()

from exodus_dump import Dump
from exodus_of_mesh import check
from vfmtest import (
    collect, failure_of, fraction_image, in_folder, main, producer, save_data, VolumeFractionToHex,
    VolumeFractionToTet)


def mesher_of(make=VolumeFractionToHex, **properties):
    return make(Input=producer(fraction_image(SIZE)),
                **{"VolumeFractionArrays": ["ball", "plate"], **properties})


@in_folder
def test_meshes_by_the_ends_of_exodus(at):
    """Meshes saved with an Exodus extension hold the sets of the plugin's writer."""
    for make, properties in ((VolumeFractionToHex, {}),
                             (VolumeFractionToTet, {"Method": "Lattice"})):
        mesher = mesher_of(make, **properties)
        for end in EXODUS:
            simple.SaveData(at("mesh." + end), proxy=mesher)
            check([Dump(at("mesh." + end))], mesher.GetClientSideObject().GetOutputDataObject(0))


@in_folder
def test_a_mesh_for_abaqus(at):
    """A mesh saved as .inp has elements, surfaces and node sets."""
    simple.SaveData(at("mesh.inp"), proxy=mesher_of())
    with open(at("mesh.inp")) as file:
        text = file.read()
    assert all(word in text for word in ("C3D8", "BALL_TO_PLATE", "X_MIN")), text[:1000]


@in_folder
def test_a_mesh_saved_before_and_part_of_one(at):
    """A mesh read from a file and a part of a mesh are saved by the plugin as well."""
    mesher = mesher_of()
    save_data(at("mesh.vtu"), mesher)
    part = simple.Threshold(Input=mesher, Scalars=["CELLS", "MaterialId"], LowerThreshold=1,
                            UpperThreshold=1)
    for source in (simple.OpenDataFile(at("mesh.vtu")), part):
        assert {writers_of(source)[end] for end in EXODUS} == {"ExodusAndSetsWriter"}
    simple.SaveData(at("part.exo"), proxy=part)
    assert Dump(at("part.exo")).names("eb") == ["ball"]


@in_folder
def test_others_by_their_own_writers(at):
    """Other data use the writers of a ParaView without the plugin.

    A clipped mesh is such data: it has other elements and no point ids.
    """
    variables = {name: value for name, value in os.environ.items() if name != "PV_PLUGIN_PATH"}
    subprocess.run(["pvpython", os.path.abspath(__file__), at("names")], env=variables, check=True,
                   stdin=subprocess.DEVNULL)
    with open(at("names")) as file:
        wanted = json.load(file)
    assert set(wanted) == set(OTHERS) and "e" in wanted["tetrahedra"], wanted
    assert writers_of_others() == wanted
    cut = simple.Clip(Input=mesher_of())
    cut.ClipType.Normal = [1.0, 1.0, 1.0]
    assert writers_of(cut) == wanted["tetrahedra"], writers_of(cut)


@in_folder
def test_others_are_saved(at):
    """Other data saved as .e contain nothing of the plugin."""
    other = OTHERS["tetrahedra"]()
    simple.SaveData(at("other.e"), proxy=other)
    dump = Dump(at("other.e"))
    assert dump.size("num_elem") == other.GetDataInformation().GetNumberOfCells() > 0, dump.sizes
    assert "VolumeFractionMesh" not in list(dump.get("qa_records")) and not dump.size(
        "num_side_sets")


def test_the_window_offers_ours_first():
    """The plugin's file type is listed first, because newer ParaViews use the selected type."""
    kinds = kinds_of(mesher_of())
    assert ["Exodus and Sets", EXODUS] in kinds and ["Abaqus and CalculiX Input Files",
                                                     ["inp"]] in kinds, kinds
    for end in EXODUS:
        assert [name for name, ends in kinds if end in ends][0] == "Exodus and Sets", kinds
    for make in OTHERS.values():
        assert "Exodus and Sets" not in [name for name, _ in kinds_of(make())]


@in_folder
def test_a_mesh_that_failed_is_refused(at):
    """The writer reports why the mesh could not be made and writes no file."""
    mesher = mesher_of(VolumeFractionArrays=["none"])
    collect(mesher.GetClientSideObject())
    mesher.UpdatePipeline()
    assert failure_of(mesher.GetClientSideObject().GetOutputDataObject(0))
    for end in EXODUS:
        writer = simple.CreateWriter(at("mesh." + end), mesher)
        errors, _ = collect(writer.GetClientSideObject().GetWriter())
        writer.UpdatePipeline()
        assert len(errors) == 1 and "The mesh could not be made: " in errors[0], errors
    assert not os.listdir(at(""))


main(globals())
