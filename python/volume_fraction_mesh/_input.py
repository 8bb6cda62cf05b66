"""Converts the arguments for materials and their grid to the form of the core."""

from __future__ import annotations

from typing import Any, Dict, List, Mapping, NamedTuple, Optional, Sequence, Tuple

import numpy as np

from ._arrays import CellArrays, as_fractions, as_numbers, check_3d, check_order
from ._choice import LABELS_HINT, Contents, choose, list_contents
from ._core import Blocks, Bodies
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
    guessed: bool = False  # whether the arrays and their kind were chosen by their contents
    note: str = ""  # text of a warning
    surfaces: Optional[Bodies] = None  # from which the fractions were computed


class Source(NamedTuple):
    """Arguments of hexes() for materials and their grid.

    threshold: text of the ranges of the values of one array that are the materials. others: names
    of arrays with another purpose. tolerance: distance of fractions from [0, 1].
    """

    fractions: Any
    labels: Any
    spacing: Any
    origin: Any
    coordinates: Any
    direction: Any
    order: Any
    names: Any
    arrays: Any
    threshold: str = ""
    others: Sequence[str] = ()
    tolerance: float = 1e-6

    def contents(self, has_labels: bool = False) -> Contents:
        return Contents(self.others, self.tolerance, has_labels, bool(self.threshold))


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


def _list_named(fractions: Any) -> List[Tuple[str, Any]]:
    """Returns pairs of a name and an array or image, one per material."""
    if isinstance(fractions, Mapping):
        return list(fractions.items())
    values = list(fractions) if isinstance(fractions, (list, tuple)) else [fractions]
    return [("Material %d" % (i + 1), value) for i, value in enumerate(values)]


def _rename(chosen: Sequence[str], names: Any) -> List[str]:
    """Returns the names of fractions that the user gives."""
    if isinstance(names, (str, Mapping)) or len(names) != len(chosen):
        raise ValueError("names is %r: a list of %d, one for each material, is required."
                         % (names, len(chosen)))
    return list(names)


def _read_fractions(fractions: Any, order: str, given: Source) -> Field:
    named = _list_named(fractions)
    if not named:
        raise ValueError("fractions are empty: one array per material is required.")
    images = [read_image(value, given.arrays) for _, value in named]
    first = images[0]
    if first is not None:
        arrays = _join_images([name for name, _ in named], images, given)
        first = first._replace(chosen=list(arrays.flat), names={}, has_labels=all(
            image is not None and image.has_labels for image in images))
        return _make_field(arrays, first, isinstance(fractions, Mapping), given)
    if any(images) or given.arrays is not None:
        raise TypeError(
            "arrays is %r, or some fractions are images: arrays= requires an image, and images and "
            "arrays cannot be mixed." % (given.arrays,))
    arrays = CellArrays(order)
    for name, value in named:
        array = as_fractions(value, name)
        check_3d(array, name)
        arrays.add(name, array)
    image = Image(_given_grid(arrays.cells, given), arrays.flat, list(arrays.flat), order)
    if all(np.asarray(value).dtype == np.bool_ for _, value in named) and not given.threshold:
        return _name_fractions(arrays, image, isinstance(fractions, Mapping), given)
    return _make_field(arrays, image, isinstance(fractions, Mapping), given)


def _make_field(arrays: CellArrays, image: Image, have_names: bool, given: Source) -> Field:
    """Makes the field of arrays that are given as fractions. A single array of integers holds
    labels; several of them must be fractions or masks.

    have_names: whether the user named the arrays.
    """
    chosen, names = list(image.chosen or arrays.flat), given.names
    found = list_contents([(name, arrays.flat[name]) for name in chosen if name in arrays.flat],
                          given.contents(image.has_labels))
    if found.labels:
        label_names = dict(image.names)
        if have_names:
            label_names.setdefault(1, found.labels)
        elif isinstance(names, (list, tuple)):
            label_names.update(enumerate(_rename(chosen, names), 1))
            names = None
        return Field(arrays, image.grid, [], found.labels, _label_names(names, label_names),
                     guessed=not given.threshold)
    if found.problem:
        raise ValueError("%s %s" % (found.problem, image.hint or LABELS_HINT))
    return _name_fractions(arrays, image, have_names, given)


def _name_fractions(arrays: CellArrays, image: Image, have_names: bool, given: Source) -> Field:
    """Makes the field of arrays that hold fractions or masks. have_names: whether the user named
    the arrays."""
    chosen, names = list(image.chosen or arrays.flat), given.names
    surfaces = image.surfaces
    if names is not None:
        if have_names:
            raise TypeError("fractions have names already: names cannot be given too.")
        renamed = dict(zip(chosen, _rename(chosen, names)))
        arrays = arrays.renamed(renamed)
        chosen = list(renamed.values())
        surfaces = surfaces and surfaces._renamed(renamed)
    return Field(arrays, image.grid, chosen, "", {}, surfaces=surfaces)


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
    return Field(arrays, _given_grid(arrays.cells, given), [], "labels",
                 _label_names(given.names))


def _label_names(names: Any, own: Mapping[int, str] = {}) -> Dict[int, str]:
    """Returns the names of labels. names: from the user; own: from the file, for other labels."""
    if names is None:
        return dict(own)
    if not isinstance(names, Mapping):
        raise TypeError("names of labels is %r: a dict {label: name} is required." % (names,))
    for label, name in names.items():
        if not isinstance(label, (int, np.integer)) or not isinstance(name, str):
            raise TypeError("names of labels has %r: %r. An int and a str are required."
                            % (label, name))
    told = {int(label): name for label, name in names.items()}
    rest = {label: name for label, name in own.items() if name not in told.values()}
    return {**rest, **told}


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
    own = [blocks.labels] if blocks.labels and not blocks.fractions else blocks.fractions
    chosen = own if given.arrays is None else check_names(given.arrays)
    grid = Grid((np.empty(0),) * 3)
    if given.threshold and given.arrays is None and len(blocks.names) == 1:
        chosen = blocks.names
    if labels is not None or given.threshold or (
            given.arrays is None and blocks.labels and not blocks.fractions):
        if len(chosen) != 1:
            raise ValueError("labels are %d arrays, %r: one is required, arrays=[...]."
                             % (len(chosen), chosen))
        return Field(CellArrays("xyz"), grid, [], chosen[0], _label_names(names), blocks,
                     labels is None)
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
    arrays = _image_arrays(image)
    note, is_guessed = "", False
    if image.chosen is None:
        chosen, note = choose(arrays.items(), given.contents(image.has_labels), labels)
        image = image._replace(chosen=chosen)
        is_guessed = not given.threshold
    if not labels:
        field = _make_field(arrays, image, False, given)
        return field._replace(note=note, guessed=field.guessed or is_guessed)
    chosen = image.chosen or []
    if len(chosen) != 1:
        raise ValueError("labels are %d arrays, %r: one is required. %s"
                         % (len(chosen), chosen, image.hint or "arrays=[..] (--array) selects it."))
    return Field(arrays, image.grid, [], chosen[0], _label_names(given.names, image.names),
                 note=note)


def _join_images(names: Sequence[str], images: Sequence[Optional[Image]],
                 given: Source) -> CellArrays:
    """Returns the arrays of images on one grid, one image per material."""
    _check_no_grid(given)
    first = images[0]
    assert first is not None
    arrays = CellArrays(first.order, first.grid.cells)
    for name, image in zip(names, images):
        own = None if image is None else image.chosen or list(image.arrays)
        if image is None or own is None or len(own) != 1:
            raise TypeError(
                "fractions has %r, which is not an image of one array: images and arrays cannot be "
                "mixed." % name)
        if not image.grid.is_same(first.grid):
            raise ValueError("The images %r and %r lie on different grids: resample one of them."
                             % (names[0], name))
        if image.order != first.order:
            raise TypeError("The images %r and %r are of different kinds." % (names[0], name))
        arrays.add_flat(name, image.arrays[own[0]])
    return arrays
