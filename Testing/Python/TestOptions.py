"""Names, defaults and effect of every property."""
import numpy as np
from paraview.simple import Wavelet

from vfmtest import (
    SPACING, ball_and_plate, digest, fraction_image, image, labels, main, mesh_of, producer, run,
    VolumeFractionToHex)

N = 12
DEFAULTS = {
    "VolumeFractionArrays": [], "MaterialIdArray": "None", "IsoValue": 0.5, "MeshVoid": 0, "StairStep": 0,
    "Smoothing": "Quadric Surface", "TargetScaledJacobian": 0.0, "ConserveVolume": 1, "ComputeQuality": 1,
    "NumberOfThreads": 0}
DATA = fraction_image(N)
REFERENCE = mesh_of(DATA)


def total_volume(result):
    return sum(result.field("MeshVolume"))


def test_names_and_defaults():
    for source in (producer(fraction_image(4)), Wavelet()):
        hexes = VolumeFractionToHex(Input=source)
        assert set(hexes.ListProperties()) == {"Input"} | set(DEFAULTS)
        for name, value in DEFAULTS.items():
            assert getattr(hexes, name) == value, (name, getattr(hexes, name))


def test_output_ports_have_names():
    hexes = VolumeFractionToHex(Input=producer(DATA), VolumeFractionArrays=["ball", "plate"])
    hexes.UpdatePipeline()
    cells = [hexes[name].GetDataInformation().GetNumberOfCells() for name in ("Mesh", "Surfaces")]
    assert cells == [REFERENCE.mesh.GetNumberOfCells(), REFERENCE.surfaces.GetNumberOfCells()]


def test_order_of_the_arrays_numbers_the_materials():
    swapped = mesh_of(DATA, VolumeFractionArrays=["plate", "ball"])
    assert swapped.field("MaterialNames") == ["plate", "ball"]
    assert swapped.field("TargetVolume") == REFERENCE.field("TargetVolume")[::-1]
    assert mesh_of(DATA, VolumeFractionArrays=["ball"]).field("MaterialNames") == ["ball"]


def test_stair_step():
    result = mesh_of(image({"id": labels(N)}), MaterialIdArray="id", StairStep=1)
    cells = labels(N)
    assert result.mesh.GetNumberOfCells() == (cells > 0).sum()
    assert np.all(result.cells("ScaledJacobian") > 0.999999)
    volume = (cells > 0).sum() * np.prod(SPACING)
    assert abs(total_volume(result) - volume) < 1e-9 * volume


def test_mesh_void():
    result = mesh_of(DATA, MeshVoid=1)
    assert set(result.cells("MaterialId")) == {0, 1, 2}
    assert result.field("MaterialNames") == ["Void", "ball", "plate"]
    assert result.field("MaterialIds") == [0, 1, 2]
    whole = N ** 3 * np.prod(SPACING)
    assert abs(total_volume(result) - whole) < 1e-9 * whole
    assert abs(sum(result.field("TargetVolume")) - whole) < 1e-9 * whole


def test_iso_value():
    low, high = mesh_of(DATA, IsoValue=0.1, StairStep=1), mesh_of(DATA, IsoValue=0.9, StairStep=1)
    assert total_volume(low) > total_volume(mesh_of(DATA, StairStep=1)) > total_volume(high)


def test_smoothing():
    off = mesh_of(DATA, Smoothing="Off")
    facets = mesh_of(DATA, Smoothing="Geometry Based")
    assert len({digest(result) for result in (off, facets, REFERENCE)}) == 3
    for result in (off, facets):
        assert result.mesh.GetNumberOfCells() == REFERENCE.mesh.GetNumberOfCells()
        assert result.cells("ScaledJacobian").min() > 0
    assert REFERENCE.cells("ScaledJacobian").mean() > off.cells("ScaledJacobian").mean()


def test_target_scaled_jacobian():
    low, high = mesh_of(DATA, TargetScaledJacobian=0.2), mesh_of(DATA, TargetScaledJacobian=0.8)
    assert high.cells("ScaledJacobian").min() > low.cells("ScaledJacobian").min()


def test_conserve_volume():
    def error(result):
        pairs = zip(result.field("MeshVolume"), result.field("TargetVolume"))
        return max(abs(mesh - target) / target for mesh, target in pairs)
    free = mesh_of(DATA, ConserveVolume=0)
    assert error(REFERENCE) < 1e-3 < error(free) < 0.1


def test_compute_quality():
    result = mesh_of(DATA, ComputeQuality=0)
    assert not result.mesh.GetCellData().HasArray("ScaledJacobian")
    assert not result.mesh.GetFieldData().HasArray("MinimumScaledJacobian")
    points = result.mesh.GetPoints().GetData()
    assert digest(mesh_of(DATA, ComputeQuality=1)) == digest(REFERENCE)
    assert points.GetNumberOfTuples() == REFERENCE.mesh.GetNumberOfPoints()


def test_number_of_threads_does_not_change_the_mesh():
    for threads in (1, 2, 3, 8):
        assert digest(mesh_of(DATA, NumberOfThreads=threads)) == digest(REFERENCE), threads


def test_one_material():
    result = mesh_of(image({"ball": ball_and_plate(N)[0]}), VolumeFractionArrays=["ball"])
    assert set(result.cells("MaterialId")) == {1}
    assert set(result.cells("FragmentId")) == {1}


def test_unknown_smoothing_is_refused():
    try:
        run(DATA, Smoothing="Smooth")
    except ValueError:
        return
    raise AssertionError("no error")


main(globals())
