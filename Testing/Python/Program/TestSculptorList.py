"""sculptor --list: contents of each kind of input, equal on any number of ranks."""
import os
import re

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet
from vtkmodules.vtkIOParallelXML import vtkXMLPImageDataWriter
from vtkmodules.vtkIOXML import (
    vtkXMLMultiBlockDataWriter, vtkXMLRectilinearGridWriter, vtkXMLUniformGridAMRWriter)

from amr_cases import fields, nested, overlapping
from exodus_grids import fields as exodus_fields
from exodus_grids import hexes, shuffled, write_exodus
from sculptor_program import refused, sculptor
from vfmtest import (
    ORIGIN, SPACING, add_array, ball_and_plate, image, in_folder, labels, main, rectilinear, write)
from voxels import SIZE, grains, write_numpy, write_text

DATA = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..", "Data")
N = 12


def listed(path, *words, ranks=(1, 3)):
    """Returns the printed lines, which must be equal on these numbers of ranks."""
    outputs = []
    for count in ranks:
        result = sculptor("--list", path, *words, ranks=count)
        assert result.returncode == 0 and result.stderr == "", (count, result)
        outputs.append(result.stdout)
    assert len(set(outputs)) == 1, outputs
    assert outputs[0].startswith(path + "\n")
    return outputs[0].splitlines()[1:]


def arrays_of(lines):
    """Returns {name: (type, components, minimum and maximum)}."""
    begin = next(i for i, line in enumerate(lines) if line.startswith("cell array "))
    rows = [re.fullmatch(r"(.*?) {2,}(.*?) {2,}(\d+)(.*)", line)
            for line in lines[begin + 1:lines.index("", begin)]]
    return {row[1]: (row[2], int(row[3]), [float(x) for x in row[4].split()]) for row in rows}


def materials_of(lines):
    """Returns how the materials were found, and one line per material."""
    begin = next(i for i, line in enumerate(lines) if line.startswith("materials"))
    return lines[begin], [line.split(None, 1) for line in lines[begin + 1:] if line.startswith(" ")]


def bounds():
    return "x %g to %g, y %g to %g, z %g to %g" % tuple(x for a in range(3)
                                                        for x in (ORIGIN[a], ORIGIN[
                                                            a] + N * SPACING[a]))


def arrays():
    ball, plate = ball_and_plate(N)
    velocity = np.stack([ball, 2 * ball, plate], axis=3).astype(np.float32)
    return {"ball": ball, "plate": plate, "velocity": velocity, "heat": 300 + 5 * ball}


def check_fractions(lines, more=()):
    assert lines[0] == "no times"
    assert bounds() in lines
    found = arrays_of(lines)
    assert list(found) == ["ball", "plate", *more], found
    assert found["ball"] == ("double", 1, [0, 1])
    head, materials = materials_of(lines)
    assert "all cell arrays with values in [0, 1]" in head and materials == [
        ["1", "ball"], ["2", "plate"]]


@in_folder
def test_images_and_grids(at):
    values = arrays()
    whole = image(values)
    add_array(whole.GetPointData(), "at points", np.zeros((N + 1, N + 1, N + 1)))
    for path in (write(whole, at("image.vti")),
                 write(whole, at("pieces.pvti"), vtkXMLPImageDataWriter, pieces=3)):
        lines = listed(path)
        assert lines[1] == "1728 cells, 12 x 12 x 12"
        check_fractions(lines, ("velocity", "heat"))
        assert arrays_of(lines)["velocity"] == ("float", 3,
                                                []) and arrays_of(lines)["heat"] == (
                                                    "double", 1, [300, 305])
    nodes = [ORIGIN[a] + SPACING[a] * np.arange(N + 1) for a in range(3)]
    grid = rectilinear({name: values[name] for name in ("ball", "plate")}, nodes)
    lines = listed(write(grid, at("grid.vtr"), vtkXMLRectilinearGridWriter))
    assert lines[1] == "1728 cells, 12 x 12 x 12"
    check_fractions(lines)


@in_folder
def test_blocks_and_levels(at):
    values = {name: arrays()[name] for name in ("ball", "plate")}
    blocks = vtkMultiBlockDataSet()
    for i, (span, first) in enumerate(((slice(0, 5), (0, 0, 0)), (slice(5, 12), (5, 0, 0)))):
        blocks.SetBlock(i,
                        image({name: value[:, :, span] for name, value in values.items()}, first))
    lines = listed(write(blocks, at("blocks.vtm"), vtkXMLMultiBlockDataWriter))
    assert lines[1] == "1728 cells" and "2 blocks" in lines
    check_fractions(lines)
    lines = listed(write(overlapping(fields(2), nested()), at("levels.vthb"),
                         vtkXMLUniformGridAMRWriter))
    cells = [216, 10 * 8 * 8 + 16, 12 * 12 * 8]
    assert lines[1] == "%d cells" % sum(cells) and "12 blocks of 3 levels" in lines
    for level, (count, blocks) in enumerate(zip(cells, (8, 3, 1))):
        assert "  level %d: %d block%s, %d cells of %g x %g x %g" % (
            level, blocks, "s"[:blocks - 1], count,
            *(h / 2 ** level for h in SPACING)) in lines, lines


@in_folder
def test_labels(at):
    lines = listed(write(image({"MaterialId": labels(N).astype(np.int32) * 5,
                                "heat": 9 + ball_and_plate(N)[0]}), at("ids.vti")))
    assert materials_of(lines) == (
        "materials from MaterialId (labels, the only array of integers)", [["5"], ["10"]])
    assert arrays_of(lines)["MaterialId"] == ("int", 1, [0, 10])
    cells = grains()
    size = ",".join(map(str, SIZE))
    for lines in (listed(write_text(at("grains.spn"), cells), "--dimensions", size),
                  listed(write_numpy(at("grains.npy"), cells))):
        assert "%d cells, %d x %d x %d" % (np.prod(SIZE), *SIZE) in lines
        assert materials_of(lines)[1] == [[str(i)]
                                          for i in sorted(set(cells.ravel().tolist()) - {0})]


@in_folder
def test_exodus(at):
    cells = shuffled()
    path = write_exodus(at("in.exo"),
                        lambda step: {"left": hexes(exodus_fields(step), cells[:700]),
                                      "right": hexes(exodus_fields(step), cells[700:])})
    lines = listed(path)
    assert lines[0] == "2 times" and lines[2].split() == ["1", "2"]
    assert lines[1].split()[:2] == ["0", "0.5"] and "values below" in lines[1]
    assert "1728 cells" in lines and "2 blocks" in lines and bounds() in lines
    assert list(arrays_of(lines)) == ["MAT_10", "MAT_20", "number"]
    assert materials_of(lines)[1] == [["1", "MAT_10"], ["2", "MAT_20"]]
    for words in (("--step", "1"), ("--time", "1.9")):
        assert "values below" in listed(path, *words)[2]


def test_spyplot_and_plotfiles():
    lines = listed(os.path.join(DATA, "impact.spcth"))
    assert lines[0] == "4 times" and "8512 cells" in lines and "4 blocks" in lines
    assert list(arrays_of(lines)) == ["Material volume fraction - 1",
                                      "Material volume fraction - 2", "X velocity", "Y velocity",
                                      "Z velocity"]
    head, materials = materials_of(lines)
    assert "named Material volume fraction - N" in head and materials[1] == [
        "2", "Material volume fraction - 2"]
    lines = listed(os.path.join(DATA, "AMReX", "plt00011"))
    assert "22 blocks of 3 levels" in lines and "0.5" in lines[1]
    assert materials_of(lines)[0].startswith("materials: none found") and "--clip" in lines[-1]


@in_folder
def test_what_holds_no_materials(at):
    lines = listed(write(image({"heat": 9 + ball_and_plate(N)[0]}), at("heat.vti")))
    assert materials_of(lines) == (
        "materials: none found; name their arrays (--fractions A,B,.., --labels ARRAY, or "
        "--threshold)", [])
    assert lines[-1] == ("No array holds volume fractions or labels: 'heat' (real numbers from 9 "
                         "to 10: neither in [0, 1] nor integers, such as 9.0625).")


@in_folder
def test_contents(at):
    """Each array has its content and the reason."""
    ball = ball_and_plate(N)[0]
    values = {"ball": ball, "vf": ball, "void": 1 - ball, "mass": ball, "phi": ball - 0.5,
              "heat": 300.5 + ball, "whole": 5.0 * labels(N), "velocity": np.zeros((N, N, N, 3))}
    data = image(values)
    for name, array, dtype in (("mask", labels(N) > 0, np.uint8), ("grain", labels(N), np.int32),
                               ("level", labels(N), np.int32), ("signed", labels(N) - 1, np.int16)):
        add_array(data.GetCellData(), name, array, dtype)
    lines = listed(write(data, at("in.vti")))
    start = next(i for i, line in enumerate(lines) if line.split()[2:] == ["content"])
    found = dict(line.split(None, 1) for line in lines[start + 1:lines.index("", start)])
    print("\n".join("%s %s" % item for item in found.items()))
    assert found == {
        "ball": "fraction: real numbers in [0, 1]",
        "vf": "fraction: real numbers in [0, 1]",
        "void": "other: named void, which is no material",
        "mass": "other: named as a mass or density",
        "phi": "level set: values of both signs, -0.5 to 0.5: a level set or signed distance "
               "(LevelSets Priority, --level-set)",
        "heat": "grey values: real numbers from 300.5 to 301.5: neither in [0, 1] nor integers, "
                "such as 300.5",
        "whole": "labels: real numbers that are integers from 0 to 10",
        "velocity": "other: 3 components",
        "mask": "mask: integers 0 and 1: 1 is full",
        "grain": "labels: integers from 0 to 2",
        "level": "other: named as a processor, level or number of a cell",
        "signed": "other: integers from -1 to 1: labels are 0 (void) or positive; replace "
                  "negative ids by unused ones"}
    assert materials_of(lines) == ("materials from vf (named as volume fractions)", [["1", "vf"]])


@in_folder
def test_errors(at):
    for ranks in (1, 2):
        refused(2, "No such file", "--list", at("missing.vti"), ranks=ranks)
    refused(2, "no step 7", "--list", os.path.join(DATA, "impact.spcth"), "--step", "7", ranks=2)


main(globals())
