"""Converts the arguments for materials and their grid to the form of the core."""

from __future__ import annotations

from typing import Any, Dict, List, Mapping, NamedTuple, Optional, Sequence, Tuple

import numpy as np

from ._blocks import Blocks
from ._arrays import CellArrays, as_fractions, as_numbers, cells_of, check_3d, check_order
from ._grid import NOWHERE, UNIT, Grid, is_default, make_grid
from ._images import Image, check_names, read_image


class Field(NamedTuple):
    """Materials and their grid in the form of the core.

    fractions: names of arrays, one per material; labels: instead, the name of one array.
    label_names: names of the materials by label.
    """

    arrays: CellArrays
    grid: Grid
    fractions: List[str]
    labels: str
    label_names: Dict[int, str]
    blocks: Optional[Blocks] = None  # read from a file; grid and arrays are then empty


class Source(NamedTuple):
    """Arguments of hexes() for materials and their grid."""

    fractions: Any
    labels: Any
    spacing: Any
    origin: Any
    coordinates: Any
    direction: Any
    order: Any
    names: Any
    arrays: Any


def read_field(given: Source) -> Field:
    fractions, labels = given.fractions, given.labels
    if fractions is None and labels is None:
        raise TypeError(
            "Neither fractions nor labels are given: give volume fractions, one array per "
            "material, or one array of labels."
        )
    if fractions is not None and labels is not None:
        raise TypeError("Both fractions and labels are given: give one or the other.")
    if isinstance(fractions, Blocks) or isinstance(labels, Blocks):
        return _blocks_field(given)
    order = check_order(given.order)
    if labels is not None:
        return _read_labels(labels, order, given)
    image = read_image(fractions, given.arrays)
    if image is not None:
        return _image_field(image, given, labels=False)
    return _read_fractions(fractions, order, given)


def _named_fractions(fractions: Any, names: Optional[Sequence[str]]) -> List[Tuple[str, Any]]:
    """Returns pairs of a name and an array or image, one per material."""
    if isinstance(fractions, Mapping):
        if names is not None:
            raise TypeError("fractions have names already: names cannot be given too.")
        return list(fractions.items())
    values = list(fractions) if isinstance(fractions, (list, tuple)) else [fractions]
    if names is None:
        names = ["Material %d" % (i + 1) for i in range(len(values))]
    if isinstance(names, str) or isinstance(names, Mapping) or len(names) != len(values):
        raise ValueError("names is %r: a list of %d, one for each material, is required."
                         % (names, len(values)))
    return list(zip(names, values))


def _read_fractions(fractions: Any, order: str, given: Source) -> Field:
    named = _named_fractions(fractions, given.names)
    if not named:
        raise ValueError("fractions are empty: one array per material is required.")
    images = [read_image(value, given.arrays) for _, value in named]
    first = images[0]
    if first is not None:
        return _join_images([name for name, _ in named], images, given)
    if any(images) or given.arrays is not None:
        raise TypeError(
            "arrays is %r, or some fractions are images: arrays= requires an image, and images and "
            "arrays cannot be mixed." % (given.arrays,))
    arrays = CellArrays(order)
    for name, value in named:
        array = as_fractions(value, name)
        check_3d(array, name)
        arrays.add(name, array)
    return Field(arrays, _given_grid(arrays.cells, given), [name for name, _ in named], "", {})


def _given_grid(cells: Any, given: Source) -> Grid:
    return make_grid(cells, given.spacing, given.origin, given.coordinates, given.direction)


def _read_labels(labels: Any, order: str, given: Source) -> Field:
    image = read_image(labels, given.arrays)
    if image is not None:
        return _image_field(image, given, labels=True)
    if given.arrays is not None:
        raise TypeError("arrays is %r: it names arrays of an image." % (given.arrays,))
    if isinstance(labels, (Mapping, list, tuple)):
        raise TypeError("labels are a %s: one array of integers is required."
                        % type(labels).__name__)
    array = as_numbers(labels, "labels")
    check_3d(array, "labels")
    arrays = CellArrays(order)
    arrays.add("labels", array)
    return Field(arrays, _given_grid(cells_of(array, order), given), [], "labels",
                 _label_names(given.names))


def _label_names(names: Any) -> Dict[int, str]:
    if names is None:
        return {}
    if not isinstance(names, Mapping):
        raise TypeError("names of labels is %r: a dict {label: name} is required." % (names,))
    for label, name in names.items():
        if not isinstance(label, (int, np.integer)) or not isinstance(name, str):
            raise TypeError("names of labels has %r: %r. An int and a str are required."
                            % (label, name))
    return {int(label): name for label, name in names.items()}


def _check_no_grid(given: Source) -> None:
    """Raises an exception if a grid is given in addition to an image or file."""
    told = [name for name in ("coordinates", "direction") if getattr(given, name) is not None]
    told += [name for name, default in (("spacing", UNIT), ("origin", NOWHERE))
             if not is_default(getattr(given, name), default)]
    if told:
        raise TypeError("%s cannot be given too: the image or file defines the grid."
                        % " and ".join(told))


def _blocks_field(given: Source) -> Field:
    """Makes the field of fractions or labels that read() returned."""
    _check_no_grid(given)
    labels, names = given.labels, given.names
    blocks = given.fractions if labels is None else labels
    chosen = blocks.fractions if given.arrays is None else check_names(given.arrays)
    grid = Grid((np.empty(0),) * 3)
    if labels is not None:
        if len(chosen) != 1:
            raise ValueError("labels are %d arrays, %r: one is required, arrays=[...]."
                             % (len(chosen), chosen))
        return Field(CellArrays("xyz"), grid, [], chosen[0], _label_names(names), blocks)
    if names is not None:
        raise TypeError("names cannot be given: the materials of %s have the names of its arrays."
                        % blocks.path)
    if not chosen:
        raise ValueError(
            "Name the arrays of %s that hold materials, arrays=[...]. It has %s."
            % (blocks.path, ", ".join(map(repr, blocks.names)))
        )
    return Field(CellArrays("xyz"), grid, chosen, "", {}, blocks)


def _image_arrays(image: Image) -> CellArrays:
    arrays = CellArrays(image.order, image.grid.cells)
    for name, flat in image.arrays.items():
        arrays.add_flat(name, flat)
    return arrays


def _image_field(image: Image, given: Source, labels: bool) -> Field:
    _check_no_grid(given)
    names = given.names
    if labels:
        if len(image.chosen) != 1:
            raise ValueError("labels are %d arrays, %r: one is required."
                             % (len(image.chosen), image.chosen))
        return Field(_image_arrays(image), image.grid, [], image.chosen[0], _label_names(names))
    for name in image.chosen:
        if name in image.arrays:
            image.arrays[name] = as_fractions(image.arrays[name], name)
    chosen = image.chosen
    if names is not None:
        chosen = [name for name, _ in _named_fractions([None] * len(chosen), names)]
        renamed = dict(zip(image.chosen, chosen))
        image = image._replace(arrays={renamed.get(name, name): array
                                       for name, array in image.arrays.items()})
    return Field(_image_arrays(image), image.grid, chosen, "", {})


def _join_images(names: Sequence[str], images: Sequence[Optional[Image]], given: Source) -> Field:
    """Makes the field of images on one grid, one image per material."""
    _check_no_grid(given)
    first = images[0]
    assert first is not None
    arrays = CellArrays(first.order, first.grid.cells)
    for name, image in zip(names, images):
        if image is None or len(image.chosen) != 1:
            raise TypeError(
                "fractions has %r, which is not an image of one array: images and arrays cannot be "
                "mixed." % name)
        if not image.grid.is_same(first.grid):
            raise ValueError("The images %r and %r lie on different grids: resample one of them."
                             % (names[0], name))
        arrays.add_flat(name, as_fractions(image.arrays[image.chosen[0]], name))
    return Field(arrays, first.grid, list(names), "", {})
