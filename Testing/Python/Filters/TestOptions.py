"""Name, default and effect of each property."""
import numpy as np

from vfmtest import (
    ORIGIN, SPACING, ball_and_plate, box_along_axes, check_error, check_surfaces, digest,
    fraction_image, image, labels, list_defaults, main, mesh_of, OF_PANEL, points_of, producer, run,
    simple, uniform, VolumeFractionToHex, VolumeFractionToTet)

N = 12
DATA = fraction_image(N)
REFERENCE = mesh_of(DATA)


def total_volume(result):
    return sum(result.field("MeshVolume"))


def volume_error(result):
    pairs = zip(result.field("MeshVolume"), result.field("TargetVolume"))
    return max(abs(mesh - target) / target for mesh, target in pairs)


def film(thickness, n=12, s=8):
    """Returns fractions of an oblique film; the thickness is in cells."""
    z, y, x = np.meshgrid(*[(np.arange(n * s) + 0.5) / s - n / 2] * 3, indexing="ij")
    inside = np.abs((x + 2 * y + 3 * z) / 14 ** 0.5 - 0.1) < thickness / 2
    return image({"film": inside.reshape(n, s, n, s, n, s).mean(axis=(1, 3, 5))})


def mesh_of_film(thickness, refinement, thin_parts):
    return mesh_of(film(thickness), VolumeFractionArrays=["film"], ThinParts=thin_parts,
                   **uniform(refinement))


def test_names_and_defaults():
    defaults = list_defaults(of_tets=False)
    for source in (producer(fraction_image(4)), simple.Wavelet()):
        hexes = VolumeFractionToHex(Input=source)
        assert set(hexes.ListProperties()) == OF_PANEL | set(defaults)
        for name, value in defaults.items():
            assert getattr(hexes, name) == value, (name, getattr(hexes, name))


def test_levels_by_number_and_word():
    hexes = VolumeFractionToHex(Input=producer(fraction_image(4)))
    for value, word, number in ((2, "2", 2), (-1, "Automatic", -1), (3, "3", 3),
                                ("Automatic", "Automatic", -1)):
        hexes.MaximumLevel = value
        assert hexes.MaximumLevel == word and hexes.SMProxy.GetProperty("MaximumLevel").GetElement(
            0) == number, value


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


def test_refinement():
    refined = mesh_of(DATA, **uniform(1))
    assert 6 < refined.mesh.GetNumberOfCells() / REFERENCE.mesh.GetNumberOfCells() < 9
    assert np.allclose(refined.field("TargetVolume"), REFERENCE.field("TargetVolume"), rtol=1e-9)
    assert volume_error(refined) < 1e-6
    assert refined.cells("ScaledJacobian").min() > 0.4
    check_surfaces(refined)
    assert digest(mesh_of(DATA, **uniform(1), NumberOfThreads=3)) == digest(refined)
    tets = mesh_of(DATA, VolumeFractionToTet, Method="Lattice", **uniform(1))
    assert np.allclose(tets.field("TargetVolume"), REFERENCE.field("TargetVolume"), rtol=1e-9)
    assert tets.cells("ScaledJacobian").min() > 0


def test_refinement_of_labels():
    arrays = {"id": labels(4)}
    cells = mesh_of(image(arrays), MaterialIdArray="id", StairStep=1).mesh.GetNumberOfCells()
    for refinement in (1, 2, 3):
        fine = mesh_of(image(arrays), MaterialIdArray="id", StairStep=1, **uniform(refinement))
        assert fine.mesh.GetNumberOfCells() == 8 ** refinement * cells


def test_refinement_mends_films():
    """A film that breaks at one level is whole with halved cells, or with Thin Parts."""
    torn, whole = mesh_of_film(0.8, 0, 0), mesh_of_film(0.8, 1, 0)
    assert torn.field("NumberOfFragments")[0] > 1
    assert whole.field("NumberOfFragments")[0] == 1 and volume_error(whole) < 1e-6
    # thinner than the halved cells
    assert mesh_of_film(0.4, 1, 0).field("NumberOfFragments")[0] > 1
    assert mesh_of_film(0.4, 2, 0).field("NumberOfFragments")[0] == 1
    for thickness, refinement in ((0.8, 0), (0.4, 1)):
        film_of_cells = mesh_of_film(thickness, refinement, 1)
        assert film_of_cells.field("NumberOfFragments")[0] == 1
        assert volume_error(film_of_cells) < 1e-6


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


def test_sharp_edges():
    """Corners of a box that is not aligned with the grid are kept with sharp edges.

    The fractions of the box are exact.
    """
    low, high = np.array([2.3, 3.6, 2.8]), np.array([9.4, 8.7, 9.1])  # in cells
    box = image({"box": box_along_axes(low, high, N)})
    corners = [np.where([c & 1, c & 2, c & 4], high, low) for c in range(8)]
    for filter, words in ((VolumeFractionToHex, {}), (VolumeFractionToTet, {"Method": "Lattice"}),
                          (VolumeFractionToTet, {"Method": "Cells"})):
        farthest = {}
        for mode in ("Off", "On", "Automatic"):
            points = points_of(mesh_of(box, filter, VolumeFractionArrays=["box"], SharpEdges=mode,
                                       **words))
            places = (points - ORIGIN) / SPACING
            farthest[mode] = max(np.linalg.norm(places - corner, axis=1).min()
                                 for corner in corners)
        assert farthest["On"] == farthest["Automatic"] < 0.2 and farthest["Off"] > 0.6, (
            filter, words, farthest)


def test_target_scaled_jacobian():
    low, high = mesh_of(DATA, TargetScaledJacobian=0.2), mesh_of(DATA, TargetScaledJacobian=0.8)
    assert high.cells("ScaledJacobian").min() > low.cells("ScaledJacobian").min()


def test_conserve_volume():
    free = mesh_of(DATA, ConserveVolume=0)
    assert volume_error(REFERENCE) < 1e-3 < volume_error(free) < 0.1


def test_compute_quality():
    result = mesh_of(DATA, ComputeQuality=0)
    assert not result.mesh.GetCellData().HasArray("ScaledJacobian")
    assert not result.mesh.GetFieldData().HasArray("MinimumScaledJacobian")
    points = result.mesh.GetPoints().GetData()
    assert digest(mesh_of(DATA, ComputeQuality=1)) == digest(REFERENCE)
    assert points.GetNumberOfTuples() == REFERENCE.mesh.GetNumberOfPoints()


def test_layers():
    assert not REFERENCE.mesh.GetCellData().HasArray("Layer")
    layers = mesh_of(DATA, Layers=3, FirstLayer=0.1).cells("Layer")
    count = (layers == 1).sum()
    assert count > 100 and (layers == 2).sum() == (layers == 3).sum() == count
    assert len(layers) == REFERENCE.mesh.GetNumberOfCells() + 2 * count
    one_side = mesh_of(DATA, Layers=2, LayerInterfaces="1/0", LayersOn="First Material")
    materials = one_side.cells("MaterialId")[one_side.cells("Layer") > 0]
    assert set(materials) == {1}
    sides = mesh_of(DATA, Layers=2, LayerInterfaces="1/2", LayerSides="XYZ").cells("Layer")
    assert (sides > 0).sum() > 0
    check_error(DATA, "Layers are for hexahedra", make=VolumeFractionToTet, Layers=2)


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
