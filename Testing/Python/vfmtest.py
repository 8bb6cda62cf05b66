"""Shared by the Python tests: the plugin, small fields, and runs that collect their messages.

The environment variable VFM_PLUGIN names the plugin; without it, vtk_simple on plain VTK replaces
paraview.simple. A test is a function test_*; main() runs all and reports which need ParaView.
"""
import hashlib
import json
import os
import re
import subprocess
import sys
import tempfile
import time
import traceback
import unittest
import zlib

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkRectilinearGrid
from vtkmodules.vtkCommonCore import vtkIdTypeArray, vtkVersion
from vtkmodules.vtkCommonMath import vtkMatrix3x3
from vtkmodules.vtkIOIOSS import vtkIOSSReader
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter
from vtkmodules.vtkParallelCore import vtkCommunicator, vtkMultiProcessController

if "VFM_PLUGIN" in os.environ:
    from paraview import servermanager, simple
    from paraview.modules.vtkRemotingCore import vtkProcessModule
    # This defines VolumeFractionToHex, VolumeFractionToTet, ...
    simple.LoadPlugin(os.path.abspath(os.environ["VFM_PLUGIN"]), remote=False, ns=globals())
    RUNS_ON_ALL_RANKS = vtkProcessModule.GetProcessModule().GetSymmetricMPIMode()
    PYTHON = ["pvbatch", "--sym"]  # runs a script on all ranks
else:
    import vtk_simple as simple
    servermanager = simple.servermanager
    globals().update(simple.PROXIES)
    RUNS_ON_ALL_RANKS = True
    PYTHON = [sys.executable]
GHOST, HIDDEN = 1, 32  # bits of vtkGhostType
HEX_FACES = np.array([[0, 4, 7, 3], [1, 2, 6, 5], [0, 1, 5, 4], [3, 7, 6, 2], [0, 3, 2, 1],
                      [4, 5, 6, 7]])
# The three neighbours of each corner.
HEX_EDGES = np.array([[1, 3, 4], [2, 0, 5], [3, 1, 6], [0, 2, 7], [7, 5, 0], [4, 6, 1], [5, 7, 2],
                      [6, 4, 3]])
TET_FACES = np.array([[0, 1, 3], [1, 2, 3], [2, 0, 3], [0, 2, 1]])
# exact in binary: coordinates of blocks match exactly
SPACING, ORIGIN = (0.25, 0.25, 0.5), (-1.0, 0.5, 2.0)

# Properties of the meshing filters that are not options.
OF_PANEL = {"Input", "InputSpacing", "Cells"} if "VFM_PLUGIN" in os.environ else {"Input"}


def list_defaults(of_tets):
    """Returns the defaults of a meshing filter's properties from the table of options.

    The program describe_options prints the table.
    """
    built = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "build", "bin",
                         "describe_options")
    rows = json.loads(subprocess.check_output([os.environ.get("VFM_OPTIONS", built)]))["options"]
    defaults = {"VolumeFractionArrays": [], "MaterialIdArray": [None, "None"], "StateArrays": []}
    for row in rows:
        if of_tets or not row["tets"]:
            words = re.sub("(?<=[a-z])(?=[A-Z])", " ", row["default"])
            lists = dict.fromkeys(("arrays", "kinds", "boxes"), [])
            defaults[row["name"]] = {**lists, "array": "None", "pairs": "None", "ranges": "None",
                                     "file": "", "widths": "0", "sizes": "None",
                                     "choice": words}.get(row["kind"], row["number"])
    # The GUI shows these defaults as text.
    return {**defaults, "StateOrder": "2", "MaximumLevel": "Automatic"}


def ball_and_plate(n=12):
    """Returns fractions of a ball on a plate, each (n, n, n) in the order z, y, x.

    The ball is complete; the plate fills the rest of its layer.
    """
    s = 4
    z, y, x = np.meshgrid(*[(np.arange(n * s) + 0.5) / s] * 3, indexing="ij")
    ball = (x - n / 2) ** 2 + (y - n / 2) ** 2 + (z - 0.55 * n) ** 2 < (0.3 * n) ** 2
    plate = (z < 0.33 * n) & ~ball
    cells = lambda inside: inside.reshape(n, s, n, s, n, s).mean(axis=(1, 3, 5))
    return cells(ball), cells(plate)


def box_along_axes(low, high, n=12):
    """Returns exact fractions (z, y, x) of a box between two corners, given in cells."""
    parts = [np.clip(np.minimum(np.arange(n) + 1, h) - np.maximum(np.arange(n), l), 0, 1)
             for l, h in zip(low, high)]
    return np.einsum("k,j,i->kji", *parts[::-1])


def labels(n=12):
    """Returns the material with the largest fraction per cell: 0 void, 1 ball, 2 plate."""
    ball, plate = ball_and_plate(n)
    return np.where(ball + plate < 0.5, 0, np.where(ball >= plate, 1, 2))


def add_array(attributes, name, values, dtype=None):
    """Adds values, (z, y, x) or (z, y, x, components), as a VTK array."""
    values = np.asarray(values, dtype=dtype)
    flat = values.reshape(-1, values.shape[3]) if values.ndim == 4 else values.reshape(-1)
    array = numpy_to_vtk(np.ascontiguousarray(flat), deep=1)
    array.SetName(name)
    attributes.AddArray(array)
    return array


def image(arrays, first=(0, 0, 0), kind=vtkImageData):
    """Makes an image with cell arrays {name: values (z, y, x)}.

    first: index of its first node in the extent.
    """
    values = next(iter(arrays.values()))
    data = kind()
    data.SetOrigin(ORIGIN)
    data.SetSpacing(SPACING)
    size = values.shape[2::-1]
    data.SetExtent([e for a in range(3) for e in (first[a], first[a] + size[a])])
    for name, value in arrays.items():
        add_array(data.GetCellData(), name, value)
    return data


def at_points(data, matrix=None):
    """Makes the image whose points are the cell centres of an image.

    It has the arrays and the ghost flags of the image;
    matrix: direction matrix, about the first point.
    """
    points, (x0, x1, y0, y1, z0, z1) = vtkImageData(), data.GetExtent()
    points.SetExtent(x0, x1 - 1, y0, y1 - 1, z0, z1 - 1)
    points.SetSpacing(data.GetSpacing())
    points.SetOrigin([o + s / 2 for o, s in zip(data.GetOrigin(), data.GetSpacing())])
    points.GetPointData().ShallowCopy(data.GetCellData())
    if matrix is not None:
        turned = vtkMatrix3x3()
        turned.DeepCopy(np.asarray(matrix, float).ravel().tolist())
        points.SetDirectionMatrix(turned)
    return points


def rectilinear(arrays, coordinates):
    """Makes a grid with cell arrays {name: values (z, y, x)} and node coordinates x, y, z."""
    grid = vtkRectilinearGrid()
    grid.SetDimensions([len(x) for x in coordinates])
    for x, setter in zip(coordinates, ("X", "Y", "Z")):
        holder = vtkImageData().GetFieldData()
        getattr(grid, "Set%sCoordinates" % setter)(add_array(holder, setter, np.array(x)))
    for name, value in arrays.items():
        add_array(grid.GetCellData(), name, value)
    return grid


def fraction_image(n=12, dtype=np.float64):
    ball, plate = ball_and_plate(n)
    return image({"ball": ball.astype(dtype), "plate": plate.astype(dtype)})


def reduced(value, operation):
    """Reduces an integer over all ranks."""
    mine, result = vtkIdTypeArray(), vtkIdTypeArray()
    mine.InsertNextValue(value)
    result.SetNumberOfValues(1)
    vtkMultiProcessController.GetGlobalController().AllReduce(mine, result, operation)
    return result.GetValue(0)


class Result:
    """Outputs of a run and its error and warning messages."""

    def __init__(self, algorithm, errors, warnings):
        self.mesh, self.surfaces, self.curves, self.vertices, self.materials = map(
            algorithm.GetOutputDataObject, range(5))
        self.cohesive, self.particles = map(algorithm.GetOutputDataObject, (5, 6))
        self.errors, self.warnings = errors, warnings

    def cells(self, name):
        return vtk_to_numpy(self.mesh.GetCellData().GetArray(name))

    def points(self, name):
        return vtk_to_numpy(self.mesh.GetPointData().GetArray(name))

    def field(self, name):
        array = self.mesh.GetFieldData().GetAbstractArray(name)
        return [array.GetValue(i) for i in range(array.GetNumberOfValues())]


def failure_of(data):
    """Returns the reason why an output is empty, or None for an output that was made."""
    array = data.GetFieldData().GetAbstractArray("MeshError")
    return array.GetValue(0) if array else None


def table_of(table):
    """Returns the columns of a table as {name: values}, in order."""
    columns = [table.GetColumn(c) for c in range(table.GetNumberOfColumns())]
    return {column.GetName(): [column.GetValue(row) for row in range(table.GetNumberOfRows())]
            for column in columns}


def elements(result):
    """Returns the corners of each hexahedron or tetrahedron."""
    connectivity = vtk_to_numpy(result.mesh.GetCells().GetConnectivityArray())
    return connectivity.reshape(result.mesh.GetNumberOfCells(), -1)


def facets(result):
    """Returns the corners of each quadrilateral or triangle of the surfaces."""
    connectivity = vtk_to_numpy(result.surfaces.GetPolys().GetConnectivityArray())
    return connectivity.reshape(result.surfaces.GetNumberOfCells(), -1)


def tet_volumes(points, tets):
    p = points[tets]
    return np.einsum("ij,ij->i", p[:, 1] - p[:, 0],
                     np.cross(p[:, 2] - p[:, 0], p[:, 3] - p[:, 0])) / 6


def face_owners(cells, materials):
    """Returns the materials of the elements at each face: {sorted corners: [material, ...]}."""
    table = HEX_FACES if cells.shape[1] == 8 else TET_FACES
    faces = np.sort(cells[:, table].reshape(-1, table.shape[1]), axis=1)
    owners = {}
    for face, owner in zip(map(tuple, faces.tolist()), np.repeat(materials, len(table)).tolist()):
        owners.setdefault(face, []).append(owner)
    assert max(map(len, owners.values())) <= 2, "a face is on more than two elements"
    return owners


def surface_faces(cells, materials):
    """Returns the two materials, 0 for none, of each face between materials or on the boundary."""
    return {face: tuple(sorted(pair if len(pair) == 2 else pair + [0]))
            for face, pair in face_owners(cells, materials).items()
            if len(pair) == 1 or pair[0] != pair[1]}


def check_surfaces(result):
    """Checks that port 1 holds each interface and boundary face once, with its materials."""
    expected = surface_faces(result.points("GlobalPointIds")[elements(result)],
                             result.cells("MaterialId"))
    ids = vtk_to_numpy(result.surfaces.GetPointData().GetGlobalIds())
    faces = list(map(tuple, np.sort(ids[facets(result)], axis=1).tolist()))
    assert len(faces) == len(set(faces)) and set(faces) == set(expected)
    pairs = vtk_to_numpy(result.surfaces.GetCellData().GetArray("MaterialPair"))
    assert np.all(pairs[:, 0] <= pairs[:, 1])
    side = vtk_to_numpy(result.surfaces.GetCellData().GetArray("DomainSide"))
    for face, pair, s in zip(faces, pairs, side):
        if s < 0:
            assert expected[face] == tuple(pair), (face, pair)


def points_of(result):
    return vtk_to_numpy(result.mesh.GetPoints().GetData())


def domain_faces(result, faces):
    """Returns which faces (rows of mesh points) lie entirely on a side of the domain."""
    on = [points_of(result)[:, side // 2] == bound
          for side, bound in enumerate(result.field("DomainBounds"))]
    return np.any([side[faces].all(axis=1) for side in on], axis=0)


def hex_volumes(points, hexes):
    """Returns exact volumes: each face is the mean of its two cuts into triangles."""
    volumes = np.zeros(len(hexes))
    for face in HEX_FACES:
        a, b, c, d = (points[hexes[:, corner]] for corner in face)
        for p, q, r in ((a, b, c), (a, c, d), (a, b, d), (b, c, d)):
            volumes += np.einsum("ij,ij->i", p, np.cross(q, r)) / 12
    return volumes


def check_hexes(result):
    """Checks that the mesh is conforming and valid, as far as this is quick.

    - A face has two hexes, or one on the domain boundary or next to unmeshed space.
    - Every corner is positive.
    - The volumes equal the reported ones.
    - The surfaces hold exactly the interface and boundary faces.
    """
    points, cells = points_of(result), elements(result)
    assert len(np.unique(result.points("GlobalPointIds"))) == len(points) == len(np.unique(cells))
    corner = points[cells]
    edges = corner[:, HEX_EDGES] - corner[:, :, None]
    assert (np.einsum("hci,hci->hc", edges[:, :, 0],
                      np.cross(edges[:, :, 1],
                               edges[:, :, 2])) > 0).all(), "a corner is not positive"
    faces = np.sort(cells[:, HEX_FACES].reshape(-1, 4), axis=1)
    distinct, first, which, counts = np.unique(faces, axis=0, return_index=True,
                                               return_inverse=True, return_counts=True)
    assert counts.max() <= 2, "a face is on more than two hexes"
    material = np.repeat(result.cells("MaterialId"), 6)
    sums = np.bincount(which.ravel(), weights=material, minlength=len(counts)).astype(int)
    other = np.where(counts == 1, 0, sums - material[first])
    on_domain = domain_faces(result, distinct)
    assert (result.points("GeometryDimension")[distinct[counts == 1]] < 3).all() and (
        0 not in result.field("MaterialIds") or on_domain[counts == 1].all()), "there is a crack"
    is_surface = (counts == 1) | (other != material[first])
    ids = result.points("GlobalPointIds")
    surface_ids = vtk_to_numpy(result.surfaces.GetPointData().GetGlobalIds())
    own = np.sort(surface_ids[facets(result)], axis=1)
    expected = np.sort(ids[distinct[is_surface]], axis=1)
    order, own_order = np.lexsort(expected.T), np.lexsort(own.T)
    assert np.array_equal(expected[order], own[own_order]), "the surfaces have other faces"
    pairs = np.sort(np.stack([material[first], other], axis=1)[is_surface], axis=1)[order]
    inner = vtk_to_numpy(result.surfaces.GetCellData().GetArray("DomainSide"))[own_order] < 0
    assert np.array_equal(inner,
                          ~on_domain[is_surface][order]), "a single face is inside the domain"
    assert np.array_equal(pairs[inner],
                          vtk_to_numpy(result.surfaces.GetCellData().GetArray("MaterialPair"))[
                              own_order][inner])
    volumes = hex_volumes(points, cells)
    for i, expected_volume in zip(result.field("MaterialIds"), result.field("MeshVolume")):
        volume = volumes[result.cells("MaterialId") == i].sum()
        assert np.isclose(volume, expected_volume, rtol=1e-9), (i, volume, expected_volume)


def collect(algorithm):
    """Returns two lists that collect errors and warnings; the algorithm no longer prints them."""
    errors, warnings = [], []

    def on_error(_, __, text):
        errors.append(text)

    def on_warning(_, __, text):
        warnings.append(text)

    on_error.CallDataType = on_warning.CallDataType = "string0"
    algorithm.AddObserver("ErrorEvent", on_error)
    algorithm.AddObserver("WarningEvent", on_warning)
    algorithm.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)
    return errors, warnings


def held_class(proxy):
    """Returns the plugin's algorithm in a proxy of files.

    In ParaView it is inside an algorithm for file series.
    """
    algorithm = proxy.GetClientSideObject()
    get = getattr(algorithm, "GetReader", None) or getattr(algorithm, "GetWriter", None)
    return get() if get else algorithm


def producer(data):
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(data)
    return source


def ghost_cells(source):
    """Applies ParaView's filter for ghost cells, which was renamed in 5.13."""
    return (getattr(simple, "GhostCells", None)
            or simple.GhostCellsGenerator)(Input=source, BuildIfRequired=0)


def save_data(path, proxy):
    """Saves with inline data.

    With expat since 2.6 and Debian's 2.5.0-1+deb12u5, VTK 9.2 cannot read appended data.
    """
    simple.SaveData(path, proxy=proxy,
                    **({} if path.endswith((".vtk", ".csv")) else {"DataMode": "Binary"}))


def write(data, path, writer=vtkXMLImageDataWriter, pieces=0):
    """Writes a data set to a file in a VTK XML format and returns the path."""
    it = writer()
    it.SetInputData(data)
    it.SetFileName(path)
    it.SetDataModeToBinary()
    if pieces:
        it.SetNumberOfPieces(pieces)
        it.SetEndPiece(pieces - 1)
    assert it.Write()
    return path


def needs_vtk(major, minor, why):
    """Skips the test if VTK is older than this version."""
    if (vtkVersion.GetVTKMajorVersion(), vtkVersion.GetVTKMinorVersion()) < (major, minor):
        raise unittest.SkipTest("needs VTK %d.%d: %s" % (major, minor, why))


def new_ioss_reader():
    needs_vtk(9, 2, "its reader takes a side set and a node set of one name, as x_min")
    return vtkIOSSReader()


def exodus_parts(path):
    """Yields (block name, part) for each part with elements of an Exodus file.

    The reader also finds the files of the other ranks.
    """
    reader = new_ioss_reader()
    reader.SetFileName(path)
    reader.Update()
    blocks = reader.GetOutputDataObject(0)
    for i in range(blocks.GetNumberOfPartitionedDataSets()):
        for p in range(blocks.GetNumberOfPartitions(i)):
            part = blocks.GetPartition(i, p)
            if part and part.GetNumberOfCells() > 0:
                yield blocks.GetMetaData(i).Get(blocks.NAME()), part


def in_folder(test):
    """Passes a function to the test that returns paths in a new folder."""
    def run_test():
        with tempfile.TemporaryDirectory() as folder:
            test(lambda name: os.path.join(folder, name))
    return run_test


def has_tetgen():
    return bool(VolumeFractionToTet(Input=VolumeFractionShapes()).GetPropertyValue("HasTetGen"))


def run(data, make=None, **properties):
    """Runs VolumeFractionToHex or `make` on data and collects its messages.

    The fractions are 'ball' and 'plate' unless other arrays are given.
    """
    if not {"VolumeFractionArrays", "MaterialIdArray"} & set(properties):
        properties["VolumeFractionArrays"] = ["ball", "plate"]
    mesher = (make or VolumeFractionToHex)(Input=producer(data), **properties)
    algorithm = mesher.GetClientSideObject()
    messages = collect(algorithm)
    mesher.UpdatePipeline()
    return Result(algorithm, *messages)


def mesh_of(data, make=None, **properties):
    """Runs the filter like run() and checks that there is no error."""
    result = run(data, make, **properties)
    assert not result.errors, result.errors
    assert result.mesh.GetNumberOfCells() > 0
    return result


def check_error(data, *words, make=None, **properties):
    """Checks that the run fails on every rank with one equal message that contains all words.

    The outputs must be empty except for that message.
    """
    result = run(data, make, **properties)
    message = result.errors[0].strip().split("): ", 1)[1] if result.errors else ""
    value = zlib.crc32(message.encode())
    # All ranks reduce before any of them may fail.
    same = reduced(value, vtkCommunicator.MIN_OP) == reduced(value, vtkCommunicator.MAX_OP)
    assert same and len(result.errors) == 1, result.errors
    for word in words:
        assert word in message, (word, message)
    assert result.mesh.IsA("vtkUnstructuredGrid") and result.surfaces.IsA("vtkPolyData")
    for output in (result.mesh, result.surfaces, result.curves, result.vertices, result.cohesive):
        assert output.GetNumberOfCells() == 0 and output.GetNumberOfPoints() == 0
        assert output.GetCellData().GetNumberOfArrays() == 0
    assert result.materials.GetNumberOfColumns() == 0
    for output in (result.mesh, result.surfaces, result.curves, result.vertices, result.materials,
                   result.cohesive):
        assert output.GetFieldData().GetNumberOfArrays() == 1 and failure_of(output) == message, (
            message, failure_of(output))


def uniform(levels):
    """Returns the properties that halve all cells of an image `levels` times."""
    return {"Refinement": "Uniform", "MaximumLevel": levels}


def digest(result):
    """Returns a hash of all bits of mesh and surfaces, except field data."""
    sha = hashlib.sha256()
    for data, cells in ((result.mesh, "GetCells"), (result.surfaces, "GetPolys")):
        connectivity = getattr(data, cells)().GetConnectivityArray()
        arrays = [data.GetPoints().GetData(), connectivity]
        for attributes in (data.GetPointData(), data.GetCellData()):
            arrays += [attributes.GetArray(i) for i in range(attributes.GetNumberOfArrays())]
        for array in arrays:
            sha.update(vtk_to_numpy(array).tobytes())
    return sha.hexdigest()


TET_METHODS = (["TetGen"] if has_tetgen() else []) + ["Cells", "Lattice"]  # methods in this build


def main(tests):
    """Runs the functions test_* of a script and exits with status 1 if one fails."""
    failed = 0
    for name, test in list(tests.items()):
        if not name.startswith("test_"):
            continue
        start = time.time()
        try:
            test()
            print("%-60s %.2f s" % (name, time.time() - start))
        except unittest.SkipTest as reason:
            print("%-60s %s" % (name, reason))
        except Exception:
            failed += 1
            print("%s FAILED" % name)
            traceback.print_exc()
    sys.stdout.flush()
    sys.stderr.write("")  # ParaView 5.13 otherwise delays the output until the next error
    controller = vtkMultiProcessController.GetGlobalController()
    if controller.GetNumberOfProcesses() > 1 and not RUNS_ON_ALL_RANKS:
        return  # pvbatch ends the other ranks, which run no script
    controller.Finalize()  # mpiexec complains otherwise
    os._exit(1 if failed else 0)
