"""Meshes that are modified, and the comparison with meshes made with the same options."""
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from vfmtest import (
    VolumeFractionInterfaces, VolumeFractionToHex, VolumeFractionToTet, collect, image, producer)

N = 9
SEEDS = np.random.default_rng(7).uniform(0, N, (7, 3))
CENTRES = np.stack(np.meshgrid(*[np.arange(N) + 0.5] * 3, indexing="ij"), -1)
APART = np.abs(CENTRES[..., None, :] - SEEDS)
# periodic grains; 0 is void
LABELS = (np.minimum(APART, N - APART) ** 2).sum(-1).argmin(-1) * 3
GRAINS = {"labels": LABELS}
SPLIT = {"SplitInterfaces": "all", "SplitConnection": "Cohesive"}
LAYERS = {"Layers": 3, "LayerGrowth": 1.3, "FirstLayer": 0.03}
BOTH = {**LAYERS, "SplitInterfaces": "3/*", "SplitConnection": "Cohesive"}
WALLS = {"Layers": 2, "LayerSides": "XY", "LayerInterfaces": "6/*"}


def make(mesher, labels=None, data=None, **properties):
    if labels is not None:
        data, properties["MaterialIdArray"] = image({"id": labels.astype(np.int32)}), "id"
    if "FirstLayer" in properties:
        properties["FirstLayerUnit"] = "Length"
    return mesher(Input=producer(data), **properties)


def hexes(**properties):
    return make(VolumeFractionToHex, **properties)


def tets(**properties):
    return make(VolumeFractionToTet, **properties)


def modify(mesh, **options):
    return VolumeFractionInterfaces(Input=mesh, **options)


def run(proxy, fails=False):
    """Returns the mesh and the cohesive elements; if it fails, also the errors."""
    algorithm = proxy.GetClientSideObject()
    errors, warnings = collect(algorithm)
    algorithm.Update()
    cohesive = min(algorithm.GetNumberOfOutputPorts() - 1, 5)  # behind it are the particles
    outputs = [algorithm.GetOutputDataObject(port) for port in (0, cohesive)]
    if fails:
        return outputs, errors
    warnings = [text for text in warnings if "is read as void" not in text]  # a note on label 0
    assert not errors and not warnings, (errors, warnings)
    return outputs


def values_of(array):
    if array.GetDataType() == 13:  # VTK_STRING
        return [array.GetValue(i) for i in range(array.GetNumberOfValues())]
    return vtk_to_numpy(array)


def arrays_of(grid):
    """Returns the cell, point and field arrays of a grid, in order."""
    lists = {"cell": grid.GetCellData(), "point": grid.GetPointData(), "field": grid.GetFieldData()}
    return {kind: {data.GetAbstractArray(a).GetName(): values_of(data.GetAbstractArray(a))
                   for a in range(data.GetNumberOfArrays())} for kind, data in lists.items()}


def compare(made, expected):
    """Compares the mesh and the cohesive elements of two runs, bitwise."""
    for one, other in zip(made, expected):
        assert one.GetNumberOfCells() == other.GetNumberOfCells()
        assert one.GetNumberOfPoints() == other.GetNumberOfPoints()
        if other.GetNumberOfCells() == 0:
            continue
        assert one.GetCellType(0) == other.GetCellType(0)
        for values in (lambda g: g.GetPoints().GetData(),
                       lambda g: g.GetCells().GetConnectivityArray()):
            assert np.array_equal(vtk_to_numpy(values(one)), vtk_to_numpy(values(other)))
        arrays, others = arrays_of(one), arrays_of(other)
        for kind in others:
            assert list(arrays[kind]) == list(others[kind]), (arrays[kind], others[kind])
            for name, value in others[kind].items():
                mine = arrays[kind][name]
                assert getattr(mine, "dtype", None) == getattr(value, "dtype", None), name
                assert np.array_equal(mine, value), (kind, name, mine, value)
