"""The same field gives a bitwise identical mesh, in each form of input."""
import random

import numpy as np
from vtkmodules.vtkCommonCore import vtkBitArray
from vtkmodules.vtkCommonDataModel import (
    vtkImageData, vtkMultiBlockDataSet, vtkNonOverlappingAMR, vtkOverlappingAMR, vtkAMRBox,
    vtkPartitionedDataSet, vtkPartitionedDataSetCollection, vtkUniformGrid)

from amr_cases import set_boxes
from vfmtest import (
    GHOST, HIDDEN, ORIGIN, SPACING, add_array, ball_and_plate, digest, fraction_image, image,
    labels, main, mesh_of, rectilinear, run)

N = 12


def uniform_coordinates():
    return [ORIGIN[a] + SPACING[a] * np.arange(N + 1.0) for a in range(3)]


def uneven_coordinates():
    return [np.cumsum(1 + 0.5 * np.sin(np.arange(N + 1) + a)) for a in range(3)]


def block_ranges(ghosts):
    """Yields (own box, box with ghosts) of eight boxes that tile the grid unevenly.

    Ghost layers end at the boundary of the grid.
    """
    cuts = [(0, 5, N), (0, 7, N), (0, 4, N)]  # z, y, x
    for c in np.ndindex(2, 2, 2):
        kept = [(cuts[a][c[a]], cuts[a][c[a] + 1]) for a in range(3)]
        yield kept, [(max(lo - ghosts, 0), min(hi + ghosts, N)) for lo, hi in kept]


def cut(values, box):
    return values[tuple(slice(lo, hi) for lo, hi in box)]


def split(arrays, ghosts, make):
    """Makes eight blocks by make(arrays, box), in random order.

    Ghost cells are marked and hold invalid values.
    """
    blocks = []
    for kept, box in block_ranges(ghosts):
        own = np.zeros((N, N, N), bool)
        own[tuple(slice(lo, hi) for lo, hi in kept)] = True
        ghost = ~cut(own, box)
        parts = {}
        for name, values in arrays.items():
            parts[name] = cut(values, box).copy()
            parts[name][ghost] = np.nan
        block = make(parts, box)
        add_array(block.GetCellData(), "vtkGhostType", np.where(ghost, GHOST, 0), np.uint8)
        blocks.append(block)
    random.Random(7).shuffle(blocks)
    return blocks


def extent_block(parts, box):
    return image(parts, first=[lo for lo, hi in box[::-1]])


def restarted_block(parts, box):
    """Makes an image with its own origin, whose extent starts at 0."""
    data = image(parts)
    data.SetOrigin([ORIGIN[a] + SPACING[a] * box[2 - a][0] for a in range(3)])
    return data


def arrays():
    ball, plate = ball_and_plate(N)
    return {"ball": ball, "plate": plate}


def multiblock(blocks):
    """Makes a nested multi-block with an empty leaf."""
    inner, outer = vtkMultiBlockDataSet(), vtkMultiBlockDataSet()
    for i, block in enumerate(blocks[:3]):
        inner.SetBlock(i, block)
    inner.SetBlock(3, vtkImageData())
    outer.SetBlock(1, inner)
    for i, block in enumerate(blocks[3:]):
        outer.SetBlock(3 + i, block)
    return outer


REFERENCE = digest(mesh_of(fraction_image(N)))


def test_uniform_grid():
    assert digest(mesh_of(image(arrays(), kind=vtkUniformGrid))) == REFERENCE


def test_rectilinear_grid_of_equal_cells():
    assert digest(mesh_of(rectilinear(arrays(), uniform_coordinates()))) == REFERENCE


def test_extent_that_does_not_start_at_zero():
    data = image(arrays(), first=(-3, 5, 100))
    data.SetOrigin([ORIGIN[a] - SPACING[a] * (-3, 5, 100)[a] for a in range(3)])
    assert digest(mesh_of(data)) == REFERENCE


def test_blocks_with_ghosts_in_a_multiblock():
    for ghosts in (0, 1, 2):
        for make in (extent_block, restarted_block):
            data = multiblock(split(arrays(), ghosts, make))
            assert digest(mesh_of(data)) == REFERENCE, (ghosts, make)


def test_blocks_of_mixed_kinds():
    blocks = split(arrays(), 1, restarted_block)
    blocks[0] = split(arrays(), 1, extent_block)[0]
    coordinates = uniform_coordinates()
    blocks[5] = split(arrays(), 1, lambda parts, box: rectilinear(
        parts, [coordinates[a][box[2 - a][0]:box[2 - a][1] + 1] for a in range(3)]))[5]
    assert digest(mesh_of(multiblock(blocks))) == REFERENCE


def test_partitioned_data_sets():
    blocks = split(arrays(), 1, extent_block)
    single = vtkPartitionedDataSet()
    for i, block in enumerate(blocks):
        single.SetPartition(i, block)
    assert digest(mesh_of(single)) == REFERENCE
    collection = vtkPartitionedDataSetCollection()
    for i, block in enumerate(blocks):
        collection.SetPartition(i % 3, i // 3, block)
    assert digest(mesh_of(collection)) == REFERENCE


def test_uneven_rectilinear_blocks():
    coordinates = uneven_coordinates()
    whole = digest(mesh_of(rectilinear(arrays(), coordinates)))
    assert whole != REFERENCE
    make = lambda parts, box: rectilinear(
        parts, [coordinates[a][box[2 - a][0]:box[2 - a][1] + 1] for a in range(3)])
    assert digest(mesh_of(multiblock(split(arrays(), 2, make)))) == whole


def test_inexact_origins_of_blocks():
    """Nodes of two blocks that differ by rounding are merged."""
    def make(parts, box):
        data = image(parts)
        data.SetSpacing(0.1, 0.1, 0.1)
        data.SetOrigin([0.1 * box[2 - a][0] + 1e-9 * box[a][0] for a in range(3)])
        return data
    whole = image(arrays())
    whole.SetSpacing(0.1, 0.1, 0.1)
    whole.SetOrigin(0, 0, 0)
    result = mesh_of(multiblock(split(arrays(), 1, make)))
    assert result.mesh.GetNumberOfPoints() == mesh_of(whole).mesh.GetNumberOfPoints()


def test_amr_of_one_level():
    flat = vtkNonOverlappingAMR()
    set_boxes(flat, [1])
    flat.SetDataSet(0, 0, image(arrays(), kind=vtkUniformGrid))
    assert digest(mesh_of(flat)) == REFERENCE
    over = vtkOverlappingAMR()
    set_boxes(over, [1])
    over.SetOrigin(ORIGIN)
    over.SetGridDescription(8)  # VTK_XYZ_GRID
    over.SetSpacing(0, SPACING)
    over.SetAMRBox(0, 0, vtkAMRBox((0, 0, 0), (N - 1, N - 1, N - 1)))
    over.SetDataSet(0, 0, image(arrays(), kind=vtkUniformGrid))
    assert digest(mesh_of(over)) == REFERENCE


def test_types_of_fractions():
    ball, plate = ball_and_plate(N)
    single = {"ball": ball.astype(np.float32), "plate": plate.astype(np.float32)}
    double = {name: values.astype(np.float64) for name, values in single.items()}
    assert digest(mesh_of(image(single))) == digest(mesh_of(image(double)))
    assert digest(mesh_of(image({"ball": single["ball"], "plate": double["plate"]}))) == REFERENCE
    bytes_ = {"ball": np.floor(255 * ball).astype(np.uint8),
              "plate": np.floor(255 * plate).astype(np.uint8)}
    reals = {name: values / 255.0 for name, values in bytes_.items()}
    assert digest(mesh_of(image(bytes_))) == digest(mesh_of(image(reals)))


def half_and_half(value):
    """Returns two materials of type unsigned char with this value each in eight shared cells."""
    shared = np.s_[5:7, 5:7, 5:7]
    values = {"ball": np.full((N, N, N), 255, np.uint8), "plate": np.zeros((N, N, N), np.uint8)}
    for name in values:
        values[name][shared] = value
    return values


def test_rounded_bytes_may_sum_over_one():
    """Fractions as bytes may exceed a sum of 1 by the rounding of the materials in the cell."""
    result = mesh_of(image(half_and_half(128)))  # 256 / 255: both bytes were rounded up by a half
    assert result.field("NormalisedCells") == [0], result.warnings
    # All cells of 'plate' are shared; it gets them as a thin part.
    assert not result.warnings and result.field("ThinPartCells") == [8], result.warnings
    assert np.allclose(result.field("VolumeError"), 0, atol=1e-6)
    without = mesh_of(image(half_and_half(128)), ThinParts=0)
    assert len(without.warnings) == 1 and "'plate' (id 2)" in without.warnings[0], without.warnings
    cell = np.prod(SPACING)
    assert np.allclose(result.field("TargetVolume"), [(N ** 3 - 4) * cell, 4 * cell], rtol=1e-12)
    reals = {name: values / 255.0 for name, values in half_and_half(128).items()}
    for data, text in ((half_and_half(129), "sum to 1.01176"), (reals, "sum to 1.00392")):
        errors = run(image(data)).errors
        assert len(errors) == 1 and "cell (5, 5, 5) " + text in errors[0], errors
    empty = {name: np.zeros((N, N, N), np.uint8) for name in ("third", "fourth")}
    four = {**half_and_half(128), **empty}
    # 257 / 255 exceeds the rounding of the two materials in the cell; four are selected.
    four["ball"][5, 5, 5] = 129
    result = mesh_of(image(four), VolumeFractionArrays=list(four))
    assert result.field("NormalisedCells") == [1]
    assert sum("1 cells sum to slightly more than 1" in text
               for text in result.warnings) == 1, result.warnings


def test_types_of_labels():
    reference = digest(mesh_of(image({"id": labels(N).astype(np.int32)}), MaterialIdArray="id"))
    for dtype in (np.int8, np.uint8, np.int16, np.uint16, np.uint32, np.int64, np.uint64):
        result = mesh_of(image({"id": labels(N).astype(dtype)}), MaterialIdArray="id")
        assert digest(result) == reference, dtype
    whole = {"ball": (labels(N) == 1).astype(np.int32), "plate": (labels(N) == 2).astype(float)}
    assert digest(mesh_of(image(whole))) == reference


def test_arrays_that_are_not_plain_memory():
    inside = labels(N).ravel() == 1
    bits = vtkBitArray()
    bits.SetName("bits")
    for value in inside:
        bits.InsertNextValue(int(value))
    data = image({"whole": inside.reshape(N, N, N).astype(np.float64),
                  "id": inside.reshape(N, N, N).astype(np.int32)})
    data.GetCellData().AddArray(bits)
    reference = digest(mesh_of(data, MaterialIdArray="id"))
    assert digest(mesh_of(data, MaterialIdArray="bits")) == reference
    assert digest(mesh_of(data, VolumeFractionArrays=["whole"])) == reference
    assert digest(mesh_of(data, VolumeFractionArrays=["bits"])) == reference


def test_labels_are_kept():
    renamed = np.array([0, 70, 8])[labels(N)]  # changes the order of the labels
    result = mesh_of(image({"id": renamed}), MaterialIdArray="id", MeshVoid=1)
    assert set(result.cells("MaterialId")) == {0, 8, 70}
    assert result.field("MaterialIds") == [0, 8, 70]
    assert result.field("MaterialNames") == ["Void", "Material 8", "Material 70"]
    pairs = result.surfaces.GetCellData().GetArray("MaterialPair")
    seen = {pairs.GetTuple(i) for i in range(pairs.GetNumberOfTuples())}
    assert {value for pair in seen for value in pair} == {0, 8, 70}, seen
    volume = dict(zip(result.field("MaterialIds"), result.field("TargetVolume")))
    assert abs(volume[70] - (renamed == 70).sum() * np.prod(SPACING)) < 1e-8


def test_labels_in_blocks_with_ghosts():
    whole = {"id": labels(N).astype(float)}
    blocks = split(whole, 1, extent_block)
    for block in blocks:
        ids = block.GetCellData().GetArray("id")
        values = np.array([ids.GetValue(i) for i in range(ids.GetNumberOfTuples())])
        add_array(block.GetCellData(), "id", np.where(np.isnan(values), -5, values), np.int32)
    reference = digest(mesh_of(image({"id": labels(N)}), MaterialIdArray="id"))
    assert digest(mesh_of(multiblock(blocks), MaterialIdArray="id")) == reference


def test_blanked_cells_are_void():
    hidden = np.zeros((N, N, N), np.uint8)
    hidden[:, :, : N // 2] = HIDDEN
    data = image({"ball": ball_and_plate(N)[0], "plate": ball_and_plate(N)[1],
                  "vtkGhostType": hidden})
    keep = hidden == 0
    expected = image({name: np.where(keep, values, 0) for name, values in arrays().items()})
    assert digest(mesh_of(data)) == digest(mesh_of(expected))
    ids = image({"id": labels(N), "vtkGhostType": hidden})
    cleared = image({"id": np.where(keep, labels(N), 0)})
    assert digest(mesh_of(ids,
                          MaterialIdArray="id")) == digest(mesh_of(cleared, MaterialIdArray="id"))


main(globals())
