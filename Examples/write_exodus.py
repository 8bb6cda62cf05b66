#!/usr/bin/env pvpython
"""Writes a mesh of Volume Fraction To Hex or To Tet as Exodus: element blocks, side sets, node
sets, global ids.

usage: pvpython write_exodus.py MESH.vtu MESH.exo
       mpiexec -n P pvbatch --sym write_exodus.py MESH.pvtu MESH.exo

The second form writes MESH.exo.P.0, MESH.exo.P.1 and so on. The plugin is
build/lib/VolumeFractionMesh.so, or the path in the environment variable VFM_PLUGIN. A script that
has loaded the plugin can use SaveData("mesh.exo", proxy=hexes) instead.
"""
import os
import sys

from paraview import servermanager, simple

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)
from load_plugin import load_plugin
from need_files import need_files


def write_exodus(mesh, path, single_file=False):
    """Writes a vtkUnstructuredGrid as Exodus. The name of the file can have any extension.

    On several ranks, all ranks call it, each with its piece. single_file: write one file of the
    whole mesh instead of one per rank. Raises RuntimeError if the file cannot be written."""
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(mesh)
    writer = servermanager.writers.VolumeFractionExodusWriter(
        Input=source, FileName=path, SingleFile=int(single_file))
    writer.UpdatePipeline()
    failed = writer.GetClientSideObject().GetWriter().GetErrorCode()
    simple.Delete(source)
    if failed:
        raise RuntimeError("cannot write " + path)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    PLUGIN = os.environ.get("VFM_PLUGIN",
                            os.path.join(HERE, "..", "build", "lib", "VolumeFractionMesh.so"))
    need_files(PLUGIN, sys.argv[1])
    load_plugin(PLUGIN, globals())
    reader = simple.OpenDataFile(sys.argv[1])
    reader.UpdatePipeline()
    try:
        write_exodus(reader.GetClientSideObject().GetOutputDataObject(0), sys.argv[2])
    except RuntimeError as error:
        sys.exit(str(error))
