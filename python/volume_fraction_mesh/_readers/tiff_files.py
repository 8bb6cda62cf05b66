"""Reads TIFF files by tifffile: stacks, single pages, files of ImageJ and OME."""

from __future__ import annotations

import re
from typing import Any, Dict, List, NamedTuple, Optional, Tuple
from xml.etree import ElementTree

import numpy as np

from .report import keep_log, load_library

ENDINGS = (".tif", ".tiff")
MILLIMETRES = {2: 25.4, 3: 10.0}  # values of ResolutionUnit
WHITE_IS_ZERO = 0  # value of PhotometricInterpretation
# Units of length in metres. Units that OME and ImageJ write.
METRES = {"m": 1.0, "dm": 0.1, "cm": 1e-2, "mm": 1e-3, "um": 1e-6, "micron": 1e-6,
          "microns": 1e-6, "micrometer": 1e-6, "micrometre": 1e-6, "nm": 1e-9,
          "nanometer": 1e-9, "nanometre": 1e-9, "pm": 1e-12, "angstrom": 1e-10, "a": 1e-10,
          "millimeter": 1e-3, "millimetre": 1e-3, "centimeter": 1e-2, "centimetre": 1e-2,
          "meter": 1.0, "metre": 1.0, "inch": 0.0254, "in": 0.0254}

Widths = Tuple[Optional[float], Optional[float], Optional[float]]


class Stack(NamedTuple):
    """Volumes of a file, each of shape (slices, rows, columns) or with channels of colour as a
    fourth axis; widths of voxels along x, y and z, None if the file does not contain them."""

    volumes: List[np.ndarray]
    widths: Widths


def read(path: str, step: int, is_slice: bool = False) -> Stack:
    """Reads a file. is_slice: it is one slice of several; ImageJ then describes the whole stack in
    it."""
    tifffile = load_library("tifffile", path)
    with keep_log("tifffile") as log, tifffile.TiffFile(path) as file:
        stack = _read_page(file) if is_slice and _is_part(file) else _read_file(file, step)
        lost = [text for text in log if "TiffPages" in text or "Missing data" in text]
        if lost:
            raise ValueError("a page is damaged or missing: %s." % re.sub(r"<.*?> ?", "", lost[0]))
    return stack


def _is_part(file: Any) -> bool:
    """Returns whether the file has one page, and not the other images that it describes."""
    return len(file.pages) == 1 and any(
        series.size > file.pages[0].size and series.nbytes > file.filehandle.size
        for series in file.series)


def _read_page(file: Any) -> Stack:
    page = file.pages[0]
    volumes = _split(_turn(page.asarray(), page.axes, page), page.axes, 0)
    return Stack(volumes, _find_widths(file, page))


def _read_file(file: Any, step: int) -> Stack:
    if not file.series:
        raise ValueError("it has no image.")
    first = file.series[0]
    for other in file.series[1:]:
        if (other.shape, other.dtype, other.axes) != (first.shape, first.dtype, first.axes):
            raise ValueError(
                "its pages differ in size or type: %s of the type %s, and %s of the type %s."
                % (" x ".join(map(str, first.shape)), first.dtype,
                   " x ".join(map(str, other.shape)), other.dtype))
    images, axes = [series.asarray() for series in file.series], first.axes
    if first.axes in ("YX", "YXS") and len(images) > 1:  # one series per page
        images, axes = [np.stack(images)], "I" + axes
    volumes: List[np.ndarray] = []
    for image in images:
        volumes += _split(_turn(image, axes, first.keyframe), axes, step)
    return Stack(volumes, _find_widths(file, first.keyframe))


def _turn(values: np.ndarray, axes: str, page: Any) -> np.ndarray:
    """Inverts values for which 0 is white, and reverses rows that are stored from the bottom."""
    if page.photometric == WHITE_IS_ZERO and values.dtype.kind in "bu":
        values = ~values
    if values.dtype == np.bool_:
        values = values.view(np.uint8)
    orientation = page.tags.get(274)
    if orientation is not None and orientation.value != 1:
        values = np.flip(values, axis=axes.index("Y"))
    return values


def _split(values: np.ndarray, axes: str, step: int) -> List[np.ndarray]:
    """Returns the volumes of a time step, one per channel."""
    order = [axis for axis in axes]
    if "Y" not in order or "X" not in order:
        raise ValueError("its axes are %s: Y and X are required." % axes)
    slices = [axis for axis in order if axis not in "YXSCT"]
    if not slices and "T" in order:  # a stack of pages without other axes
        slices = ["T"]
    steps = values.shape[order.index("T")] if "T" in order and "T" not in slices else 1
    if not -steps <= step < steps:
        raise ValueError("there is no step %d: it has %d, counted from 0." % (step, steps))
    if steps > 1 or ("T" in order and "T" not in slices):
        values = values.take(step, axis=order.index("T"))
        order.remove("T")
    wanted = (["C"] if "C" in order else []) + slices + ["Y", "X"] + (["S"] if "S" in order else [])
    values = values.transpose([order.index(axis) for axis in wanted])
    channels = values.shape[0] if "C" in order else 1
    if "S" in order and values.shape[-1] not in (3, 4):
        raise ValueError("it has %d values per point: 1, 3 or 4 are required." % values.shape[-1])
    tail = values.shape[-3:] if "S" in order else values.shape[-2:]
    values = values.reshape(channels, -1, *tail)
    return [np.ascontiguousarray(volume) for volume in values]


def _find_widths(file: Any, page: Any) -> Widths:
    """Returns the widths in the unit that ImageJ or OME names, otherwise in millimetres."""
    if file.is_ome:
        widths = _find_ome_widths(file.ome_metadata or "")
        if widths[0] is not None:
            return widths
    x, y = (_read_ratio(page, tag) for tag in (282, 283))
    tag = page.tags.get(296)
    number = int(tag.value) if tag is not None else 2
    if file.is_imagej:
        meta: Dict[str, Any] = file.imagej_metadata or {}
        unit, z = _clean_unit(meta.get("unit")), meta.get("spacing")
        if unit in METRES and x and y:
            depth = abs(float(z)) if isinstance(z, (int, float)) and z else None
            # A resolution per centimetre next to micrometres, as ImageJ reads it.
            scale = 1e4 if number == 3 and METRES[unit] == 1e-6 else 1.0
            return scale / x, scale / y, depth
    length = MILLIMETRES.get(number)
    if length is None or not x or not y:
        return None, None, None
    return length / x, length / y, None


def _read_ratio(page: Any, tag: int) -> Optional[float]:
    found = page.tags.get(tag)
    if found is None or not isinstance(found.value, tuple) or len(found.value) != 2:
        return None
    above, below = found.value
    return above / below if above > 0 and below > 0 else None


def _clean_unit(unit: Any) -> str:
    text = str(unit).strip().lower()
    for sign in ("\\u00b5", "\u00b5", "\u03bc", "\ufffd"):
        text = text.replace(sign, "u")
    return text.replace("\u00e5", "angstrom")


def _find_ome_widths(text: str) -> Widths:
    """Returns the PhysicalSize of the first image of OME, in the unit of x."""
    if "<!ENTITY" in text:
        return None, None, None
    try:
        root = ElementTree.fromstring(text)
    except ElementTree.ParseError:
        return None, None, None
    pixels = next((node for node in root.iter() if node.tag.split("}")[-1] == "Pixels"), None)
    if pixels is None:
        return None, None, None
    units = [_clean_unit(pixels.get("PhysicalSize%sUnit" % axis, "um")) for axis in "XYZ"]
    common = METRES.get(units[0])
    widths: List[Optional[float]] = []
    for axis, unit in zip("XYZ", units):
        try:
            size = float(pixels.get("PhysicalSize" + axis, ""))
        except ValueError:
            size = 0.0
        known = common is not None and unit in METRES and 0 < size < float("inf")
        scale = 1.0 if not known or unit == units[0] else METRES[unit] / common
        widths.append(size * scale if known else None)
    x, y, z = widths
    return (None, None, None) if x is None or y is None else (x, y, z)
