"""Finds the names of labels that an image itself holds."""

from __future__ import annotations

import re
from typing import Any, Dict, Iterable, List, Mapping, NamedTuple, Optional, Tuple
from xml.etree import ElementTree

import numpy as np


class Segment(NamedTuple):
    """Segment of 3D Slicer: its name, and the value that marks it in one volume of the file."""

    name: str
    value: int
    layer: int


def unique_names(pairs: Iterable[Tuple[int, str]]) -> Dict[int, str]:
    """Returns the names by label, without the void. Repeated names get their label."""
    names: Dict[int, str] = {}
    for label, name in pairs:
        if label > 0 and name:
            names[label] = "%s (%d)" % (name, label) if name in names.values() else name
    return names


def find_caret_names(extensions: Iterable[Any], volume: int) -> Dict[int, str]:
    """Returns the names in the LabelTable of a Caret extension of NIfTI.

    extensions: of a header of nibabel. volume: index of the volume whose table is read.
    """
    for extension in extensions:
        content = getattr(extension, "content", None)  # bytes, since nibabel 5.3
        try:
            content = extension.get_content() if content is None else content
        except Exception:  # extensions of other programs may be damaged
            continue
        if not isinstance(content, bytes) or b"<LabelTable" not in content:
            continue
        names = _read_caret(content.strip(b"\0"), volume)
        if names:
            return names
    return {}


def _read_caret(text: bytes, volume: int) -> Dict[int, str]:
    if b"<!ENTITY" in text:
        return {}
    try:
        root = ElementTree.fromstring(text)
    except ElementTree.ParseError:
        return {}
    volumes = list(root.iter("VolumeInformation"))
    own = [node for node in volumes if node.get("Index", "0").strip() == str(volume)]
    found = (own or volumes or [root])[0]
    return unique_names(
        (int(label.get("Key", "")), " ".join((label.text or "").split()))
        for label in found.iter("Label")
        if re.fullmatch(r"\s*[0-9]{1,9}\s*", label.get("Key", "")))


def find_segments(header: Mapping[str, str]) -> List[Segment]:
    """Returns the segments that 3D Slicer lists in the header of a .seg.nrrd."""
    segments = []
    for number in sorted(int(match.group(1)) for match in map(
            re.compile(r"Segment(\d+)_LabelValue").fullmatch, header) if match):
        value, layer = (header.get("Segment%d_%s" % (number, key), "0").strip()
                        for key in ("LabelValue", "Layer"))
        name = " ".join(_decode(header.get("Segment%d_Name" % number, "")).split())
        if value.isdecimal() and layer.isdecimal():
            segments.append(Segment(name or "Segment %d" % number, int(value), int(layer)))
    return segments


def _decode(text: str) -> str:
    """Returns a text of SimpleITK, whose bytes are Latin-1 if they are not UTF-8."""
    try:
        text.encode()
    except UnicodeEncodeError:
        return text.encode("utf-8", "surrogateescape").decode("latin-1")
    return text


def join_segments(segments: List[Segment], layers: List[np.ndarray]) -> Optional[np.ndarray]:
    """Returns labels from 1 in the order of the segments, or None if the file lists no layer.

    Raises ValueError if two segments overlap.
    """
    labels = np.zeros(layers[0].shape, np.int32)
    for number, segment in enumerate(segments, 1):
        if segment.layer >= len(layers):
            raise ValueError("its segment '%s' lies in layer %d, and it has %d layers."
                             % (segment.name, segment.layer, len(layers)))
        own = layers[segment.layer] == segment.value
        overlap = labels[own]
        if overlap.any():
            other = segments[int(overlap[overlap > 0][0]) - 1]
            raise ValueError(
                "its segments '%s' and '%s' share %d voxels, and a voxel has one material. Choose "
                "one of its %d layers: volume=N (--volume N), from 0."
                % (other.name, segment.name, np.count_nonzero(overlap), len(layers)))
        labels[own] = number
    return labels if segments else None
