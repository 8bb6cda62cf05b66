"""Conserved state: for each material, numpy sums over mesh and input are equal."""
import functools

import numpy as np

from conserve_cases import (
    ARRAYS, BOTH, CELLS, CONSERVE, DATA, FRACTIONS, KINDS, MAKES, N, STATE, VOLUME, cells_of,
    check_balance, check_energy, close, conserved, elements_hold, volumes_of)
from vfmtest import add_array, check_error, digest, image, main, mesh_of, run, table_of

BALL, PLATE = FRACTIONS[1], FRACTIONS[2]
check_conserve_error = functools.partial(check_error, **CONSERVE)


def test_all_kinds_of_meshes():
    """State is conserved and energy balanced for each kind of mesh, of first and second order."""
    for kind in MAKES:
        for order in (1, 2):
            result = conserved(StateOrder=order, **kind)
            check_balance(result, CELLS)
            lost = sum(result.field("LostKineticEnergy"))
            check_energy(result, CELLS, lost=lost)


def test_energy_is_whole():
    """With the lost kinetic energy added to internal energy, total energy is conserved."""
    for kind in MAKES:
        for properties in ({"LostKineticEnergy": "Internal Energy"}, BOTH):
            result = conserved(**properties, **kind)
            check_balance(result, CELLS, skipped=("volume", "kinetic", "energy"))
            check_energy(result, CELLS)


def test_void_is_a_material():
    """State of meshed void is conserved.

    Void has a share of the kind `cell` only in cells that contain nothing else.
    """
    cells = cells_of({0: 1 - BALL - PLATE, **FRACTIONS}, ARRAYS, VOLUME)
    for kind in MAKES:
        check_balance(conserved(MeshVoid=1, **kind), cells)


def test_balance_is_told():
    """Field data and columns of the table equal the sums by numpy."""
    result = conserved(**BOTH)
    mesh, table = elements_hold(result), table_of(result.materials)
    names = {"volume": "Volume", "mass": "Mass", "energy": "InternalEnergy",
             "kinetic": "KineticEnergy", "momentum": "Momentum"}
    for name, field in names.items():
        size = 3 if name == "momentum" else 1
        for held, prefix in ((CELLS, "Input"), (mesh, "Mesh"))[:1 if name == "volume" else 2]:
            told = np.reshape(result.field(prefix + field), (-1, size))
            for m, material in enumerate((1, 2)):
                scale = np.abs(held[material][name]).max()
                assert close(np.ravel(held[material][name]), told[m], 10 * scale), (prefix, field)
            column = result.materials.GetColumnByName(prefix + field)
            assert [column.GetTuple(i) for i in range(2)] == [tuple(row) for row in told.tolist()]
        assert result.field("Unmeshed" + field) == [0] * 2 * size
    for name in ("LostKineticEnergy", "LostNodalKineticEnergy"):
        assert result.field(name) == table[name]
        assert result.mesh.GetFieldData().GetAbstractArray(name).GetInformation().Has(
            result.mesh.GetFieldData().GetAbstractArray(name).GUI_HIDE())
    lost = np.array(result.field("LostKineticEnergy"))
    found = [CELLS[m]["kinetic"] - mesh[m]["kinetic"] for m in (1, 2)]
    assert np.allclose(lost, found, rtol=0, atol=1e-13 * CELLS[2]["kinetic"])


def test_without_density_mass_is_volume():
    """Without a density, the mass of a cell is its volume.

    Sums with the volumes of elements agree as far as these volumes do.
    """
    result = conserved(DensityArrays=[], StateTransfer="Conserve")
    volume, material = volumes_of(result), result.cells("MaterialId")
    least, most = np.reshape(result.field("VolumeFactors"), (-1, 2)).T
    assert (1 - 1e-6 < least).all() and (least
                                         <= 1).all() and (1
                                                          <= most).all() and (most < 1 + 1e-6).all()
    for m, fraction in FRACTIONS.items():
        own = (fraction * VOLUME)[..., None] * ARRAYS["velocity"]
        told = np.reshape(result.field("MeshMomentum"), (-1, 3))[m - 1]
        assert close(told, own.sum(axis=(0, 1, 2)), np.abs(own).sum())
        total = volume[material == m] @ result.cells("velocity")[material == m]
        assert np.abs(total - told).max() < 1e-6 * np.abs(own).sum()
    assert not result.mesh.GetFieldData().HasArray(
        "InputMass") and result.mesh.GetFieldData().HasArray("InputMomentum")


def test_automatic_conserves_where_there_is_a_density():
    """Without a density, state is copied and the options of conservation are ignored."""
    ignored = {"StateKinds": ["nonsense"], "VelocityArray": "nothing", "EnergyArray": "nothing",
               "NodalVelocity": 1, "StateOrder": 1}
    copied = digest(mesh_of(DATA, StateArrays=STATE))
    assert copied == digest(mesh_of(DATA, StateArrays=STATE, StateTransfer="Copy",
                                    DensityArrays=["density"], **ignored))
    assert copied == digest(mesh_of(DATA, StateArrays=STATE, **ignored))
    conserve = {"DensityArrays": ["density"], "StateArrays": STATE}
    assert digest(mesh_of(DATA,
                          **conserve)) == digest(mesh_of(DATA, StateTransfer="Conserve",
                                                         **conserve)) != copied


def arrays_of(result):
    data = result.mesh.GetCellData()
    return [data.GetArrayName(i) for i in range(data.GetNumberOfArrays())]


def test_outputs():
    """Arrays are double: selected ones in order, then densities, velocity and energy.

    Names of components are kept.
    """
    data = image({"ball": BALL, "plate": PLATE,
                  **{name: values.astype(np.float32) for name, values in ARRAYS.items()}})
    data.GetCellData().GetArray("velocity").SetComponentName(2, "w")
    result = conserved(data, NodalVelocity=1)
    assert arrays_of(result) == arrays_of(mesh_of(DATA)) + STATE + ["density", "velocity", "energy"]
    for array in (result.mesh.GetCellData().GetArray("velocity"),
                  result.mesh.GetPointData().GetArray("velocity")):
        assert (array.GetDataTypeAsString() == "double" and array.GetNumberOfComponents() == 3
                and array.GetComponentName(2) == "w")
    assert result.mesh.GetCellData().GetScalars().GetName() == "MaterialId"


def test_whole_numbers_are_copied():
    """Integer arrays, and arrays of the kind copy, are copied."""
    data = image({"ball": BALL, "plate": PLATE,
                  "number": np.arange(N ** 3, dtype=np.int64).reshape(N, N, N),
                  "density": ARRAYS["density"]})
    names = ["number", "ball"]
    copied = mesh_of(data, StateArrays=names)
    result = mesh_of(data, StateArrays=names, DensityArrays=["density"], StateKinds=["ball=copy"])
    for name in names:
        assert result.cells(name).tobytes() == copied.cells(name).tobytes() and result.cells(
            name).dtype == copied.cells(name).dtype
    counted = mesh_of(data, StateArrays=names, DensityArrays=["density"],
                      StateKinds=["number=extensive"])
    total = sum(((f > 0) * f / np.where(f > 0, BALL + PLATE, 1) * data_values(data, "number")).sum()
                for f in FRACTIONS.values())
    assert close(counted.cells("number").sum(), total, total)


def data_values(data, name):
    from vtkmodules.util.numpy_support import vtk_to_numpy
    return vtk_to_numpy(data.GetCellData().GetArray(name)).reshape(N, N, N)


def test_uniform_state_stays():
    """Uniform state stays uniform except for rounding.

    Volumes of the mesh differ from the cells by up to 1e-7, and densities change as much.
    """
    arrays = {"density": np.full((N, N, N), 3.0), "velocity": np.ones((N, N, N, 3)),
              "energy": np.full((N, N, N), 2.0)}
    data = image({"ball": BALL, "plate": PLATE, **arrays})
    for kind in MAKES:
        result = mesh_of(data, StateArrays=[], DensityArrays=["density"], VelocityArray="velocity",
                         EnergyArray="energy", NodalVelocity=1, **kind)
        assert np.allclose(result.cells("density"), 3, rtol=1e-5,
                           atol=0), (result.cells("density") / 3 - 1).max()
        for values, expected in ((result.cells("velocity"), 1), (result.points("velocity"), 1),
                                 (result.cells("energy"), 2)):
            assert np.allclose(values, expected, rtol=1e-12,
                               atol=0), np.abs(values / expected - 1).max()


def test_threads():
    for kind in MAKES:
        one, two = (conserved(NumberOfThreads=n, **BOTH, **kind) for n in (1, 2))
        assert digest(one) == digest(two), kind


FORMS = {"Material volume fraction - %s": ("Material density - %s", "Material density", ("1", "2")),
         "frac_%s": ("rho_%s", "rho", ("steel", "stone")),
         "%s": ("speed of %s (m/s)", "speed of (m/s)", ("ball", "plate")),
         "%s share": ("Density - %s", "Density", ("1", "2")), "vof%s": ("rho%s", "rho", ("1", "2"))}


def test_arrays_a_material():
    """Arrays of different materials become one array of the mesh.

    Their names differ where the names of the fractions differ, or in a number after a hyphen.
    """
    densities = {1: ARRAYS["density"], 2: 8 - ARRAYS["energy"]}
    for fraction, (density, stem, words) in FORMS.items():
        fractions = [fraction % word
                     for word in (words if fraction != "%s share" else ("ball", "plate"))]
        names = [density % word for word in words]
        data = image({**dict(zip(fractions, FRACTIONS.values())),
                      **dict(zip(names, densities.values())), "velocity": ARRAYS["velocity"]})
        for chosen in ({"DensityArrays": names},
                       {"StateArrays": names, "DensityArrays": names[:1]}):
            result = mesh_of(data, VolumeFractionArrays=fractions, VelocityArray="velocity",
                             **chosen)
            assert stem in arrays_of(result) and names[0] not in arrays_of(result), (
                arrays_of(result), stem)
            cells = {}
            for m, own in FRACTIONS.items():
                mass = own * VOLUME * densities[m]
                cells[m] = {"volume": 0, "mass": mass.sum(),
                            "momentum": np.einsum("zyx,zyxc->c", mass, ARRAYS["velocity"]),
                            "kinetic": 0.5 * (mass * (ARRAYS["velocity"] ** 2).sum(axis=3)).sum()}
            mesh = elements_hold(result, stem)
            for m in FRACTIONS:
                assert close(mesh[m]["mass"], cells[m]["mass"], cells[m]["mass"])
                assert close(mesh[m]["momentum"], cells[m]["momentum"],
                             np.sqrt(2 * cells[m]["mass"] * cells[m]["kinetic"]))


def test_energy_by_its_stem():
    """The energy can be given by the common part of its names or by any array."""
    names = ["energy - 1", "energy - 2"]
    data = image({"ball": BALL, "plate": PLATE,
                  **{name: values for name, values in ARRAYS.items() if name != "energy"},
                  **{name: ARRAYS["energy"] for name in names}})
    whole = conserved(StateArrays=[], StateKinds=[])
    for name in ("energy", *names):
        result = conserved(data, StateArrays=names, StateKinds=[], EnergyArray=name)
        assert result.cells("energy").tobytes() == whole.cells("energy").tobytes()
        assert result.field("MeshInternalEnergy") == whole.field("MeshInternalEnergy")


def test_velocity_by_components():
    """Three arrays of components, as in SpyPlot files and plotfiles, become one velocity.

    It can be given by the name of any component or by their common part.
    """
    whole = conserved(NodalVelocity=1)
    for names, stem in ((["X velocity", "Y velocity", "Z velocity"], "velocity"),
                        (["y_vel", "x_vel", "z_vel"], "vel")):
        parts = {name: ARRAYS["velocity"][..., "xyz".index(name[0].lower())] for name in names}
        data = image({"ball": BALL, "plate": PLATE,
                      **{name: values for name, values in ARRAYS.items() if name != "velocity"},
                      **parts})
        for name in (*names, stem):
            result = conserved(data, NodalVelocity=1, VelocityArray=name,
                               StateArrays=STATE + [name for name in names if name[0] in "yY"])
            assert arrays_of(result).count(stem) == 1 and not set(names) & set(
                arrays_of(result)), arrays_of(result)
            for get in ("cells", "points"):
                assert getattr(result,
                               get)(stem).tobytes() == getattr(whole, get)("velocity").tobytes()
        array = result.mesh.GetCellData().GetArray(stem)
        assert [array.GetComponentName(c) for c in range(3)] == ["X", "Y", "Z"]
    data.GetCellData().RemoveArray("z_vel")
    check_conserve_error(data, "no numeric cell array 'z_vel'", VelocityArray="x_vel")
    check_conserve_error(data, "no numeric cell array 'vel'", VelocityArray="vel")


def test_names_that_begin_alike():
    """An array with the exact name is used; a velocity vector may be named x_vel."""
    data = image({"ball": BALL, "plate": PLATE, **ARRAYS, "velocity_error": BALL,
                  "energy_source": BALL, "x_vel": ARRAYS["velocity"]})
    whole = conserved()
    for velocity in ("velocity", "x_vel"):
        result = conserved(data, VelocityArray=velocity,
                           StateArrays=["velocity_error", "energy_source"], StateKinds=[])
        assert result.cells(velocity).tobytes() == whole.cells("velocity").tobytes()
        assert result.cells("energy").tobytes() == whole.cells("energy").tobytes()


def test_roles_of_whole_numbers():
    """Integer densities, velocities and energies are conserved, not copied."""
    whole = {name: np.round(8 * ARRAYS[name]).astype(np.int32)
             for name in ("density", "velocity", "energy")}
    results = [conserved(image({"ball": BALL, "plate": PLATE,
                                **{name: values.astype(kind) for name, values in whole.items()}}),
                         StateArrays=[], StateKinds=[]) for kind in (np.int32, float)]
    assert digest(results[0]) == digest(results[1]) and results[0].cells("energy").dtype == float


def test_blanks_in_kinds():
    """Blanks in StateKinds are ignored, except in names of arrays."""
    kinds = [" pressure = volume", "inertia= extensive ", "bulk =cell",
             "temperature = mass * heat_capacity"]
    assert digest(conserved(StateKinds=kinds)) == digest(conserved())
    data = image({"ball": BALL, "plate": PLATE, **ARRAYS, " pressure": ARRAYS["pressure"]})
    result = conserved(data, StateArrays=[" pressure"], StateKinds=[" pressure=volume"])
    assert result.cells(" pressure").tobytes() == conserved().cells("pressure").tobytes()


def test_extensive_arrays_a_material():
    """An extensive array of a material belongs only to this material; void has none."""
    held = {m: f * ARRAYS["energy"] for m, f in FRACTIONS.items()}
    data = image({"ball": BALL, "plate": PLATE, "charge ball": held[1], "charge plate": held[2],
                  "mass ball": held[1], "mass plate": held[2]})
    result = mesh_of(data, MeshVoid=1, StateArrays=["charge ball", "charge plate"],
                     DensityArrays=["mass ball", "mass plate"],
                     StateKinds=["charge=extensive", "mass ball=cell"])
    for m, values in {0: np.zeros(1), **held}.items():
        own = result.cells("MaterialId") == m
        assert close(result.cells("charge")[own].sum(), values.sum(), held[1].sum()), m
        assert close((result.cells("mass") * volumes_of(result))[own].sum(), values.sum() * VOLUME,
                     held[1].sum() * VOLUME), m


def test_errors_of_the_choice():
    for word in ("pressure", "pressure=", "=volume", "pressure=weight", "pressure=mass*"):
        check_conserve_error(DATA, "'%s' is not valid" % word, "write array=kind",
                             "mass, volume, cell, extensive, copy", StateKinds=[word])
    check_conserve_error(DATA, "name 'pressur', which is not a selected state array",
                         StateKinds=["pressur=volume"])
    check_conserve_error(DATA, "name 'pressure' twice",
                         StateKinds=["pressure=volume", "pressure=mass"])
    for weight in ("nothing", "pressure", "velocity", "temperature"):
        check_conserve_error(DATA, "'temperature' cannot be weighted with '%s'" % weight,
                             StateKinds=["pressure=volume", "temperature=mass*" + weight])
    check_conserve_error(DATA, "no numeric cell array 'rho'", DensityArrays=["rho"])
    check_conserve_error(DATA, "'density' cannot be copied", StateKinds=["density=copy"])
    check_conserve_error(DATA, "'density' cannot be of the kind mass", StateKinds=["density=mass"])
    check_conserve_error(DATA, "'density' and 'pressure' are not arrays of different materials",
                         DensityArrays=["density", "pressure"], StateKinds=[])
    check_conserve_error(DATA, "'velocity' has 3 components", DensityArrays=["velocity"],
                         VelocityArray="None", StateKinds=["velocity=volume"])
    check_conserve_error(DATA, "velocity array 'energy' has 1 component: velocity has 3",
                         VelocityArray="energy")
    check_conserve_error(DATA, "energy array 'velocity' has 3 components: energy has 1",
                         EnergyArray="velocity")
    check_conserve_error(DATA, "energy array 'pressure' must be of the kind mass",
                         EnergyArray="pressure")
    check_conserve_error(DATA,
                         "energy array 'press' is neither an array of the input nor the common "
                         "part of names of state arrays", EnergyArray="press")


def test_errors_of_arrays_a_material():
    data = image({"f1": BALL, "f2": PLATE, "rho1": BALL + 1, "rho2": PLATE + 1, "u1": BALL,
                  "rho": BALL + 1})
    fractions = {"VolumeFractionArrays": ["f1", "f2"], "VelocityArray": "None",
                 "EnergyArray": "None", "StateKinds": []}
    check_conserve_error(data, "'rho1' belongs to one material", "'f2'", "'rho2'", "rho1=volume",
                         **fractions, DensityArrays=["rho1"], StateArrays=[])
    check_conserve_error(data, "'u1' belongs to one material", "'u2'", "u1=mass", **fractions,
                         DensityArrays=["rho1", "rho2"], StateArrays=["u1"])
    kinds = {**fractions, "StateKinds": ["rho1=volume", "rho2=cell"]}
    check_conserve_error(data, "'rho1' and 'rho2' differ", "one array of the mesh, 'rho'", **kinds,
                         DensityArrays=["rho1", "rho2"], StateArrays=[])
    check_conserve_error(data, "'rho1', 'rho2', .. become the array 'rho'", "another of that name",
                         **fractions, DensityArrays=["rho1", "rho2"], StateArrays=["rho"])
    result = mesh_of(data, **{**fractions, "StateKinds": ["u1=volume"]},
                     DensityArrays=["rho1", "rho2"], StateArrays=["u1"])
    assert result.cells("u1").dtype == float
    data = image({"f1": BALL, "f2": PLATE, **{axis + " u1": BALL for axis in "XYZ"},
                  "rho": BALL + 1})
    check_conserve_error(data, "'X u1' is a component of one material's velocity",
                         **{**fractions, "VelocityArray": "X u1"}, DensityArrays=["rho"],
                         StateArrays=[])


def test_errors_of_values():
    """Invalid values are errors only in cells that contain material."""
    for name, value, word in (("density", -1.0, "-1"), ("density", np.nan, "nan"),
                              ("energy", np.inf, "inf"), ("velocity", np.nan, "nan")):
        values = ARRAYS[name].copy()
        values[7, 5, 6] = value
        data = image({"ball": BALL, "plate": PLATE, **ARRAYS, name: values})
        kind = "density" if name == "density" else "state"
        check_conserve_error(data,
                             "The %s array '%s' is %s in cell (6, 5, 7), which holds 'ball'"
                             % (kind, name, word))
        empty = (BALL + PLATE)[11, 0, 0]
        values = ARRAYS[name].copy()
        values[11, 0, 0] = value
        data = image({"ball": BALL, "plate": PLATE, **ARRAYS, name: values})
        assert empty == 0 and not run(data, **CONSERVE).errors
        check_conserve_error(data, "which holds 'Void'", MeshVoid=1)


main(globals())
