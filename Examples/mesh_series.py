#!/usr/bin/env pvbatch
"""Meshes each time step of a file series.

usage: pvbatch mesh_series.py --plugin PLUGIN.so --array water --out meshes [--exodus] dump_*.vti
       pvbatch mesh_series.py --plugin PLUGIN.so --material-ids id --out meshes run.pvd
       pvbatch mesh_series.py --plugin PLUGIN.so --out meshes impact.spcth
       pvbatch mesh_series.py --plugin PLUGIN.so --array phi --out meshes plt*

Several files are the steps of one series, in the order of the numbers in their names. From a file
with several steps (.pvd, .spcth), all steps are read. A SpyPlot case (.spcth) needs neither --array
nor --material-ids; the default is its arrays 'Material volume fraction - N'. All levels of refined
data are read (.vthb, AMReX plotfiles, .hierarchy of Enzo, .flash).

Writes OUT/NAME_0000.vtu, OUT/NAME_0001.vtu and so on, and prints one line per step. Options add an
Exodus file and a table of fragments per step. If a step cannot be meshed, the others are meshed and
the exit status is 1.
"""
import argparse
import os
import re
import sys

from paraview import simple

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from load_plugin import load_plugin
from need_files import need_files
from write_exodus import write_exodus


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("files", nargs="+", help="files of the series, or one file with all steps")
    parser.add_argument("--plugin", required=True, help="path of VolumeFractionMesh.so")
    parser.add_argument("--array", action="append", default=[],
                        help="array of volume fractions of a material; repeat for each material")
    parser.add_argument("--material-ids", metavar="ARRAY",
                        help="integer array of material ids, instead of --array")
    parser.add_argument("--out", default=".",
                        help="folder of the meshes (default: the current folder)")
    parser.add_argument("--name", default="mesh",
                        help="first part of the file names (default: mesh)")
    parser.add_argument("--exodus", action="store_true",
                        help="also write .e files, with blocks and side sets, of non-empty meshes")
    parser.add_argument("--fragments", action="store_true",
                        help="also write a table of the fragments, .csv")
    parser.add_argument("--target", type=float, default=0.0,
                        help="TargetScaledJacobian (default: 0, automatic)")
    parser.add_argument("--tets", choices=("TetGen", "Cells", "Lattice"),
                        help="make tetrahedra with this method instead of hexahedra")
    parser.add_argument("--void", action="store_true", help="also mesh the void, as material 0")
    arguments = parser.parse_args()
    if arguments.array and arguments.material_ids or not (
            arguments.array or arguments.material_ids or is_spyplot(arguments.files)):
        parser.error("give either --array or --material-ids")
    return arguments


# By default ParaView reads such files as particles.
GRID_READERS = {".hierarchy": "EnzoReader", ".flash": "FlashReader"}


def is_spyplot(files):
    return files[0].endswith(".spcth")


def number_key(path):
    """Returns a sort key that orders step_9 before step_10."""
    return [int(part) if part.isdigit() else part for part in re.split(r"(\d+)", path)]


def open_files(files, arrays):
    """Returns a reader of the files. A reader of refined data reads all levels and these arrays."""
    grids = GRID_READERS.get(os.path.splitext(files[0])[1])
    source = getattr(simple, grids)(FileNames=files) if grids else simple.OpenDataFile(files)
    properties = source.ListProperties() if source else []
    if "DefaultNumberOfLevels" in properties:
        source.DefaultNumberOfLevels = 0  # all levels
    if "Level" in properties:
        source.Level, source.CellArrayStatus = 100, arrays
    return source


def open_series(files, arrays):
    """Returns a reader of the series. For a SpyPlot case it reads these arrays; if the list is
    empty, it reads all volume fractions and adds their names to the list."""
    if not is_spyplot(files):
        return open_files(sorted(files, key=number_key), arrays)
    if len(files) > 1:
        sys.exit("give one SpyPlot case file; it contains all steps")
    source = simple.OpenDataFile(files[0])
    if source is None:
        return None
    fractions = [name for name in source.CellArrays.Available
                 if re.search(r"[vV]olume [fF]raction - \d+$", name)]
    arrays += [] if arrays else sorted(fractions, key=number_key)
    source.CellArrays = arrays
    # This must follow the opening of the files; ParaView 5.11 would reset it.
    source.DownConvertVolumeFraction = 0
    return source


def find_times(source):
    """Returns the time steps of the series, or [None] if it has no times."""
    source.UpdatePipelineInformation()
    times = source.TimestepValues
    return (list(times) if hasattr(times, "__len__") and len(times)
            else [times] if isinstance(times, float) else [None])


def report(mesh, path):
    field = lambda name: mesh.GetFieldData().GetAbstractArray(name)
    volumes = ", ".join("%s %.6g" % (field("MaterialNames").GetValue(i),
                                     field("MeshVolume").GetValue(i))
                        for i in range(field("MeshVolume").GetNumberOfValues()))
    lowest = field("MinimumScaledJacobian").GetValue(0)
    print("%s: %d elements, min scaled Jacobian %.3f, volumes: %s"
          % (path, mesh.GetNumberOfCells(), lowest, volumes))


def main():
    arguments = parse_arguments()
    need_files(arguments.plugin, *arguments.files)
    load_plugin(arguments.plugin, globals())  # defines the filters
    arrays = [arguments.material_ids] if arguments.material_ids else arguments.array
    source = open_series(arguments.files, arrays)
    if source is None:
        sys.exit("cannot read " + arguments.files[0])
    mesher = (VolumeFractionToTet(Input=source, Method=arguments.tets) if arguments.tets
              else VolumeFractionToHex(Input=source))
    mesher.VolumeFractionArrays = arguments.array
    mesher.MaterialIdArray = arguments.material_ids or "None"
    mesher.TargetScaledJacobian, mesher.MeshVoid = arguments.target, int(arguments.void)
    fragments = VolumeFractionFragments(Input=mesher)
    os.makedirs(arguments.out, exist_ok=True)
    failed = 0
    for step, time in enumerate(find_times(source)):
        at_time = [] if time is None else [time]
        mesher.UpdatePipeline(*at_time)
        mesh = mesher.GetClientSideObject().GetOutputDataObject(0)
        stem = os.path.join(arguments.out, "%s_%04d" % (arguments.name, step))
        if mesh.GetFieldData().GetAbstractArray("MeshVolume") is None:
            print("%s: no mesh, see the message above" % stem)
            failed += 1
            continue
        report(mesh, stem + ".vtu")
        simple.SaveData(stem + ".vtu", proxy=mesher, DataMode="Binary", CompressorType="ZLib")
        if arguments.exodus and mesh.GetNumberOfCells() > 0:
            write_exodus(mesh, stem + ".e")
        if arguments.fragments:
            fragments.UpdatePipeline(*at_time)
            simple.SaveData(stem + ".csv", proxy=fragments, Precision=16, UseScientificNotation=1)
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
