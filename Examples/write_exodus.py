#!/usr/bin/env pvpython
"""Writes a mesh of Volume Fraction To Hex or To Tet as an Exodus file with one element block a material.

usage: pvpython write_exodus.py MESH.vtu MESH.e
       mpiexec -n P pvbatch --sym write_exodus.py MESH.pvtu MESH.e     writes MESH.e.P.0, MESH.e.P.1, ...

Blocks are named after the materials (field data MaterialNames). Node and element ids are the mesh's
GlobalPointIds and GlobalCellIds; all cell and point arrays become element and node variables.
From Python: write_exodus(mesh, path), mesh a vtkUnstructuredGrid; on several ranks all call it, each with its piece.
"""
import sys

from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkCommonDataModel import (
    vtkCompositeDataSet, vtkDataAssembly, vtkDataObject, vtkPartitionedDataSetCollection)
from vtkmodules.vtkFiltersCore import vtkThreshold
from vtkmodules.vtkIOIOSS import vtkIOSSWriter
from vtkmodules.vtkIOXML import vtkXMLPUnstructuredGridReader, vtkXMLUnstructuredGridReader
from vtkmodules.vtkParallelCore import vtkCommunicator, vtkMultiProcessController


def extract_material(mesh, material):
    """The cells of one material as a mesh of their own, ids kept."""
    threshold = vtkThreshold()
    threshold.SetInputData(mesh)
    threshold.SetInputArrayToProcess(0, 0, 0, vtkDataObject.CELL, "MaterialId")
    threshold.SetThresholdFunction(vtkThreshold.THRESHOLD_BETWEEN)
    threshold.SetLowerThreshold(material)
    threshold.SetUpperThreshold(material)
    threshold.Update()
    part = threshold.GetOutput()
    part.GetCellData().SetGlobalIds(part.GetCellData().GetArray("GlobalCellIds"))
    part.GetPointData().SetGlobalIds(part.GetPointData().GetArray("GlobalPointIds"))
    return part


def reduced(value, operation):
    """A number of each rank made one."""
    mine, all_ranks = vtkDoubleArray(), vtkDoubleArray()
    mine.InsertNextValue(value)
    all_ranks.DeepCopy(mine)
    controller = vtkMultiProcessController.GetGlobalController()
    if controller:
        controller.AllReduce(mine, all_ranks, operation)
    return all_ranks.GetValue(0)


def is_anywhere(part):
    """Whether any rank has cells of the part."""
    return reduced(part.GetNumberOfCells(), vtkCommunicator.SUM_OP) > 0


def split_by_material(mesh):
    """One block a material, with the assembly that the Exodus writer asks for."""
    names = mesh.GetFieldData().GetAbstractArray("MaterialNames")
    ids = mesh.GetFieldData().GetArray("MaterialIds")
    blocks = vtkPartitionedDataSetCollection()
    assembly = vtkDataAssembly()
    assembly.SetRootNodeName("IOSS")
    element_blocks = assembly.AddNode("element_blocks")
    for i in range(ids.GetNumberOfTuples()):
        part = extract_material(mesh, ids.GetValue(i))
        if not is_anywhere(part):
            continue
        block = blocks.GetNumberOfPartitionedDataSets()
        blocks.SetPartition(block, 0, part)
        blocks.GetMetaData(block).Set(vtkCompositeDataSet.NAME(), names.GetValue(i))
        node = assembly.AddNode("material_%d" % ids.GetValue(i), element_blocks)
        assembly.AddDataSetIndex(node, block)
    blocks.SetDataAssembly(assembly)
    return blocks


def write_exodus(mesh, path):
    writer = vtkIOSSWriter()
    writer.SetInputDataObject(split_by_material(mesh))
    writer.SetFileName(path)
    writer.PreserveInputEntityGroupsOn()
    if not writer.Write():
        raise RuntimeError("cannot write " + path)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    reader = vtkXMLPUnstructuredGridReader() if sys.argv[1].endswith(".pvtu") else vtkXMLUnstructuredGridReader()
    reader.SetFileName(sys.argv[1])
    ranks = vtkMultiProcessController.GetGlobalController()
    if ranks:
        reader.UpdatePiece(ranks.GetLocalProcessId(), ranks.GetNumberOfProcesses(), 0)
    else:
        reader.Update()
    write_exodus(reader.GetOutput(), sys.argv[2])
