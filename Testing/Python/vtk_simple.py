"""The part of paraview.simple that the tests need, for builds without ParaView.

It wraps the Python classes of the plugin (VFM_WRAPPERS) and readers and writers of VTK. Commands,
entries and defaults of properties come from the XML of the plugin. A test that needs anything else
is skipped. With mpiexec all ranks run the script, as with pvbatch --sym.
"""
import os
import sys
import types
import unittest
from xml.etree import ElementTree

import mpi4py.MPI  # initializes MPI

sys.path[:0] = [os.environ["VFM_WRAPPERS"],
                os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scripts")]
from options.documents import all_properties, entries, read_proxies
from volumefractionmesh import vtkVolumeFractionMeshFilters, vtkVolumeFractionMeshIO
from vtkmodules import vtkIOParallelXML, vtkIOXML
from vtkmodules.vtkCommonDataModel import vtkDataObject
from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer
from vtkmodules.vtkParallelCore import vtkMultiProcessController
from vtkmodules.vtkParallelMPI import vtkMPIController

ASSOCIATIONS = {"POINTS": vtkDataObject.FIELD_ASSOCIATION_POINTS,
                "CELLS": vtkDataObject.FIELD_ASSOCIATION_CELLS,
                "FIELD": vtkDataObject.FIELD_ASSOCIATION_NONE}
NUMBERS = {"IntVectorProperty": int, "DoubleVectorProperty": float, "StringVectorProperty": str}


def make_controller():
    controller = vtkMPIController()
    controller.Initialize()
    vtkMultiProcessController.SetGlobalController(controller)
    return controller


CONTROLLER = make_controller()
RANK, RANKS = CONTROLLER.GetLocalProcessId(), CONTROLLER.GetNumberOfProcesses()


def needs_paraview(what):
    return unittest.SkipTest("needs ParaView: %s" % what)


def __getattr__(name):
    raise AttributeError(name) if name.startswith("_") else needs_paraview(name)


class OutputPort:
    """An output of a proxy, with its data information."""

    def __init__(self, proxy, port=0):
        names = {element.get("name"): int(element.get("index")) for element in proxy.outputs}
        self.proxy, self.port = proxy, names.get(port, port)

    def output(self):
        return self.proxy.GetClientSideObject().GetOutputDataObject(self.port)

    def GetDataInformation(self):
        self.proxy.UpdatePipeline()
        return self.output()

    def arrays(self, kind):
        attributes = self.output().GetAttributesAsFieldData(kind)
        return {attributes.GetArrayName(i): attributes.GetAbstractArray(i)
                for i in range(attributes.GetNumberOfArrays())}

    PointData = property(lambda self: self.arrays(vtkDataObject.POINT))
    CellData = property(lambda self: self.arrays(vtkDataObject.CELL))
    FieldData = property(lambda self: self.arrays(vtkDataObject.FIELD))


class Proxy(OutputPort):
    """An algorithm with its properties as attributes, which are passed on at once."""
    make, properties, outputs = None, {}, []

    def __init__(self, Input=None, registrationName=None, **values):
        vars(self).update(proxy=self, port=0, values={}, algorithm=self.make())
        for name, element in self.properties.items():
            default = element.get("default_values")
            # A default with @ is chosen by the build and set by the class.
            if default is not None and not default.startswith("@"):
                self.set(name, element, default.split(element.get("default_values_delimiter")))
        if Input is not None:
            self.Input = Input
        for name, value in values.items():
            setattr(self, name, value)

    def __setattr__(self, name, value):
        if name == "Input":
            self.algorithm.RemoveAllInputs()
            for port in value if isinstance(value, list) else [value]:
                self.algorithm.AddInputConnection(port.proxy.algorithm.GetOutputPort(port.port))
        elif name in self.properties:
            self.set(name, self.properties[name], value)
        else:
            raise AttributeError("%s has no property %s" % (type(self).__name__, name))

    def __getattr__(self, name):
        if name in self.values:
            return self.values[name]
        if name in self.properties and self.properties[name].get("information_only"):
            return getattr(self.algorithm, self.properties[name].get("command"))()
        raise needs_paraview("%s.%s" % (type(self).__name__, name))

    def __getitem__(self, port):
        return OutputPort(self, port)

    def set(self, name, element, value):
        command, clean, words = getattr(self.algorithm,
                                        element.get("command")), element.get(
                                            "clean_command"), entries(element)
        self.values[name] = words.get(str(value), value)
        values = list(value) if isinstance(value, (list, tuple)) else [value]
        numbers = {text: number for number, text in words.items()}
        values = [NUMBERS[element.tag](numbers.get(v, v)) if v is not None else "None"
                  for v in values]
        if clean:
            getattr(self.algorithm, clean)()
            count = int(element.get("number_of_elements_per_command"))
            for i in range(0, len(values), count):
                command(*values[i:i + count])
        # An array: only its name, the association and name, or all elements as in the ParaView GUI.
        elif element.get("default_values_delimiter"):
            panel = len(values) == int(element.get("number_of_elements"))
            command(*(values if panel else [ASSOCIATIONS.get(word, word) for word in values[-2:]]))
        elif values:
            command(*values) if len(values) <= 6 else command(values)

    def GetPropertyValue(self, name):
        return getattr(self, name)

    def GetClientSideObject(self):
        return self.algorithm

    def UpdateVTKObjects(self):
        pass

    def UpdatePipelineInformation(self):
        self.algorithm.UpdateInformation()

    def UpdatePipeline(self, time=None):
        if self.algorithm.GetNumberOfOutputPorts() == 0:
            self.algorithm.Write()
        elif time is None:
            self.algorithm.UpdatePiece(RANK, RANKS, 0)
        else:
            self.algorithm.UpdateTimeStep(time, RANK, RANKS, 0)


def proxy_class(name, algorithm, properties, outputs=()):
    return type(name, (Proxy,),
                {"make": staticmethod(algorithm), "properties": properties, "outputs": outputs})


def own_or_of_base(element, path):
    """Returns the elements at a path; if there are none, the elements of the base proxy."""
    base = ELEMENTS.get(element.get("base_proxyname"))
    return element.findall(path) or ([] if base is None else own_or_of_base(base, path))


def plugin_class(element):
    """Makes the proxy class of an XML element.

    A proxy of files becomes the proxy inside it, because only ParaView supports file series.
    """
    maker, properties = element, all_properties(element, ELEMENTS)
    for inside in own_or_of_base(element, "SubProxy/Proxy"):
        maker = ELEMENTS[inside.get("proxyname")]
        held = all_properties(maker, ELEMENTS)
        properties = {p.get("name"): held[p.get("name")]
                      for p in own_or_of_base(element, "SubProxy/ExposedProperties/Property")}
        properties["FileName"] = FILE_NAME
    name = maker.get("class")
    algorithm = getattr(vtkVolumeFractionMeshFilters, name,
                        None) or getattr(vtkVolumeFractionMeshIO, name)
    return proxy_class(element.get("name"), algorithm, properties,
                       own_or_of_base(element, "OutputPort"))


def reader_class(name, algorithm, **commands):
    properties = {n: ElementTree.Element("IntVectorProperty", name=n, command=command)
                  for n, command in commands.items()}
    return proxy_class(name, algorithm, {"FileName": FILE_NAME, **properties})


def by_endings(kind):
    """Returns the proxies of the plugin by the file extensions that they support."""
    return {ending: PROXIES[name] for name in PROXIES for factory in ELEMENTS[name].iter(kind)
            for ending in factory.get("extensions").split()}


FILE_NAME = ElementTree.Element("StringVectorProperty", name="FileName", command="SetFileName")
ELEMENTS = read_proxies()
PROXIES = {name: plugin_class(element) for name, element in ELEMENTS.items()
           if own_or_of_base(element, "Documentation")}


class servermanager:
    writers = types.SimpleNamespace(**PROXIES)

    @staticmethod
    def ProxyManager():
        raise needs_paraview("ProxyManager")


XMLImageDataReader = reader_class("XMLImageDataReader", vtkIOXML.vtkXMLImageDataReader)
XMLPartitionedImageDataReader = reader_class("XMLPartitionedImageDataReader",
                                             vtkIOXML.vtkXMLPImageDataReader)
XMLUniformGridAMRReader = reader_class(
    "XMLUniformGridAMRReader", vtkIOXML.vtkXMLUniformGridAMRReader,
    DefaultNumberOfLevels="SetMaximumLevelsToReadByDefault")
READERS = {
    **by_endings("ReaderFactory"), "vti": XMLImageDataReader, "pvti": XMLPartitionedImageDataReader,
    "vthb": XMLUniformGridAMRReader,
    "vtu": reader_class("XMLUnstructuredGridReader", vtkIOXML.vtkXMLUnstructuredGridReader),
    "pvtu": reader_class("XMLPartitionedUnstructuredGridReader",
                         vtkIOXML.vtkXMLPUnstructuredGridReader),
    "vtm": reader_class("XMLMultiBlockDataReader", vtkIOXML.vtkXMLMultiBlockDataReader)}
WRITERS = {"vti": vtkIOXML.vtkXMLImageDataWriter, "vtu": vtkIOXML.vtkXMLUnstructuredGridWriter,
           "vtp": vtkIOXML.vtkXMLPolyDataWriter,
           "pvtu": vtkIOParallelXML.vtkXMLPUnstructuredGridWriter,
           "pvtp": vtkIOParallelXML.vtkXMLPPolyDataWriter}
OWN_WRITERS = by_endings("WriterFactory")


def by_ending(table, path):
    """Returns the entry for the longest extension of the path that the table has."""
    parts = os.path.basename(path).lower().split(".")
    for start in range(1, len(parts)):
        if ".".join(parts[start:]) in table:
            return table[".".join(parts[start:])]
    raise needs_paraview(parts[-1])


def OpenDataFile(path, **values):
    if not isinstance(path, str):
        raise needs_paraview("a series of files")
    return by_ending(READERS, path)(FileName=path, **values)


def CreateWriter(path, proxy):
    return by_ending(OWN_WRITERS, path)(FileName=path, Input=proxy)


def SaveData(path, proxy, DataMode=None, **values):
    """Writes a file; collective."""
    if path.rsplit(".")[-1] in OWN_WRITERS:
        by_ending(OWN_WRITERS, path)(FileName=path, Input=proxy, **values).UpdatePipeline()
        return
    writer = by_ending(WRITERS, path)()
    writer.SetInputConnection(proxy.proxy.algorithm.GetOutputPort(proxy.port))
    writer.SetFileName(path)
    writer.SetDataModeToBinary()
    if isinstance(writer, vtkIOParallelXML.vtkXMLPDataWriter):
        writer.SetNumberOfPieces(RANKS)
        writer.SetStartPiece(RANK)
        writer.SetEndPiece(RANK)
    assert writer.Write()


def TrivialProducer():
    return proxy_class("TrivialProducer", vtkTrivialProducer, {})()


def Delete(proxy):
    pass  # Python frees it after the last reference.
