"""Input on several levels (AMR): each kind of data set, the data that are used, and errors."""
import numpy as np
from vtkmodules.vtkCommonDataModel import vtkUniformGrid
from vtkmodules.vtkIOXML import vtkXMLUniformGridAMRWriter
from vtkmodules.util.numpy_support import vtk_to_numpy

from amr_cases import (
    N, block_of, collection, cover, cut, doubled, everywhere, fields, means, multiblock, nested,
    non_overlapping, overlapping)
from vfmtest import (
    GHOST, HIDDEN, ORIGIN, SPACING, VolumeFractionToHex, VolumeFractionToTet, add_array,
    check_error, collect, digest, elements, image, in_folder, main, mesh_of, write, simple)

REFINED = 8  # bit of vtkGhostType
FIELDS = fields(2)
UNIFORM = {"Refinement": "Uniform"}


def finest_image(arrays, level=2):
    data = image(arrays)
    data.SetSpacing([h / 2 ** level for h in SPACING])
    return data


def without_number(arrays):
    return {name: arrays[name] for name in ("ball", "plate")}


def leaves():
    """Returns blocks of three levels that do not overlap."""
    covered = lambda box, level: any(
        own == level + 1 and all(2 * a < d and c < 2 * b for (a, b), (c, d) in zip(box, other))
        for own, other in result)
    result = [(2, ((8, 16), (8, 16), (8, 16)))]
    result += [(1, box) for box in cut(2 * N, 6) if all(2 <= a < 10 for a, _ in box)
               and not covered(box, 1)]
    result += [(0, box) for box in cut(N, 6) if not all(1 <= a < 5 for a, _ in box)]
    return result


def volumes(result):
    return np.array(result.field("TargetVolume"))


def test_all_levels_everywhere_are_the_finest_image():
    """Levels that are fine everywhere give the mesh of the finest image."""
    for make in (VolumeFractionToHex, VolumeFractionToTet):
        kind = {"Method": "Lattice"} if make is VolumeFractionToTet else {}
        for levels in (1, 2):
            whole = mesh_of(finest_image(FIELDS[levels], levels), make, StateArrays=["number"],
                            **kind)
            for data in (overlapping(FIELDS, everywhere(levels)),
                         multiblock(FIELDS, everywhere(levels), "rectilinear")):
                assert digest(mesh_of(data, make, StateArrays=["number"], **UNIFORM,
                                      **kind)) == digest(whole)


def test_finest_data_count():
    """Data of coarser blocks below finer ones are ignored, for any vtkGhostType there."""
    reference = digest(mesh_of(overlapping(FIELDS, nested()), **UNIFORM))
    for flag, value in ((0, np.nan), (REFINED, 77), (HIDDEN, 0.5)):
        arrays, flags = [dict(own) for own in FIELDS], []
        for level in range(3):
            below = cover(nested(), 2, level + 1)[::2, ::2,
                                                  ::2] if level < 2 else np.zeros(
                                                      (4 * N,) * 3, bool)
            flags.append({"vtkGhostType": np.where(below, flag, 0).astype(np.uint8)})
            for name in ("ball", "plate"):
                arrays[level][name] = np.where(below, value, arrays[level][name])
        assert digest(mesh_of(overlapping(arrays, nested(), flags), **UNIFORM)) == reference, flag


def test_data_sets_of_every_kind():
    """Each kind of data set gives the same mesh."""
    reference = digest(mesh_of(overlapping(FIELDS, nested()), **UNIFORM))
    for data in (multiblock(FIELDS, nested()), multiblock(FIELDS, nested()[::-1], "rectilinear"),
                 collection(FIELDS, nested())):
        assert digest(mesh_of(data, **UNIFORM)) == reference
    leaf = non_overlapping(FIELDS, leaves())
    assert digest(mesh_of(leaf,
                          **UNIFORM)) == digest(
                              mesh_of(multiblock(FIELDS,
                                                 [(0, ((0, N),) * 3), (1, ((2, 10),) * 3),
                                                  leaves()[0]]), **UNIFORM))


def test_ratio_of_four():
    """A ratio of 4 gives the mesh with a level between."""
    blocks = [(0, ((0, N),) * 3), (2, ((4, 20), (4, 20), (8, 20)))]
    between = (1, ((2, 10), (2, 10), (4, 10)))
    assert digest(mesh_of(overlapping(FIELDS, blocks, ratio=4), **UNIFORM)) == digest(
        mesh_of(overlapping(FIELDS, blocks + [between]), **UNIFORM))


def test_ghost_layers_are_dropped():
    """Ghost layers of blocks are dropped."""
    reference = digest(mesh_of(multiblock(FIELDS, nested(1)), **UNIFORM))
    wide = [(level, tuple((max(a - 1, 0), min(b + 1, N << level)) for a, b in box))
            for level, box in nested(1)]
    data = multiblock(FIELDS, wide)
    for i, (level, box) in enumerate(nested(1)):
        ghost = np.full([b - a for a, b in wide[i][1]], GHOST, np.uint8)
        ghost[tuple(slice(a - c, b - c) for (a, b), (c, _) in zip(box, wide[i][1]))] = 0
        add_array(data.GetBlock(i).GetCellData(), "vtkGhostType", ghost)
    assert digest(mesh_of(data, **UNIFORM)) == reference


def composite_volumes(blocks, levels=2):
    """Returns the volume of each material in the finest data, by numpy."""
    result = np.zeros(2)
    for level in range(levels + 1):
        own = np.zeros((N << level,) * 3, bool)
        for _, box in (block for block in blocks if block[0] == level):
            own[tuple(slice(*span) for span in box)] = True
        if level < levels:
            own &= ~cover(blocks, levels, level + 1)[::2, ::2, ::2]
        result += [FIELDS[level][name][own].sum() / 8 ** level for name in ("ball", "plate")]
    return result


def unit_cubes(blocks):
    """Makes blocks whose cells of level 0 have the width 1."""
    data = multiblock(FIELDS, blocks)
    for i, (level, box) in enumerate(blocks):
        data.GetBlock(i).SetOrigin([span[0] / 2 ** level for span in box[::-1]])
        data.GetBlock(i).SetSpacing([1 / 2 ** level] * 3)
    return data


def test_volumes_are_kept():
    """Averaging to any level and dividing to any level keep the volumes.

    TargetVolume is summed in units of 2^-36. The volumes of these cubes are multiples of the unit;
    volumes from planes are not.
    """
    for blocks in (nested(), leaves()):
        expected = composite_volumes(blocks)
        for properties in ({}, {"Refinement": "Off"},
                           *({**UNIFORM, "MaximumLevel": level} for level in (0, 1, 2, 3)),
                           {"Refinement": "Input Levels", "MaximumLevel": 1}):
            for rule, tolerance in (("Parent", 1e-12), ("Planes", 1e-9)):
                found = volumes(mesh_of(unit_cubes(blocks), StairStep=1, ChildFractions=rule,
                                        **properties))
                assert np.allclose(found, expected, rtol=tolerance,
                                   atol=0), (properties, rule, found - expected)


def test_level_0_is_the_mean():
    """Averaged data give the mesh of the coarse image, because coarse FIELDS are means."""
    for level in (0, 1):
        whole = digest(mesh_of(finest_image(without_number(FIELDS[level]), level)))
        spoilt = [{name: values * (own == 2) for name, values in arrays.items()}
                  for own, arrays in enumerate(FIELDS)]
        data = multiblock([without_number(arrays) for arrays in spoilt], everywhere(2))
        assert digest(mesh_of(data, **UNIFORM, MaximumLevel=level)) == whole
        if level == 0:
            assert digest(mesh_of(data, Refinement="Off")) == whole


def test_children_by_planes_or_as_their_parent():
    """Children take the fractions of their parent or of planes."""
    data = lambda: multiblock(FIELDS, [(0, ((0, N),) * 3)])
    parent = finest_image({name: doubled(FIELDS[0][name]) for name in ("ball", "plate")}, 1)
    assert digest(mesh_of(data(), **UNIFORM, ChildFractions="Parent")) == digest(mesh_of(parent))
    assert digest(mesh_of(data(), **UNIFORM, ChildFractions="Planes")) != digest(mesh_of(parent))


def test_labels():
    """Halved cells keep the label; averaged labels become fractions."""
    labels = [{"id": np.where(arrays["ball"] + arrays["plate"] < 0.5, 0,
                              np.where(arrays["ball"] >= arrays["plate"], 7, 3))}
              for arrays in FIELDS]
    result = mesh_of(multiblock(labels, nested()), MaterialIdArray="id", StairStep=1, **UNIFORM)
    whole = doubled(doubled(labels[0]["id"]))
    for level, box in nested()[8:]:
        window = tuple(slice(a << (2 - level), b << (2 - level)) for a, b in box)
        own = labels[level]["id"] if level == 2 else doubled(labels[level]["id"])
        whole[window] = own[window]
    assert digest(result) == digest(mesh_of(finest_image({"id": whole}), MaterialIdArray="id",
                                            StairStep=1))
    ids = labels[1]["id"]
    data = multiblock(labels, [(0, ((0, N),) * 3), (1, ((0, 2 * N),) * 3)])
    coarse = {"three": means((ids == 3).astype(float)), "seven": means((ids == 7).astype(float))}
    off = mesh_of(data, MaterialIdArray="id", Refinement="Off")
    reference = mesh_of(image(coarse), VolumeFractionArrays=["three", "seven"])
    assert off.field("TargetVolume") == reference.field("TargetVolume")
    assert np.array_equal(vtk_to_numpy(off.mesh.GetPoints().GetData()),
                          vtk_to_numpy(reference.mesh.GetPoints().GetData()))


def test_labels_under_finer_blocks_do_not_count():
    """Invalid labels below finer blocks are ignored."""
    labels = [{"id": np.ones((N << level,) * 3, np.int32)} for level in (0, 1)]
    labels[0]["id"][1:5, 1:5, 1:5] = -5
    result = mesh_of(multiblock(labels, [(0, ((0, N),) * 3), (1, ((2, 10),) * 3)]),
                     MaterialIdArray="id", StairStep=1, **UNIFORM)
    assert result.field("MaterialNames") == ["Material 1"] and result.mesh.GetNumberOfCells() == (
        2 * N) ** 3


def test_state_of_the_finest_data():
    """Elements have the state of the finest data, on any level of the mesh."""
    full = [{"full": np.ones((N << level,) * 3), "number": FIELDS[level]["number"]}
            for level in range(3)]
    for maximum in (0, 1, 2, 3):
        result = mesh_of(multiblock(full, nested()), VolumeFractionArrays=["full"],
                         StateArrays=["number"], StairStep=1, **UNIFORM, MaximumLevel=maximum)
        centres = vtk_to_numpy(result.mesh.GetPoints().GetData())[elements(result)].mean(axis=1)
        assert len(centres) == (N << maximum) ** 3
        expected = np.full(len(centres), -1)
        for level in range(3):
            i, j, k = np.floor((centres - ORIGIN) / SPACING * 2 ** level + 1e-9).astype(int).T
            own = np.zeros((N << level,) * 3, bool)
            for _, box in (block for block in nested() if block[0] == level):
                own[tuple(slice(*span) for span in box)] = True
            expected = np.where(own[k, j, i], FIELDS[level]["number"][k, j, i], expected)
        assert (result.cells("number") == expected).all(), maximum


@in_folder
def test_files(at):
    """A file read only partly gives a warning that names the reader's property."""
    reference = digest(mesh_of(overlapping(FIELDS, nested()), **UNIFORM))
    reader = simple.OpenDataFile(write(overlapping(FIELDS, nested()), at("levels.vthb"),
                                       vtkXMLUniformGridAMRWriter), DefaultNumberOfLevels=1)
    hexes = VolumeFractionToHex(Input=reader, VolumeFractionArrays=["ball", "plate"], **UNIFORM)
    errors, warnings = collect(hexes.GetClientSideObject())
    hexes.UpdatePipeline()
    assert not errors and len(warnings) == 1 and "boxes without data on level 1" in warnings[0], (
        errors, warnings)
    assert "Set Default Number Of Levels of the reader to 0" in warnings[0]
    reader.DefaultNumberOfLevels = 0  # all levels
    hexes.UpdatePipeline()
    assert not errors and len(warnings) == 1, (errors, warnings)
    mesh = hexes.GetClientSideObject().GetOutputDataObject(0)
    data = mesh_of(overlapping(FIELDS, nested()), **UNIFORM)
    assert digest(data) == reference and mesh.GetNumberOfCells() == data.mesh.GetNumberOfCells()
    assert np.array_equal(vtk_to_numpy(mesh.GetPoints().GetData()),
                          vtk_to_numpy(data.mesh.GetPoints().GetData()))


def moved(block, shift):
    """Returns a block whose origin is shifted by fractions of its cell width."""
    data = block_of(FIELDS, block)
    data.SetOrigin([o + s * h for o, s, h in zip(data.GetOrigin(), shift, data.GetSpacing())])
    return data


def with_block(data, number, block):
    data.SetBlock(number, block)
    return data


def test_what_is_refused():
    """Blocks that do not fit or overlap, and gaps, are rejected."""
    blocks = nested()
    good = lambda: multiblock(FIELDS, blocks)
    third = block_of(FIELDS, (1, ((0, 6),) * 3))
    third.SetSpacing([h / 3 for h in SPACING])
    check_error(with_block(good(), 20, third), "Block 12", "must differ by the factor 2, 4, 8")
    flat = block_of(FIELDS, (1, ((0, 6),) * 3))
    flat.SetSpacing([SPACING[0] / 2, SPACING[1] / 2, SPACING[2]])
    check_error(with_block(good(), 20, flat), "Block 12", "the same along x, y and z")
    check_error(with_block(good(), 11, moved(blocks[11], (0.3, 0, 0))),
                "Block 11 does not fit the other blocks along x", "level 2 of a refined grid")
    check_error(with_block(good(), 11, moved(blocks[11], (0, 1, 0))),
                "Finer blocks cover only a part of cell (", "of level 1")
    check_error(with_block(good(), 10, moved(blocks[10], (0, 8, 0))), "leave a gap")
    check_error(multiblock(FIELDS, blocks[1:]), "leave a gap", "cell (0, 0, 0) of level 0")
    check_error(multiblock(FIELDS, blocks + blocks[-1:]), "Block 11 and Block 12 overlap")
    check_error(multiblock(FIELDS, [(0, ((0, N),) * 3), (1, ((2, 5), (2, 6), (2, 6)))]),
                "Finer blocks cover only a part of cell (1, 1, 2)")


def test_arrays_that_are_missing():
    blocks = [(0, ((0, N),) * 3), (1, ((2, 6),) * 3)]
    less = [FIELDS[0], {"ball": FIELDS[1]["ball"], "disc": FIELDS[1]["plate"]}]
    check_error(multiblock(less, blocks), "Block 1 has no numeric cell array 'plate'",
                "'ball', 'disc'")
    check_error(multiblock([less[1] and {"id": np.ones((N,) * 3, np.int32)}, less[1]], blocks),
                "Block 1 has no numeric cell array 'id'", MaterialIdArray="id")
    check_error(multiblock(less, blocks), "has no numeric cell array 'number'",
                VolumeFractionArrays=["ball"], StateArrays=["number"])


def test_coarsen_says_what_limits_it():
    """A warning names the number of cells that limits coarsening."""
    data = image({"ball": np.ones((8, 12, 8))})
    mesh_of(data, VolumeFractionArrays=["ball"], Refinement="Coarsen", MaximumLevel=2)
    result = mesh_of(data, VolumeFractionArrays=["ball"], Refinement="Coarsen", MaximumLevel=3)
    assert len(result.warnings) == 1 and "12 cells along y" in result.warnings[
        0] and "2 levels" in result.warnings[0], result.warnings
    assert not mesh_of(data, VolumeFractionArrays=["ball"], Refinement="Coarsen").warnings


main(globals())
