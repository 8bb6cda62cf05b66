"""Checks a file of VTK before VTK's readers open it, which crash or convert damaged values."""

from __future__ import annotations

import lzma
import zlib
from typing import Any, Dict, List, Optional, Tuple
from xml.parsers import expat

from .. import _core

CHUNK = 1 << 16  # bytes
DEEPEST = 64  # levels of elements
Element = Tuple[str, Dict[str, str], int, List[Any]]


def check(path: str, is_trusted: bool) -> None:
    """Raises ValueError, without the path, that names the array, the place and the value.

    is_trusted: the file may name files outside of its folder.
    """
    _core.check_vtk_file(path, read_outline, unpack, is_trusted)


class _Appended(Exception):
    """The appended data begin."""


class _Outline:
    """Elements of a file up to its appended data."""

    def __init__(self) -> None:
        self.top: Element = ("", {}, 0, [])
        self.open = [self.top]
        self.parser = expat.ParserCreate()
        self.parser.StartElementHandler = self.start
        self.parser.EndElementHandler = self.end
        self.parser.StartDoctypeDeclHandler = self.reject_doctype

    def start(self, name: str, attributes: Dict[str, str]) -> None:
        element: Element = (name, attributes, self.parser.CurrentByteIndex, [])
        self.open[-1][3].append(element)
        self.open.append(element)
        if len(self.open) > DEEPEST:
            raise ValueError("its elements are nested too deeply.")
        if name == "AppendedData":
            raise _Appended

    def end(self, _: str) -> None:
        self.open.pop()

    def reject_doctype(self, *_: Any) -> None:
        raise ValueError("it has a document type definition, which VTK does not write.")


def read_outline(path: str) -> Tuple[Element, Optional[int], str]:
    """Returns the root element, and the place and the encoding of the appended data.

    An element is its name, attributes, place in the file in bytes, and elements inside it.
    """
    outline = _Outline()
    with open(path, "rb") as file:
        try:
            data = file.read(CHUNK)
            while data:
                outline.parser.Parse(data, False)
                data = file.read(CHUNK)
            outline.parser.Parse(b"", True)
        except expat.ExpatError as error:
            raise ValueError("it is truncated or damaged: it is not XML in line %d (%s)."
                             % (error.lineno, expat.ErrorString(error.code))) from None
        except _Appended:
            last = outline.open[-1]
            return outline.top[3][0], last[2], last[1].get("encoding", "")
    return outline.top[3][0], None, ""


def unpack(compressor: str, packed: bytes, size: int) -> bytes:
    """Returns the bytes of a block of the given size; other bytes if the block is damaged."""
    try:
        if compressor == "vtkZLibDataCompressor":
            inflater = zlib.decompressobj()
            found = inflater.decompress(packed, size + 1)
            return found if inflater.eof else b""
        if compressor == "vtkLZMADataCompressor":
            unpacker = lzma.LZMADecompressor()
            found = unpacker.decompress(packed, size + 1)
            return found if unpacker.eof else b""
    except (zlib.error, lzma.LZMAError):
        return b""
    return _unpack_lz4(packed, size)


def _unpack_lz4(packed: bytes, size: int) -> bytes:
    from vtkmodules.vtkIOCore import vtkLZ4DataCompressor

    found = bytearray(max(size, 1))
    count = vtkLZ4DataCompressor().Uncompress(packed, len(packed), found, size)
    return bytes(found[:count])
