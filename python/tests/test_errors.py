"""Tests that input which cannot be meshed raises one clear error."""

import numpy as np
import pytest

import volume_fraction_mesh as vfm
from fields import BALL, LABELS, N, PLATE


def changed(value, cell=(1, 2, 3)):
    array = BALL.copy()
    array[cell] = value
    return array


def graded(node, value):
    x = np.arange(N + 1.0)
    x[node] = value
    return [x, np.arange(N + 1.0), np.arange(N + 1.0)]


WRONG = {
    "neither": (dict(), TypeError, "Neither fractions nor labels are given"),
    "both": (dict(fractions=BALL, labels=LABELS), TypeError, "Both fractions and labels are given"),
    "nan": (
        dict(fractions=changed(np.nan)),
        ValueError,
        "'Material 1' holds nan in cell (1, 2, 3): volume fractions must be finite",
    ),
    "infinite": (dict(fractions=changed(-np.inf)), ValueError, "holds -inf in cell (1, 2, 3)"),
    "above 1": (
        dict(fractions={"ball": changed(1.3)}),
        ValueError,
        "'ball' holds 1.3 in cell (1, 2, 3): volume fractions lie in [0, 1]",
    ),
    "zyx, cells named along x y z": (
        dict(fractions=changed(1.3), order="zyx"),
        ValueError,
        "holds 1.3 in cell (3, 2, 1)",
    ),
    "sum": (dict(fractions=[BALL, BALL]), ValueError, "sum to"),
    "negative integers": (dict(fractions=LABELS - 1), ValueError,
                          "labels are 0 (void) or positive"),
    "integers, two": (dict(fractions=[LABELS, LABELS]), ValueError,
                      "neither fractions nor masks: 'Material 1' (integers from 0 to 2)"),
    "complex": (dict(fractions=BALL + 0j), TypeError, "of the type complex128"),
    "objects": (dict(fractions=BALL.astype(object)), TypeError, "of the type object"),
    "texts": (dict(labels=LABELS.astype(str)), TypeError, "'labels' is of the type <U"),
    "long doubles": (dict(fractions=BALL.astype(np.longdouble)), TypeError, "up to 8 bytes"),
    "one axis": (
        dict(fractions=BALL[0, 0]),
        ValueError,
        "has the shape (12,): two or three axes are required.",
    ),
    "four axes": (
        dict(fractions=np.stack([BALL, PLATE])),
        ValueError,
        "two or three axes are required. For several materials give a list",
    ),
    "a number": (dict(fractions=0.5), ValueError,
                 "has the shape (): two or three axes are required"),
    "empty": (dict(fractions=np.zeros((0, 3, 3))), ValueError,
              "has the shape (0, 3, 3): it contains no cells"),
    "no materials": (dict(fractions=[]), ValueError, "fractions are empty"),
    "shapes": (
        dict(fractions=[BALL, PLATE[1:]]),
        ValueError,
        "'Material 2' has the shape (11, 12, 12), other arrays of the grid have (12, 12, 12)",
    ),
    "masked": (dict(fractions=np.ma.masked_less(BALL, 0.5)), ValueError, "is masked"),
    "order": (dict(fractions=BALL, order="xzy"), ValueError, "order is 'xzy': it must be 'xyz'"),
    "order, type": (dict(fractions=BALL, order=None), TypeError, "order is None"),
    "spacing": (
        dict(fractions=BALL, spacing=(1, -1, 1)),
        ValueError,
        "spacing is (1, -1, 1): widths of cells must be greater than 0",
    ),
    "spacing of two": (dict(fractions=BALL, spacing=(1, 1)), ValueError,
                       "spacing is (1, 1): 3 numbers are required"),
    "spacing, nan": (dict(fractions=BALL, spacing=np.nan), ValueError, "it must be finite"),
    "spacing, text": (dict(fractions=BALL, spacing="wide"), TypeError, "spacing is 'wide'"),
    "origin": (dict(fractions=BALL, origin=(0, 0, np.inf)), ValueError,
               "origin is (0, 0, inf): it must be finite"),
    "coordinates, count": (
        dict(fractions=BALL, coordinates=[np.arange(N)] * 3),
        ValueError,
        "along x has the shape (12,): 12 cells have 13 nodes",
    ),
    "coordinates, order": (
        dict(fractions=BALL, coordinates=graded(4, 3)),
        ValueError,
        "coordinates along x do not increase",
    ),
    "coordinates of two": (dict(fractions=BALL, coordinates=graded(4, 3)[:2]), ValueError,
                           "coordinates has 2 arrays"),
    "coordinates and spacing": (
        dict(fractions=BALL, coordinates=graded(4, 4), spacing=2),
        ValueError,
        "spacing and origin cannot be given too",
    ),
    "direction": (dict(fractions=BALL, direction=np.diag([1, 2, 1])), ValueError,
                  "sheared or scaled"),
    "direction, size": (dict(fractions=BALL, direction=np.eye(2)), ValueError,
                        "9 numbers are required"),
    "labels, half": (
        dict(labels=LABELS + 0.5),
        ValueError,
        "holds 2.5 in cell (0, 0, 0): material ids are integers",
    ),
    "labels, negative": (dict(labels=LABELS - 1), ValueError, "holds -1 in cell"),
    "labels, two": (dict(labels=[LABELS, LABELS]), TypeError, "labels are a list: one array"),
    "names, count": (dict(fractions=[BALL, PLATE], names=["ball"]), ValueError,
                     "names is ['ball']: a list of 2"),
    "names of a dict": (dict(fractions={"b": BALL}, names=["ball"]), TypeError,
                        "fractions have names already"),
    "names of labels": (dict(labels=LABELS, names=["ball"]), TypeError,
                        "a dict {label: name} is required"),
    "names of labels, equal": (dict(labels=LABELS, names={1: "a", 2: "a"}), ValueError,
                               "both called 'a'"),
    "state, shape": (dict(fractions=BALL, state={"T": BALL[1:]}), ValueError,
                     "'T' has the shape (11, 12, 12)"),
    "state, type": (dict(fractions=BALL, state=BALL), TypeError, "state is a ndarray: a dict"),
    "state, name": (
        dict(fractions=BALL, state={"MaterialId": BALL}),
        ValueError,
        "the name of an array that the mesh itself may have",
    ),
    "state, twice": (dict(fractions={"T": BALL}, state={"T": BALL}), ValueError,
                     "Two arrays are called 'T'"),
    "state, not there": (dict(fractions=BALL, state=["T"]), ValueError,
                         "no numeric cell array 'T'"),
    "kinds": (
        dict(fractions=BALL, state={"T": BALL}, density=BALL, state_kinds={"T": "weight"}),
        ValueError,
        "'T=weight' is not valid",
    ),
    "kinds without state": (dict(fractions=BALL, state_kinds={"T": "mass"}), ValueError,
                            "no state is given"),
    "rotated without state": (dict(fractions=BALL, rotated_arrays=["T"]), ValueError,
                              "no state is given"),
    "rotated, type": (dict(fractions=BALL, state={"T": BALL}, rotated_arrays=3), TypeError,
                      "rotated_arrays is 3: a list"),
    "rotated scalar": (dict(fractions=BALL, state={"T": BALL}, rotated_arrays=["T"]), ValueError,
                       "The rotated array 'T' has 1 component"),
    "density": (
        dict(fractions=BALL, density=BALL - 1),
        ValueError,
        "density array 'density' is -0.9375 in cell (5, 3, 3)",
    ),
    "densities": (
        dict(fractions=[BALL, PLATE], density=[BALL]),
        ValueError,
        "density has 1 arrays: one for all materials, or one for each of 2",
    ),
    "densities by name": (
        dict(fractions={"b": BALL}, density={"c": BALL}),
        ValueError,
        "density has arrays of 'c', but the materials are 'b'",
    ),
    "velocity": (dict(fractions=BALL, velocity=BALL, density=BALL), ValueError, "velocity has 3"),
    "progress": (dict(fractions=BALL, progress="loud"), TypeError, "progress is 'loud'"),
    "refinement boxes": (
        dict(fractions=BALL, refinement_boxes=[1, 2]),
        TypeError,
        "refinement_boxes is [1, 2]: a list",
    ),
    "kinds, type": (dict(fractions=BALL, state={"T": BALL}, state_kinds=3), TypeError,
                    "state_kinds is 3: a dict"),
    "densities of labels": (
        dict(labels=LABELS, density=[BALL, BALL]),
        TypeError,
        "density is a list: for labels, a dict",
    ),
    "refinement box": (
        dict(fractions=BALL, refinement="automatic", refinement_boxes=[(1, 2)]),
        ValueError,
        "refinement_boxes has (1.0, 2.0)",
    ),
    "refinement box, reversed": (
        dict(fractions=BALL, refinement="automatic", refinement_boxes=[(1, 1, 1, 0, 2, 2)]),
        ValueError,
        "must not end before it begins",
    ),
    "refinement array": (
        dict(fractions=BALL, refinement="automatic", refinement_array=BALL - 2),
        ValueError,
        "refinement",
    ),
    "aspect ratio": (
        dict(fractions=BALL, maximum_aspect_ratio=1.05),
        ValueError,
        "maximum_aspect_ratio is 1.05: it must be 0 (off) or a number, 1.1 or more",
    ),
    "arrays without image": (dict(fractions=BALL, arrays=["ball"]), TypeError,
                             "arrays is ['ball']"),
}


@pytest.mark.parametrize("given, error, text", WRONG.values(), ids=WRONG)
def test_wrong_input(given, error, text):
    for make in (vfm.hexes, vfm.tets):
        with pytest.raises(error) as told:
            make(**given)
        assert type(told.value) is error and text in str(told.value), str(told.value)
        assert str(told.value).count("\n") == 0


def test_runs_after_an_error():
    with pytest.raises(ValueError):
        vfm.hexes(changed(2))
    assert len(vfm.hexes(BALL))
