"""Tests that the table of options, the signatures and the core agree."""

import inspect
import re

import numpy as np
import pytest

import volume_fraction_mesh as vfm
from fields import BALL
from volume_fraction_mesh import _core

OPTIONS = _core.list_options()
NUMBERS = [option for option in OPTIONS if option.kind in ("whole", "real")]
OPENS = {"iso_value": "()", "target_scaled_jacobian": "[)"}  # ranges with open ends


def make_of(option):
    return vfm.tets if option.tets else vfm.hexes


def options_of(make):
    return [option for option in OPTIONS if make is vfm.tets or not option.tets]


@pytest.mark.parametrize("make", [vfm.hexes, vfm.tets])
def test_signatures(make):
    told = inspect.signature(make).parameters
    for option in options_of(make):
        assert told[option.name].default == option.default and told[
            option.name].kind is inspect.Parameter.KEYWORD_ONLY
    others = {
        "fractions",
        "labels",
        "spacing",
        "origin",
        "coordinates",
        "direction",
        "order",
        "names",
        "arrays",
        "state",
        "density",
        "velocity",
        "energy",
        "state_kinds",
        "rotated_arrays",
        "refinement_array",
        "refinement_boxes",
        "threshold",
        "progress",
    }
    assert set(told) == others | {option.name for option in options_of(make)}
    for name in told:
        assert re.search(r"\b%s\b.* : " % name, vfm.hexes.__doc__ + vfm.tets.__doc__), name


@pytest.mark.parametrize("option", OPTIONS, ids=lambda option: option.name)
def test_defaults_are_those_of_the_core(option):
    assert getattr(_core.Options(option.tets), option.name) == option.default


@pytest.mark.parametrize("option", NUMBERS, ids=lambda option: option.name)
def test_ranges(option):
    of, step = (int, 1) if option.kind == "whole" else (float, 1e-9)
    least, most = (end if abs(end) == float("inf") else of(end)
                   for end in (option.least, option.most))
    ends = OPENS.get(option.name, "[]")
    options = _core.Options(option.tets)
    for value in (option.default, least if ends[0] == "[" else 0.3,
                  most if ends[1] == "]" else 0.3):
        if abs(value) < float("inf"):
            setattr(options, option.name, value)
            assert getattr(options, option.name) == value
    for value in (
        least - step if ends[0] == "[" else least,
        most + step * max(1, abs(most)) if ends[1] == "]" else most,
        float("nan") if option.kind == "real" else least - 7,
    ):
        if abs(value) == float("inf"):
            continue
        with pytest.raises(ValueError) as told:
            make_of(option)(BALL, **{option.name: value})
        assert str(told.value) == "%s is %r: it must be %s." % (option.name, value, option.allowed)
        assert re.search("%g" % least, option.allowed.replace("e-", "e-0"))


@pytest.mark.parametrize("option", OPTIONS, ids=lambda option: option.name)
def test_wrong_types(option):
    for value in (*([] if option.kind in ("text", "widths", "sizes") else ["3"]), None, [1],
                  1.5 if option.kind in ("whole", "sizes") else {}):
        with pytest.raises((TypeError, ValueError)) as told:
            make_of(option)(BALL, **{option.name: value})
        assert isinstance(told.value, TypeError) or option.kind == "word"
        assert str(told.value).startswith("%s is %r: it must be " % (option.name, value))


@pytest.mark.parametrize("option", [option for option in OPTIONS if option.kind == "word"],
                         ids=lambda option: option.name)
def test_words(option):
    options = _core.Options(option.tets)
    for word in option.words:
        setattr(options, option.name, word)
        assert getattr(options, option.name) == word
    with pytest.raises(ValueError) as told:
        make_of(option)(BALL, **{option.name: "Quick"})
    assert all(repr(word) in str(told.value) for word in option.words)


def test_cell_width():
    options = _core.Options(False)
    for value, kept in ((2, 2.0), ("0.5", 0.5), ((1, 2, 0.5), "1,2,0.5"), ("1,1,2", "1,1,2")):
        options.cell_width = value
        assert options.cell_width == kept
    wide = vfm.hexes(BALL, cell_width=2)
    assert 0 < len(wide) < len(vfm.hexes(BALL)) / 4
    assert len(vfm.hexes(BALL, cell_width=(2, 2, 2))) == len(wide)
    with pytest.raises(ValueError, match="Refinement"):
        vfm.hexes(BALL, cell_width=0.3)
    with pytest.raises(ValueError, match="cell_width is -1"):
        vfm.hexes(BALL, cell_width=-1)


def test_material_widths():
    options = _core.Options(False)
    for value, kept in (("auto", "auto"), ("1=2", "1=2"), ({"cortex": 1, 7: 2.5}, "cortex=1,7=2.5"),
                        ({"left, upper": 1, 2: 1}, '"left, upper=1",2=1'), ({}, ""),
                        ({np.int64(3): np.float32(0.5)}, "3=0.5")):
        options.material_widths = value
        assert options.material_widths == kept
    narrow, wide = vfm.hexes(BALL, names=["ball"]), vfm.hexes(BALL, names=["ball"], cell_width=4)
    own = vfm.hexes(BALL, names=["ball"], cell_width=4, material_widths={"ball": 2})
    assert len(wide) < len(own) < len(narrow) / 2
    assert own.materials["MaterialWidths"] == [2.0] and own.materials["InputCells"][0] > 0
    by_id = vfm.hexes(BALL, cell_width=4, material_widths={1: 2})
    assert np.array_equal(by_id.points, own.points)
    assert len(vfm.hexes(BALL, material_widths="auto", allowed_error=1)) < len(narrow) / 2
    with pytest.raises(ValueError, match="'iron', which is not a material"):
        vfm.hexes(BALL, material_widths={"iron": 2})
    with pytest.raises(ValueError, match="Refinement"):
        vfm.hexes(BALL, material_widths={1: 0.3})
    for wrong in ("iron", "1=2,", "auto,1=2", "1=0"):
        with pytest.raises(ValueError, match="cannot be '%s': it takes auto" % wrong):
            vfm.hexes(BALL, material_widths=wrong)
    for wrong in ({1: 0}, {1: -1}, {"": 1}, {1: float("nan")}, {1: float("inf")}):
        with pytest.raises(ValueError) as told:
            vfm.hexes(BALL, material_widths=wrong)
        assert str(told.value).startswith("material_widths is %r: it must be auto" % (wrong,))
    for wrong in ({1: "wide"}, {1: None}, {1: [1]}, 2, [("ball", 1)], ("ball", 1)):
        with pytest.raises(TypeError) as told:
            vfm.hexes(BALL, material_widths=wrong)
        assert str(told.value).startswith("material_widths is %r: it must be auto" % (wrong,))


def test_unknown_options():
    with pytest.raises(TypeError, match="smoothness"):
        vfm.hexes(BALL, smoothness=1)
    with pytest.raises(TypeError, match="method"):
        vfm.hexes(BALL, method="cells")


def test_method_tetgen():
    if vfm.has_tetgen:
        assert len(vfm.tets(BALL, method="tetgen"))
    else:
        with pytest.raises(ValueError, match="TetGen"):
            vfm.tets(BALL, method="tetgen")
