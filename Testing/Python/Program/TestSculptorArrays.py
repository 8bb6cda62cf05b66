"""Arrays that sculptor finds and reads: masks, labels, ranges of values, names with commas."""
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkRectilinearGrid
from vtkmodules.vtkIOXML import vtkXMLRectilinearGridWriter

from compare_meshes import difference, merge, read_pieces
from sculptor_program import mesh_file, refused, rows, sculptor
from vfmtest import add_array, in_folder, labels, main, write


def two_boxes(first, second, dtype):
    """Returns two boxes side by side in void, a[z, y, x], of 240 cells each."""
    a = np.zeros((10, 12, 14), dtype)
    a[2:8, 2:10, 2:7] = first
    a[2:8, 2:10, 7:12] = second
    return a


def ball(dtype=np.uint8):
    """Returns a ball of 912 cells."""
    i = np.indices((16, 16, 16))
    return (((i - 7.5) ** 2).sum(axis=0) < 36).astype(dtype)


def unit_image(arrays, of_points=False):
    """Returns an image with cells of volume 1, or one whose points are their centres."""
    shape = next(iter(arrays.values())).shape
    data = vtkImageData()
    data.SetDimensions([n + (not of_points) for n in shape[::-1]])
    to = data.GetPointData() if of_points else data.GetCellData()
    for name, values in arrays.items():
        add_array(to, name, values, values.dtype)
    return data


def contents(path, *words, ranks=(1, 3), at=None):
    """Meshes a file on these numbers of ranks. Returns {material: (elements, volume)}."""
    meshes, found = [], None
    for count in ranks:
        result = sculptor(path, at("out.vtu"), *words, ranks=count)
        assert result.returncode == 0, result
        meshes.append(merge(read_pieces(at("out.vtu"))))
        found = {name: (row[0], round(row[4], 3)) for name, row in rows(result.stdout).items()
                 if name != "all" and " of material" not in name}
        assert not difference(meshes[0], meshes[-1])
    print(words, found)
    return found


@in_folder
def test_masks_of_bytes(at):
    """Bytes of which no value exceeds 1 are masks."""
    for of_points in (False, True):
        path = write(unit_image({"mask": ball()}, of_points), at("mask.vti"))
        assert contents(path, at=at) == {"1 Material 1": (1584, 912)}
        assert contents(path, "--fractions", "mask", at=at) == {"1 mask": (1584, 912)}
    mixed = {"a": two_boxes(255, 0, np.uint8), "b": two_boxes(0, 1, np.uint8)}
    refused(3, "1 is full in one of them and 255 in the other",
            write(unit_image(mixed), at("mixed.vti")), at("out.vtu"))
    path = write(unit_image({"tissue": two_boxes(3, 29, np.uint8)}), at("tissues.vti"))
    assert contents(path, at=at) == {"3 Material 3": (476, 240), "29 Material 29": (476, 240)}
    masks = {"liver": two_boxes(1, 0, np.uint8), "spleen": two_boxes(0, 1, np.uint8)}
    path = write(unit_image(masks), at("masks.vti"))
    for words in ([], ["--fractions", "liver,spleen"]):
        assert contents(path, *words, at=at) == {"1 liver": (476, 240), "2 spleen": (476, 240)}
    assert contents(path, "--fractions", "spleen", at=at) == {"1 spleen": (476, 240)}
    for dtype in (np.int8, np.int64):
        path = write(unit_image({name: a.astype(dtype) for name, a in masks.items()}), at("i.vti"))
        assert contents(path, at=at, ranks=[1]) == {"1 liver": (476, 240), "2 spleen": (476, 240)}


@in_folder
def test_masks_of_several_types(at):
    """Masks of any types are materials together, also next to fractions."""
    for liver, spleen in ((two_boxes(1, 0, np.uint8), two_boxes(0, 1, np.float32)),
                          (two_boxes(1, 0, np.uint8), two_boxes(0, 1, np.float64)),
                          (two_boxes(255, 0, np.uint8), two_boxes(0, 1, np.int32)),
                          (two_boxes(255, 0, np.uint8), two_boxes(0, 1, np.float32)),
                          (two_boxes(1, 0, np.float64), two_boxes(0, 1, np.int16))):
        path = write(unit_image({"liver": liver, "spleen": spleen}), at("in.vti"))
        assert contents(path, at=at) == {"1 liver": (476, 240), "2 spleen": (476, 240)}
    steel = two_boxes(0.7, 0, float)
    path = write(unit_image({"steel": steel, "tin": two_boxes(0, 1, np.int32)}), at("in.vti"))
    assert list(contents(path, at=at)) == ["1 steel", "2 tin"]
    path = write(unit_image({"steel": steel, "zone": two_boxes(1, 2, np.int32)}), at("in.vti"))
    result = sculptor(path, at("out.vtu"))
    assert result.returncode == 0 and result.stderr == (
        "sculptor: warning: Not used: 'zone' (integers from 0 to 2). --fractions or --labels "
        "selects arrays.\n"), result
    assert sculptor(path, at("out.vtu"), "--fractions", "steel").stderr == ""


@in_folder
def test_bytes_between(at):
    """Bytes up to 127 that are no masks are rejected as fractions."""
    values = {"a": two_boxes(3, 0, np.uint8), "b": two_boxes(0, 29, np.uint8)}
    path = write(unit_image(values), at("in.vti"))
    for ranks in (1, 3):
        refused(2, "'a' (integers from 0 to 3), 'b' (integers from 0 to 29)", path, at("o.vtu"),
                ranks=ranks)
        refused(3, "'a' holds values up to 3, 'b' holds values up to 29", path, at("o.vtu"),
                "--fractions", "a,b", ranks=ranks)
        refused(3, "choose the array as labels (--labels b)", path, at("o.vtu"), "--fractions", "b",
                ranks=ranks)
    # Values above 127 of which none is 255 may be labels or fractions.
    one = write(unit_image({"tissue": two_boxes(100, 200, np.uint8)}), at("one.vti"))
    for ranks in (1, 3):
        refused(2, "Labels or volume fractions: 'tissue' (unsigned char up to 200, never 255: ",
                one, at("o.vtu"), ranks=ranks)
    refused(2, "(--fractions A,B,..), an array of labels (--labels ARRAY)", one, at("o.vtu"))
    assert contents(one, "--labels", "tissue", at=at) == {"100 Material 100": (476, 240),
                                                          "200 Material 200": (476, 240)}
    assert list(contents(one, "--fractions", "tissue", at=at)) == ["1 tissue"]
    values["c"] = np.full((10, 12, 14), 200, np.uint8)
    refused(2, "'a' (unsigned char up to 3, next to 200, never 255",
            write(unit_image(values), at("in.vti")), at("out.vtu"))
    # One array that fills cells makes all of them fractions of 255.
    values["c"] = 255 - values["a"] - values["b"]
    path = write(unit_image(values), at("in.vti"))
    result = sculptor(path, at("out.vtu"))
    assert "materials from a, b, c (all cell arrays" in result.stdout, result
    table = rows(result.stdout)
    assert [table[name][5] for name in ("1 a", "2 b", "3 c")] == [2.82353, 27.2941, 1649.88]
    path = write(unit_image({"vf": two_boxes(100, 0, np.uint8)}), at("vf.vti"))
    refused(3, "The mesh has no elements", path, at("o.vtu"), "--fractions", "vf", "--set",
            "ThinParts=off")


@in_folder
def test_states_and_masks_of_reals(at):
    """A damage is no material; masks of reals next to labels are not guessed."""
    steel = two_boxes(1, 0, float)
    path = write(unit_image({"steel": steel, "damage": 0.03 * steel}), at("in.vti"))
    assert contents(path, at=at) == {"1 steel": (476, 240)}
    path = write(unit_image({"damage": steel}), at("in.vti"))
    refused(2, "'damage' (named as a state of the material)", path, at("out.vtu"))
    assert contents(path, "--fractions", "damage", at=at) == {"1 damage": (476, 240)}
    for name in ("labels", "zones"):
        path = write(unit_image({"mask": steel, name: two_boxes(1, 2, np.int32)}), at("in.vti"))
        refused(2, "Labels '%s' (integers from 0 to 2) or volume fractions 'mask'" % name, path,
                at("out.vtu"))


@in_folder
def test_coordinates_that_decrease(at):
    """The message names the file."""
    data = vtkRectilinearGrid()
    data.SetDimensions(3, 2, 2)
    for to, x in ((data.SetXCoordinates, [0.0, 2, 1]), (data.SetYCoordinates, [0.0, 1]),
                  (data.SetZCoordinates, [0.0, 1])):
        to(numpy_to_vtk(np.array(x), deep=True))
    add_array(data.GetCellData(), "id", np.array([1, 2]), np.int32)
    path = write(data, at("in.vtr"), vtkXMLRectilinearGridWriter)
    refused(3, "Cannot mesh %s: The input: the x coordinates do not increase" % path, path,
            at("out.vtu"))


@in_folder
def test_one_array_of_integers(at):
    for name in ("material", "Spin", "FeatureIds", "facies"):
        path = write(unit_image({name: two_boxes(1, 2, np.int32),
                                 "heat": two_boxes(0.5, 300.5, float)}), at("in.vti"))
        assert contents(path, at=at) == {"1 Material 1": (476, 240), "2 Material 2": (476, 240)}
    path = write(unit_image({"a": two_boxes(1, 2, np.int32), "b": two_boxes(2, 1, np.int16)}),
                 at("in.vti"))
    refused(2, "Several arrays of integers can hold the materials: 'a' (integers from 0 to 2), 'b'",
            path, at("out.vtu"), ranks=2)


@in_folder
def test_labels_near_integers(at):
    """Reals within 0.001 of integers are these integers."""
    noise = np.random.default_rng(3).uniform(-9e-4, 9e-4, (10, 12, 14))
    for values in (two_boxes(17, 53, np.float32), two_boxes(17, 53, float) + noise):
        path = write(unit_image({"seg": values}), at("in.vti"))
        for words in ([], ["--labels", "seg"]):
            assert contents(path, *words, at=at) == {"17 Material 17": (476, 240),
                                                     "53 Material 53": (476, 240)}
        assert contents(path, "--material", "53", at=at) == {"53 Material 53": (476, 240)}
    path = write(unit_image({"seg": two_boxes(17, 53, float) + 2 * noise}), at("in.vti"))
    refused(3, "'seg' holds", path, at("out.vtu"), "--labels", "seg", ranks=2)
    for value, text in ((1.0012, "such as 1.0012"), (np.nan, "such as nan")):
        path = write(unit_image({"seg": two_boxes(value, 2, np.float32)}), at("in.vti"))
        for ranks in (1, 3):
            refused(2, text, path, at("out.vtu"), ranks=ranks)
    path = write(unit_image({"seg": two_boxes(1, 0.998, float)}), at("in.vti"))
    refused(3, "'seg' holds 0.998 in cell (7, 2, 2): material ids are integers", path,
            at("out.vtu"), "--labels", "seg", ranks=2)


def zero_based():
    i = np.indices((16, 16, 16))[::-1]
    return np.where(i[0] < 8, 0, np.where(i[1] < 8, 1, 2))


@in_folder
def test_label_zero(at):
    """Label 0 that lies among the labels has a note; ZeroLabel makes it a material."""
    for dtype in (np.int64, float):
        path = write(unit_image({"material": zero_based().astype(dtype)}), at("in.vti"))
        for ranks in (1, 3):
            result = sculptor(path, at("out.vtu"), ranks=ranks)
            assert result.returncode == 0 and result.stderr == (
                "sculptor: warning: Label 0 of the array 'material' is read as void: 2048 of 4096 "
                "cells, 50 %. Other labels reach the sides of the domain as it does. If label 0 is "
                "a material, set ZeroLabel to Material (--zero-label Material).\n"), result
        volumes = {name: volume for name, (_, volume) in contents(
            path, "--zero-label", "Material", at=at).items()}
        assert volumes == {"1 Material 1": 1024, "2 Material 2": 1024,
                           "3 Material 0": 2048}, volumes
    refused(1, "--material cannot be combined with --zero-label Material", path, at("out.vtu"),
            "--material", "1", "--zero-label", "Material")
    with open(at("names.txt"), "w") as names:
        names.write("0 matrix\n1 fibre\n2 pore\n")
    found = contents(path, "--zero-label", "material", "--label-names", at("names.txt"), at=at)
    assert list(found) == ["1 fibre", "2 pore", "3 matrix"], found
    for ending in ("e", "inp", "msh", "k", "rad", "bdf"):
        mesh_file(path, at("out." + ending), "--zero-label", "Material")
    hole = np.ones((8, 8, 8), np.int32)
    hole[3:5, 3:5, 3:5] = 0
    result = sculptor(write(unit_image({"id": hole}), at("in.vti")), at("out.vtu"))
    assert "8 of 512 cells, 1.56 %. Other labels enclose it." in result.stderr, result
    for quiet in (ball(np.int32), two_boxes(1, 2, np.int32), 1 + hole, labels(16).astype(np.int32)):
        result = sculptor(write(unit_image({"id": quiet}), at("in.vti")), at("out.vtu"))
        assert result.returncode == 0 and result.stderr == "", result


@in_folder
def test_label_zero_with_refinement_and_state(at):
    ids = zero_based()
    path = write(unit_image({"material": ids.astype(np.int32), "number": ids.astype(float)}),
                 at("in.vti"))
    words = ["--labels", "material", "--zero-label", "Material", "--state", "number"]
    for more in ([], ["--refine-box", "6,6,6,10,10,10"]):
        contents(path, *words, *more, at=at)
        mesh = merge(read_pieces(at("out.vtu")))
        material = vtk_to_numpy(read_pieces(at("out.vtu"))[0].GetCellData().GetArray("MaterialId"))
        number = vtk_to_numpy(read_pieces(at("out.vtu"))[0].GetCellData().GetArray("number"))
        assert mesh and set(zip(material.tolist(), number.tolist())) == {(1, 1), (2, 2), (3, 0)}


def grey(seed=1, n=24):
    """Returns an image of a ball with noise and a soft border."""
    i = np.indices((n, n, n)) - (n - 1) / 2
    noise = np.random.default_rng(seed).normal(0, 6, (n, n, n))
    values = 40 + 160 / (1 + np.exp((np.sqrt((i ** 2).sum(axis=0)) - n / 3) / 0.7)) + noise
    return np.clip(values, 0, 255).astype(np.uint8)


@in_folder
def test_grey_values(at):
    values = grey(n=16)
    path = write(unit_image({"scan": values.astype(np.int16)}), at("in.vti"))
    for ranks in (1, 3):
        refused(3, "Cannot mesh %s: The array 'scan' looks like grey values, not labels: " % path,
                path, at("out.vtu"), ranks=ranks)
    result = sculptor(path, at("out.vtu"), "--labels", "scan", "--stairstep", ranks=2)
    assert result.returncode == 0 and "looks like grey values" in result.stderr, result
    # Grains are no grey values.
    cells = np.stack(np.indices((24, 24, 24)), axis=-1) + 0.5
    centres = np.random.default_rng(7).random((400, 3)) * 24
    grains = 1 + ((cells[..., None, :] - centres) ** 2).sum(axis=-1).argmin(axis=-1)
    path = write(unit_image({"grain": grains.astype(np.int32)}), at("grains.vti"))
    assert sculptor(path, at("out.vtu"), "--stairstep", "--quiet").stderr == ""


@in_folder
def test_grey_bytes(at):
    """Bytes up to 255 of which most are neither 0 nor 255 are no fractions of 255."""
    values = grey(n=16)
    values[0, 0, 0] = 255
    path = write(unit_image({"scan": values}), at("in.vti"))
    for ranks in (1, 3):
        refused(3, "Cannot mesh %s: The array 'scan' looks like grey values or labels, not volume "
                "fractions of 255: " % path, path, at("out.vtu"), ranks=ranks)
        result = sculptor(path, at("out.vtu"), "--fractions", "scan", "--stairstep", ranks=ranks)
        assert result.returncode == 0 and "looks like grey values" in result.stderr, result
    regions = np.kron(np.array([10, 40, 80, 120, 160, 200, 230, 255]).reshape(2, 2, 2),
                      np.ones((5, 5, 5))).astype(np.uint8)
    path = write(unit_image({"tissue": regions}), at("in.vti"))
    refused(3, "7 different values, and 87.5 % of the cells are neither 0 nor 255", path,
            at("out.vtu"))
    path = write(unit_image({"vf_scan": values}), at("in.vti"))
    assert sculptor(path, at("out.vtu"), "--stairstep").stderr == ""


@in_folder
def test_threshold(at):
    values = grey()
    for of_points in (False, True):
        for dtype in (np.uint8, np.float32):
            data = unit_image({"scan": values.astype(dtype)}, of_points)
            path = write(data, at("in.vti"))
            found = contents(path, "--threshold", "128", at=at)
            assert found["1 Material 1"][1] == (values > 128).sum(), found
    ranges = ["--threshold", "-5:50.5", "--threshold=50.5:100;150:"]
    found = contents(path, *ranges, at=at)
    bounds = ((-5, 50.5), (50.5, 100), (150, 999))
    assert list(found) == ["1 Material 1", "2 Material 2", "3 Material 3"]
    table = rows(sculptor(path, at("o.vtu"), *ranges).stdout)
    assert [round(table[name][5]) for name in found] == [
        ((values > low) & (values <= high)).sum() for low, high in bounds]
    with open(at("names.txt"), "w") as names:
        names.write("1 bone\n")
    assert list(contents(path, "--threshold", "128", "--label-names", at("names.txt"),
                         at=at)) == ["1 bone"]
    for wrong in ("5:3", "1:3,2:4", "x", ":", "1:2:3"):
        refused(1, "The option Threshold cannot be '%s'" % wrong, path, at("o.vtu"), "--threshold",
                wrong)
    refused(1, "exclude each other", path, at("o.vtu"), "--threshold", "1", "--fractions", "scan")
    refused(3, "no elements", path, at("o.vtu"), "--threshold", "300")
    path = write(unit_image({"a": values, "b": values}), at("two.vti"))
    refused(2, "Threshold takes one array, and there are several: 'a'", path, at("o.vtu"),
            "--threshold", "128")
    assert contents(path, "--threshold", "128", "--labels", "b", at=at)


@in_folder
def test_threshold_of_negative_integers(at):
    """Integers of NumPy below 0 are values of an image, as real numbers are."""
    values = np.where(ball() > 0, 300, -196)
    for dtype in ("<i2", ">i4", "<i8", "<f4"):
        np.save(at("in.npy"), values.astype(dtype))
        found = contents(at("in.npy"), "--threshold", "100", at=at)
        assert found == {"1 Material 1": (1584, 912)}, found
        found = contents(at("in.npy"), "--threshold", ":-10", at=at, ranks=[1])
        assert found["1 Material 1"][1] == 4096 - 912, found
    np.save(at("in.npy"), values.astype(np.int16))
    refused(2, "the label of cell (0, 0, 0) is -196", at("in.npy"), at("o.vtu"))


@in_folder
def test_shock_codes(at):
    """Volume fractions by their names; void and masses are no materials; names with commas."""
    solid = np.where(ball() > 0, 1.0, 0.0)
    values = {"vf, tin": solid, "vf, void": 1 - solid, "mass, tin": 1e-3 * solid,
              "damage": 0.5 * solid}
    path = write(unit_image(values), at("in.vti"))
    assert contents(path, at=at) == {"1 vf, tin": (1584, 912)}
    assert contents(path, "--fractions", '"vf, tin"', at=at) == {"1 vf, tin": (1584, 912)}
    both = ["--fractions", "vf, tin", "--fractions", "vf, void"]
    assert [v for _, v in contents(path, *both, at=at).values()] == [912, 4096 - 912]
    result = mesh_file(path, at("out.vtu"), "--state", '"mass, tin",damage')
    assert result
    names = [read_pieces(at("out.vtu"))[0].GetCellData().GetArrayName(i)
             for i in range(read_pieces(at("out.vtu"))[0].GetCellData().GetNumberOfArrays())]
    assert {"mass, tin", "damage"} <= set(names), names
    assert "mass" in mesh_file(path, at("out.vtu"), "--density", '"mass, tin"')


@in_folder
def test_sums_above_one(at):
    first = np.zeros((16, 16, 16))
    first[:8], first[8] = 1, 0.5
    second = 1 - first
    second[8, 3:6, 3] += 0.0018
    path = write(unit_image({"a": first, "b": second}), at("in.vti"))
    for ranks in (1, 3):
        refused(3, "The volume fractions of cell (3, 3, 8) sum to 1.0018: more than 1. The sums of "
                "3 of 4096 cells are too large, the largest is 1.0018. If the arrays hold separate "
                "materials, FractionTolerance 0.0019 (--clip 0.0019) scales", path, at("o.vtu"),
                ranks=ranks)
    result = sculptor(path, at("o.vtu"), "--clip", "0.0019")
    assert result.returncode == 0 and "3 cells sum to slightly more than 1" in result.stderr, result
    path = write(unit_image({"a": first, "b": first}), at("in.vti"))
    refused(3, "Choose arrays of separate materials.", path, at("o.vtu"), ranks=2)


@in_folder
def test_values_slightly_outside(at):
    """The message names the tolerance that accepts all values."""
    whole = np.zeros((16, 16, 16))
    whole[:8], whole[8] = 1, 0.5
    whole[1, 2, 3], whole[9, 3, 2] = 1.0009, -0.0018
    path = write(unit_image({"vf_a": whole, "vf_b": 1 - np.clip(whole, 0, 1)}), at("in.vti"))
    for ranks in (1, 3):
        for words in ([], ["--fractions", "vf_a"]):
            refused(3, "'vf_a' holds 1.0009 in cell (3, 2, 1): volume fractions lie in [0, 1]. "
                    "FractionTolerance 0.0019 (--clip 0.0019) clips all values", path, at("o.vtu"),
                    *words, ranks=ranks)
    assert sculptor(path, at("o.vtu"), "--clip", "0.0019").returncode == 0
    path = write(unit_image({"a": whole}), at("in.vti"))
    refused(2, "FractionTolerance 0.0019 (--clip 0.0019)", path, at("o.vtu"))


@in_folder
def test_level_sets(at):
    i = np.indices((12, 12, 12)) - 5.5
    path = write(unit_image({"phi": np.sqrt((i ** 2).sum(axis=0)) - 4}), at("in.vti"))
    for ranks in (1, 2):
        refused(2, "'phi' (values of both signs, -3.13397 to 5.52628: a level set or signed "
                "distance (LevelSets Priority, --level-set))", path, at("o.vtu"), ranks=ranks)
        refused(3, "Threshold (--threshold LOW:HIGH)", path, at("o.vtu"), "--labels", "phi",
                ranks=ranks)
    found = contents(path, "--threshold", ":0", at=at)
    assert found["1 Material 1"][1] == (np.sqrt((i ** 2).sum(axis=0)) <= 4).sum(), found
    found = contents(path, "--level-set", "phi", at=at)
    assert abs(found["1 phi"][1] / (4 / 3 * np.pi * 4 ** 3) - 1) < 1e-3, found


main(globals())
