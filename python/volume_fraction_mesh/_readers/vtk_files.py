"""Reads files of VTK: images, rectilinear grids, and hexahedra that form a grid."""

from __future__ import annotations

import os
import re
import subprocess
import sys
import tempfile
from typing import Any

from .named_files import check_inside, list_vtk_files, read_header
from .report import load_library, quiet

READERS = {".vti": "XMLImageData", ".vtr": "XMLRectilinearGrid", ".vts": "XMLStructuredGrid",
           ".vtu": "XMLUnstructuredGrid", ".pvti": "XMLPImageData",
           ".pvtr": "XMLPRectilinearGrid", ".pvts": "XMLPStructuredGrid",
           ".pvtu": "XMLPUnstructuredGrid"}
HEADER = re.compile(
    rb"^(DIMENSIONS|POINTS|CELLS|CELL_TYPES|CELL_DATA|POINT_DATA|[XYZ]_COORDINATES)([ \t0-9-]+)",
    re.MULTILINE)
LARGEST_RATIO = 1100  # of zlib


def read(path: str, is_trusted: bool) -> Any:
    """Returns a data set of VTK. is_trusted: the file may name files outside of its folder."""
    load_library("vtkmodules.vtkCommonCore", path)
    ending = os.path.splitext(path)[1].lower()
    if ending.startswith(".p") and not is_trusted:
        check_inside(path, list_vtk_files(read_header(path)))
    _check_lengths(path, ending)
    if ending in READERS:
        return _read_xml(path, ending)
    with tempfile.TemporaryDirectory() as folder:
        name = _convert(path, folder)
        return _read_xml(os.path.join(folder, name), os.path.splitext(name)[1])


def _convert(path: str, folder: str) -> str:
    """Converts a legacy file to a file in XML, in another process. Returns its name."""
    program = os.path.join(os.path.dirname(__file__), "convert_legacy_vtk.py")
    run = subprocess.run(
        [sys.executable, program, os.path.abspath(path), folder], stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, errors="replace", check=False,
        env={**os.environ, "PYTHONPATH": os.pathsep.join(each for each in sys.path if each)})
    _raise_problem(run.stdout)
    if run.returncode != 0:
        raise ValueError("it is damaged: VTK's reader ended with status %d." % run.returncode)
    return run.stdout.split()[-1]


def _raise_problem(text: str) -> None:
    """Raises ValueError with the first error that VTK printed."""
    problems = re.findall(r"^(?:vtk\w* \(\w+\): |(?=Error ))(.*)", text, re.MULTILINE)
    if problems:
        raise ValueError(problems[0])


def _read_xml(path: str, ending: str) -> Any:
    from vtkmodules import vtkIOXML
    from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow

    if ending not in READERS:
        raise ValueError("it holds polygons: volumes of a grid are required.")
    window, before = vtkStringOutputWindow(), vtkOutputWindow.GetInstance()
    vtkOutputWindow.SetInstance(window)
    try:
        with quiet():
            reader = getattr(vtkIOXML, "vtk%sReader" % READERS[ending])()
            reader.SetFileName(path)
            reader.Update()
        data = reader.GetOutputDataObject(0)
    finally:
        vtkOutputWindow.SetInstance(before)
    _raise_problem(window.GetOutput() or "")
    if data is None:
        raise ValueError("it holds no data set of VTK.")
    return data


def _check_lengths(path: str, ending: str) -> None:
    """Raises ValueError if the header announces more values than the file can hold, because VTK
    ends the program if it cannot allocate them."""
    length = os.path.getsize(path)
    with open(path, "rb") as file:
        if ending in READERS:
            _check_extents(file.read(1 << 16), length, ending)
            return
        text = file.read(1 << 27)
    _check_title(text)
    for match in HEADER.finditer(text):
        numbers = [int(word) for word in match.group(2).split() if word.lstrip(b"-").isdigit()]
        if match.group(1) != b"DIMENSIONS":
            counts = numbers[:1]
        else:
            counts = [max(numbers[0] - 1, 1) * max(numbers[1] - 1, 1) * max(numbers[2] - 1, 1)
                      ] if len(numbers) == 3 else [-1]
        if any(count < 0 or count > length for count in counts):
            raise ValueError("its line '%s' announces more values than its %d bytes hold."
                             % (match.group(0).decode("ascii").strip(), length))


def _check_title(text: bytes) -> None:
    """Checks the lines before the data."""
    title = re.match(rb"# vtk DataFile Version ([1-9])\.[0-9]+[ \t\r]*\n[^\n]*\n(ASCII|BINARY)\s+"
                     rb"DATASET[ \t]+(\w+)", text, re.IGNORECASE)
    if title is None:
        raise ValueError("it does not begin with '# vtk DataFile Version N.N', a title, ASCII or "
                         "BINARY, and DATASET.")


def _check_extents(text: bytes, length: int, ending: str) -> None:
    if b"<VTKFile" not in text:
        raise ValueError("it has no element VTKFile: it is not a file of VTK in XML.")
    if ending.startswith(".p"):  # lists other files
        return
    for extent in re.findall(rb'Extent="([-0-9 ]+)"', text):
        numbers = [int(word) for word in extent.split() if word.lstrip(b"-").isdigit()]
        if len(numbers) != 6:
            raise ValueError("its extent '%s' is not six integers." % extent.decode("ascii"))
        count = 1
        for a in range(3):
            count *= max(numbers[2 * a + 1] - numbers[2 * a], 1)
        if count > LARGEST_RATIO * length:
            raise ValueError("its extent '%s' has more cells than its %d bytes hold."
                             % (extent.decode("ascii"), length))
    for number in re.findall(rb'NumberOf(?:Points|Cells)="([0-9]+)"', text):
        if int(number) > LARGEST_RATIO * length:
            raise ValueError("it announces %s points or cells, more than its %d bytes hold."
                             % (number.decode("ascii"), length))
