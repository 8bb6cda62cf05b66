"""Converts the arguments for state to the form of the core."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, List, Mapping, NamedTuple, Optional, Tuple

import numpy as np

from ._arrays import as_numbers, shaped
from ._images import read_image
from ._input import Field

if TYPE_CHECKING:
    from ._core import StateChoice


class StateGiven(NamedTuple):
    """Arguments of hexes() for state."""

    state: Any
    density: Any
    velocity: Any
    energy: Any
    state_kinds: Any
    rotated_arrays: Any


def list_names(given: StateGiven, refinement_array: Any) -> List[str]:
    """Returns the names of arrays that are state or control the refinement."""
    names: List[str] = []
    for value in (given.state, given.density, given.velocity, given.energy, refinement_array):
        values = [value] if isinstance(value, str) else value
        if isinstance(values, (list, tuple)):
            names += [name for name in values if isinstance(name, str)]
    return names


def read_state(given: StateGiven, field: Field) -> Optional[StateChoice]:
    """Returns the state for the core, None without state. Adds the arrays to the field."""
    arrays = _list_arrays(field, given.state)
    densities = _add(field, "density", given.density)
    velocities, velocity = _add_one(field, "velocity", given.velocity)
    energies, energy = _add_one(field, "energy", given.energy)
    for names in (velocities, energies):  # the core transfers a single array by its role
        arrays += [name for name in names if len(names) > 1 and name not in arrays]
    kinds = _list_kinds(given.state_kinds)
    rotated = _list_rotated(given.rotated_arrays)
    if not (arrays or densities or velocity or energy):
        for name in ("state_kinds", "rotated_arrays"):
            if getattr(given, name):
                raise ValueError("%s is %r, but no state is given." % (name, getattr(given, name)))
        return None
    return {
        "arrays": arrays,
        "densities": densities,
        "kinds": kinds,
        "velocity": velocity,
        "energy": energy,
        "rotated": rotated,
    }


def _list_arrays(field: Field, state: Any) -> List[str]:
    if state is None:
        return []
    if isinstance(state, Mapping):
        return [name for key, value in state.items() for name in _add(field, key, value)]
    if isinstance(state, (list, tuple)) and all(isinstance(name, str) for name in state):
        return list(state)
    raise TypeError(
        "state is a %s: a dict {name: array}, or a list of names of arrays of the image, is "
        "required." % type(state).__name__
    )


def _list_kinds(kinds: Any) -> List[str]:
    """Returns the kinds as strings array=kind."""
    if kinds is None:
        return []
    if isinstance(kinds, Mapping):
        return ["%s=%s" % pair for pair in kinds.items()]
    if isinstance(kinds, str):
        return [kinds]
    if isinstance(kinds, (list, tuple)):
        return [str(word) for word in kinds]
    raise TypeError("state_kinds is %r: a dict {array: kind} is required." % (kinds,))


def _list_rotated(names: Any) -> List[str]:
    if names is None:
        return []
    if isinstance(names, str):
        return [names]
    if isinstance(names, (list, tuple)) and all(isinstance(name, str) for name in names):
        return list(names)
    raise TypeError("rotated_arrays is %r: a list of names is required." % (names,))


def _add(field: Field, name: str, value: Any) -> List[str]:
    """Adds the arrays of a value to the field and returns their names.

    The value is a name or names, one array for all materials, or one array per material.
    """
    if value is None:
        return []
    if isinstance(value, str):
        return [value]
    if field.blocks is not None and not (isinstance(value, (list, tuple))
                                         and all(isinstance(word, str) for word in value)):
        raise TypeError("%s is a %s: for %s, names of arrays are required."
                        % (name, type(value).__name__, field.blocks.path))
    if isinstance(value, Mapping):
        return _add_of_materials(field, name, value)
    if isinstance(value, (list, tuple)):
        if value and all(isinstance(word, str) for word in value):
            return list(value)
        if field.labels:
            raise TypeError("%s is a %s: for labels, a dict {label: array} is required."
                            % (name, type(value).__name__))
        if len(value) != len(field.fractions):
            raise ValueError(
                "%s has %d arrays: one for all materials, or one for each of %d, is required."
                % (name, len(value), len(field.fractions))
            )
        return _add_of_materials(field, name, dict(zip(field.fractions, value)))
    _add_array(field, name, value)
    return [name]


def _add_one(field: Field, name: str, value: Any) -> Tuple[List[str], str]:
    """Adds arrays as _add() does. Returns their names, and the name for the core: the array, or the
    common part of the names of one array per material."""
    names = _add(field, name, value)
    if isinstance(value, str):
        return [], value
    are_own = len(names) > 1 and not isinstance(
        value[0] if isinstance(value, (list, tuple)) else None, str)
    return names, name if are_own else names[0] if names else ""


def _add_of_materials(field: Field, name: str, values: Mapping[Any, Any]) -> List[str]:
    """Adds one array per material, with names such as "density - 1" that the core recognises."""
    if not field.labels and set(values) != set(field.fractions):
        raise ValueError(
            "%s has arrays of %s, but the materials are %s."
            % (name, ", ".join(map(repr, values)) or "none", ", ".join(map(repr, field.fractions)))
        )
    if len(values) == 1 and _are_alone(field, next(iter(values))):
        _add_array(field, name, next(iter(values.values())))
        return [name]
    numbers = ({key: key for key in values} if field.labels
               else {key: i + 1 for i, key in enumerate(field.fractions)})
    for key, number in numbers.items():
        _add_array(field, "%s - %s" % (name, number), values[key])
    return ["%s - %s" % (name, number) for number in numbers.values()]


def _are_alone(field: Field, label: Any) -> bool:
    """Returns whether the field has no other label than this one and void."""
    labels = field.arrays.flat[field.labels] if field.labels else np.empty(0)
    return bool(((labels == 0) | (labels == label)).all())


def _add_array(field: Field, name: str, value: Any) -> None:
    """Adds an array, an image, or a number that applies to all cells."""
    image = read_image(value, None)
    if image is None:
        array = as_numbers(value, name)
        if array.ndim == 0:
            array = shaped(np.full(int(np.prod(field.grid.cells)), array), field.grid.cells,
                           field.arrays.order)
        field.arrays.add(name, array)
    elif len(image.chosen) != 1 or not image.grid.is_same(field.grid):
        raise ValueError(
            "The image %r lies on another grid than the materials, or has several arrays." % name)
    else:
        field.arrays.add_flat(name, image.arrays[image.chosen[0]])


def add_refinement(value: Any, field: Field) -> str:
    """Adds the refinement array and returns its name, "" without one."""
    names = _add(field, "refinement_array", value)
    if len(names) > 1:
        raise TypeError("refinement_array is a %s: one array of integers is required."
                        % type(value).__name__)
    return "".join(names)


def list_boxes(boxes: Any) -> List[List[float]]:
    """Returns boxes of seven numbers each."""
    if boxes is None:
        return []
    try:
        found = [[float(number) for number in box] for box in boxes]
    except (TypeError, ValueError):
        raise TypeError("refinement_boxes is %r: a list of boxes of seven numbers is required."
                        % (boxes,)) from None
    for box in found:
        if len(box) not in (6, 7):
            raise ValueError(
                "refinement_boxes has %r: x0, y0, z0, x1, y1, z1 and the number of halvings are "
                "required." % (tuple(box),)
            )
    return [box + [1.0] * (7 - len(box)) for box in found]
