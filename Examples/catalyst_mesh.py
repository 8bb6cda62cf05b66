# script-version: 2.0
"""Meshes the volume fractions of a running simulation: a ParaView Catalyst script (version 2).

Give it to vfm::CatalystAdaptor of either kind or any other Catalyst adaptor whose input is named
"input": a uniform grid in one or more blocks a rank, or a refined one (AMR) of blocks on several
levels. Every mesh becomes OUT/NAME_SSSSSS.pvtu (S: the step), the series OUT/NAME.pvd, on demand an
Exodus file and a picture.

Settings: the values below, or environment variables of the simulation:
  VFM_PLUGIN    path of VolumeFractionMesh.so
  VFM_ARRAYS    cell arrays with the volume fraction of one material each, between commas; or
  VFM_LABELS    one integer cell array of material ids
  VFM_OUT       folder of the files
  VFM_NAME      first part of their names
  VFM_STEPS     these steps are meshed, between commas
  VFM_EVERY     every so many steps; 0: none. Default: 1, but 0 where VFM_STEPS or VFM_TRIGGER is
                set
  VFM_TRIGGER   and those when one of these, between semicolons, comes true:
                  NAME changes              a global number that the simulation hands over, as
                  "Fragments", is another;
                                            the first step counts as a change
                  NAME > VALUE              ... has passed the value; also NAME < VALUE
                  sum ARRAY > VALUE         the sum of a cell array over all cells has; also min,
                  max; vectors by length;
                                            a finer cell counts as the part that it is of a coarsest
                                            one
  VFM_STATE     cell arrays that the elements carry along, between commas: velocity, temperature
  VFM_DENSITY   cell arrays of mass per volume, one or one a material: state is then carried so that
                nothing is lost
  VFM_VELOCITY, VFM_ENERGY, VFM_STATE_KINDS, VFM_STATE_TRANSFER, VFM_STATE_ORDER,
  VFM_NODAL_VELOCITY, VFM_LOST_KINETIC_ENERGY,
  VFM_UNMESHED  the properties VelocityArray, EnergyArray, StateKinds (NAME=KIND between commas),
                StateTransfer, StateOrder,
                NodalVelocity (0 or 1), LostKineticEnergy and UnmeshedMaterial of the filter; empty:
                its defaults
  VFM_TETS      tetrahedra by this method, TetGen, Cells or Lattice; empty: hexahedra
  VFM_EXODUS    1: NAME_SSSSSS.e too, with side sets, on N ranks NAME_SSSSSS.e.N.0 and so on
  VFM_PICTURE   1: NAME_SSSSSS.png too, where there is an X server (DISPLAY)
  VFM_CAMERA    direction from the grid to the camera, three numbers between commas
  VFM_ZOOM      size in the picture
"""
import ctypes
import operator
import os
import sys

import numpy as np
from paraview import catalyst, servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet, vtkPartitionedDataSetCollection
from vtkmodules.vtkParallelCore import vtkCommunicator, vtkMultiProcessController

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(HERE)
sys.path.insert(0, HERE)
import pictures
from load_plugin import load_plugin
from write_exodus import write_exodus

PLUGIN = os.path.join(ROOT, "build", "lib", "VolumeFractionMesh.so")
ARRAYS = "ball,plate"
LABELS = ""
OUT = "catalyst"
NAME = "mesh"
STEPS = ""
EVERY = ""
TRIGGER = ""
STATE = DENSITY = VELOCITY = ENERGY = STATE_KINDS = STATE_TRANSFER = STATE_ORDER = ""
NODAL_VELOCITY = LOST_KINETIC_ENERGY = UNMESHED = ""
TETS = ""
EXODUS = "0"
PICTURE = "1"
CAMERA = "0.7,-1.0,0.5"
ZOOM = "1.25"

COMPARISONS = {">": operator.gt, "<": operator.lt}
REDUCTIONS = {  # name: of the values on a rank, over the ranks, of no values
    "sum": (np.sum, vtkCommunicator.SUM_OP, 0.0),
    "min": (np.min, vtkCommunicator.MIN_OP, np.inf),
    "max": (np.max, vtkCommunicator.MAX_OP, -np.inf),
}
GHOST, HIDDEN = 1, 32  # bits of vtkGhostType: copies of other blocks' cells; below finer blocks


def setting(name):
    return os.environ.get("VFM_" + name, globals()[name])


def names_of(text):
    return [part.strip() for part in text.split(",") if part.strip()]


PROPERTIES = {  # of the filter: the setting, and what makes its value of it
    "StateArrays": ("STATE", names_of), "DensityArrays": ("DENSITY", names_of),
    "VelocityArray": ("VELOCITY", str),
    "EnergyArray": ("ENERGY", str), "StateKinds": ("STATE_KINDS", names_of),
    "StateTransfer": ("STATE_TRANSFER", str),
    "StateOrder": ("STATE_ORDER", int), "NodalVelocity": ("NODAL_VELOCITY", int),
    "LostKineticEnergy": ("LOST_KINETIC_ENERGY", str), "UnmeshedMaterial": ("UNMESHED", str)}


def word_of(chosen, value):
    """The word of an enumeration that a text means: blanks and case do not count. Other values as
    they are."""
    plain = lambda word: word.replace(" ", "").lower()
    is_word = isinstance(chosen, servermanager.EnumerationProperty) and isinstance(value, str)
    return next((word for word in chosen.Available if plain(word) == plain(value)),
                value) if is_word else value


def is_first_rank():
    return vtkMultiProcessController.GetGlobalController().GetLocalProcessId() == 0


def reduced(value, operation):
    """A number of each rank made one."""
    mine, all_ranks = vtkDoubleArray(), vtkDoubleArray()
    mine.InsertNextValue(value)
    all_ranks.DeepCopy(mine)
    vtkMultiProcessController.GetGlobalController().AllReduce(mine, all_ranks, operation)
    return all_ranks.GetValue(0)


def say(text):
    if is_first_rank():
        print("catalyst_mesh: " + text, flush=True)


def blocks_of(data):
    """Without those that only make the data alike on all ranks."""
    if not isinstance(data, vtkCompositeDataSet):
        return [data]
    blocks, iterator = [], data.NewIterator()
    while not iterator.IsDoneWithTraversal():
        blocks.append(iterator.GetCurrentDataObject())
        iterator.GoToNextItem()
    return [block for block in blocks if block.GetNumberOfCells() > 0]


def numbers_named(data, name):
    """Arrays of a global number: the first kind of Catalyst gives it to the data, the second to its
    parts."""
    is_collection = isinstance(data, vtkPartitionedDataSetCollection)
    parts = map(data.GetPartitionedDataSet,
                range(data.GetNumberOfPartitionedDataSets())) if is_collection else []
    arrays = [part.GetFieldData().GetArray(name) for part in [data, *parts]]
    return [array for array in arrays if array]


def own_values(block, name):
    """The values of a cell array, lengths of vectors, without what other blocks tell of; None if
    there is no such array."""
    array, ghosts = block.GetCellData().GetArray(name), block.GetCellData().GetArray("vtkGhostType")
    if array is None:
        return None
    values = vtk_to_numpy(array)
    values = values if values.ndim == 1 else np.linalg.norm(values, axis=1)
    return values if ghosts is None else values[vtk_to_numpy(ghosts) & (GHOST | HIDDEN) == 0]


def cell_volume(block):
    return np.prod(block.GetSpacing())


class Trigger:
    """One condition of VFM_TRIGGER, watched from step to step."""

    def __init__(self, text):
        self.text, words = text.strip(), text.split()
        self.reduction = words.pop(0) if words[0] in REDUCTIONS and len(words) == 4 else None
        self.before = None
        if len(words) == 2 and words[1] == "changes":
            self.name, self.comparison = words[0], None
        elif len(words) == 3 and words[1] in COMPARISONS:
            self.name, self.comparison, self.limit = words[0], COMPARISONS[words[1]], float(
                words[2])
        else:
            raise ValueError("VFM_TRIGGER: cannot read '%s'" % self.text)

    def fires(self, data):
        value = self.reduce(data) if self.reduction else self.find_number(data)
        if self.comparison is None:
            now, fires = value, value != self.before
        else:
            now = self.comparison(value, self.limit)
            fires = now and not self.before
        self.before = now
        return fires

    def find_number(self, data):
        arrays = numbers_named(data, self.name)
        if not arrays:
            raise ValueError("VFM_TRIGGER: the simulation hands over no number '%s'" % self.name)
        return arrays[0].GetComponent(0, 0)

    def reduce(self, data):
        of_values, of_ranks, nothing = REDUCTIONS[self.reduction]
        blocks = blocks_of(data)
        widest = reduced(max([cell_volume(block) for block in blocks], default=0.0),
                         vtkCommunicator.MAX_OP)
        parts = [(own_values(block, self.name), cell_volume(block) / widest) for block in blocks]
        parts = [part * weight if self.reduction == "sum" else part for part, weight in parts
                 if part is not None]
        if not reduced(len(parts), vtkCommunicator.SUM_OP):
            raise ValueError("VFM_TRIGGER: the simulation hands over no cell array '%s'"
                             % self.name)
        return reduced(of_values([of_values(part) for part in parts if part.size] or [nothing]),
                       of_ranks)


class Choice:
    """Which steps are meshed."""

    def __init__(self):
        self.steps = {int(step) for step in names_of(setting("STEPS"))}
        self.triggers = [Trigger(text) for text in setting("TRIGGER").split(";") if text.strip()]
        self.every = int(setting("EVERY") or not (self.steps or self.triggers))

    def by_number(self, step):
        return step in self.steps or (self.every > 0 and step % self.every == 0)

    def may_want(self, step):
        return bool(self.triggers) or self.by_number(step)

    def reasons(self, step, data):
        """Why the step is meshed; none: it is not. All triggers look at every step."""
        fired = [trigger.text for trigger in self.triggers if trigger.fires(data)]
        return (["step %d" % step] if self.by_number(step) else []) + fired


def has_display():
    """Whether all ranks reach an X server: ParaView ends the process if not."""
    x11 = ctypes.CDLL("libX11.so.6")
    x11.XOpenDisplay.restype = ctypes.c_void_p
    display = x11.XOpenDisplay(None)
    if display:
        x11.XCloseDisplay(ctypes.c_void_p(display))
    return reduced(1 if display else 0, vtkCommunicator.MIN_OP) > 0


class Picture:
    """The outside of the mesh with the edges of the elements, a colour a material; the camera stays
    where it is."""

    def __init__(self, mesher, bounds):
        self.mesher, self.parts = mesher, {}
        simple._DisableFirstRenderCameraReset()
        self.view = pictures.make_view()
        pictures.aim(self.view, bounds, [float(x) for x in names_of(setting("CAMERA"))],
                     float(setting("ZOOM")))

    def save(self, materials, time, path):
        for material in materials:
            if material not in self.parts:
                self.parts[material] = pictures.show_material(self.mesher, self.view, material)
        self.view.ViewTime = time
        simple.SaveScreenshot(path, self.view, ImageResolution=pictures.SIZE)


class Mesher:
    """The filter on the input of the simulation, and the files of its meshes."""

    def __init__(self, source):
        tets = setting("TETS")
        self.filter = VolumeFractionToTet(Input=source,
                                          Method=tets) if tets else VolumeFractionToHex(
                                              Input=source)
        self.filter.VolumeFractionArrays = [] if setting("LABELS") else names_of(setting("ARRAYS"))
        self.filter.MaterialIdArray = setting("LABELS") or "None"
        for name, (key, value) in PROPERTIES.items():
            if setting(key):
                setattr(self.filter, name,
                        word_of(self.filter.GetProperty(name), value(setting(key))))
        self.errors = []
        self.filter.GetClientSideObject().AddObserver("ErrorEvent", self.make_observer())
        self.stem, self.series, self.picture = os.path.join(setting("OUT"),
                                                            setting("NAME")), [], None
        self.wants_picture = int(setting("PICTURE")) > 0
        os.makedirs(setting("OUT"), exist_ok=True)

    def make_observer(self):
        def take(_, __, text):
            self.errors.append(text.split("): ", 1)[-1].strip())

        take.CallDataType = "string0"
        return take

    def run(self, step, time):
        """The mesh on this rank. All ranks raise when it cannot be made."""
        self.errors.clear()
        self.filter.UpdatePipeline(time)
        mesh = self.filter.GetClientSideObject().GetOutputDataObject(0)
        if self.errors or mesh.GetFieldData().GetArray("MeshVolume") is None:
            raise RuntimeError("no mesh of step %d: %s" % (step,
                                                           " ".join(self.errors)
                                                           or "see the messages before"))
        return mesh

    def write(self, mesh, step, time):
        stem = "%s_%06d" % (self.stem, step)
        simple.SaveData(stem + ".pvtu", proxy=self.filter, DataMode="Binary", CompressorType="ZLib")
        elements = int(reduced(mesh.GetNumberOfCells(), vtkCommunicator.SUM_OP))
        if int(setting("EXODUS")) and elements > 0:
            write_exodus(mesh, stem + ".e")
        self.write_series(stem, time)
        return elements, stem + ".pvtu"

    def write_series(self, stem, time):
        entry = '<DataSet timestep="%r" file="%s.pvtu"/>\n' % (time, os.path.basename(stem))
        self.series.append(entry)
        if is_first_rank():
            with open(self.stem + ".pvd", "w") as file:
                file.write('<VTKFile type="Collection" version="0.1">\n<Collection>\n'
                           + "".join(self.series) +
                           "</Collection>\n</VTKFile>\n")

    def draw(self, mesh, data, step, time):
        if self.wants_picture and not self.picture:
            if not has_display():
                say("no pictures: no X server (DISPLAY)")
                self.wants_picture = False
            else:
                self.picture = Picture(self.filter, bounds_of(data))
        if self.picture:
            ids = vtk_to_numpy(mesh.GetFieldData().GetArray("MaterialIds")).tolist()
            self.picture.save(ids, time, "%s_%06d.png" % (self.stem, step))


def bounds_of(data):
    """Of all ranks."""
    bounds = [np.inf, -np.inf] * 3
    for block in blocks_of(data):
        pairs = zip(bounds, block.GetBounds())
        bounds = [max(pair) if i % 2 else min(pair) for i, pair in enumerate(pairs)]
    return [reduced(x, vtkCommunicator.MAX_OP if i % 2 else vtkCommunicator.MIN_OP)
            for i, x in enumerate(bounds)]


load_plugin(setting("PLUGIN"), globals())  # defines VolumeFractionToHex, VolumeFractionToTet
source = simple.TrivialProducer(registrationName="input")
options = catalyst.Options()  # Catalyst asks for it
choice = Choice()
mesher = None


def RequestDataDescription(description):
    """By the first kind of Catalyst asked before the simulation makes any data; the second makes
    them when the source is updated."""
    if choice.may_want(description.GetTimeStep()):
        for i in range(description.GetNumberOfInputDescriptions()):
            description.GetInputDescription(i).AllFieldsOn()
            description.GetInputDescription(i).GenerateMeshOn()


def catalyst_execute(info):
    global mesher
    if not choice.may_want(info.timestep):
        return
    source.UpdatePipeline(info.time)
    data = source.GetClientSideObject().GetOutputDataObject(0)
    reasons = choice.reasons(info.timestep, data)
    if not reasons:
        return
    mesher = mesher or Mesher(source)
    mesh = mesher.run(info.timestep, info.time)
    elements, path = mesher.write(mesh, info.timestep, info.time)
    mesher.draw(mesh, data, info.timestep, info.time)
    say("%s: %d elements, time %g (%s)" % (path, elements, info.time, "; ".join(reasons)))
