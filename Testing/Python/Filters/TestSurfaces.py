"""Surfaces pass from Volume Fraction Of Surface to the mesh filters as field data."""
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkMultiBlockDataSet
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkSphereSource

from compare_meshes import difference, merge
from vfmtest import (
    collect, failure_of, main, producer, VolumeFractionOfSurface, VolumeFractionShapes,
    VolumeFractionToHex, VolumeFractionToTet)

NAMES = ["InputSurface" + name
         for name in ("Points", "Triangles", "Bodies", "Patches", "Names", "PatchNames")]


def cube():
    source = vtkCubeSource()
    source.Update()
    return source.GetOutput()


def ball():
    source = vtkSphereSource()
    source.SetCenter(2, 0, 0)
    source.Update()
    return source.GetOutput()


def with_patches(data):
    """Adds the patches of ParaView's STL reader: one per side of the cube."""
    labels = numpy_to_vtk(np.arange(data.GetNumberOfCells(), dtype=np.float32), deep=1)
    labels.SetName("STLSolidLabeling")
    data.GetCellData().AddArray(labels)
    return data


def fractions(*surfaces, **properties):
    proxy = VolumeFractionOfSurface(Input=[producer(data) for data in surfaces],
                                    **{"Dimensions": [20] * 3, **properties})
    proxy.UpdatePipeline()
    image = vtkImageData()
    image.DeepCopy(proxy.GetClientSideObject().GetOutputDataObject(0))
    return image


def texts(array):
    return [array.GetValue(i) for i in range(array.GetNumberOfValues())]


def mesh_of(data, make=VolumeFractionToHex, **properties):
    """Returns the mesh, or the only message of an error."""
    mesher = make(Input=producer(data), **properties)
    algorithm = mesher.GetClientSideObject()
    errors, _ = collect(algorithm)
    mesher.UpdatePipeline()
    mesh = algorithm.GetOutputDataObject(0)
    if errors:
        assert len(errors) == 1 and failure_of(mesh) in errors[0], errors
        return errors[0]
    assert mesh.GetNumberOfCells() > 0
    return mesh


def without(data, *names):
    copy = vtkImageData()
    copy.DeepCopy(data)
    for name in names or NAMES:
        copy.GetFieldData().RemoveArray(name)
    return copy


def test_arrays():
    fields = fractions(with_patches(cube()), ball()).GetFieldData()
    points, triangles, bodies, patches, names, of_patches = map(fields.GetAbstractArray, NAMES)
    assert texts(names) == ["Material1", "Material2"]
    bodies, patches = vtk_to_numpy(bodies), vtk_to_numpy(patches)
    assert (bodies == 0).sum() == 12 and texts(of_patches) == [""] * 7
    assert np.bincount(patches[bodies == 0]).tolist() == [2] * 6
    assert set(patches[bodies == 1]) == {6}
    corners = vtk_to_numpy(points)[vtk_to_numpy(triangles)]
    volumes = np.linalg.det(corners)
    assert abs(volumes[bodies == 0].sum() / 6 - 1) < 1e-12


def test_shapes_alone_have_no_surfaces():
    source = VolumeFractionShapes()
    source.UpdatePipeline()
    fields = source.GetClientSideObject().GetOutputDataObject(0).GetFieldData()
    assert fields.GetNumberOfArrays() == 0


def test_mesh_uses_the_surfaces():
    """The option switches them off, as does their absence; blocks pass them too."""
    data = fractions(cube(), Bounds=[-0.83, 0.8, -0.8, 0.77, -0.8, 0.8], FitToInput=0)
    blocks = vtkMultiBlockDataSet()
    blocks.SetBlock(0, data)
    for make in (VolumeFractionToHex, VolumeFractionToTet):
        used, off, none, in_blocks = (
            merge([mesh]) for mesh in (
                mesh_of(data, make), mesh_of(data, make, SurfaceTargets="Off"),
                mesh_of(without(data), make), mesh_of(blocks, make)))
        assert difference(used, none)
        for one, other in ((off, none), (in_blocks, used)):
            problem = difference(one, other)
            assert not problem, problem


def test_arrays_that_do_not_fit_are_an_error():
    data = fractions(cube())
    assert "do not fit each other" in mesh_of(without(data, "InputSurfaceBodies"))
    for name, value, text in (("InputSurfaceTriangles", 1000, "refers to point 1000"),
                              ("InputSurfacePatches", 7, "do not fit each other")):
        wrong = without(data, "none")
        wrong.GetFieldData().GetArray(name).SetComponent(0, 0, value)
        message = mesh_of(wrong)
        assert text in message and "InputSurface" in message, message


main(globals())
