"""Images with values at points or with a direction matrix, and the offered and default arrays."""
import re

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkUniformGrid

from exodus_dump import Dump, join
from mesh_sets import find_sets
from vfmtest import (
    HIDDEN, ORIGIN, SPACING, TET_METHODS, VolumeFractionToHex, VolumeFractionToTet, add_array,
    at_points, ball_and_plate, check_surfaces,
    digest, elements, facets, hex_volumes, image, in_folder, labels, main, mesh_of, points_of,
    producer, rectilinear, run, tet_volumes, simple)

N = 12
BALL, PLATE = ball_and_plate(N)
RANDOM = np.random.default_rng(3)
FIELDS = {"ball": BALL, "plate": PLATE}
STATE = {"velocity": RANDOM.normal(size=(N, N, N, 3)).astype(np.float32),
         "number": RANDOM.integers(2 ** 60, size=(N, N, N))}
METHODS = [{}] + [{"make": VolumeFractionToTet, "Method": method} for method in TET_METHODS]
ROTATIONS = {  # direction matrices
    "quarter": [[0, -1, 0], [1, 0, 0], [0, 0, 1]],
    "oblique": [[0.6, -0.8, 0], [0.48, 0.36, -0.8], [0.64, 0.48, 0.6]]}
MIRRORS = {"along x": [[-1, 0, 0], [0, 1, 0], [0, 0, 1]],
           "swapped": [[0, 1, 0], [1, 0, 0], [0, 0, 1]],
           "oblique": [[0.6, 0.8, 0], [0.8, -0.6, 0], [0, 0, 1]]}
# the first point, which is the centre of rotation
CENTRE = np.array(ORIGIN) + 0.5 * np.array(SPACING)


def check_same(arrays, kind=image, **properties):
    """Checks that values at points give the same mesh as in cells."""
    assert digest(mesh_of(at_points(image(arrays)),
                          **properties)) == digest(mesh_of(image(arrays), **properties))


def test_fractions():
    for method in METHODS:
        check_same({**FIELDS, **STATE}, StateArrays=["velocity", "number"], **method)
    check_same({name: np.round(255 * values).astype(np.uint8) for name, values in FIELDS.items()})
    check_same(FIELDS, Refinement="Coarsen", MeshVoid=1)


def test_labels_of_any_type():
    reference = digest(mesh_of(image({"id": labels(N)}), MaterialIdArray="id"))
    for dtype in (np.int8, np.uint8, np.int16, np.uint16, np.int32, np.int64, np.float32,
                  np.float64):
        arrays = {"id": labels(N).astype(dtype)}
        for data in (image(arrays), at_points(image(arrays))):
            assert digest(mesh_of(data, MaterialIdArray="id")) == reference, dtype
    check_same({"id": labels(N)}, MaterialIdArray="id", LabelSmoothing=2, make=VolumeFractionToTet,
               Method="Lattice")


def test_refinement():
    wish = np.zeros((N, N, N), np.int16)
    wish[2:4, 5:7, 5:7] = 1
    check_same({**FIELDS, "wish": wish}, Refinement="Automatic", RefinementArray="wish",
               RefinementBoxes=[0, 1, 3, 1, 2, 4, 1])


def test_one_slice():
    for size in ((1, N, N), (N, 1, N), (N, N, 1)):
        ids = RANDOM.integers(0, 3, size)
        check_same({"id": ids}, MaterialIdArray="id")


def split(arrays, shared):
    """Makes two blocks of points along x with `shared` common planes."""
    blocks = vtkMultiBlockDataSet()
    for i, (begin, end) in enumerate(((0, 5 + shared), (5, N))):
        part = {name: np.ascontiguousarray(values[:, :, begin:end])
                for name, values in arrays.items()}
        data = at_points(image(part, kind=vtkUniformGrid))
        data.SetOrigin(data.GetOrigin()[0] + begin * SPACING[0], *data.GetOrigin()[1:])
        blocks.SetBlock(i, data)
    return blocks


def test_blocks():
    reference = digest(mesh_of(image(FIELDS)))
    for shared in (0, 1):
        assert digest(mesh_of(split(FIELDS, shared))) == reference
    result = run(split(FIELDS, 2))
    assert len(result.errors) == 1 and "overlap" in result.errors[0]


def test_hidden_points():
    hidden = RANDOM.random((N, N, N)) < 0.1
    cells = image({**FIELDS, "vtkGhostType": np.where(hidden, HIDDEN, 0).astype(np.uint8)})
    points = at_points(image({**FIELDS, "vtkGhostType": np.where(hidden, 2, 0).astype(np.uint8)}))
    assert digest(mesh_of(points)) == digest(mesh_of(cells))


def test_forms_of_a_choice():
    """Properties accept names with and without the association."""
    both = at_points(image({"id": labels(N), **FIELDS}))
    smaller = {"id": np.ones((N - 1,) * 3, np.int16), "ball": np.ones((N - 1,) * 3),
               "rest": np.zeros((N - 1,) * 3)}
    for name, values in smaller.items():
        add_array(both.GetCellData(), name, values)
    cells = lambda **chosen: mesh_of(both, StairStep=1, **chosen).mesh.GetNumberOfCells()
    of_cells, of_points = (N - 1) ** 3, np.count_nonzero(labels(N))
    assert cells(MaterialIdArray="id") == cells(MaterialIdArray=["CELLS", "id"]) == of_cells
    assert cells(MaterialIdArray=["POINTS", "id"]) == of_points
    assert cells(VolumeFractionArrays=["ball",
                                       "rest"]) == cells(
                                           VolumeFractionArrays=[
                                               "CELLS", "ball", "CELLS", "rest"]) == of_cells
    expected = mesh_of(image(FIELDS), StairStep=1).mesh.GetNumberOfCells()
    for words in (["ball", "plate"], ["POINTS", "ball", "plate"],
                  ["POINTS", "ball", "POINTS", "plate"]):
        # The first array without association decides; only points have 'plate'.
        assert cells(VolumeFractionArrays=words) == expected, words
    hexes = VolumeFractionToHex(Input=producer(both), MaterialIdArray=["POINTS", "id"])
    assert list(hexes.MaterialIdArray) == ["POINTS", "id"]
    hexes.MaterialIdArray = "None"
    hexes.VolumeFractionArrays = ["POINTS", "ball"]
    hexes.UpdatePipeline()
    hexes.VolumeFractionArrays = ["ball"]  # POINTS no longer applies
    hexes.StairStep = 1
    hexes.UpdatePipeline()
    assert hexes.GetDataInformation().GetNumberOfCells() == of_cells


@in_folder
def test_state_files_of_before(at):
    """State files of older versions, where MaterialIdArray had one element, are read."""
    simple.ResetSession()
    data = at_points(image({"id": labels(N), "ball": BALL}))
    source = producer(data)
    simple.SaveData(at("in.vti"), proxy=source, DataMode="Binary")
    simple.Delete(source)
    del source
    VolumeFractionToHex(registrationName="mesh", Input=simple.OpenDataFile(at("in.vti")),
                        MaterialIdArray="id")
    simple.SaveState(at("new.pvsm"))
    with open(at("new.pvsm")) as file:
        text = file.read()
    pattern = (r'(<Property name="MaterialIdArray" id="[^"]*" number_of_elements=)"5">.*?'
               r'(<Domain|</Property>)')
    text, count = re.subn(pattern, r'\1"1"><Element index="0" value="id"/>\2', text, flags=re.S)
    assert count >= 1
    with open(at("old.pvsm"), "w") as file:
        file.write(text)
    for name in ("new.pvsm", "old.pvsm"):
        simple.ResetSession()
        simple.LoadState(at(name))
        mesh = simple.FindSource("mesh")
        mesh.UpdatePipeline()
        assert mesh.GetDataInformation().GetNumberOfCells() == mesh_of(
            data, MaterialIdArray="id").mesh.GetNumberOfCells()


def turned(points, matrix):
    return (points - CENTRE) @ np.array(matrix, float).T + CENTRE


def volumes_of(result):
    cells = elements(result)
    return (hex_volumes if cells.shape[1] == 8 else tet_volumes)(points_of(result), cells)


def outward_volume(result, material):
    """Returns the volume that the facets around a material enclose.

    It is positive if their normals, reversed where needed, point out of the material.
    """
    pairs = vtk_to_numpy(result.surfaces.GetCellData().GetArray("MaterialPair"))
    points = vtk_to_numpy(result.surfaces.GetPoints().GetData()) - CENTRE
    volume = 0.0
    # Normals point from the second material to the first.
    for sign, own in ((1, pairs[:, 1] == material), (-1, pairs[:, 0] == material)):
        corners = points[facets(result)[own]]
        for c in range(1, corners.shape[1] - 1):
            volume += sign * np.einsum("ij,ij->", corners[:, 0],
                                       np.cross(corners[:, c], corners[:, c + 1])) / 6
    return volume


def check_turned(matrix, is_mirror, **method):
    arrays = {**FIELDS, **STATE}
    properties = {"StateArrays": ["velocity", "number"], **method}
    plain, result = mesh_of(at_points(image(arrays)),
                            **properties), mesh_of(at_points(image(arrays), matrix), **properties)
    for output in ("mesh", "surfaces", "curves", "vertices"):
        own, other = (vtk_to_numpy(getattr(r, output).GetPoints().GetData())
                      for r in (plain, result))
        assert np.allclose(turned(own, matrix), other, rtol=0, atol=1e-12), output
        for of in ("GetPointData", "GetCellData"):
            attributes, others = (getattr(getattr(r, output), of)() for r in (plain, result))
            for i in range(attributes.GetNumberOfArrays()):
                assert np.array_equal(vtk_to_numpy(attributes.GetArray(i)),
                                      vtk_to_numpy(others.GetArray(i))), attributes.GetArrayName(i)
    assert is_mirror != np.array_equal(elements(plain), elements(result))
    assert np.array_equal(np.sort(elements(plain)), np.sort(elements(result)))
    assert volumes_of(result).min() > 0 and np.allclose(volumes_of(result), volumes_of(plain),
                                                        rtol=1e-9)
    check_surfaces(result)
    for material, volume in zip(result.field("MaterialIds"), result.field("MeshVolume")):
        # The sum cuts each quadrilateral along one diagonal only.
        assert np.isclose(outward_volume(result, material), volume, rtol=0.01), material
    assert result.field("DomainBounds") == plain.field("DomainBounds")
    assert np.array_equal(result.field("DomainFrame"), [*np.ravel(matrix), *CENTRE])
    assert not plain.mesh.GetFieldData().HasArray("DomainFrame")


def test_turned_images():
    """The mesh of a rotated or mirrored image is the rotated mesh."""
    for method in METHODS:
        for matrix in ROTATIONS.values():
            check_turned(matrix, False, **method)
        for matrix in MIRRORS.values():
            check_turned(matrix, True, **method)
    data, cells = image(FIELDS), at_points(image(FIELDS), MIRRORS["oblique"])
    # rotates about the corner of the first cell
    data.SetDirectionMatrix(cells.GetDirectionMatrix())
    corner = np.array(ORIGIN)
    expected = (points_of(mesh_of(image(FIELDS)))
                - corner) @ np.array(MIRRORS["oblique"]).T + corner
    assert np.allclose(points_of(mesh_of(data)), expected, rtol=0, atol=1e-12)


def test_rotated_arrays():
    """Rotated Arrays are vectors and tensors in image axes; the mesh has them in world axes."""
    random = np.random.default_rng(5)
    shape = FIELDS["ball"].shape
    vector, tensor = random.random((*shape, 3)), random.random((*shape, 3, 3))
    even = tensor + np.swapaxes(tensor, -1, -2)

    def arrays(*values):
        return {**FIELDS, "v": values[0], "t": values[1].reshape(*shape, 9),
                "s": values[2][..., (0, 1, 2, 0, 1, 0), (0, 1, 2, 1, 2, 2)]}

    names = ["v", "t", "s"]
    for matrix in (ROTATIONS["oblique"], MIRRORS["oblique"]):
        a = np.array(matrix)
        own = at_points(image(arrays(vector, tensor, even)), matrix)
        world = at_points(image(arrays(vector @ a.T, a @ tensor @ a.T, a @ even @ a.T)), matrix)
        for how in ("Copy", "Conserve"):
            state = {"StateArrays": names, "StateTransfer": how}
            meshes = [mesh_of(own, RotatedArrays=names, **state), mesh_of(world, **state)]
            for name in names:
                one, other = [vtk_to_numpy(m.mesh.GetCellData().GetArray(name)) for m in meshes]
                assert np.allclose(one, other, rtol=0, atol=1e-13), (name, how)


def test_turned_blocks():
    """Rotated blocks with different origins lie where they lie in space."""
    matrix = MIRRORS["oblique"]
    whole = mesh_of(at_points(image(FIELDS), matrix))
    blocks = split(FIELDS, 1)
    for i in range(2):
        block = blocks.GetBlock(i)
        block.SetOrigin(turned(np.array(block.GetOrigin()), matrix))
        block.SetDirectionMatrix(at_points(image(FIELDS), matrix).GetDirectionMatrix())
    parts = mesh_of(blocks)
    assert np.array_equal(elements(parts), elements(whole))
    assert np.allclose(points_of(parts), points_of(whole), rtol=0, atol=1e-9)


def test_boxes_in_turned_images():
    """Refinement boxes are in world coordinates, if the image axes are parallel to the axes."""
    box = np.array([[0.0, 1.0, 3.0], [1.0, 2.0, 4.0]])
    options = {"Refinement": "Automatic", "ThinCells": 0}
    plain = mesh_of(at_points(image(FIELDS)), RefinementBoxes=[*box[0], *box[1], 1], **options)
    # Files of single precision have such matrices.
    rounded = np.array(ROTATIONS["quarter"]) + 4e-8 * np.eye(3)
    for matrix in (ROTATIONS["quarter"], MIRRORS["swapped"], rounded):
        moved = turned(box, matrix)
        result = mesh_of(at_points(image(FIELDS), matrix),
                         RefinementBoxes=[*moved.min(axis=0), *moved.max(axis=0), 1], **options)
        assert result.field("ChosenCells") == plain.field("ChosenCells") != [0]
        assert np.allclose(points_of(result), turned(points_of(plain), matrix), rtol=0, atol=1e-12)


@in_folder
def test_side_sets_of_turned_images(at):
    """Domain sides belong to the image's own axes."""
    sides, nodes = find_sets(mesh_of(at_points(image(FIELDS))).mesh)
    assert any(name == "x_min" for _, name in sides)
    for i, matrix in enumerate((*ROTATIONS.values(), *MIRRORS.values())):
        hexes = VolumeFractionToHex(Input=producer(at_points(image(FIELDS), matrix)),
                                    VolumeFractionArrays=["ball", "plate"])
        simple.SaveData(at("turned%d.exo" % i), proxy=hexes)
        found = join([Dump(at("turned%d.exo" % i))])
        assert found["sides"] == sides and found["node sets"] == nodes


def chosen_by_default(data, make=VolumeFractionToHex):
    mesher = make(Input=producer(data))
    return list(mesher.VolumeFractionArrays), mesher.MaterialIdArray[1]


def offered(data, name):
    domain = VolumeFractionToHex(Input=producer(data)).GetProperty(name).FindDomain(
        "vtkSMArrayListDomain")
    return [domain.GetString(i) for i in range(domain.GetNumberOfStrings())
            if domain.GetString(i) != "None"]


def test_arrays_that_are_offered():
    """Arrays of ids and flags are not offered."""
    arrays = {"ball": BALL, "id": labels(N), "vtkOriginalCellIds": labels(N), "number": labels(N),
              "vtkGhostType": 0 * BALL.astype(np.uint8), "velocity": STATE["velocity"]}
    for data in (image(arrays), at_points(image(arrays))):
        attributes = (data.GetCellData() if data.GetCellData().GetNumberOfArrays()
                      else data.GetPointData())
        attributes.SetPedigreeIds(attributes.GetArray("number"))
        for name in ("VolumeFractionArrays", "MaterialIdArray", "RefinementArray"):
            assert offered(data, name) == ["ball", "id"], (name, offered(data, name))
        assert offered(data, "StateArrays") == ["ball", "id", "velocity"]
    grid = rectilinear({"ball": BALL}, [np.arange(N + 1.0)] * 3)
    add_array(grid.GetPointData(), "nodal", np.zeros((N + 1,) * 3))
    assert offered(grid, "VolumeFractionArrays") == ["ball"]  # its points are not cell centres
    assert offered(split({"ball": BALL}, 1), "VolumeFractionArrays") == ["ball"]


def test_a_single_array_is_chosen():
    """A single array of fractions or labels is selected by default."""
    cases = [({"ball": BALL}, ["ball"], "None"), ({"id": labels(N)}, [], "id"),
             (FIELDS, [], "None"),
             ({"ball": BALL, "density": 1000 * BALL}, ["ball"], "None"),
             ({"density": 1000 * BALL}, [], "None"),
             ({"ball": BALL, "id": labels(N)}, [], "None"),
             ({"mask": 255 * labels(N).clip(0, 1).astype(np.uint8)}, ["mask"], "None"),
             ({"mask": labels(N).clip(0, 1).astype(np.uint8)}, [], "mask"),
             ({"tissue": labels(N).astype(np.uint8), "void": 1 - BALL}, [], "tissue"),
             ({"vf_ball": BALL, "id": labels(N), "damage": BALL}, ["vf_ball"], "None"),
             ({"phi": BALL - 0.5}, [], "None"),
             ({"ball": BALL, "vtkGhostType": np.zeros((N, N, N), np.uint8)}, ["ball"], "None")]
    for arrays, fractions, ids in cases:
        for data in (image(arrays), at_points(image(arrays))):
            for make in (VolumeFractionToHex, VolumeFractionToTet):
                assert chosen_by_default(data, make) == (fractions,
                                                         ids), (list(arrays), chosen_by_default(
                                                             data, make))
        # The filter itself selects it if no array is selected.
        result = run(image(arrays), VolumeFractionArrays=[])
        if fractions or ids != "None":
            chosen = {"MaterialIdArray": ids} if ids != "None" else {
                "VolumeFractionArrays": fractions}
            assert not result.errors and digest(result) == digest(mesh_of(image(arrays), **chosen))
        else:
            assert len(result.errors) == 1 and "No array is chosen" in result.errors[0]


def test_what_is_chosen_counts():
    """An explicit choice replaces the default."""
    hexes = VolumeFractionToHex(Input=producer(image({"ball": np.round(BALL)})))
    hexes.MaterialIdArray = "ball"
    hexes.UpdatePipeline()
    expected = mesh_of(image({"ball": np.round(BALL)}), MaterialIdArray="ball")
    assert hexes.GetDataInformation().GetNumberOfCells() == expected.mesh.GetNumberOfCells()
    assert hexes.GetClientSideObject().GetOutputDataObject(0).GetFieldData().GetAbstractArray(
        "MaterialNames").GetValue(0) == "Material 1"
    hexes = VolumeFractionToHex(Input=producer(image({"id": labels(N).clip(0, 1)})))
    hexes.VolumeFractionArrays = ["id"]
    hexes.UpdatePipeline()
    assert hexes.GetClientSideObject().GetOutputDataObject(0).GetFieldData().GetAbstractArray(
        "MaterialNames").GetValue(0) == "id"


main(globals())
