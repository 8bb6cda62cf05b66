"""Masks, labels near integers, label 0, ranges of values and grey values in the filters."""
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from vfmtest import (
    SPACING, VolumeFractionToHex, VolumeFractionToTet, check_error, digest, image, main, mesh_of,
    run)

CELL = np.prod(SPACING)


def two_boxes(first, second, dtype=np.uint8):
    """Returns two boxes side by side in void, a[z, y, x], of 240 cells each."""
    a = np.zeros((10, 12, 14), dtype)
    a[2:8, 2:10, 2:7] = first
    a[2:8, 2:10, 7:12] = second
    return a


def volumes(result):
    """Returns {name: number of cells of this volume}."""
    names = [result.mesh.GetFieldData().GetAbstractArray("MaterialNames").GetValue(i)
             for i in range(len(result.field("TargetVolume")))]
    found = {name: round(volume / CELL, 6)
             for name, volume in zip(names, result.field("TargetVolume"))}
    print(found, result.mesh.GetNumberOfCells())
    return found


def test_masks():
    """Bytes of which no value exceeds 1 are masks, whether they are selected or not."""
    masks = {"liver": two_boxes(1, 0), "spleen": two_boxes(0, 1)}
    reals = {name: values.astype(float) for name, values in masks.items()}
    expected = digest(mesh_of(image(reals), VolumeFractionArrays=list(reals)))
    for chosen in ([], ["liver", "spleen"]):
        result = mesh_of(image(masks), VolumeFractionArrays=chosen)
        assert volumes(result) == {"liver": 240, "spleen": 240} and digest(result) == expected
        assert result.mesh.GetNumberOfCells() == 952
    result = mesh_of(image({"mask": two_boxes(1, 1)}), VolumeFractionArrays=[])
    assert volumes(result) == {"Material 1": 480}
    result = mesh_of(image({"tissue": two_boxes(3, 29)}), VolumeFractionArrays=[])
    assert volumes(result) == {"Material 3": 240, "Material 29": 240}
    check_error(image({"tissue": two_boxes(3, 29)}), "'tissue' holds values up to 29",
                VolumeFractionArrays=["tissue"])
    check_error(image({"a": two_boxes(3, 0), "b": two_boxes(0, 29)}), "No array is chosen",
                "'b' (integers from 0 to 29)", VolumeFractionArrays=[])


def test_labels_near_integers():
    noise = np.random.default_rng(3).uniform(-9e-4, 9e-4, (10, 12, 14))
    expected = digest(mesh_of(image({"seg": two_boxes(17, 53, np.int32)}), MaterialIdArray="seg"))
    for values in (two_boxes(17, 53, np.float32), two_boxes(17, 53, float) + noise):
        for properties in ({"MaterialIdArray": "seg"}, {"VolumeFractionArrays": []}):
            assert digest(mesh_of(image({"seg": values}), **properties)) == expected


def test_label_zero():
    i = np.indices((16, 16, 16))[::-1]
    ids = np.where(i[0] < 8, 0, np.where(i[1] < 8, 1, 2)).astype(np.int32)
    result = mesh_of(image({"material": ids}), MaterialIdArray="material")
    assert len(result.warnings) == 1 and "2048 of 4096 cells, 50 %" in result.warnings[0]
    for make in (VolumeFractionToHex, VolumeFractionToTet):
        result = mesh_of(image({"material": ids}), make, MaterialIdArray="material",
                         ZeroLabel="Material")
        assert not result.warnings, result.warnings
        assert volumes(result) == {"Material 1": 1024, "Material 2": 1024, "Material 0": 2048}
        found = vtk_to_numpy(result.mesh.GetCellData().GetArray("MaterialId"))
        assert set(found.tolist()) == {1, 2, 3}
    hidden = np.where(i[2] < 4, 32, 0).astype(np.uint8)
    result = mesh_of(image({"material": ids, "vtkGhostType": hidden}), MaterialIdArray="material",
                     ZeroLabel="Material")
    assert volumes(result) == {"Material 1": 768, "Material 2": 768, "Material 0": 1536}


def grey(n=16):
    i = np.indices((n, n, n)) - (n - 1) / 2
    noise = np.random.default_rng(1).normal(0, 6, (n, n, n))
    values = 40 + 160 / (1 + np.exp((np.sqrt((i ** 2).sum(axis=0)) - n / 3) / 0.7)) + noise
    return np.clip(values, 0, 255)


def test_grey_values():
    scan = grey().astype(np.int16)
    for properties in ({"MaterialIdArray": "scan"}, {"VolumeFractionArrays": []}):
        result = run(image({"scan": scan}), StairStep=1, **properties)
        assert not result.errors and sum("'scan' looks like grey values, not labels" in text
                                         for text in result.warnings) == 1, result.warnings
    for values in (scan, grey(), grey().astype(np.uint8)):
        for properties in ({"MaterialIdArray": "scan"}, {"VolumeFractionArrays": []},
                           {"VolumeFractionArrays": ["scan"]}):
            result = mesh_of(image({"scan": values}), Threshold="50:128;128", StairStep=1,
                             **properties)
            low, high = ((values > 50) & (values <= 128)).sum(), (values > 128).sum()
            assert volumes(result) == {"Material 1": low, "Material 2": high}
    check_error(image({"scan": scan}), "Threshold cannot be '5:3'", MaterialIdArray="scan",
                Threshold="5:3")
    check_error(image({"a": scan, "b": scan}), "Threshold makes materials of ranges",
                VolumeFractionArrays=["a", "b"], Threshold="5")


def test_level_sets():
    i = np.indices((12, 12, 12)) - 5.5
    phi = np.sqrt((i ** 2).sum(axis=0)) - 4
    check_error(image({"phi": phi}), "No array is chosen",
                "'phi' (values of both signs, -3.13397 to 5.52628", VolumeFractionArrays=[])
    check_error(image({"phi": phi}), "level set", "Threshold", MaterialIdArray="phi")


def test_sums_above_one():
    first = np.zeros((8, 8, 8))
    first[:4] = 1
    second = 1 - first
    second[2, 3, 3:6] += 0.0018
    check_error(image({"a": first, "b": second}), "cell (3, 3, 2) sum to 1.0018",
                "3 of 512 cells", "FractionTolerance 0.0019", VolumeFractionArrays=["a", "b"])
    result = mesh_of(image({"a": first, "b": second}), VolumeFractionArrays=["a", "b"],
                     FractionTolerance=0.0019)
    assert result.field("NormalisedCells") == [3]


main(globals())
