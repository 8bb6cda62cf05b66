"""Pictures of meshes in one piece per rank: pieces moved apart, colours by number, several pictures
in one file."""
import colorsys
import os
import sys

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkAppendFilter
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
import pictures
from rank_meshes import points_of

SIZE = (1000, 750)


def with_rank(meshes, apart=0.0):
    """Returns the elements of all ranks in one grid, with the cell array Rank. apart: moves each
    piece away from the middle by this fraction of its distance."""
    places = np.concatenate([points_of(mesh) for mesh in meshes])
    middle = (places.min(axis=0) + places.max(axis=0)) / 2
    append = vtkAppendFilter()
    for rank, mesh in enumerate(meshes):
        if mesh.GetNumberOfCells() == 0:
            continue
        part = mesh.NewInstance()
        part.DeepCopy(mesh)
        points = points_of(part)
        points += apart * ((points.min(axis=0) + points.max(axis=0)) / 2 - middle)
        array = numpy_to_vtk(np.full(part.GetNumberOfCells(), rank, np.int32), deep=True)
        array.SetName("Rank")
        part.GetCellData().AddArray(array)
        append.AddInputData(part)
    append.Update()
    return producer(append.GetOutput())


def producer(data):
    """Returns a source of ParaView's pipeline with these data."""
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(data)
    source.UpdatePipeline()
    return source


def colour_of(index, saturation=0.45, value=0.92):
    """Returns a colour for a number. Colours of successive numbers differ clearly."""
    return colorsys.hsv_to_rgb((0.58 + 0.381966 * index) % 1.0, saturation, value)


def colour_by_number(display, array, least, most):
    """Gives each integer of a cell array its own colour."""
    simple.ColorBy(display, ("CELLS", array))
    table = simple.GetColorTransferFunction(array)
    table.InterpretValuesAsCategories = 1
    table.AnnotationsInitialized = 1
    table.Annotations = [text for number in range(least, most + 1)
                         for text in (str(number), str(number))]
    table.IndexedColors = [channel for number in range(least, most + 1)
                           for channel in colour_of(number)]


def draw(mesh, array, least, most, path, edges=True, **look):
    """Saves a picture of the mesh from outside, coloured by an integer array. look: camera, zoom
    and size, if they differ from the defaults of save_view."""
    save_view(
        mesh,
        lambda view: colour_by_number(pictures.show(mesh, view, edges=edges), array, least, most),
        path, **look)


def draw_quality(mesh, lowest, path, **look):
    save_view(mesh,
              lambda view: pictures.colour_by_quality(pictures.show(mesh, view), view, lowest),
              path, sink=0.15, **look)


def save_view(mesh, show, path, camera=(0.7, -1.0, 0.7), zoom=1.1, size=SIZE, sink=0.0):
    view = pictures.make_view(size)
    show(view)
    pictures.aim(view, mesh.GetDataInformation().GetBounds(), camera, zoom, sink)
    pictures.save(view, path)


def join(panels, path, columns):
    """Writes pictures of equal size in rows and columns. Removes the files of the panels."""
    images = []
    for panel in panels:
        reader = vtkPNGReader()
        reader.SetFileName(panel)
        reader.Update()
        width, height, _ = reader.GetOutput().GetDimensions()
        images.append(
            vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(height, width, -1))
        os.remove(panel)
    rows = [np.concatenate(images[i:i + columns], axis=1) for i in range(0, len(images), columns)]
    whole = np.concatenate(rows[::-1])  # the first row of an image is the lowest one
    image = vtkImageData()
    image.SetDimensions(whole.shape[1], whole.shape[0], 1)
    image.GetPointData().SetScalars(numpy_to_vtk(whole.reshape(-1, whole.shape[2]), deep=True))
    writer = vtkPNGWriter()
    writer.SetFileName(path)
    writer.SetInputData(image)
    writer.Write()
