"""The options of hexes() and tets(), one table: the name, what it takes and the default of each."""

from __future__ import annotations

import math
import operator
from typing import Any, Mapping, NamedTuple, Tuple, Type

from . import _core


class Option(NamedTuple):
    """kind: "flag", "whole", "real" or "word"; ends: which of low and high are allowed themselves, as in "[0, 1)";
    words: in the order of the core's numbers."""

    name: str
    kind: str
    default: Any
    low: float = -math.inf
    high: float = math.inf
    ends: str = "[]"
    words: Tuple[str, ...] = ()

    def range(self) -> str:
        """For messages and help."""
        if self.kind == "flag":
            return "True or False"
        if self.kind == "word":
            return ", ".join(repr(word) for word in self.words)
        text = "a whole number" if self.kind == "whole" else "a number"
        if math.isinf(self.low) and math.isinf(self.high):
            return text
        if math.isinf(self.high):
            return "%s, %g or more" % (text, self.low)
        return "%s in %s%g, %g%s" % (text, self.ends[0], self.low, self.high, self.ends[1])

    def check(self, value: Any) -> Any:
        """The value as the core takes it: bool, int, float or the number of a word.

        Raises ValueError or TypeError with name, value and range.
        """
        return getattr(self, "_" + self.kind)(value)

    def _refuse(self, error: Type[Exception], value: Any) -> Exception:
        return error("%s is %r: it must be %s." % (self.name, value, self.range()))

    def _flag(self, value: Any) -> bool:
        if isinstance(value, str) or value not in (False, True):
            raise self._refuse(TypeError, value)
        return bool(value)

    def _word(self, value: Any) -> int:
        if not isinstance(value, str):
            raise self._refuse(TypeError, value)
        if value not in self.words:
            raise self._refuse(ValueError, value)
        return self.words.index(value)

    def _whole(self, value: Any) -> int:
        try:
            number = operator.index(value)
        except TypeError:
            raise self._refuse(TypeError, value) from None
        return int(self._in_range(number, value))

    def _real(self, value: Any) -> float:
        if isinstance(value, (str, bytes)):
            raise self._refuse(TypeError, value)
        try:
            number = float(value)
        except (TypeError, ValueError):
            raise self._refuse(TypeError, value) from None
        return self._in_range(number, value)

    def _in_range(self, number: float, value: Any) -> float:
        above = number >= self.low if self.ends[0] == "[" else number > self.low
        below = number <= self.high if self.ends[1] == "]" else number < self.high
        if not (above and below):  # nor NaN
            raise self._refuse(ValueError, value)
        return number


STATE = (
    Option("state_transfer", "word", "automatic", words=("automatic", "copy", "conserve")),
    Option("state_order", "whole", 2, 1, 2),
    Option("nodal_velocity", "flag", False),
    Option("lost_kinetic_energy", "word", "report", words=("report", "internal_energy")),
    Option("unmeshed_material", "word", "give", words=("give", "drop")),
)
COMMON = (
    Option("mesh_void", "flag", False),
    Option("minimum_region_cells", "whole", 0, 0),
    Option("fraction_tolerance", "real", 1e-6, 1e-6, 0.1),
    Option("iso_value", "real", 0.5, 0, 1, "()"),
    Option("stair_step", "flag", False),
    Option("smoothing", "word", "quadric_surface", words=("off", "quadric_surface", "geometry_based")),
    Option("sharp_edges", "word", "automatic", words=("off", "on", "automatic")),
    Option("label_smoothing", "whole", 0, 0, 10),
    Option("conserve_volume", "flag", True),
    Option("refinement", "word", "input_levels", words=("off", "input_levels", "automatic", "coarsen", "uniform")),
    Option("maximum_level", "whole", -1, -1, 10),
    Option("fine_interfaces", "flag", True),
    Option("fine_layers", "whole", 2, 2, 64),
    Option("thin_cells", "real", 2.0, 0, 3),
    Option("curvature_per_cell", "real", 0.0, 0),
    Option("refine_flipped_cells", "flag", False),
    Option("interface_layers", "whole", 0, 0, 64),
    Option("maximum_aspect_ratio", "real", 0.0, 0),
    Option("child_fractions", "word", "planes", words=("planes", "parent")),
    Option("target_scaled_jacobian", "real", 0.0, 0, 1, "[)"),
    Option("compute_quality", "flag", True),
)
OF_TETS = (
    Option("method", "word", "lattice", words=("tetgen", "cells", "lattice")),
    Option("relative_size", "real", 1.0, 0.1, 1e6),
    Option("growth", "real", 0.3, 0, 1e6),
    Option("radius_edge_ratio", "real", 1.4, 1, 100),
    Option("minimum_dihedral_angle", "real", 10.0, 0, 60),
    Option("optimization_level", "whole", 4, 0, 10),
)
THREADS = Option("threads", "whole", 0, 0, 2**31 - 1)


def options_of(tets: bool) -> Tuple[Option, ...]:
    """Those of hexes(), or of tets(), but threads."""
    return STATE + COMMON + (OF_TETS if tets else ())


def core_options(tets: bool, given: Mapping[str, Any]) -> Any:
    """The options of the core; given: a value for each of options_of(tets)."""
    options = _core.Options()
    options.tets = tets
    checked = {option.name: option.check(given[option.name]) for option in options_of(tets)}
    del checked["state_transfer"]  # told with the arrays
    options.lost_to_internal = bool(checked.pop("lost_kinetic_energy"))
    options.give_unmeshed = checked.pop("unmeshed_material")
    for name, value in checked.items():
        setattr(options, name, value)
    return options
