"""AMR files of other codes through ParaView's readers.

The same data in five formats gives the same mesh; meshes of Gerris and AMReX runs keep the volumes.
"""
import importlib.util
import os
import subprocess

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkNonOverlappingAMR

from amr_files import (
    SPACING, Amr, make_amr, spyplot_blocks, vtk_amr, write_enzo, write_flash, write_plotfile,
    write_vthb)
from compare_meshes import difference, merge, read_pieces
from sculptor_program import mesh_file
from spyplot import write_file, write_spyplot
from spyplot_cases import without_reader_fields
from vfmtest import (
    PYTHON, Result, VolumeFractionToHex, VolumeFractionToTet, collect, digest, in_folder, main,
    mesh_of, simple)

HERE = os.path.dirname(os.path.abspath(__file__))
DATA = os.path.join(HERE, "..", "..", "..", "Data")
EXAMPLES = os.path.join(HERE, "..", "..", "..", "Examples")
FRACTIONS = ["ball", "rest"]
SPY = ["Material volume fraction - 1", "Material volume fraction - 2"]
AMR = make_amr()
HAS_H5PY = importlib.util.find_spec("h5py") is not None
MODES = ("Off", "Input Levels", "Uniform")


def read_vthb(path):
    reader = simple.XMLUniformGridAMRReader(FileName=[path])
    reader.DefaultNumberOfLevels = 0  # all levels
    return reader


def read_levels(kind, path, arrays=FRACTIONS, level=100):
    reader = kind(FileNames=[path])
    reader.Level, reader.CellArrayStatus = level, arrays
    return reader


def read_spyplot(path):
    reader = simple.OpenDataFile(path)
    reader.CellArrays = SPY
    reader.DownConvertVolumeFraction = 0
    return reader


def readers(at):
    """Yields format, reader and names of the fractions of the same data in each format."""
    yield "overlapping", read_vthb(write_vthb(at("o.vthb"), AMR)), FRACTIONS
    yield "leaves", read_vthb(write_vthb(at("n.vthb"), AMR, vtkNonOverlappingAMR)), FRACTIONS
    yield "AMReX", read_levels(simple.AMReXBoxLibGridReader,
                               write_plotfile(at("plt00000"), AMR)), FRACTIONS
    for files in (1, 3):
        yield "SpyPlot", read_spyplot(write_spyplot(at(""), "spy%d" % files, [0.0],
                                                    spyplot_blocks(AMR), files)), SPY
    if HAS_H5PY:
        yield "Enzo", read_levels(simple.EnzoReader, write_enzo(at("enzo"), AMR)), FRACTIONS
        yield "FLASH", read_levels(simple.FlashReader, write_flash(at("run.flash"), AMR)), FRACTIONS
    else:
        print("Enzo and FLASH are left out: no h5py")


def mesh_from(source, arrays, make=None, **properties):
    mesher = (make or VolumeFractionToHex)(Input=source, VolumeFractionArrays=arrays, **properties)
    messages = collect(mesher.GetClientSideObject())
    mesher.UpdatePipeline()
    return Result(mesher.GetClientSideObject(), *messages)


def check_volumes(result, expected, places=1e-6):
    assert not result.errors, result.errors
    assert np.allclose(result.field("TargetVolume"), expected,
                       rtol=places), (result.field("TargetVolume"), expected)
    assert np.allclose(result.field("MeshVolume"), expected,
                       rtol=places), (result.field("MeshVolume"), expected)


def volumes_of(amr):
    cell = np.prod(SPACING)
    return [cell * sum(block.arrays[name].sum() for block in amr.of_level(0)) for name in FRACTIONS]


@in_folder
def test_same_mesh_of_all_formats(at):
    """All formats give the same mesh, with each kind of refinement."""
    sources = list(readers(at))
    assert len(sources) == (7 if HAS_H5PY else 5)
    sizes = []
    for mode in MODES:
        reference = mesh_of(vtk_amr(AMR), VolumeFractionArrays=FRACTIONS, Refinement=mode)
        check_volumes(reference, volumes_of(AMR))
        sizes.append(reference.mesh.GetNumberOfCells())
        for name, source, arrays in sources:
            result = mesh_from(source, arrays, Refinement=mode)
            check_volumes(result, volumes_of(AMR))
            assert digest(result) == digest(reference), (mode, name)
    assert sizes[0] < sizes[1] < sizes[2], sizes  # coarsest, refined at the ball, all fine


def check_sculptor(at, amr, paths):
    for mode, all_ranks in (("Input Levels", (1, 3)), ("Off", (2,))):
        reference = mesh_of(vtk_amr(amr), VolumeFractionArrays=FRACTIONS, Refinement=mode)
        for path in paths:
            for ranks in all_ranks:
                mesh_file(path, at("out.vtu"), "--set", "Refinement=" + mode.replace(" ", ""),
                          ranks=ranks)
                meshes = [without_reader_fields(mesh)
                          for mesh in (*read_pieces(at("out.vtu")), reference.mesh)]
                for mesh in meshes:
                    mesh.GetFieldData().RemoveArray("MaterialNames")
                problem = difference(merge(meshes[:1]), merge(meshes[1:]))
                assert not problem, (path, mode, ranks, problem)


@in_folder
def test_sculptor(at):
    """sculptor reads the same files on any number of ranks."""
    amr = make_amr(levels=2)
    paths = [write_vthb(at("o.vthb"), amr), write_vthb(at("n.vthb"), amr, vtkNonOverlappingAMR),
             write_plotfile(at("plt00000"), amr)]
    check_sculptor(at, amr, paths)


@in_folder
def test_sculptor_spyplot(at):
    """sculptor reads SpyPlot files whose parts hold different kinds of blocks."""
    amr = make_amr(levels=2)
    blocks = spyplot_blocks(amr)
    path = write_spyplot(at(""), "spy", [0.0], blocks, 3)
    check_sculptor(at, amr, [path])
    # ParaView's reader supports only one kind per case.
    for kinds in ((blocks[:1], blocks[1:]), (blocks[:-1], blocks[-1:])):
        write_spyplot(at(""), "spy", [0.0], blocks, 2)
        for file in (0, 1):
            write_file(at("spy.spcth.%d" % file), 105, [0.0], kinds[file], file, 2)
        check_sculptor(at, amr, [path])


@in_folder
def test_tets(at):
    """Tetrahedra of all formats have equal volumes and are identical."""
    reference = None
    for name, source, arrays in list(readers(at))[:3]:
        result = mesh_from(source, arrays, VolumeFractionToTet, Method="Lattice",
                           Refinement="Uniform")
        check_volumes(result, volumes_of(AMR))
        reference = reference or digest(result)
        assert digest(result) == reference, name


@in_folder
def test_ratio_four(at):
    """Levels with ratio 4 give the mesh of the VTK data set."""
    amr = make_amr(2, 4, (2, 2, 2))
    source = read_levels(simple.AMReXBoxLibGridReader, write_plotfile(at("plt4"), amr))
    for mode in MODES:
        result = mesh_from(source, FRACTIONS, Refinement=mode)
        check_volumes(result, volumes_of(amr))
        assert digest(result) == digest(mesh_of(vtk_amr(amr), VolumeFractionArrays=FRACTIONS,
                                                Refinement=mode)), mode


@in_folder
def test_levels_of_the_reader(at):
    """Levels that the reader omits are not needed: only the given blocks count."""
    folder = write_plotfile(at("plt00000"), AMR)
    for level in (0, 1):
        result = mesh_from(read_levels(simple.AMReXBoxLibGridReader, folder, level=level),
                           FRACTIONS, Refinement="Uniform")
        check_volumes(result, volumes_of(AMR))
        known = Amr([block for block in AMR.blocks if block.level <= level], 2, level + 1,
                    AMR.roots)
        reference = mesh_of(vtk_amr(known), VolumeFractionArrays=FRACTIONS, Refinement="Uniform")
        assert digest(result) == digest(reference), level
    # the initial state: no array is selected
    result = mesh_from(simple.OpenDataFile(folder), FRACTIONS)
    assert len(result.errors) == 1 and "no numeric cell array 'ball'" in result.errors[
        0], result.errors


def test_amrex_run():
    """A ball in a vortex; the numerical scheme exceeds [0, 1] slightly."""
    exact = 0.01413679
    source = read_levels(simple.AMReXBoxLibGridReader, os.path.join(DATA, "AMReX", "plt00000"),
                         ["phi"])
    for mode in MODES:
        result = mesh_from(source, ["phi"], Refinement=mode)
        check_volumes(result, [exact], 1e-5)
        assert np.isclose(exact, 4 / 3 * np.pi * 0.15 ** 3, rtol=1e-3)
    source = read_levels(simple.AMReXBoxLibGridReader, os.path.join(DATA, "AMReX", "plt00011"),
                         ["phi"])
    result = mesh_from(source, ["phi"])
    assert len(result.errors) == 1 and "phi" in result.errors[0], result.errors
    clipped = simple.Calculator(Input=source, AttributeType="Cell Data", ResultArrayName="clipped",
                                Function="min(max(phi,0),1)")
    for mode in MODES:
        result = mesh_from(clipped, ["clipped"], Refinement=mode)
        check_volumes(result, result.field("TargetVolume"))
        assert np.isclose(result.field("TargetVolume")[0], exact,
                          rtol=0.01), result.field("TargetVolume")
        own = mesh_from(source, ["phi"], Refinement=mode, FractionTolerance=0.02)
        assert own.field("ClippedCells")[0] > 0 and np.isclose(
            own.field("TargetVolume"), result.field("TargetVolume"), rtol=1e-6), mode


@in_folder
def test_gerris_run(at):
    """A drop that has fallen into a pool, on an octree of cells."""
    command = [PYTHON[0], os.path.join(EXAMPLES, "gerris_to_vthb.py"),
               os.path.join(DATA, "Gerris", "impact_0.24.txt.gz")]
    run = subprocess.run(command + [at("drop.vthb")], stdout=subprocess.PIPE,
                         stderr=subprocess.STDOUT, text=True)
    assert run.returncode == 0 and "level 3: cells of 0.015625, 20480 leaves" in run.stdout, run
    sizes = []
    for mode in MODES:
        result = mesh_from(read_vthb(at("drop.vthb")), ["T"], Refinement=mode)
        check_volumes(result, [0.314048])
        sizes.append(result.mesh.GetNumberOfCells())
    print("elements of the drop:", dict(zip(MODES, sizes)))
    # Families refine single cells of the octree.
    assert sizes[0] < sizes[1] < 0.6 * sizes[2], sizes
    run = subprocess.run(command[:2] + [os.path.join(DATA, "README.md"), at("no.vthb")],
                         stderr=subprocess.PIPE, text=True)
    assert run.returncode == 1 and "has no cells of Gerris in three dimensions" in run.stderr, run


main(globals())
