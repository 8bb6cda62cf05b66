"""vfmesh makes a mesh file from a file of volume fractions, labels or closed surfaces."""

from __future__ import annotations

import argparse
import csv
import os
import sys
import warnings
from typing import Any, Dict, List, Optional

from . import VolumeFractionMeshWarning, __version__, fragments, hexes, tets
from ._core import Option, list_options, read_label_names
from ._images import Arrays, Fractions
from ._output import ended_by_signals, find_conflict, whole_file
from ._read import find_files, is_surface, read, sort_slices
from ._readers.report import one_line
from ._run import LABELS_OPTION
from ._save import BY_CORE
from ._shapes import DEFAULT_CELLS, surface
from .mesh import Mesh

OPTIONS = list_options()
EMPTY = "The mesh is empty"  # begins the warning of the core
OTHER_NAMES = {"fraction_tolerance": ("--clip",)}  # as in sculptor, which messages name


def _find_word(option: Option, text: str) -> str:
    """Returns the word of an option in any case, with or without separators; the text if there is
    none."""
    def plain(word: str) -> str:
        return word.lower().replace("_", "").replace("-", "")

    return next((word for word in option.words if plain(word) == plain(text)), text)


def _add_option(group: Any, option: Option) -> None:
    word, told = "--" + option.name.replace("_", "-"), option.text.replace("%", "%%")
    if option.kind == "flag":
        group.add_argument(word, action=argparse.BooleanOptionalAction, default=option.default,
                           help=told)
    else:
        told += " (%s; %s)" % (option.allowed, option.default)
        kind = {"word": lambda text: _find_word(option, text), "text": str, "widths": str,
                "sizes": str, "whole": int, "real": float}[option.kind]
        group.add_argument(word, *OTHER_NAMES.get(option.name, ()), type=kind,
                           default=option.default, metavar=option.kind.upper(), help=told)


def make_parser() -> argparse.ArgumentParser:
    """Makes the parser of the command line."""
    parser = argparse.ArgumentParser(
        prog="vfmesh", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("input", nargs="+",
                        help=".npy, .npz, .vti and other files of VTK, NIfTI, NRRD, MetaImage, "
                        "TIFF, PNG and other pictures, .dream3d, .spcth, Exodus, the folder of an "
                        "AMReX plotfile; slices: a folder, a pattern such as 'slices/*.tif', or "
                        "files; or closed surfaces (.stl, ..), each a material with the name of "
                        "its file if there are several, where the first has priority")
    parser.add_argument("output", help="%s or another format of Mesh.save" % ", ".join(BY_CORE))
    parser.add_argument("--version", action="version", version=__version__)
    parser.add_argument("--tets", action="store_true", help="make tetrahedra instead of hexahedra")
    kind = parser.add_mutually_exclusive_group()
    kind.add_argument("--labels", action="store_true",
                      help="the array holds labels (default: decided by its type and range)")
    kind.add_argument("--fractions", action="store_true", help="the arrays hold volume fractions")
    parser.add_argument(
        "--array", action="append", metavar="NAME",
        help="an array of the file that holds a material; repeat for more materials"
    )
    parser.add_argument("--threshold", metavar="LOW:HIGH",
                        help="values above LOW, up to and including HIGH, are a material; LOW has "
                        "no upper limit, :HIGH no lower one; several ranges with commas between "
                        "them")
    parser.add_argument("--names", metavar="FILE",
                        help="names of labels: a text file with a label and its name in each line, "
                        "or a table of ITK-SNAP, FreeSurfer, MRIcron or an FSL atlas")
    parser.add_argument("--volume", type=int, metavar="N",
                        help="index of the volume, from 0, of a file with several volumes")
    parser.add_argument(
        "--spacing", type=float, nargs="+", metavar="WIDTH",
        help="width of cells, instead of that of the file: one number, or three for x, y and z"
    )
    parser.add_argument(
        "--origin", type=float, nargs=3, metavar="X", default=[0.0, 0.0, 0.0],
        help="corner of the first cell in .npy and .npz"
    )
    parser.add_argument("--order", choices=("xyz", "zyx"), default="xyz",
                        help="order of the axes of arrays in .npy and .npz")
    parser.add_argument("--trust-input", action="store_true",
                        help="the header may name files outside of its folder")
    parser.add_argument("--cells", type=int,
                        help="number of cells along the longest side of surfaces (64); or "
                        "--cell-width")
    parser.add_argument("--step", type=int, default=0,
                        help="index of the time step in .spcth, Exodus and TIFF, from 0")
    for name, told in (
        ("state", "array to transfer to the elements; repeat for more"),
        ("density", "array of mass per volume, which switches conservation on; "
         "one for all materials, or repeat for each"),
        ("state-kind", "array=kind: quantity to conserve for a state array"),
        ("rotated-array", "state array of vectors or tensors along the axes of the image"),
    ):
        parser.add_argument("--" + name, action="append", metavar="NAME", help=told)
    for name, told in (
        ("velocity", "array of three components"),
        ("energy", "array of internal energy per mass"),
        ("refinement-array", "array of the number of times to halve each cell"),
    ):
        parser.add_argument("--" + name, metavar="NAME", help=told)
    parser.add_argument(
        "--refinement-box", type=float, nargs=7, action="append", metavar="X",
        help="box whose cells are halved: x0 y0 z0 x1 y1 z1 and the number of times"
    )
    parser.add_argument("--surfaces", metavar="FILE",
                        help="write the surfaces of the mesh: .stl or .obj, a closed surface per "
                        "material, with {} in the name one file each; a folder (a name without a "
                        "dot), one .stl each; .vtp or another format of PyVista, all facets once")
    parser.add_argument("--fragments", metavar="FILE", dest="table",
                        help="write a table of the fragments, .csv")
    parser.add_argument("--report", metavar="FILE",
                        help="write a quality report of the mesh, .html")
    parser.add_argument("--quiet", action="store_true", help="print neither progress nor summary")
    for title in dict.fromkeys(option.group for option in OPTIONS):
        group = parser.add_argument_group(title)
        for option in OPTIONS:
            if option.group == title:
                _add_option(group, option)
    parser.set_defaults(flat=None)  # None: pictures of one slice are meshed as a plane
    return parser


def _check_files(words: argparse.Namespace) -> None:
    """Raises ValueError if an output would replace an input or another output."""
    outputs = {"output": words.output, "--surfaces": words.surfaces, "--fragments": words.table,
               "--report": words.report}
    inputs = [("input", path) for word in words.input for path in find_files(word)]
    if words.names:
        inputs.append(("--names", words.names))
    problem = find_conflict({name: path for name, path in outputs.items() if path}, inputs)
    if problem:
        raise ValueError(problem)


def _read_surfaces(words: argparse.Namespace) -> Fractions:
    """Returns the fractions of surfaces. --cell-width without --cells is the width of their grid;
    the mesher then keeps these cells."""
    paths = words.input
    other = next((path for path in paths if not is_surface(path)), None)
    if other is not None:
        raise ValueError(
            "Surfaces can only be meshed with surfaces, but of the inputs %s is a surface and %s "
            "is not." % (next(filter(is_surface, paths)), other))
    if words.spacing or words.volume is not None or words.step or words.labels:
        raise ValueError("--spacing, --volume, --step and --labels do not apply to the surface %s: "
                         "--cells or --cell-width sets the grid." % paths[0])
    widths = [float(width) for width in str(words.cell_width).replace(",", " ").split()]
    if words.cells is not None or not any(widths):
        return surface(paths, DEFAULT_CELLS if words.cells is None else words.cells)
    if not words.material_widths:
        words.cell_width = 0.0
    return surface(paths, cell_width=widths[0] if len(widths) == 1 else widths)


def _read_input(words: argparse.Namespace) -> Any:
    """Returns the content of the input file or files."""
    if any(map(is_surface, words.input)):
        return _read_surfaces(words)
    if words.cells is not None:
        raise ValueError("--cells is for surfaces, and %s is none." % words.input[0])
    path = words.input[0] if len(words.input) == 1 else sort_slices(words.input)
    spacing = words.spacing
    return read(path, step=words.step, volume=words.volume, origin=words.origin, order=words.order,
                trust_input=words.trust_input,
                spacing=spacing[0] if spacing and len(spacing) == 1 else spacing)


def _arguments(words: argparse.Namespace) -> Dict[str, Any]:
    """Returns the arguments of hexes() or tets()."""
    found = _read_input(words)  # may take the option cell_width
    given: Dict[str, Any] = {
        option.name: getattr(words, option.name) for option in OPTIONS if words.tets
        or not option.tets
    }
    given["flat"] = bool(words.flat)
    if isinstance(found, Arrays) and words.flat is not None:
        found.is_picture = words.flat
    given["labels" if words.labels else "fractions"] = found
    if words.names is not None:
        given["names"] = read_label_names(words.names)
    given.update(
        arrays=words.array, threshold=words.threshold, state=words.state, velocity=words.velocity,
        energy=words.energy, density=words.density, state_kinds=words.state_kind,
        rotated_arrays=words.rotated_array, refinement_array=words.refinement_array,
        refinement_boxes=words.refinement_box
    )
    return given


def write_table(mesh: Mesh, path: str) -> None:
    """Writes a table with one row per fragment."""
    columns: Dict[str, Any] = {}
    sides = ("x_min", "x_max", "y_min", "y_max", "z_min", "z_max")
    axes = {
        "centroid": ("centroid_x", "centroid_y", "centroid_z"),
        "momentum": ("momentum_x", "momentum_y", "momentum_z"),
        "bounds": sides,
    }
    for name, values in fragments(mesh).items():
        if name in axes:
            columns.update(zip(axes[name], values.T))
        else:
            columns[name] = [" ".join(map(str, ids))
                             for ids in values] if name == "neighbours" else values
    with whole_file(path) as unfinished, open(unfinished, "w", newline="",
                                              encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(columns)
        writer.writerows(zip(*columns.values()))


def _show_warning(message: Any, *_: Any, **__: Any) -> None:
    """Prints a warning, except that of an empty mesh, which is an error of the command."""
    if not str(message).startswith(EMPTY):
        print("warning: %s" % one_line(message), file=sys.stderr)


def _is_folder(path: str) -> bool:
    """Returns whether a path of surfaces means a folder: its name has no dot, or it ends with /."""
    name = os.path.basename(path)
    return "." not in name or name in (".", "..")


def _write(mesh: Mesh, words: argparse.Namespace) -> None:
    """Writes all files of the command."""
    name = " ".join(words.input)
    if len(mesh) == 0:
        raise ValueError("The mesh of %s has no elements, because no cell is filled by its "
                         "materials to the iso value. Check --array, --labels, --threshold and "
                         "--iso-value. Nothing is written." % name)
    mesh.save(words.output)
    if words.surfaces and _is_folder(words.surfaces):
        if not os.path.isdir(words.surfaces):
            os.mkdir(words.surfaces)
        mesh.save(os.path.join(words.surfaces, "{}.stl"))
    elif words.surfaces and words.surfaces.lower().endswith((".stl", ".obj")):
        mesh.save(words.surfaces)
    elif words.surfaces:
        with whole_file(words.surfaces) as path:
            mesh.to_pyvista("surfaces").save(path)
    if words.table:
        write_table(mesh, words.table)
    if words.report:
        mesh.run.source = {"Input": name, "Mesh": words.output, **mesh.run.source}
        mesh.report(words.report, title="Mesh quality: " + words.output)


def main(arguments: Optional[List[str]] = None) -> int:
    """Runs the command. Returns the exit status: 0, or 1 after one line with the reason. SIGTERM,
    SIGINT and SIGHUP end the process."""
    with ended_by_signals("vfmesh"):
        return _run(arguments)


def _make_mesh(given: Dict[str, Any], words: argparse.Namespace) -> Mesh:
    """Makes the mesh. Messages of errors begin with the name of the input."""
    make = tets if words.tets else hexes
    before = LABELS_OPTION.set("--labels --array")
    try:
        return make(**given, progress=not words.quiet)
    except (ValueError, TypeError) as error:
        raise ValueError("Cannot mesh %s: %s" % (" ".join(words.input), error)) from None
    finally:
        LABELS_OPTION.reset(before)


def _run(arguments: Optional[List[str]]) -> int:
    words = make_parser().parse_args(arguments)
    warnings.showwarning = _show_warning
    warnings.simplefilter("always", VolumeFractionMeshWarning)
    try:
        _check_files(words)
        mesh = _make_mesh(_arguments(words), words)
        _write(mesh, words)
    except (ValueError, TypeError, ImportError, OSError, RuntimeError, MemoryError) as error:
        print("vfmesh: %s" % (one_line(error) or "There is not enough memory."), file=sys.stderr)
        return 1
    if not words.quiet:
        print(mesh)
    return 0


if __name__ == "__main__":
    sys.exit(main())
