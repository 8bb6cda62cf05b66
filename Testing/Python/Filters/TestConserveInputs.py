"""Conserved state from each kind of input, to meshes finer and coarser than the input."""
import os

import numpy as np
from paraview import simple
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet

import amr_cases
from conserve_cases import (
    ARRAYS, CELLS, CONSERVE, DATA, FRACTIONS, MAKES, N, VOLUME, added, cells_of, check_balance,
    check_energy, close, conserved, state, volumes_of)
from exodus_grids import hexes, shuffled
from spyplot import split, write_spyplot
from vfmtest import (
    GHOST, HIDDEN, ORIGIN, SPACING, Result, at_points, collect, image, in_folder, labels, main,
    rectilinear, run, uniform, VolumeFractionToHex)

BALL, PLATE = FRACTIONS[1], FRACTIONS[2]
IMPACT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..", "Data",
                      "impact.spcth")


def test_finer_meshes():
    for kind in MAKES[:2]:
        for properties in (uniform(1), {"Refinement": "Coarsen", "MaximumLevel": 1},
                           {"Refinement": "Automatic", "MaximumLevel": 1},
                           {**uniform(1), "ChildFractions": "Parent"}):
            check_balance(conserved(**properties, **kind), CELLS)


def test_long_cells():
    for kind in MAKES[:2]:
        result = conserved(MaximumAspectRatio=1.5, **kind)
        assert result.mesh.GetNumberOfCells() > conserved(**kind).mesh.GetNumberOfCells()
        check_balance(result, CELLS)


def test_graded_grids():
    nodes = [np.concatenate([[0], np.cumsum(0.25 + 0.1 * np.sin(np.arange(N) + a))])
             for a in range(3)]
    volume = np.einsum("k,j,i->kji", *(np.diff(x) for x in nodes[::-1]))
    cells = cells_of(FRACTIONS, ARRAYS, volume)
    for kind in MAKES:
        check_balance(conserved(rectilinear({"ball": BALL, "plate": PLATE, **ARRAYS}, nodes),
                                **kind), cells)


def test_labels():
    ids = labels(N)
    data = image({"id": ids, **ARRAYS})
    cells = cells_of({label: (ids == label).astype(float) for label in (1, 2)}, ARRAYS, VOLUME)
    for kind in MAKES:
        for smoothing in (0, 3):
            check_balance(conserved(data, MaterialIdArray="id", LabelSmoothing=smoothing, **kind),
                          cells)


def amr(levels=2):
    """Returns AMR data with state, their blocks, and the totals over the finest cells.

    Data below finer blocks are invalid.
    """
    fields, blocks = amr_cases.fields(levels), amr_cases.nested(levels)
    parts = []
    for level, arrays in enumerate(fields):
        shape = arrays["ball"].shape
        arrays.update(state(shape, seed=level))
        own = amr_cases.cover([block for block in blocks if block[0] == level], levels, level)
        if level < levels:
            own &= ~amr_cases.cover([block for block in blocks if block[0] > level], levels, level)
            arrays["density"] = np.where(own, arrays["density"], np.nan)
        parts.append(cells_of(
            {0: (1 - arrays["ball"] - arrays["plate"])[own], 1: arrays["ball"][own],
             2: arrays["plate"][own]},
            {name: values[own] for name, values in arrays.items()},
            np.prod(amr_cases.spacing(level))))
    return fields, blocks, added(parts)


def test_levels():
    """State on several levels is conserved; data finer than the mesh are summed."""
    fields, blocks, cells = amr()
    check_balance(conserved(amr_cases.overlapping(fields, blocks)), cells)
    data = amr_cases.multiblock(fields, blocks[::-1])
    for properties in ({"MeshVoid": 1}, {"FineInterfaces": 0}, {"Refinement": "Off"},
                       {"Refinement": "Input Levels", "MaximumLevel": 1},
                       {"ChildFractions": "Parent"}, {"Refinement": "Coarsen"}):
        check_balance(conserved(data, **properties), cells)
    for properties in ({}, {"Refinement": "Off"}):
        check_balance(conserved(data, **properties, **MAKES[-1]), cells)


def test_finer_than_all_levels():
    fields, blocks, cells = amr(1)
    check_balance(conserved(amr_cases.multiblock(fields, blocks), **uniform(2)), cells)


def test_fine_cells_are_averaged():
    """With StairStep, an element holds the state of its eight fine cells."""
    fields, blocks, _ = amr(1)
    blocks = amr_cases.everywhere(1)
    fields[1].update(state(fields[1]["ball"].shape, seed=1), ball=np.ones_like(fields[1]["ball"]),
                     plate=np.zeros_like(fields[1]["ball"]))
    result = conserved(amr_cases.multiblock(fields, blocks), Refinement="Off", StairStep=1)
    mean = lambda values: amr_cases.means(values).ravel()
    fine = fields[1]
    density, capacity = mean(fine["density"]), mean(fine["density"] * fine["heat_capacity"])
    close_to = lambda name, values: np.testing.assert_allclose(
        result.cells(name), values, rtol=1e-13)
    close_to("density", density)
    close_to("energy", mean(fine["density"] * fine["energy"]) / density)
    close_to("temperature",
             mean(fine["density"] * fine["heat_capacity"] * fine["temperature"]) / capacity)
    close_to("inertia", 8 * mean(fine["inertia"]))


def spray():
    """Returns the ball and the plate, and drops of ball too small for an element.

    One drop is close to the ball, the other is not.
    """
    ball = BALL.copy()
    ball[11, 11, 11], ball[0, 0, 11] = 0.3, 0.2
    plate = np.minimum(PLATE, 1 - ball)
    return {1: ball, 2: plate}


def unmeshed(result):
    names = {"volume": "Volume", "mass": "Mass", "energy": "InternalEnergy",
             "kinetic": "KineticEnergy"}
    told = {name: result.field("Unmeshed" + field) for name, field in names.items()}
    momentum = np.reshape(result.field("UnmeshedMomentum"), (-1, 3))
    return {material: {"momentum": momentum[m],
                       **{name: values[m] for name, values in told.items()}}
            for m, material in enumerate(result.field("MaterialIds"))}


def test_what_is_not_meshed():
    """State in elements plus reported losses equals the input, with Give and with Drop."""
    fractions = spray()
    data, cells = image({"ball": fractions[1], "plate": fractions[2],
                         **ARRAYS}), cells_of(fractions, ARRAYS, VOLUME)
    for kind in MAKES:
        for more in ({}, {"MinimumRegionCells": 3}):
            left = {}
            for choice in ("Give", "Drop"):
                result = run(data, UnmeshedMaterial=choice, ThinParts=0, **CONSERVE, **more,
                             **kind)
                left[choice] = unmeshed(result)
                check_balance(result, cells,
                              skipped=("volume", "kinetic", "pressure", "inertia", "bulk",
                                       "heat_capacity", "temperature"), unmeshed=left[choice])
                lost = np.sum(result.field("LostKineticEnergy")) + sum(
                    own["energy"] + own["kinetic"] for own in left[choice].values())
                check_energy(result, cells, lost=lost)
                told = [text for text in result.warnings if "left out" in text]
                assert len(told) == (left[choice][1]["volume"] > 0) and not result.errors, (
                    result.warnings, left)
                assert all("'ball' volume" in text and "mass" in text for text in told)
            assert np.isclose(left["Drop"][1]["volume"],
                              0.5 * VOLUME) and np.isclose(left["Give"][1]["volume"],
                                                           0.2 * VOLUME), left


def sorted_by_id(result, name):
    return result.cells(name)[np.argsort(result.cells("GlobalCellIds"))]


def test_the_way_of_the_input_is_nothing():
    """Blocks with ghost cells, hexahedra and images of points give the values of the image."""
    slabs = vtkMultiBlockDataSet()
    for b, (begin, end) in enumerate(((0, 5), (5, N))):
        wide = slice(max(begin - 1, 0), min(end + 1, N))
        own = np.zeros((N, N, N), bool)
        own[begin:end] = True
        parts = {name: np.where(own.reshape(own.shape + (1,) * (values.ndim - 3)), values, -9)[wide]
                 for name, values in {"ball": BALL, "plate": PLATE, **ARRAYS}.items()}
        block = image({**parts, "vtkGhostType": np.where(own[wide], 0, GHOST).astype(np.uint8)})
        block.SetOrigin(*ORIGIN[:2], ORIGIN[2] + wide.start * SPACING[2])
        slabs.SetBlock(b, block)
    boxes = hexes({"ball": BALL, "plate": PLATE, **ARRAYS}, shuffled(),
                  [x + h * np.arange(N + 1.0) for x, h in zip(ORIGIN, SPACING)])
    reference = conserved()
    for data in (slabs, boxes, at_points(DATA)):
        result = conserved(data)
        for name in ("density", "velocity", "energy", "inertia", "bulk", "temperature"):
            assert sorted_by_id(result,
                                name).tobytes() == sorted_by_id(reference, name).tobytes(), name


def test_blanked_cells_give_nothing():
    hidden = np.zeros((N, N, N), np.uint8)
    hidden[2:8, 4:8, 4:8] = HIDDEN
    arrays = {**ARRAYS, "density": np.where(hidden, np.nan, ARRAYS["density"])}
    cells = cells_of({m: np.where(hidden, 0, f) for m, f in FRACTIONS.items()}, arrays, VOLUME)
    check_balance(conserved(image({"ball": BALL, "plate": PLATE, **arrays,
                                   "vtkGhostType": hidden})), cells)


def test_turned_images():
    """Vectors are not rotated."""
    turned = at_points(DATA, [[0, -1, 0], [1, 0, 0], [0, 0, 1]])
    check_balance(conserved(turned), cells_of(FRACTIONS, ARRAYS, VOLUME))


@in_folder
def test_spyplot_files_of_densities(at):
    """Density and energy per material are conserved with the names of SpyPlot files."""
    density, energy = ({m: (values * scale).astype(np.float32) for m, scale in ((1, 1), (2, 7))}
                       for values in (ARRAYS["density"], ARRAYS["energy"]))
    fractions = {1: BALL.astype(np.float32), 2: np.minimum(PLATE, 1 - BALL).astype(np.float32)}
    names = {"Material volume fraction": fractions, "Material density": density,
             "Material energy": energy}
    step = {"%s - %d" % (name, m): values for name, own in names.items()
            for m, values in own.items()}
    nodes = [x + h * np.arange(N + 1) for x, h in zip(ORIGIN, SPACING)]
    reader = simple.OpenDataFile(write_spyplot(at(""), "case", [0], split(nodes, [step], (2, 1, 2)),
                                               2))
    reader.DownConvertVolumeFraction = 0
    reader.CellArrays = list(step)
    chosen = lambda name: ["%s - %d" % (name, m) for m in (1, 2)]
    mesher = VolumeFractionToHex(Input=reader,
                                 VolumeFractionArrays=chosen("Material volume fraction"),
                                 DensityArrays=chosen("Material density"),
                                 StateArrays=chosen("Material energy"),
                                 EnergyArray="Material energy - 2")
    errors, _ = collect(mesher.GetClientSideObject())
    mesher.UpdatePipeline()
    assert not errors, errors
    result = Result(mesher.GetClientSideObject(), [], [])
    mass = volumes_of(result) * result.cells("Material density")
    for m, fraction in fractions.items():
        own = result.cells("MaterialId") == m
        held = fraction.astype(float) * VOLUME * density[m]
        assert close(mass[own].sum(), held.sum(), held.sum()), m
        assert close((mass * result.cells("Material energy"))[own].sum(), (held * energy[m]).sum(),
                     (held * energy[m]).sum()), m


def test_impact():
    """Fractions as bytes or floats, and the velocity as vector or components, are conserved.

    ParaView's SpyPlot reader returns all these forms.
    """
    for to_bytes in (0, 1):
        reader = simple.OpenDataFile(IMPACT)
        reader.DownConvertVolumeFraction = reader.MergeXYZComponents = to_bytes
        reader.CellArrays = reader.CellArrays.Available
        names = ["Material volume fraction - 1", "Material volume fraction - 2"]
        mesher = VolumeFractionToHex(Input=reader, VolumeFractionArrays=names,
                                     StateTransfer="Conserve",
                                     VelocityArray=" velocity" if to_bytes else "X velocity",
                                     NodalVelocity=1)
        errors, _ = collect(mesher.GetClientSideObject())
        mesher.UpdatePipeline(reader.TimestepValues[2])
        mesh = mesher.GetClientSideObject().GetOutputDataObject(0)
        field = lambda name: np.array([mesh.GetFieldData().GetArray(name).GetTuple(i)
                                       for i in range(2)])
        assert not errors and mesh.GetNumberOfCells() > 3000, errors
        gap = np.abs(field("InputMomentum") - field("MeshMomentum")
                     - field("UnmeshedMomentum")).max()
        assert gap <= 1e-13 * np.abs(field("InputMomentum")).max() and np.abs(
            field("InputMomentum")).min(axis=1).max() >= 0
        assert np.allclose(field("InputKineticEnergy"),
                           field("MeshKineticEnergy") + field("UnmeshedKineticEnergy")
                           + field("LostKineticEnergy"), rtol=1e-13, atol=0)
        assert (field("LostNodalKineticEnergy") > 0).all() and not mesh.GetFieldData().HasArray(
            "InputMass")


main(globals())
