"""Tests Mesh.bin_materials: bins against numpy, and the materials of files that are read back."""

from xml.etree import ElementTree

import numpy as np
import pytest

import volume_fraction_mesh as vfm
from decks import read_abaqus, read_keyword_file, read_nastran, read_radioss
from fields import BALL, N, PLATE, same

A, B, POISSON, C0, C1 = 6850.0, 1.49, 0.25, 0.1, 0.001
FRACTIONS = {"bone": BALL, "plate": PLATE}
x, y, z = np.meshgrid(*[np.arange(N) + 0.5] * 3, indexing="ij")
GREY = np.round(100 * x + 20 * np.sin(y) * z)
MESHES = {"hexes": vfm.hexes(FRACTIONS, state={"grey": GREY}),
          "tets": vfm.tets(FRACTIONS, state={"grey": GREY}, mesh_void=True)}
COUNT = 12
READERS = {".k": read_keyword_file, ".rad": read_radioss, ".bdf": read_nastran,
           ".inp": read_abaqus}
DIGITS = {".k": 5e-6, ".rad": 1e-13, ".bdf": 1e-9, ".inp": 1e-13, ".feb": 0}


def binned_of(mesh):
    return mesh.bin_materials("grey", COUNT, a=A, b=B, poisson=POISSON, c0=C0, c1=C1)


@pytest.fixture(params=MESHES)
def mesh(request):
    return MESHES[request.param]


@pytest.fixture
def binned(mesh):
    return binned_of(mesh)


def expected_bins(mesh):
    """Returns {name: (material, elements, lower, upper, mean, volume)} by numpy."""
    solid, grey, volumes = mesh.material > 0, mesh.state["grey"], mesh.volumes()
    edges = np.linspace(grey[solid].min(), grey[solid].max(), COUNT + 1)
    number = np.clip(np.searchsorted(edges, grey, side="right"), 1, COUNT)
    found = {}
    for material, name in zip(mesh.materials["MaterialId"], mesh.materials["Name"]):
        for one in range(1, COUNT + 1):
            own = (mesh.material == material) & (number == one)
            if material > 0 and own.any():
                found["%s_bin_%02d" % (name, one)] = (
                    material, np.flatnonzero(own), edges[one - 1], edges[one],
                    np.average(grey[own], weights=volumes[own]), volumes[own].sum())
    return found


def test_table(mesh, binned):
    expected, fields = expected_bins(mesh), binned.fields
    assert fields["BinNames"] == list(expected) and len(expected) > COUNT
    material, elements, lower, upper, mean, volume = zip(*expected.values())
    ids = fields["BinIds"]
    assert ids.min() > max(mesh.materials["MaterialId"]) + 1 and (np.diff(ids) == 1).all()
    assert fields["BinMaterials"].tolist() == list(material)
    assert fields["BinNumbers"].tolist() == [int(name[-2:]) for name in expected]
    assert fields["BinElements"].tolist() == list(map(len, elements))
    for name, values in (("Lower", lower), ("Upper", upper), ("Mean", mean), ("Volume", volume)):
        assert np.allclose(fields["Bin" + name], values, rtol=1e-12), name
    density = C0 + C1 * np.array(mean)
    assert np.allclose(fields["BinDensity"], density, rtol=1e-12)
    assert np.allclose(fields["BinModulus"], A * density ** B, rtol=1e-12)
    assert (fields["BinPoisson"] == POISSON).all()
    for one, own in zip(ids, elements):
        assert np.array_equal(np.flatnonzero(binned.state["BinId"] == one), own)
    meshed = mesh.materials["MeshVolume"][np.array(mesh.materials["MaterialId"]) > 0]
    assert np.isclose(fields["BinVolume"].sum(), meshed.sum(), rtol=1e-9)


def test_mesh_stays(mesh, binned, tmp_path):
    assert same(mesh, binned) and "BinId" not in mesh.state
    assert not any(name.startswith("Bin") for name in mesh.fields)
    again = binned.bin_materials("grey", 3)
    assert "BinModulus" not in again.fields and set(again.fields["BinNumbers"]) == {1, 2, 3}
    one = mesh.bin_materials("grey", 5, materials="bone")
    assert set(one.fields["BinMaterials"]) == {1}
    assert np.array_equal(one.state["BinId"] > 0, mesh.material == 1)
    binned.save(tmp_path / "binned.npz")
    loaded = vfm.load(tmp_path / "binned.npz")
    loaded.save(tmp_path / "loaded.inp")
    binned.save(tmp_path / "binned.inp")
    assert (tmp_path / "loaded.inp").read_bytes() == (tmp_path / "binned.inp").read_bytes()
    split = binned.split()
    assert np.array_equal(split.state["BinId"], binned.state["BinId"])
    assert split.fields["BinNames"] == binned.fields["BinNames"]


@pytest.mark.parametrize("suffix", READERS)
def test_decks(mesh, binned, suffix, tmp_path):
    """Parts and constants are those of the bins; all else is as in the file without bins."""
    binned.save(tmp_path / ("bins" + suffix))
    mesh.save(tmp_path / ("plain" + suffix))
    deck, plain = (READERS[suffix](tmp_path / (name + suffix)) for name in ("bins", "plain"))
    assert deck.nodes == plain.nodes and deck.elements == plain.elements
    assert deck.node_sets == plain.node_sets and deck.surfaces == plain.surfaces
    fields = binned.fields
    for row, (name, (_, elements, *_)) in enumerate(expected_bins(mesh).items()):
        number = int(fields["BinIds"][row])
        title = name.upper() if suffix == ".inp" else name
        assert deck.parts[number] == (title, (elements + 1).tolist())
        constants = deck.constants[title if suffix == ".inp" else number]
        assert np.allclose(constants, [fields["Bin" + column][row] for column in (
            "Density", "Modulus", "Poisson")], rtol=DIGITS[suffix])
    void = {number for number, (_, elements) in plain.parts.items()
            if set(mesh.material[np.array(elements) - 1]) == {0}}
    assert set(deck.parts) == void | set(fields["BinIds"].tolist())
    assert len(deck.constants) == len(fields["BinIds"])
    if suffix == ".inp":
        for name, elements in plain.element_sets.items():
            assert deck.element_sets[name] == elements
    if suffix == ".k":
        assert deck.part_sets == {name: (material, fields["BinIds"][fields[
            "BinMaterials"] == material].tolist()) for material, name in ((1, "bone"),
                                                                          (2, "plate"))}


def test_febio(mesh, binned, tmp_path):
    binned.save(tmp_path / "bins.feb")
    root = ElementTree.parse(tmp_path / "bins.feb").getroot()
    expected, fields = expected_bins(mesh), binned.fields
    parts = {part.get("name"): [int(one.get("id")) - 1 for one in part]
             for part in root.find("Mesh").findall("Elements")}
    assert set(parts) - {"Void"} == set(expected)
    domains = {one.get("name"): one.get("mat") for one in root.find("MeshDomains")}
    assert domains == {name: name for name in parts}
    materials = {one.get("name"): one for one in root.find("Material")}
    assert list(materials) == list(domains)
    for row, (name, (_, elements, *_)) in enumerate(expected.items()):
        assert parts[name] == elements.tolist()
        found = [float(materials[name].find(key).text) for key in ("density", "E", "v")]
        assert found == [fields["Bin" + key][row] for key in ("Density", "Modulus", "Poisson")]
    sets = {one.get("name"): [int(text) - 1 for text in one.text.split(",")]
            for one in root.find("Mesh").findall("ElementSet")}
    assert sets == {"all_elements": list(range(len(mesh))),
                    "bone": np.flatnonzero(mesh.material == 1).tolist(),
                    "plate": np.flatnonzero(mesh.material == 2).tolist()}
    assert {one.get("name") for one in root.find("MeshData")} == {"grey"}


def test_exodus(mesh, binned, tmp_path):
    netcdf = pytest.importorskip("netCDF4")
    binned.save(tmp_path / "bins.e")
    mesh.save(tmp_path / "plain.e")
    expected, fields = expected_bins(mesh), binned.fields
    with netcdf.Dataset(tmp_path / "bins.e") as data, netcdf.Dataset(tmp_path / "plain.e") as plain:
        names = list(netcdf.chartostring(data["eb_names"][:]))
        ids, cell_ids = data["eb_prop1"][:].tolist(), data["elem_num_map"][:]
        variables = list(netcdf.chartostring(data["name_elem_var"][:]))
        assert [name for name in names if name != "Void"] == list(expected)
        assert ids[-len(expected):] == fields["BinIds"].tolist()
        first = 0
        for block, name in enumerate(names, 1):
            corners = data["connect%d" % block][:] - 1
            own = expected[name][1] if name in expected else np.flatnonzero(mesh.material == 0)
            assert np.array_equal(cell_ids[first:first + len(corners)], mesh.cell_ids[own])
            assert np.array_equal(corners, mesh.cells[own])
            values = data["vals_elem_var%deb%d" % (variables.index("grey") + 1, block)][0]
            assert np.array_equal(values, mesh.state["grey"][own])
            first += len(corners)
        for kind in ("ss", "ns"):
            assert (data[kind + "_names"][:] == plain[kind + "_names"][:]).all()
            assert (data[kind + "_prop1"][:] == plain[kind + "_prop1"][:]).all()
        for number in range(1, len(data.dimensions["num_side_sets"]) + 1):
            sides = [{(file["elem_num_map"][:][element - 1], side) for element, side in zip(
                file["elem_ss%d" % number][:], file["side_ss%d" % number][:])}
                for file in (data, plain)]
            assert sides[0] == sides[1]


def test_ids_with_cohesive_elements(mesh, tmp_path):
    """Blocks of cohesive elements have ids above those of bins."""
    netcdf = pytest.importorskip("netCDF4")
    binned_of(mesh).split(connection="cohesive").save(tmp_path / "bins.e")
    with netcdf.Dataset(tmp_path / "bins.e") as data:
        ids = data["eb_prop1"][:].tolist()
    assert len(set(ids)) == len(ids) and ids == sorted(ids)


def test_plane(tmp_path):
    """Bins of a mesh of a plane have areas."""
    grey = np.repeat(np.arange(8.0)[:, None], 4, axis=1)
    flat = vfm.hexes({"bone": np.ones((8, 4))}, state={"grey": grey}).bin_materials("grey", 4, a=1)
    assert np.allclose(flat.fields["BinVolume"], 8) and np.allclose(
        flat.fields["BinModulus"], [0.5, 2.5, 4.5, 6.5])


@pytest.mark.parametrize("arguments, text", [
    ({"array": "gray"}, "no array 'gray' of elements for bins"),
    ({"array": "grey", "count": 0}, "number of bins is 0"),
    ({"array": "grey", "a": 1, "b": np.inf}, "exponent b of the law of bins is not finite"),
    ({"array": "grey", "a": -1}, "factor a of the law of bins is -1"),
    ({"array": "grey", "a": 1, "poisson": 0.5}, "Poisson's ratio of bins is 0.5"),
    ({"array": "grey", "a": 1, "c0": -1e6}, "density of bone_bin_.. is -"),
    ({"array": "grey", "materials": "wood"}, "no material 'wood'"),
    ({"array": "constant"}, "All values of the array 'constant' are 2"),
    ({"array": "nan"}, "'nan' has 1 values that are not finite"),
    ({"array": "vector"}, "'vector' has 3 components"),
])
def test_wrong_arguments(arguments, text):
    made = MESHES["hexes"]
    values = np.full(len(made), 2.0)
    holes = values.copy()
    holes[7] = np.nan
    changed = made.bin_materials("grey", 2)
    changed.state.update(constant=values, nan=holes, vector=np.ones((len(made), 3)))
    with pytest.raises(ValueError, match=text):
        changed.bin_materials(**arguments)
    with pytest.raises(TypeError):
        made.bin_materials("grey", 2.5)
