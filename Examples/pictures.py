"""Pictures of meshes with ParaView: view, contents, camera and file. Needs an X server."""
import math

from paraview import simple
from vtkmodules.vtkFiltersCore import vtkImageAppend
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter

SIZE = (1600, 1200)
VIEW_ANGLE = 18  # degrees
EDGES = (0.13, 0.17, 0.22)
TEXT = (0.15, 0.15, 0.15)
# ParaView 6.1 removed brackets from names of colour maps and uses formats of C++ (std::format).
IS_RENAMED = simple.GetParaViewVersion() >= (6, 1)
VIRIDIS = "Viridis" if IS_RENAMED else "Viridis (matplotlib)"


def number_format(digits):
    """Returns the format of the numbers at a colour bar. digits: number of decimals."""
    return f"{{:.{digits}f}}" if IS_RENAMED else f"%.{digits}f"


def make_view(size=SIZE):
    view = simple.CreateRenderView()
    view.ViewSize = size
    view.UseColorPaletteForBackground = 0
    view.BackgroundColorMode = "Gradient"
    view.Background, view.Background2 = (1.0, 1.0, 1.0), (0.87, 0.90, 0.94)
    view.OrientationAxesVisibility = 0
    view.UseFXAA = 1
    view.KeyLightIntensity = 0.95
    return view


def aim(view, bounds, direction, zoom, sink=0.1):
    """Points the camera, with z up, at the middle of the bounds. direction: from there to the
    camera. sink: distance of the focal point below the middle, relative to the radius of the
    bounds."""
    centre = [(bounds[2 * a] + bounds[2 * a + 1]) / 2 for a in range(3)]
    radius = math.dist(bounds[0::2], bounds[1::2]) / 2
    centre[2] -= sink * radius
    length = math.hypot(*direction)
    distance = radius / math.sin(math.radians(VIEW_ANGLE / 2)) / zoom
    view.CameraFocalPoint = centre
    view.CameraPosition = [c + distance * d / length for c, d in zip(centre, direction)]
    view.CameraViewUp = (0, 0, 1)
    view.CameraViewAngle = VIEW_ANGLE


def show(proxy, view, colour=None, edges=True):
    """Shows a mesh and returns its display. colour: red, green, blue; None: set by ColorBy."""
    display = simple.Show(proxy, view)
    display.SetRepresentationType("Surface With Edges" if edges else "Surface")
    display.EdgeColor = EDGES
    display.LineWidth = 1.0
    display.Ambient, display.Diffuse = 0.25, 0.85
    display.Specular, display.SpecularPower = 0.1, 20.0
    if colour:
        display.ColorArrayName = [None, ""]
        display.AmbientColor = display.DiffuseColor = colour
    return display


def show_material(mesh, view, material):
    """Shows the elements of a material in the colour of the plugin. Returns their proxy."""
    part = simple.Threshold(Input=mesh, Scalars=["CELLS", "MaterialId"], LowerThreshold=material,
                            UpperThreshold=material)
    simple.ColorBy(show(part, view), ("CELLS", "MaterialId"))
    return part


def show_particles(particles, view, colour=None):
    """Shows particles as spheres of their Radius and returns their display. colour: as for show."""
    display = simple.Show(particles, view)
    display.SetRepresentationType("Point Gaussian")
    display.ShaderPreset = "Sphere"
    display.ScaleByArray, display.SetScaleArray = 1, ["POINTS", "Radius"]
    display.UseScaleFunction, display.GaussianRadius = 0, 1.0
    if colour:
        display.ColorArrayName = [None, ""]
        display.AmbientColor = display.DiffuseColor = colour
    return display


def cut(mesh, origin, normal):
    """Returns the elements on the side of a plane to which its normal points, without cutting
    them."""
    half = simple.Clip(Input=mesh, ClipType="Plane", Crinkleclip=1, Invert=0)
    half.ClipType.Origin, half.ClipType.Normal = origin, normal
    return half


def colour_by_quality(display, view, lowest):
    """Colours elements by scaled Jacobian, from `lowest` to 1, and shows a colour bar."""
    colour_by(display, view, "ScaledJacobian", "Scaled Jacobian", math.floor(10 * lowest) / 10)


def colour_by(display, view, array, title, lowest, preset=VIRIDIS, inverted=False,
              kind="CELLS"):
    """Colours cells or POINTS by an array, from `lowest` to 1, and shows a colour bar."""
    simple.ColorBy(display, (kind, array))
    table = simple.GetColorTransferFunction(array)
    table.ApplyPreset(preset, True)
    if inverted:
        table.InvertTransferFunction()
    table.RescaleTransferFunction(lowest, 1.0)
    bar = simple.GetScalarBar(table, view)
    bar.Title, bar.ComponentTitle = title, ""
    bar.TitleColor = bar.LabelColor = TEXT
    bar.TitleFontSize, bar.LabelFontSize = 30, 26
    bar.ScalarBarThickness, bar.ScalarBarLength = 28, 0.5
    bar.AutomaticLabelFormat, bar.LabelFormat, bar.RangeLabelFormat = (
        0, number_format(2), number_format(2))
    bar.Orientation, bar.WindowLocation, bar.Position = "Horizontal", "Any Location", (0.25, 0.045)
    display.SetScalarBarVisibility(view, True)


def save(view, path):
    simple.Render(view)
    simple.SaveScreenshot(path, view, ImageResolution=view.ViewSize)
    simple.Delete(view)


def join(left, right, path):
    """Writes two pictures of the same height side by side."""
    pair = vtkImageAppend()
    pair.SetAppendAxis(0)
    for picture in (left, right):
        reader = vtkPNGReader()
        reader.SetFileName(picture)
        reader.Update()
        pair.AddInputData(reader.GetOutput())
    pair.Update()
    writer = vtkPNGWriter()
    writer.SetFileName(path)
    writer.SetInputData(pair.GetOutput())
    writer.Write()
