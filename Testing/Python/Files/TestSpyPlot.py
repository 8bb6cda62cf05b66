"""SpyPlot files (.spcth) with ParaView's reader, step by step, and with `sculptor`."""
import os
import struct
import subprocess

import numpy as np
from paraview import simple

from compare_meshes import difference, merge, read_pieces
from sculptor_program import mesh_file, refused, sculptor
from spyplot import GROUP, Fields, header, split, write_spyplot
from spyplot_cases import (
    LAYOUTS, NODES, SPY, STATE, TIMES, UNEVEN_NODES, data_of_step, refined_blocks, steps,
    without_reader_fields)
from vfmtest import (
    VolumeFractionToHex, VolumeFractionToTet, collect, image, in_folder, main, mesh_of, uniform)

HERE = os.path.dirname(os.path.abspath(__file__))
IMPACT = os.path.join(HERE, "..", "..", "..", "Data", "impact.spcth")
IMPACT_SIZES = [3161, 3144, 3195, 3378]  # numbers of elements at the four times
SERIES = os.path.join(HERE, "..", "..", "..", "Examples", "mesh_series.py")


def open_case(path, to_bytes=False):
    reader = simple.OpenDataFile(path)
    reader.CellArrays = [*SPY, *({STATE} & set(reader.CellArrays.Available))]
    if not to_bytes:
        reader.DownConvertVolumeFraction = 0
    return reader


def mesh_of_step(step, make=None, nodes=None, to_bytes=False, **properties):
    return mesh_of(data_of_step(step, nodes, to_bytes), make, VolumeFractionArrays=SPY,
                   **properties).mesh


def check_equal(mesh, reference, what):
    problem = difference(merge([without_reader_fields(mesh)]),
                         merge([without_reader_fields(reference)]))
    assert not problem, "%s: %s" % (what, problem)


def check_output(output, reference):
    problem = difference(merge([without_reader_fields(piece) for piece in read_pieces(output)]),
                         merge([reference]))
    assert not problem, "%s: %s" % (output, problem)


@in_folder
def test_reader_into_filters(at):
    """Each time gives the mesh of an image, for each layout of blocks and files."""
    for to_bytes in (True, False):
        meshes = [mesh_of_step(step, to_bytes=to_bytes, StateArrays=[STATE]) for step in (0, 1)]
        assert difference(merge(meshes[:1]), merge(meshes[1:]))
        for counts, files in LAYOUTS:
            path = write_spyplot(at(""), "case", TIMES, split(NODES, steps(), counts), files)
            hexes = VolumeFractionToHex(Input=open_case(path, to_bytes), VolumeFractionArrays=SPY,
                                        StateArrays=[STATE])
            errors, warnings = collect(hexes.GetClientSideObject())
            for step in (1, 0, 1):
                hexes.UpdatePipeline(TIMES[step])
                check_equal(hexes.GetClientSideObject().GetOutputDataObject(0), meshes[step],
                            (to_bytes, counts, files, step))
            assert not errors and not warnings, (errors, warnings)


@in_folder
def test_reader_into_tets(at):
    """Tetrahedra are the same as for images and rectilinear grids."""
    lattice = dict(Method="Lattice", make=VolumeFractionToTet)
    for nodes, counts, files in ((UNEVEN_NODES, (2, 1, 2), 4), (NODES, (2, 1, 2), 2)):
        path = write_spyplot(at(""), "case", TIMES, split(nodes, steps(), counts), files)
        tets = VolumeFractionToTet(Input=open_case(path), VolumeFractionArrays=SPY,
                                   Method="Lattice")
        tets.UpdatePipeline(TIMES[1])
        check_equal(tets.GetClientSideObject().GetOutputDataObject(0),
                    mesh_of_step(1, nodes=nodes, **lattice), files)


@in_folder
def test_reader_refined(at):
    """Fine blocks that repeat the coarse cells give the mesh of halved cells."""
    for step in (0, 1):
        hexes = VolumeFractionToHex(
            Input=open_case(write_spyplot(at(""), "refined", TIMES, refined_blocks())),
            VolumeFractionArrays=SPY, StateArrays=[STATE], ChildFractions="Parent", **uniform(-1))
        hexes.UpdatePipeline(TIMES[step])
        check_equal(hexes.GetClientSideObject().GetOutputDataObject(0),
                    mesh_of_step(step, StateArrays=[STATE], ChildFractions="Parent", **uniform(1)),
                    step)


def impact_mesh(time):
    """Returns the mesh of one time, from a reader that has read no other time."""
    hexes = VolumeFractionToHex(Input=open_case(IMPACT), VolumeFractionArrays=SPY)
    hexes.UpdatePipeline(time)
    return hexes.GetClientSideObject().GetOutputDataObject(0)


def impact_times():
    return list(open_case(IMPACT).TimestepValues)


def test_time_controls():
    """Time controls of the GUI give the mesh of each time.

    The animation scene is what the buttons change; a spreadsheet view needs no screen.
    """
    for source in simple.GetSources().values():  # The scene would include their times.
        simple.Delete(source)
    meshes = [impact_mesh(time) for time in impact_times()]
    sizes = [mesh.GetNumberOfCells() for mesh in meshes]
    assert sizes == IMPACT_SIZES, sizes
    hexes = VolumeFractionToHex(Input=open_case(IMPACT), VolumeFractionArrays=SPY)
    simple.Show(hexes, simple.CreateView("SpreadSheetView"))
    scene = simple.GetAnimationScene()
    scene.UpdateAnimationUsingDataTimeSteps()
    assert list(scene.TimeKeeper.TimestepValues) == impact_times()
    for move, step in (("GoToFirst", 0), ("GoToNext", 1), ("GoToNext", 2), ("GoToLast", 3),
                       ("GoToPrevious", 2), ("GoToFirst", 0), ("Play", 3)):
        getattr(scene, move)()
        check_equal(hexes.GetClientSideObject().GetOutputDataObject(0), meshes[step], move)


@in_folder
def test_series_script(at):
    """Examples/mesh_series.py writes the mesh of each time and of selected arrays."""
    command = ["pvbatch", SERIES, "--plugin", os.environ["VFM_PLUGIN"]]
    run = lambda *options: subprocess.run(
        command + list(options), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    result = run("--out", at("all"), IMPACT)
    assert result.returncode == 0 and result.stdout.count(" elements") == 4, result
    for step, time in enumerate(impact_times()):
        check_equal(read_pieces(at("all/mesh_%04d.vtu" % step))[0], impact_mesh(time), step)
    result = run("--out", at("ball"), "--array", SPY[0], IMPACT)
    assert result.returncode == 0 and result.stdout.count(SPY[0]) == 4 and SPY[
        1] not in result.stdout, result


@in_folder
def test_sculptor_series(at):
    """sculptor meshes each time step on 1 to 3 ranks."""
    for step, time in enumerate(impact_times()):
        # At the last time, the ball begins to break.
        note = {"note": "1 material has more than 5 % of its volume in another place"}
        mesh_file(IMPACT, at("out.vtu"), "--step", str(step), ranks=1 + step % 3,
                  **(note if step == 3 else {}))
        check_output(at("out.vtu"), without_reader_fields(impact_mesh(time)))


@in_folder
def test_sculptor_blocks(at):
    """sculptor reads blocks of each version of the format, on ranks, and refined blocks."""
    meshes = [mesh_of_step(step, StateArrays=[STATE]) for step in (0, 1)]
    for counts, files, version, ranks in (
            ((2, 1, 2), 1, 105, 1), ((2, 1, 2), 2, 103, 3), ((2, 1, 2), 4, 101, 2),
            ((1, 1, 1), 1, 102, 3)):
        path = write_spyplot(at(""), "blocks", TIMES, split(NODES, steps(), counts), files, version)
        for arguments, step in (([], 0), (["--step", "1"], 1), (["--time", "1.5e-6"], 1)):
            text = mesh_file(path, at("out.vtu"), "--state", STATE, *arguments, ranks=ranks)
            assert "time %g\n" % TIMES[step] in text
            check_output(at("out.vtu"), meshes[step])
    assert sculptor("--input", "blocks.spcth", "--output", "near.vtu",
                    folder=at("")).returncode == 0
    refused(2, "no step 2: it has 2", "--input", path, "--output", at("no.vtu"), "--step", "2",
            ranks=2)
    path = write_spyplot(at(""), "refined", TIMES, refined_blocks())
    settings = ["Refinement=Uniform", "ChildFractions=Parent"]
    for ranks in (1, 3):
        mesh_file(path, at("out.vtu"), "--set", *settings, ranks=ranks)
        check_output(at("out.vtu"), mesh_of_step(0, ChildFractions="Parent", **uniform(1)))


@in_folder
def test_sculptor_flat_mesh(at):
    """sculptor reads flat meshes with arbitrary node coordinates."""
    for counts, files, ranks in (((1, 1, 1), 1, 2), ((2, 1, 2), 4, 1), ((2, 1, 2), 4, 3)):
        path = write_spyplot(at(""), "flat", TIMES, split(UNEVEN_NODES, steps(), counts), files)
        mesh_file(path, at("out.vtu"), ranks=ranks)
        check_output(at("out.vtu"), mesh_of_step(0, nodes=UNEVEN_NODES))


@in_folder
def test_sculptor_conserves_state(at):
    """Densities per material and a velocity in components are conserved as by the filter."""
    densities = ["Material density - 1", "Material density - 2"]
    step = steps()[1]
    ramp = np.linspace(0, 1, 12, dtype=np.float32)[:, None, None] + 0 * step[SPY[0]]
    step.update({densities[0]: 2 + ramp, densities[1]: 8 - ramp, "Y velocity": 3 * ramp,
                 "Z velocity": 1 - ramp})
    path = write_spyplot(at(""), "state", [0], split(NODES, [step], (2, 1, 2)), 2)
    joined = {**step, "velocity": np.stack([step[axis + " velocity"] for axis in "XYZ"], -1)}
    mesh = mesh_of(image(joined), VolumeFractionArrays=SPY, DensityArrays=densities,
                   VelocityArray="velocity", NodalVelocity=1, EnergyArray="Pressure").mesh
    for ranks, velocity in ((1, "velocity"), (2, "velocity"), (1, "X velocity")):
        out = mesh_file(path, at("out.vtu"), "--density", ",".join(densities), "--velocity",
                        velocity, "--energy", "Pressure", "--nodal-velocity", ranks=ranks)
        assert "materials from %s, %s (" % tuple(SPY) in out and "momentum z" in out, out
        check_output(at("out.vtu"), mesh)
    assert mesh.GetCellData().HasArray("Material density") and mesh.GetPointData().HasArray(
        "velocity")


@in_folder
def test_sculptor_newer_names(at):
    """The newer names of volume fractions are recognized."""
    names = dict(zip(SPY, ("Volume Fraction - 1", "Volume Fraction - 2")))
    renamed = [{names.get(name, name): value for name, value in step.items()} for step in steps()]
    path = write_spyplot(at(""), "names", TIMES, split(NODES, renamed))
    assert "materials from Volume Fraction - 1, Volume Fraction - 2 (" in mesh_file(
        path, at("out.vtu"))


def write_small(at, files=1, version=105, change=None, times=TIMES):
    """Writes two blocks of 4 x 4 x 6 cells per file; returns the path and the blocks.

    change(steps) may alter the arrays.
    """
    small = [{name: value[:6, 4:8, 4:8] for name, value in step.items()}
             for step in steps()][:len(times)]
    if change:
        change(small)
    blocks = split([x[:n] for x, n in zip(NODES, (5, 5, 7))], small, (1, 1, 2 * files))
    return write_spyplot(at(""), "case", times, blocks, files, version), blocks


def landmarks(content, blocks, version=105):
    """Returns the positions of the parts of a file of write_small()."""
    fields = Fields(list(blocks[0].steps[0]))
    at = {"tables": len(header(version, blocks, fields, 0, 1))}
    at["groups"] = at["tables"] + len(fields.tables(version))
    at["group"] = at["groups"] + 8
    at["dump"] = int(struct.unpack_from(">d", content, at["group"] + 4 + GROUP * (4 + 8 + 8))[0])
    count = struct.unpack_from(">i", content, at["dump"])[0]
    at["offsets"] = at["dump"] + 4 + 4 * count
    at["tracers"] = at["offsets"] + 8 * count
    at["blocks"] = at["tracers"] + 8
    at["grids"] = at["blocks"] + 4 + 3 * 48  # one block is unused
    at["fields"] = [int(x) for x in struct.unpack_from(">%dd" % count, content, at["offsets"])]
    return at


def int_at(position, value):
    return lambda content: content[:position] + struct.pack(">i", value) + content[position + 4:]


def double_at(position, value):
    return lambda content: content[:position] + struct.pack(">d", value) + content[position + 8:]


def cut_at(position):
    return lambda content: content[:position]


@in_folder
def test_damaged_files(at):
    """Each damage gives one message with the file, the place and the problem."""
    path, blocks = write_small(at)
    with open(path + ".0", "rb") as file:
        content = file.read()
    mark = landmarks(content, blocks)
    volume = mark["fields"][1]  # fractions of the first material, whose first planes are all 0
    cases = [
        (cut_at(0), "header near byte 0: 8 bytes should follow, the file has 0"),
        (cut_at(5), "header near byte 0"),
        (cut_at(100), "header near byte 8: 128 bytes"),
        (cut_at(mark["tables"] - 3), "the header"),
        (cut_at(mark["tables"] + 70), "the tables of arrays"),
        (cut_at(mark["group"] - 1), "the list of times"),
        (cut_at(mark["group"] + 900), "the list of times"),
        (cut_at(mark["dump"]), "the list of times"),
        # the data of the second time come later
        (cut_at(mark["offsets"] + 4), "it points to byte"),
        (int_at(mark["tables"], 2 ** 30), "the tables of arrays"),
        (double_at(mark["groups"], 1e300), "points to byte"),
        (double_at(mark["groups"], -8.0), "points to byte"),
        (double_at(mark["groups"], float("nan")), "points to byte"),
        (double_at(mark["groups"], 8.0), "it points back"),
        (int_at(mark["group"], -1), "-1 times"),
        (int_at(mark["group"], 101), "101 times"),
        (int_at(mark["group"], 0), "holds no times"),
        (double_at(mark["group"] + 404, float("inf")), "a time is not finite"),
        (int_at(mark["dump"], 0), "has 0 arrays"),
        (int_at(mark["dump"], 2 ** 31 - 1), "step 0"),
        (int_at(mark["dump"] + 4, 777), "there is no array 777"),
        (int_at(mark["dump"] + 8, 102), "other arrays in step 1 than in step 0"),
        (double_at(mark["offsets"], 1e9), "points to byte 1000000000"),
        (int_at(mark["tracers"], 5), "step 0"),
        (int_at(mark["tracers"] + 4, 2 ** 30), "step 0"),
        (int_at(mark["blocks"], 2), "it has 2 blocks, the header 3"),
        (int_at(mark["blocks"] + 52, -5), "block 1 has -5 x 6 x 5 cells"),
        (int_at(mark["blocks"] + 52, 7), "does not hold 8 values"),
        (int_at(mark["blocks"] + 72, 2 ** 30), "on level 1073741824"),
        (int_at(mark["grids"], -1), "-1 bytes should follow"),
        (int_at(mark["grids"], 2 ** 31 - 1), "2147483647 bytes should follow"),
        (int_at(mark["grids"], 7), "a chunk of 7 bytes does not hold"),
        (int_at(volume, 2 ** 31 - 1),
         "'Material volume fraction - 1' of step 0, block 1, plane 0 near"),
        (int_at(volume, -1), "'Material volume fraction - 1' of step 0, block 1, plane 0 near"),
        (int_at(volume, 4), "a chunk of 4 bytes does not hold 36 values"),
        (int_at(136, 100), "is of version 100 of the format. Versions 101 to 105 are supported"),
        (int_at(136, 106), "is of version 106 of the format"),
        (int_at(140, 16), "file positions have 16 bits"),
        (int_at(160, 2), "has 2 dimensions"),
        (int_at(mark["tables"] - 28, 1), "has markers of materials"),
        (lambda content: b"garbage" + content[7:], "is not a SpyPlot file"),
    ]
    for number, (change, text) in enumerate(cases):
        with open(path + ".0", "wb") as file:
            file.write(change(content))
        refused(2, text, "--input", path, "--output", at("no.vtu"), ranks=1 + number % 5 // 4)


@in_folder
def test_cut_in_last_time(at):
    """Truncation at any place of the last time is reported with step, block and plane."""
    path, blocks = write_small(at, times=TIMES[:1])
    with open(path + ".0", "rb") as file:
        content = file.read()
    mark = landmarks(content, blocks)
    places = [(mark[name] + more, "step 0 near") for name, more in (
        ("dump", 2), ("offsets", -4), ("offsets", 0), ("tracers", 4), ("blocks", 3), ("blocks", 70),
        ("grids", 0), ("grids", 9))]
    last = mark["fields"][3]
    places += [(mark["fields"][1] + 2, "it points to byte"), (last, "it points to byte"),
               (last + 3, "'X velocity' of step 0, block 1, plane 0 near"),
               ((last + len(content)) // 2, "'X velocity' of step 0, block "),
               (len(content), "'X velocity' of step 0, block 2, plane 4 near")]
    for number, (place, text) in enumerate(places):
        with open(path + ".0", "wb") as file:
            file.write(content[:place - 1])
        refused(2, text, "--input", path, "--output", at("no.vtu"), "--state", STATE,
                ranks=1 + number % 2)
    mesh_file(path, at("out.vtu"))  # Data that are not read may be missing.


@in_folder
def test_damaged_cases(at):
    """Damaged case files, missing parts and parts that disagree are reported."""
    for change, text in (
            (lambda: os.truncate(path + ".2", os.path.getsize(path + ".2") // 2),
             "case.spcth.2 is truncated or damaged"),
            (lambda: os.remove(path + ".1"), "case.spcth.1 cannot be read: No such file"),
            (lambda: (os.remove(path + ".1"), os.mkdir(path + ".1")),
             "case.spcth.1 cannot be read: Is a directory"),
            (lambda: write_text(path, "spycase\n  \n"), "it lists no files"),
            (lambda: write_text(path, "spycase\n"), "it lists no files"),
            (lambda: write_text(path, "no case\n"), "it is not a SpyPlot file"),
            (lambda: write_text(path, ""), "the file is empty")):
        path, _ = write_small(at, files=3)
        change()
        for ranks in (1, 2):
            refused(2, text, "--input", path, "--output", at("no.vtu"), ranks=ranks)
        if os.path.isdir(path + ".1"):
            os.rmdir(path + ".1")
    for text, other in (("different times", dict(times=TIMES[:1])),
                        ("different times", dict(times=[0, 3e-6])),
                        ("different arrays",
                         dict(change=lambda steps: [step.pop("Pressure") for step in steps]))):
        write_small(at, files=2, **other)
        os.rename(path + ".1", at("other"))
        write_small(at, files=2)
        os.rename(at("other"), path + ".1")
        for ranks in (1, 2):
            refused(2, "its files hold " + text, "--input", path, "--output", at("no.vtu"),
                    ranks=ranks)


def write_text(path, text):
    with open(path, "w", encoding="ascii") as file:
        file.write(text)


main(globals())
