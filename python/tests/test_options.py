"""The table of options, the signatures, the core and the README tell the same."""

import inspect
import re

import pytest

import volume_fraction_mesh as vfm
from fields import BALL
from volume_fraction_mesh import _core
from volume_fraction_mesh._options import COMMON, OF_TETS, STATE, THREADS, options_of

ALL = STATE + COMMON + OF_TETS + (THREADS,)
NUMBERS = [option for option in ALL if option.kind in ("whole", "real")]
IN_CORE = [
    option
    for option in ALL
    if option.name not in ("threads", "state_transfer", "lost_kinetic_energy", "unmeshed_material")
]


def make_of(option):
    return vfm.tets if option in OF_TETS else vfm.hexes


@pytest.mark.parametrize("make", [vfm.hexes, vfm.tets])
def test_signatures(make):
    told = inspect.signature(make).parameters
    for option in options_of(make is vfm.tets) + (THREADS,):
        assert told[option.name].default == option.default and told[option.name].kind is inspect.Parameter.KEYWORD_ONLY
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
        "refinement_array",
        "refinement_boxes",
        "progress",
        "threads",
    }
    assert set(told) == others | {option.name for option in options_of(make is vfm.tets)}
    for name in told:
        assert re.search(r"\b%s\b.* : " % name, vfm.hexes.__doc__ + vfm.tets.__doc__), name


@pytest.mark.parametrize("option", IN_CORE, ids=lambda option: option.name)
def test_defaults_are_those_of_the_core(option):
    if option.name == "method":
        return  # the filters prefer TetGen where it is built in
    assert getattr(_core.Options(), option.name) == option.check(option.default)


@pytest.mark.parametrize("option", NUMBERS, ids=lambda option: option.name)
def test_ranges(option):
    step = 1 if option.kind == "whole" else 1e-9
    inside = [low for low in (option.low,) if option.ends[0] == "["] + [
        high for high in (option.high,) if option.ends[1] == "]"
    ]
    for value in inside:
        assert abs(value) == float("inf") or option.check(value) == value
    for value in (
        option.low - step,
        option.high + step * max(1, abs(option.high)),
        float("nan") if option.kind == "real" else option.low - 7,
    ):
        if abs(value) == float("inf"):
            continue
        with pytest.raises(ValueError) as told:
            make_of(option)(BALL, **{option.name: value})
        assert (
            option.name in str(told.value) and repr(value) in str(told.value) and "%g" % option.low in str(told.value)
        )


@pytest.mark.parametrize("option", ALL, ids=lambda option: option.name)
def test_wrong_types(option):
    for value in ("3", None, [1], 1.5 if option.kind == "whole" else {}):
        with pytest.raises((TypeError, ValueError)) as told:
            make_of(option)(BALL, **{option.name: value})
        assert isinstance(told.value, TypeError) or option.kind == "word"
        assert str(told.value).startswith("%s is %r: it must be " % (option.name, value))


@pytest.mark.parametrize("option", [option for option in ALL if option.kind == "word"], ids=lambda option: option.name)
def test_words(option):
    for number, word in enumerate(option.words):
        assert option.check(word) == number
    with pytest.raises(ValueError) as told:
        make_of(option)(BALL, **{option.name: "Quick"})
    assert all(repr(word) in str(told.value) for word in option.words)


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
