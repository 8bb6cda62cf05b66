"""Side sets and node sets of a mesh, found by brute force."""
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from vfmtest import HEX_FACES, TET_FACES

FIRST_OF_UNIONS = 7  # id after those of the sides of the domain
AXES = [axis + end for axis in "xyz" for end in ("_min", "_max")]


def array(attributes, name):
    return vtk_to_numpy(attributes.GetArray(name))


def elements_of(mesh):
    return vtk_to_numpy(mesh.GetCells().GetConnectivityArray()).reshape(mesh.GetNumberOfCells(), -1)


def material_names(mesh):
    """Returns {id: name}; id 0 is the void."""
    field = mesh.GetFieldData()
    names, ids = field.GetAbstractArray("MaterialNames"), field.GetArray("MaterialIds")
    return {0: "Void",
            **{int(ids.GetTuple1(i)): names.GetValue(i) for i in range(names.GetNumberOfValues())}}


def on_sides(mesh):
    """Returns for each point whether it lies on each of the six sides of the domain."""
    points, bounds = vtk_to_numpy(mesh.GetPoints().GetData()), array(
        mesh.GetFieldData(), "DomainBounds")
    return np.stack([points[:, side // 2] == bounds[side] for side in range(6)], axis=1)


def find_sets(mesh):
    """Returns the side sets and the node sets of a whole mesh.

    Side sets: {(id, name): set of (element id, sorted
    point ids)}; node sets: {(id, name): set of point ids}.
    """
    cells, ids = elements_of(mesh), array(mesh.GetPointData(), "GlobalPointIds")
    table = HEX_FACES if cells.shape[1] == 8 else TET_FACES
    materials, names = array(mesh.GetCellData(), "MaterialId").tolist(), material_names(mesh)
    cell_ids, sides = array(mesh.GetCellData(), "GlobalCellIds").tolist(), on_sides(mesh)
    void = max(max(materials), max(names)) + 1
    owners = {}
    for element, cell in enumerate(cells):
        for face in cell[table]:
            owners.setdefault(tuple(sorted(ids[face].tolist())), []).append((element, face))
    side_sets, interfaces, skins = {}, set(), {}
    for points, at in owners.items():
        for element, face in at:
            behind = [materials[other] for other, _ in at if other != element]
            if behind == [materials[element]]:
                continue
            skins.setdefault(materials[element], set()).add((cell_ids[element], points))
            if behind and (behind[0] or void) > (materials[element] or void):
                interfaces.add((cell_ids[element], points))
            full = np.flatnonzero(sides[face].all(axis=0))
            if not behind and len(full):
                key = (int(full[0]) + 1, AXES[full[0]])
            else:
                one, other = materials[element], (behind or [0])[0]
                key = ((one or void) * 1000 + other, "%s_to_%s" % (names[one], names[other]))
            side_sets.setdefault(key, set()).add((cell_ids[element], points))
    unions = [("interfaces", interfaces)] if interfaces else []
    unions += [(names[material] + "_skin", skins[material]) for material in sorted(skins)]
    side_sets.update(((FIRST_OF_UNIONS + i, name), sides)
                     for i, (name, sides) in enumerate(unions))
    node_sets = {(s + 1, AXES[s]): set(ids[sides[:, s]].tolist()) for s in range(6)
                 if sides[:, s].any()}
    return side_sets, node_sets
