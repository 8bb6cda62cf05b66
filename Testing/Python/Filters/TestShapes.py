"""Source of volume fractions of shapes, and filter for closed surfaces."""
import math

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import (
    vtkAppendPolyData, vtkMassProperties, vtkReverseSense, vtkTriangleFilter)
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkCylinderSource, vtkSphereSource

from vfmtest import (
    collect, failure_of, main, producer, VolumeFractionOfSurface, VolumeFractionShapes)


class Fractions:
    """Output of a proxy, and messages of the run."""

    def __init__(self, proxy):
        algorithm = proxy.GetClientSideObject()
        self.errors, self.warnings = collect(algorithm)
        proxy.UpdatePipeline()
        self.image = algorithm.GetOutputDataObject(0)

    def names(self):
        data = self.image.GetCellData()
        return [data.GetArrayName(i) for i in range(data.GetNumberOfArrays())]

    def values(self, material=1):
        return vtk_to_numpy(self.image.GetCellData().GetArray("Material%d" % material))

    def volume(self, material=1):
        return self.values(material).sum() * np.prod(self.image.GetSpacing())


def of(proxy):
    """Runs a proxy and checks that there is no message."""
    result = Fractions(proxy)
    assert not result.errors and not result.warnings, result.errors + result.warnings
    return result


def output(algorithm):
    algorithm.Update()
    return algorithm.GetOutput()


def sphere(radius=0.5, x=0.0):
    source = vtkSphereSource()
    source.SetThetaResolution(24)
    source.SetPhiResolution(17)
    source.SetRadius(radius)
    source.SetCenter(x, 0, 0)
    return output(source)


def cube(edge=1.0):
    source = vtkCubeSource()
    for axis in "XYZ":
        getattr(source, "Set%sLength" % axis)(edge)
    return output(source)


def reversed_sense(data):
    turn = vtkReverseSense()
    turn.SetInputData(data)
    turn.ReverseCellsOn()
    return output(turn)


def appended(*parts):
    append = vtkAppendPolyData()
    for part in parts:
        append.AddInputData(part)
    return output(append)


def volume_inside(data):
    triangles, mass = vtkTriangleFilter(), vtkMassProperties()
    triangles.SetInputData(data)
    mass.SetInputConnection(triangles.GetOutputPort())
    return mass.GetVolume()


def of_surface(*data, **properties):
    return VolumeFractionOfSurface(Input=[producer(d) for d in data], **properties)


def test_default_is_a_ball_and_a_plate():
    result = of(VolumeFractionShapes())
    assert result.names() == ["Material1", "Material2"], result.names()
    assert result.image.GetDimensions() == (33, 33, 33)
    assert result.image.GetBounds() == (-1, 1, -1, 1, -1, 1)
    assert result.values().dtype == np.float64
    assert abs(result.volume(1) / (4 / 3 * math.pi * 0.125) - 1) < 1e-5
    assert abs(result.volume(2) / 1.024 - 1) < 1e-5


def test_every_preset_of_the_menu_is_the_one_named():
    ball = lambda radius: 4 / 3 * math.pi * radius ** 3
    volumes = {  # volumes in the default bounds
        "Sphere": [ball(0.75)], "Two Spheres": [2 * ball(0.4)],
        "Ellipsoid": [ball(1) * 0.8 * 0.5 * 0.35],
        "Ball and Plate": [ball(0.5), 1.6 * 1.6 * 0.4], "Three Sectors": [ball(0.75) / 3] * 3,
        "Torus": [2 * math.pi ** 2 * 0.55 * 0.25 ** 2], "Half Sphere": [ball(0.75) / 2],
        "Gyroid": [4]}
    counts = {"Cylinder": 1, "Oblique Plate": 1, "Polycrystal": 20, "Eight Shapes": 8}
    names = list(VolumeFractionShapes().GetProperty("Preset").Available)
    assert set(names) == {"None"} | set(volumes) | set(counts), names
    for name in names[1:]:
        result = of(VolumeFractionShapes(Preset=name, Dimensions=[21, 20, 19]))
        found = [result.volume(m + 1) for m in range(len(result.names()))]
        total = sum(result.values(m + 1) for m in range(len(found)))
        assert total.min() >= 0 and total.max() <= 1 + 1e-12, (name, total.max() - 1)
        if name in volumes:
            assert np.allclose(found, volumes[name], rtol=2e-5, atol=0), (name, found)
        else:
            assert len(found) == counts[name] and 1 < sum(found) < 8.001, (name, found)
            assert (abs(total - 1).max() < 1e-12) == (name == "Polycrystal"), name


def test_text_replaces_the_preset():
    text = "sphere radius=0.5  # first\nbox material=3 size=1,1,1 rotation=0,0,30"
    result = of(VolumeFractionShapes(Shapes=text, Bounds=[-1, 1, -2, 2, -1, 2],
                                     Dimensions=[20, 30, 40]))
    assert result.names() == ["Material1", "Material2", "Material3"]
    assert result.image.GetDimensions() == (21, 31, 41)
    assert result.image.GetBounds() == (-1, 1, -2, 2, -1, 2)
    ball = 4 / 3 * math.pi * 0.125
    assert abs(result.volume(1) - ball) < 1e-5 and result.volume(2) == 0
    assert abs(result.volume(3) - (1 - ball)) < 1e-5


def test_any_extent_gives_the_same_fractions():
    proxy = VolumeFractionShapes(Preset="Three Sectors", Dimensions=[24, 20, 22])
    whole = of(proxy)
    algorithm = VolumeFractionShapes(Preset="Three Sectors",
                                     Dimensions=[24, 20, 22]).GetClientSideObject()
    algorithm.UpdateInformation()
    for extent in ([0, 24, 0, 20, 0, 22], [3, 17, 5, 20, 0, 9], [8, 9, 8, 9, 8, 9]):
        algorithm.Modified()  # otherwise the larger extent of before is used
        assert algorithm.UpdateExtent(extent)
        part = algorithm.GetOutputDataObject(0)
        assert list(part.GetExtent()) == extent
        for m in (1, 2, 3):
            values = whole.values(m).reshape(22, 20, 24)
            values = values[extent[4]:extent[5], extent[2]:extent[3], extent[0]:extent[1]]
            name = "Material%d" % m
            assert np.array_equal(values.ravel(), vtk_to_numpy(part.GetCellData().GetArray(name)))


def test_threads_do_not_matter():
    surfaces = [sphere(), sphere(0.4, 0.3)]
    for make in (lambda n: VolumeFractionShapes(Preset="Torus", NumberOfThreads=n),
                 lambda n: of_surface(*surfaces, Dimensions=[20] * 3, NumberOfThreads=n)):
        one, three = of(make(1)), of(make(3))
        assert np.array_equal(one.values(), three.values())


def test_surface_volume_is_exact():
    for data in (sphere(), cube(), reversed_sense(sphere()), appended(sphere(), sphere(0.3, 2.0))):
        result = of(of_surface(data, Dimensions=[25] * 3))
        assert abs(result.volume() / volume_inside(data)
                   - 1) < 1e-12, (result.volume(), volume_inside(data))
        low, high = result.image.GetBounds()[::2], result.image.GetBounds()[1::2]
        width = result.image.GetSpacing()[0]
        assert result.image.GetSpacing() == (width, width, width)
        for axis in range(3):
            assert low[axis] + 1.999 * width < data.GetBounds()[2 * axis]
            assert high[axis] - 1.999 * width > data.GetBounds()[2 * axis + 1]


def test_surface_on_cell_faces_is_exact():
    result = of(of_surface(cube(), FitToInput=0, Bounds=[-1, 1, -1, 1, -1, 1], Dimensions=[8] * 3))
    cells = np.zeros((8, 8, 8))
    cells[2:6, 2:6, 2:6] = 1
    assert np.abs(result.values() - cells.ravel()).max() < 1e-14


def test_cavity_is_void():
    result = of(of_surface(appended(sphere(0.5), reversed_sense(sphere(0.3)))))
    assert abs(result.volume() / (volume_inside(sphere(0.5)) - volume_inside(sphere(0.3)))
               - 1) < 1e-12


def test_surfaces_follow_each_other_and_the_text():
    ball = volume_inside(sphere())
    result = of(of_surface(sphere(), cube(2), FitToInput=0, Bounds=[-1.5, 1.5] * 3,
                           Dimensions=[20] * 3))
    assert abs(result.volume(1) - ball) < 1e-12 and abs(result.volume(2) - (8 - ball)) < 1e-12
    result = of(of_surface(sphere(), Shapes="halfspace point=0,0,0 normal=1,0,0",
                           Dimensions=[20] * 3))
    assert abs(result.volume(2) / (0.5 * ball) - 1) < 1e-12  # the plane is between cells
    result = of(of_surface(sphere(), Shapes="halfspace point=0,0,0 normal=1,2,3",
                           Dimensions=[20] * 3))
    # In cells that both boundaries cut, the surface gets the whole rest.
    assert 1 < result.volume(2) / (0.5 * ball) < 1.01, result.volume(2) / (0.5 * ball)
    assert (result.values(1) + result.values(2)).max() <= 1
    result = of(of_surface(sphere(), sphere(0.4, 2), SurfaceMaterial=3))
    assert result.names() == ["Material1", "Material2", "Material3"]
    assert abs(result.volume(3) / (ball + volume_inside(sphere(0.4, 2))) - 1) < 1e-12


def expect_error(proxy, *words):
    result = Fractions(proxy)
    assert len(result.errors) == 1, result.errors
    for word in words:
        assert word in result.errors[0], result.errors
    assert result.image.GetCellData().GetNumberOfArrays() == 0 and failure_of(
        result.image) in result.errors[0]
    assert result.names() == []


def test_errors_are_one_message_and_an_empty_output():
    expect_error(VolumeFractionShapes(Shapes="sphere radius=1\nsphere radius=x"), "line 2", "'x'")
    expect_error(VolumeFractionShapes(Shapes="sphere radius=0"), "line 1", "radius")
    expect_error(VolumeFractionShapes(Preset="None"), "no shape")
    expect_error(VolumeFractionShapes(Bounds=[0, 1, 0, 1, 1, 1]), "Bounds")
    expect_error(VolumeFractionShapes(Dimensions=[4, 0, 4]), "Dimensions")
    expect_error(VolumeFractionShapes(Tolerance=0), "tolerance")
    expect_error(VolumeFractionShapes(Preset="None", Shapes="torus ring=1 tube=2"), "torus")
    pipe = vtkCylinderSource()
    pipe.SetResolution(6)
    pipe.CappingOff()
    expect_error(of_surface(output(pipe)), "open", "12 edges")
    expect_error(of_surface(vtkPolyData()), "no polygons")
    expect_error(of_surface(vtkPolyData(), FitToInput=0), "no polygons")
    expect_error(of_surface(sphere(), Dimensions=[4, 20, 20]), "at least 5")
    expect_error(of_surface(sphere(), SurfaceMaterial=-1), "material")


def tetrahedron(tip):
    points, cells = vtkPoints(), vtkCellArray()
    for p in ((0, 0, 0), (1, 0, 0), tip, (0.5, 0.2, tip[1])):
        points.InsertNextPoint(p)
    for t in ((0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)):
        cells.InsertNextCell(3, t)
    data = vtkPolyData()
    data.SetPoints(points)
    data.SetPolys(cells)
    return data


def test_edge_of_four_triangles():
    two = appended(tetrahedron((0.5, 1, 0)), tetrahedron((0.5, -1, 0)))  # the two share an edge
    result = Fractions(of_surface(two))
    assert not result.errors, result.errors


def test_surface_that_is_not_manifold_is_an_error():
    points, cells = vtkPoints(), vtkCellArray()
    for p in ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 1), (-1, -1, 0.5)):
        points.InsertNextPoint(p)
    for t in ((0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3), (0, 1, 4), (1, 2, 4), (2, 0, 4)):
        cells.InsertNextCell(3, t)
    data = vtkPolyData()
    data.SetPoints(points)
    data.SetPolys(cells)
    expect_error(of_surface(data), "not manifold", "3 edges", "(0, 0, 0)")


main(globals())
