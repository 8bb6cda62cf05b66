"""vfmesh makes a mesh file from a file of volume fractions, labels or a closed surface."""

from __future__ import annotations

import argparse
import csv
import sys
import warnings
from typing import Any, Dict, List, Optional

import numpy as np

from . import VolumeFractionMeshWarning, __version__, fragments, hexes, tets
from ._core import Option, list_options, read_label_names
from ._files import are_labels, read_source
from .mesh import Mesh

OPTIONS = list_options()


def _add_option(group: Any, option: Option) -> None:
    word, told = "--" + option.name.replace("_", "-"), option.text.replace("%", "%%")
    if option.kind == "flag":
        group.add_argument(word, action=argparse.BooleanOptionalAction, default=option.default,
                           help=told)
    else:
        told += " (%s; %s)" % (option.allowed, option.default)
        kind = {"word": str, "text": str, "whole": int, "real": float}[option.kind]
        group.add_argument(word, type=kind, default=option.default, metavar=option.kind.upper(),
                           help=told)


def make_parser() -> argparse.ArgumentParser:
    """Makes the parser of the command line."""
    parser = argparse.ArgumentParser(
        prog="vfmesh", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("input",
                        help=".npy, .npz, .spcth, a folder of an AMReX plotfile, NIfTI (nibabel), "
                        ".vti (PyVista), .stl, or a format of SimpleITK")
    parser.add_argument("output", help=".vtu, .e, .inp, .msh, .xdmf, .foam or another format of "
                        "Mesh.save")
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
    parser.add_argument("--names", metavar="FILE",
                        help="names of labels: a text file with a label and its name in each line, "
                        "or a table of ITK-SNAP, FreeSurfer, MRIcron or an FSL atlas")
    parser.add_argument(
        "--spacing", type=float, nargs="+", metavar="WIDTH",
        help="width of cells in .npy and .npz: one number, or three for x, y and z"
    )
    parser.add_argument(
        "--origin", type=float, nargs=3, metavar="X",
        help="corner of the first cell in .npy and .npz"
    )
    parser.add_argument("--order", choices=("xyz", "zyx"), default="xyz",
                        help="order of the axes of arrays in .npy and .npz")
    parser.add_argument("--cells", type=int, default=64,
                        help="number of cells along the longest side of a surface (64)")
    parser.add_argument("--step", type=int, default=0,
                        help="index of the time step in .spcth, from 0")
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
                        help="write the surfaces of the mesh: .stl, a closed surface per material, "
                        "with {} in the name one file each; .vtp or another format of PyVista, all "
                        "facets once")
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
    return parser


def _arguments(words: argparse.Namespace) -> Dict[str, Any]:
    """Returns the arguments of hexes() or tets()."""
    source = read_source(words.input, words.array, words.cells, words.step)
    given: Dict[str, Any] = {
        option.name: getattr(words, option.name) for option in OPTIONS if words.tets
        or not option.tets
    }
    labels = words.labels or (not words.fractions and are_labels(source, words.array))
    if source.is_image:
        given["labels" if labels else "fractions"] = source.materials
        given["arrays"] = words.array
    elif labels:
        if len(source.materials) != 1:
            raise ValueError(
                "%s has %d arrays: choose the one that holds labels by --array."
                % (words.input, len(source.materials))
            )
        given["labels"] = next(iter(source.materials.values()))
    else:
        given["fractions"] = source.materials
    if words.names is not None:
        given["names"] = read_label_names(words.names)
    if words.spacing is not None:
        given["spacing"] = words.spacing if len(words.spacing) > 1 else words.spacing[0]
    if words.origin is not None:
        given["origin"] = words.origin
    given.update(
        order=words.order, state=words.state, velocity=words.velocity, energy=words.energy,
        density=words.density
    )
    given.update(
        state_kinds=words.state_kind, rotated_arrays=words.rotated_array,
        refinement_array=words.refinement_array, refinement_boxes=words.refinement_box
    )
    return _name_arrays(given, source.others)


def _name_arrays(given: Dict[str, Any], arrays: Dict[str, np.ndarray]) -> Dict[str, Any]:
    """Replaces names by arrays of an .npz file."""
    if not arrays:
        return given
    named = [
        name
        for key in ("state", "density", "velocity", "energy", "refinement_array")
        for name in np.atleast_1d(given[key] or [])
    ]
    given["state"] = [str(name) for name in given["state"] or []]
    chosen = {
        str(name): arrays[str(name)] for name in named if str(name) in arrays
        and name != given["refinement_array"]
    }
    missing = [name for name in given["state"] if name not in arrays]
    if missing:
        raise ValueError(
            "The file has no array %r. Its arrays that are not materials: %s."
            % (missing[0], ", ".join(map(repr, arrays)))
        )
    given["state"] = chosen or None
    if given["refinement_array"] is not None:
        given["refinement_array"] = arrays[given["refinement_array"]]
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
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(columns)
        writer.writerows(zip(*columns.values()))


def main(arguments: Optional[List[str]] = None) -> int:
    """Runs the command. Returns the exit status: 0, or 1 after one line with the reason."""
    words = make_parser().parse_args(arguments)
    warnings.showwarning = lambda message, *_, **__: print("warning: %s" % message, file=sys.stderr)
    warnings.simplefilter("always", VolumeFractionMeshWarning)
    try:
        make = tets if words.tets else hexes
        mesh = make(**_arguments(words), progress=not words.quiet)
        mesh.save(words.output)
        if words.surfaces and words.surfaces.lower().endswith(".stl"):
            mesh.save(words.surfaces)
        elif words.surfaces:
            mesh.to_pyvista("surfaces").save(words.surfaces)
        if words.table:
            write_table(mesh, words.table)
        if words.report:
            mesh.run.source = {"Input": words.input, "Mesh": words.output, **mesh.run.source}
            mesh.report(words.report, title="Mesh quality: " + words.output)
    except (ValueError, TypeError, ImportError, OSError, RuntimeError) as error:
        print("vfmesh: %s" % error, file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        return 130
    if not words.quiet:
        print(mesh)
    return 0


if __name__ == "__main__":
    sys.exit(main())
