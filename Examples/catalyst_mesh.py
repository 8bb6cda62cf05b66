# script-version: 2.0
"""Meshes the volume fractions of a running simulation: a ParaView Catalyst script (version 2).

Pass the script to vfm::CatalystAdaptor, built for legacy Catalyst or Catalyst 2, or to any other
Catalyst adaptor whose input is named "input". The input is a uniform grid in one or more blocks per
rank, or a refined grid (AMR) of blocks on several levels. Writes each mesh as OUT/NAME_SSSSSS.pvtu,
where S is the step, and the series as OUT/NAME.pvd. With VFM_UNMESHED Particles, the particles are
in OUT/NAME_particles_SSSSSS.pvtp. Exodus files and pictures are optional.

Settings are the values below or environment variables of the simulation. Lists are separated by
commas.
  VFM_PLUGIN    path of VolumeFractionMesh.so
  VFM_ARRAYS    cell arrays, each with the volume fraction of one material; or
  VFM_LABELS    one integer cell array of material ids
  VFM_OUT       folder of the files
  VFM_NAME      first part of the file names
  VFM_STEPS     steps to mesh
  VFM_EVERY     interval between meshed steps; 0 meshes none.
                Default: 0 if VFM_STEPS or VFM_TRIGGER is set, else 1.
  VFM_TRIGGER   conditions, separated by semicolons; a step is meshed when one becomes true:
                  NAME changes        A global number of the simulation, for example "Fragments",
                                      has changed. The first step counts as a change.
                  NAME > VALUE        A global number has passed the value. Also NAME < VALUE.
                  sum ARRAY > VALUE   The sum of a cell array over all cells has passed the value.
                                      Also min and max. Vectors count by length, and cells by
                                      volume relative to the coarsest level.
  VFM_STATE     cell arrays to transfer to the elements, for example velocity,temperature
  VFM_DENSITY   cell arrays of mass per volume, one or one per material; the transfer is then
                conservative
  VFM_VELOCITY, VFM_ENERGY, VFM_STATE_KINDS (list of NAME=KIND), VFM_STATE_TRANSFER,
  VFM_STATE_ORDER, VFM_NODAL_VELOCITY (0 or 1), VFM_LOST_KINETIC_ENERGY, VFM_UNMESHED
                properties VelocityArray, EnergyArray, StateKinds, StateTransfer, StateOrder,
                NodalVelocity, LostKineticEnergy and UnmeshedMaterial of the filter; if empty, its
                defaults
  VFM_TETS      method for tetrahedra: TetGen, Cells or Lattice; if empty, makes hexahedra
  VFM_EXODUS    1 also writes NAME_SSSSSS.e with side sets; on N ranks NAME_SSSSSS.e.N.0 and so on
  VFM_PICTURE   1 also writes NAME_SSSSSS.png, with particles as red spheres; needs an X server
                (DISPLAY)
  VFM_CAMERA    direction from the grid to the camera, three numbers
  VFM_ZOOM      magnification of the picture
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
REDUCTIONS = {  # name: function on a rank, operation over the ranks, result without values
    "sum": (np.sum, vtkCommunicator.SUM_OP, 0.0),
    "min": (np.min, vtkCommunicator.MIN_OP, np.inf),
    "max": (np.max, vtkCommunicator.MAX_OP, -np.inf),
}
PARTICLES = 6  # output of the filter
RED = (0.8, 0.1, 0.1)
GHOST, HIDDEN = 1, 32  # bits of vtkGhostType: copy of another block's cell; covered by finer cells


def setting(name):
    return os.environ.get("VFM_" + name, globals()[name])


def names_of(text):
    return [part.strip() for part in text.split(",") if part.strip()]


PROPERTIES = {  # property of the filter: setting, and conversion of the setting to its value
    "StateArrays": ("STATE", names_of), "DensityArrays": ("DENSITY", names_of),
    "VelocityArray": ("VELOCITY", str),
    "EnergyArray": ("ENERGY", str), "StateKinds": ("STATE_KINDS", names_of),
    "StateTransfer": ("STATE_TRANSFER", str),
    "StateOrder": ("STATE_ORDER", int), "NodalVelocity": ("NODAL_VELOCITY", int),
    "LostKineticEnergy": ("LOST_KINETIC_ENERGY", str), "UnmeshedMaterial": ("UNMESHED", str)}


def word_of(chosen, value):
    """Returns the word of an enumeration that a text selects, ignoring blanks and case. Returns
    other values unchanged."""
    plain = lambda word: word.replace(" ", "").lower()
    is_word = isinstance(chosen, servermanager.EnumerationProperty) and isinstance(value, str)
    return (next((word for word in chosen.Available if plain(word) == plain(value)), value)
            if is_word else value)


def is_first_rank():
    return vtkMultiProcessController.GetGlobalController().GetLocalProcessId() == 0


def reduced(value, operation):
    """Reduces a number over all ranks."""
    mine, all_ranks = vtkDoubleArray(), vtkDoubleArray()
    mine.InsertNextValue(value)
    all_ranks.DeepCopy(mine)
    vtkMultiProcessController.GetGlobalController().AllReduce(mine, all_ranks, operation)
    return all_ranks.GetValue(0)


def say(text):
    if is_first_rank():
        print("catalyst_mesh: " + text, flush=True)


def blocks_of(data):
    """Returns the blocks with cells. Empty blocks only give the data the same structure on all
    ranks."""
    if not isinstance(data, vtkCompositeDataSet):
        return [data]
    blocks, iterator = [], data.NewIterator()
    while not iterator.IsDoneWithTraversal():
        blocks.append(iterator.GetCurrentDataObject())
        iterator.GoToNextItem()
    return [block for block in blocks if block.GetNumberOfCells() > 0]


def numbers_named(data, name):
    """Returns the arrays of a global number. Legacy Catalyst adds it to the data, Catalyst 2 to the
    parts of the data."""
    is_collection = isinstance(data, vtkPartitionedDataSetCollection)
    parts = map(data.GetPartitionedDataSet,
                range(data.GetNumberOfPartitionedDataSets())) if is_collection else []
    arrays = [part.GetFieldData().GetArray(name) for part in [data, *parts]]
    return [array for array in arrays if array]


def own_values(block, name):
    """Returns the values of a cell array, or lengths of vectors, without ghost and covered cells.
    Returns None if the array does not exist."""
    array, ghosts = block.GetCellData().GetArray(name), block.GetCellData().GetArray("vtkGhostType")
    if array is None:
        return None
    values = vtk_to_numpy(array)
    values = values if values.ndim == 1 else np.linalg.norm(values, axis=1)
    return values if ghosts is None else values[vtk_to_numpy(ghosts) & (GHOST | HIDDEN) == 0]


def cell_volume(block):
    return np.prod(block.GetSpacing())


class Trigger:
    """One condition of VFM_TRIGGER, with its state at the previous step."""

    def __init__(self, text):
        self.text, words = text.strip(), text.split()
        self.reduction = words.pop(0) if words[0] in REDUCTIONS and len(words) == 4 else None
        self.before = None
        if len(words) == 2 and words[1] == "changes":
            self.name, self.comparison = words[0], None
        elif len(words) == 3 and words[1] in COMPARISONS:
            self.name, self.comparison, self.limit = (
                words[0], COMPARISONS[words[1]], float(words[2]))
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
            raise ValueError("VFM_TRIGGER: the simulation provides no number '%s'" % self.name)
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
            raise ValueError("VFM_TRIGGER: the simulation provides no cell array '%s'"
                             % self.name)
        return reduced(of_values([of_values(part) for part in parts if part.size] or [nothing]),
                       of_ranks)


class Choice:
    """Selection of the steps to mesh."""

    def __init__(self):
        self.steps = {int(step) for step in names_of(setting("STEPS"))}
        self.triggers = [Trigger(text) for text in setting("TRIGGER").split(";") if text.strip()]
        self.every = int(setting("EVERY") or not (self.steps or self.triggers))

    def by_number(self, step):
        return step in self.steps or (self.every > 0 and step % self.every == 0)

    def may_want(self, step):
        return bool(self.triggers) or self.by_number(step)

    def reasons(self, step, data):
        """Returns the reasons to mesh the step; an empty list if it is not meshed. Updates all
        triggers."""
        fired = [trigger.text for trigger in self.triggers if trigger.fires(data)]
        return (["step %d" % step] if self.by_number(step) else []) + fired


def has_display():
    """Returns whether all ranks can connect to an X server. ParaView would otherwise end the
    process."""
    x11 = ctypes.CDLL("libX11.so.6")
    x11.XOpenDisplay.restype = ctypes.c_void_p
    display = x11.XOpenDisplay(None)
    if display:
        x11.XCloseDisplay(ctypes.c_void_p(display))
    return reduced(1 if display else 0, vtkCommunicator.MIN_OP) > 0


class Picture:
    """Picture of the outside of the mesh, with the edges of the elements and one colour per
    material, and of the particles as spheres. The camera stays fixed."""

    def __init__(self, mesher, bounds):
        self.mesher, self.parts = mesher, {}
        simple._DisableFirstRenderCameraReset()
        self.view = pictures.make_view()
        pictures.aim(self.view, bounds, [float(x) for x in names_of(setting("CAMERA"))],
                     float(setting("ZOOM")))
        if mesher.UnmeshedMaterial == "Particles":
            pictures.show_particles(simple.OutputPort(mesher, PARTICLES), self.view, RED)

    def save(self, materials, time, path):
        for material in materials:
            if material not in self.parts:
                self.parts[material] = pictures.show_material(self.mesher, self.view, material)
        self.view.ViewTime = time
        simple.SaveScreenshot(path, self.view, ImageResolution=pictures.SIZE)


class Mesher:
    """Filter on the input of the simulation; writes the files of its meshes."""

    def __init__(self, source):
        tets = setting("TETS")
        self.filter = (VolumeFractionToTet(Input=source, Method=tets) if tets
                       else VolumeFractionToHex(Input=source))
        self.filter.VolumeFractionArrays = [] if setting("LABELS") else names_of(setting("ARRAYS"))
        self.filter.MaterialIdArray = setting("LABELS") or "None"
        for name, (key, value) in PROPERTIES.items():
            if setting(key):
                setattr(self.filter, name,
                        word_of(self.filter.GetProperty(name), value(setting(key))))
        self.errors = []
        self.filter.GetClientSideObject().AddObserver("ErrorEvent", self.make_observer())
        self.stem, self.series, self.picture = (
            os.path.join(setting("OUT"), setting("NAME")), [], None)
        self.wants_picture = int(setting("PICTURE")) > 0
        os.makedirs(setting("OUT"), exist_ok=True)

    def make_observer(self):
        def take(_, __, text):
            self.errors.append(text.split("): ", 1)[-1].strip())

        take.CallDataType = "string0"
        return take

    def run(self, step, time):
        """Returns the mesh on this rank. If it cannot be made, raises RuntimeError on all ranks."""
        self.errors.clear()
        self.filter.UpdatePipeline(time)
        mesh = self.filter.GetClientSideObject().GetOutputDataObject(0)
        if self.errors or mesh.GetFieldData().GetArray("MeshVolume") is None:
            raise RuntimeError("no mesh of step %d: %s" % (
                step, " ".join(self.errors) or "see the messages above"))
        return mesh

    def write(self, mesh, step, time):
        stem = "%s_%06d" % (self.stem, step)
        simple.SaveData(stem + ".pvtu", proxy=self.filter, DataMode="Binary", CompressorType="ZLib")
        if self.filter.UnmeshedMaterial == "Particles":
            simple.SaveData("%s_particles_%06d.pvtp" % (self.stem, step),
                            proxy=simple.OutputPort(self.filter, PARTICLES), DataMode="Binary")
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
                           + "".join(self.series) + "</Collection>\n</VTKFile>\n")

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
    """Returns the bounds of the data over all ranks."""
    bounds = [np.inf, -np.inf] * 3
    for block in blocks_of(data):
        pairs = zip(bounds, block.GetBounds())
        bounds = [max(pair) if i % 2 else min(pair) for i, pair in enumerate(pairs)]
    return [reduced(x, vtkCommunicator.MAX_OP if i % 2 else vtkCommunicator.MIN_OP)
            for i, x in enumerate(bounds)]


load_plugin(setting("PLUGIN"), globals())  # defines VolumeFractionToHex, VolumeFractionToTet
source = simple.TrivialProducer(registrationName="input")
options = catalyst.Options()  # read by Catalyst
choice = Choice()
mesher = None


def RequestDataDescription(description):
    """Requests data. Legacy Catalyst calls this before the simulation makes any data. Catalyst 2
    does not; it makes data when the source is updated."""
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
