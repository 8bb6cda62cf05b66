"""Contents that Exodus files of a mesh in memory must have."""
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from exodus_dump import join
from mesh_sets import array, elements_of, find_sets, material_names


def columns(attributes):
    """Returns the variables of the arrays as in a file: vectors as X, Y, Z; without ids."""
    result = {}
    for i in range(attributes.GetNumberOfArrays()):
        name, values = attributes.GetArrayName(i), vtk_to_numpy(attributes.GetArray(i)).astype(
            float)
        if not name.startswith("Global"):
            result.update({name: values} if values.ndim == 1
                          else {name + "_" + axis: values[:, a] for a, axis in enumerate("XYZ")})
    return np.array([result[name] for name in sorted(result)]).T.tolist()


def expected(mesh):
    """Returns the result of join() for a mesh in memory, without global variables."""
    ids = array(mesh.GetPointData(), "GlobalPointIds")
    materials, names = array(mesh.GetCellData(), "MaterialId"), material_names(mesh)
    void = max(max(names), materials.max()) + 1
    block_of = lambda material: int(material) or int(void)
    sides, nodes = find_sets(mesh)
    points = vtk_to_numpy(mesh.GetPoints().GetData()).tolist()
    cells = zip(array(mesh.GetCellData(), "GlobalCellIds").tolist(), materials,
                ids[elements_of(mesh)].tolist(), columns(mesh.GetCellData()))
    return {"blocks": {block_of(m): names[m] for m in set(materials.tolist())}, "sides": sides,
            "node sets": nodes,
            "nodes": {i: (*p, *v)
                      for i, p, v in zip(ids.tolist(), points, columns(mesh.GetPointData()))},
            "elements": {i: (block_of(m), tuple(c), *v) for i, m, c, v in cells}}


def check(dumps, mesh, wanted=None):
    """Checks that the files hold the mesh; `wanted`: expected(mesh), if already known."""
    found, wanted = join(dumps), wanted or expected(mesh)
    for part, items in wanted.items():
        assert found[part] == items, (part, len(found[part]), len(items))
    field = mesh.GetFieldData()
    for name in ("MinimumScaledJacobian", "NumberOfFragments"):
        assert found["globals"][name] == field.GetArray(name).GetTuple1(0)
    for dump in dumps:
        assert dump.get("qa_records")[0] == "VolumeFractionMesh"
        assert dump.sizes["time_step"] == 1 and dump.attributes["connect1:elem_type"] == (
            "HEX8" if mesh.GetCellType(0) == 12 else "TETRA")
