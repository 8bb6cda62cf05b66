"""Reads files of VTK: images, rectilinear grids, and hexahedra that form a grid."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from typing import Any

from .._output import at_ending, temporary_folder
from .check_vtk import check
from .report import load_library, quiet

READERS = {".vti": "XMLImageData", ".vtr": "XMLRectilinearGrid", ".vts": "XMLStructuredGrid",
           ".vtu": "XMLUnstructuredGrid", ".pvti": "XMLPImageData",
           ".pvtr": "XMLPRectilinearGrid", ".pvts": "XMLPStructuredGrid",
           ".pvtu": "XMLPUnstructuredGrid"}


def read(path: str, is_trusted: bool) -> Any:
    """Returns a data set of VTK. is_trusted: the file may name files outside of its folder."""
    load_library("vtkmodules.vtkCommonCore", path)
    ending = os.path.splitext(path)[1].lower()
    check(path, is_trusted)
    if ending in READERS:
        return _read_xml(path, ending)
    with temporary_folder() as folder:
        name = _convert(path, folder)
        return _read_xml(os.path.join(folder, name), os.path.splitext(name)[1])


def _convert(path: str, folder: str) -> str:
    """Converts a legacy file to a file in XML, in another process. Returns its name."""
    program = os.path.join(os.path.dirname(__file__), "convert_legacy_vtk.py")
    with subprocess.Popen(
            [sys.executable, program, os.path.abspath(path), folder], stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, errors="replace",
            env={**os.environ, "PYTHONPATH": os.pathsep.join(each for each in sys.path if each)}
    ) as process, at_ending(lambda: _stop(process)):
        try:
            told = process.communicate()[0]
        except BaseException:  # Ctrl-C
            _stop(process)
            raise
    _raise_problem(told)
    if process.returncode != 0:
        raise ValueError("it is damaged: VTK's reader ended with status %d." % process.returncode)
    return told.split()[-1]


def _stop(process: Any) -> None:
    process.kill()
    process.wait()


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
