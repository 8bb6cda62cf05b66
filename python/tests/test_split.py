"""Tests split interfaces: copies of nodes, cohesive elements, and the files of both."""

import os
import shutil
import subprocess
from itertools import product

import numpy as np
import pytest

import decks
import volume_fraction_mesh as vfm

CELLS = 16


def make_grains(count, cells, seed=3):
    """Returns labels from 1 of grains around random points."""
    seeds = np.random.default_rng(seed).uniform(0, cells, (count, 3))
    centres = np.stack(np.meshgrid(*[np.arange(cells) + 0.5] * 3, indexing="ij"), -1)
    return ((centres[..., None, :] - seeds) ** 2).sum(-1).argmin(-1).astype(np.int32) + 1


GRAINS = make_grains(100, CELLS)
FEW = make_grains(12, 10)
SPLIT = {"split_interfaces": "all", "split_connection": "cohesive"}
MAKERS = pytest.mark.parametrize("make", [vfm.hexes, vfm.tets])


@MAKERS
def test_cohesive_elements(make):
    whole, mesh = make(labels=FEW), make(labels=FEW, **SPLIT)
    before = np.searchsorted(whole.point_ids, mesh.original_ids)
    assert np.array_equal(before[mesh.cells], whole.cells)
    assert np.array_equal(mesh.points, whole.points[before])
    assert mesh.fields["AddedNodes"] == len(mesh.points) - len(whole.points)
    blocks = mesh.cohesive()
    ids = np.concatenate([block.ids for block in blocks.values()])
    assert np.array_equal(ids, mesh.cell_ids.max() + 1 + np.arange(len(ids)))
    for name, block in blocks.items():
        assert name == "Material %d_to_Material %d_cohesive" % block.materials
        for nodes, material in zip(np.split(block.cells, 2, axis=1), block.materials):
            assert np.isin(nodes, mesh.cells[mesh.material == material]).all()
        first, second = np.split(mesh.points[block.cells], 2, axis=1)
        assert np.array_equal(first, second)


def test_chosen_pairs_only():
    fractions = {"a/b": np.zeros((6, 6, 6)), "steel": np.zeros((6, 6, 6)),
                 "copper": np.zeros((6, 6, 6))}
    for name, part in zip(fractions, (slice(0, 2), slice(2, 4), slice(4, 6))):
        fractions[name][part] = 1
    plain = vfm.hexes(fractions)
    for pairs, copied in (("steel/copper", 49), ("a/b/steel", 49), ("steel/*", 98), ("2/3", 49),
                          ("1/3", 0), ("", 0)):
        if copied or not pairs:
            mesh = vfm.hexes(fractions, split_interfaces=pairs)
        else:
            with pytest.warns(vfm.VolumeFractionMeshWarning, match="no such materials"):
                mesh = vfm.hexes(fractions, split_interfaces=pairs)
        assert len(mesh.points) == len(plain.points) + copied, pairs
        assert mesh.cohesive() == {}
    with pytest.raises(ValueError, match="steel/lead"):
        vfm.hexes(fractions, split_interfaces="steel/lead")
    with pytest.raises(TypeError, match="split_interfaces"):
        vfm.hexes(fractions, split_interfaces=3)
    assert plain.original_ids is None


def test_npz_keeps_the_ids(tmp_path):
    mesh = vfm.hexes(labels=FEW, **SPLIT)
    mesh.save(tmp_path / "mesh.npz")
    again = vfm.load(tmp_path / "mesh.npz")
    assert np.array_equal(again.original_ids, mesh.original_ids)
    for name, block in mesh.cohesive().items():
        assert np.array_equal(again.cohesive()[name].cells, block.cells)


@MAKERS
def test_exodus(make, tmp_path):
    netcdf = pytest.importorskip("netCDF4")
    mesh = make(labels=FEW, **SPLIT)
    mesh.save(tmp_path / "mesh.e")
    blocks = mesh.cohesive()
    with netcdf.Dataset(tmp_path / "mesh.e") as file:
        names = [text.tobytes().decode().rstrip("\0") for text in file["eb_names"][:].data]
        ids = file["elem_num_map"][:]
        assert len(ids) == len(mesh) + sum(map(len, blocks.values()))
        last = 0
        for i, name in enumerate(names, 1):
            corners = file["connect%d" % i][:] - 1
            first, last = last, last + len(corners)
            if name in blocks:
                assert file["connect%d" % i].elem_type == ("HEX8" if mesh.kind == "hexahedron"
                                                           else "WEDGE")
                assert file["eb_prop1"][i - 1] == blocks[name].block
                assert np.array_equal(corners, blocks.pop(name).cells)
                assert not file["elem_var_tab"][i - 1].any()
            else:
                assert file["elem_var_tab"][i - 1].all()
                assert np.array_equal(corners, mesh.cells[np.searchsorted(mesh.cell_ids,
                                                                          ids[first:last])])
    assert not blocks


def read_inp(path):
    """Returns [keyword, parameters, data lines] of an input file."""
    found = []
    for line in path.read_text().splitlines():
        if line.startswith("**"):
            continue
        if line.startswith("*"):
            words = [word.strip() for word in line.split(",")]
            found.append([words[0], dict((w.split("=") + [""])[:2] for w in words[1:]), []])
        else:
            found[-1][2].append(line)
    return found


@MAKERS
def test_abaqus_cohesive(make, tmp_path):
    mesh = make(labels=FEW, **SPLIT)
    mesh.save(tmp_path / "mesh.inp")
    blocks = {name.upper().replace(" ", "_"): block for name, block in mesh.cohesive().items()}
    number = len(mesh)
    for keyword, words, lines in read_inp(tmp_path / "mesh.inp"):
        if words.get("TYPE", "").startswith("COH"):
            assert keyword == "*ELEMENT"
            assert words["TYPE"] == ("COH3D8" if mesh.kind == "hexahedron" else "COH3D6")
            rows = np.array([line.split(",") for line in lines], int)
            assert np.array_equal(rows[:, 0], number + 1 + np.arange(len(rows)))
            number += len(rows)
            assert np.array_equal(rows[:, 1:] - 1, blocks.pop(words["ELSET"]).cells)
        elif words.get("ELSET") == "EALL":
            assert lines == ["1,%d,1" % len(mesh)]
    assert not blocks


@MAKERS
def test_abaqus_contact(make, tmp_path):
    mesh = make(labels=FEW, split_interfaces="all", split_connection="contact")
    mesh.save(tmp_path / "mesh.inp")
    found = read_inp(tmp_path / "mesh.inp")
    surfaces = {words["NAME"] for keyword, words, _ in found if keyword == "*SURFACE"}
    interactions = {words["NAME"] for keyword, words, _ in found
                    if keyword == "*SURFACE INTERACTION"}
    pairs = [(words["INTERACTION"], lines[0].split(",")) for keyword, words, lines in found
             if keyword == "*CONTACT PAIR"]
    names = [name for name in mesh.facet_sets() if name.count("_to_") == 1]
    assert len(pairs) == len(names) // 2 and len({name for name, _ in pairs}) == len(pairs)
    for name, (one, other) in pairs:
        assert name in interactions and {one, other} <= surfaces
        assert one.split("_TO_") == other.split("_TO_")[::-1]


@MAKERS
def test_ties_connect_all_copies(make, tmp_path):
    """Each copy of a node follows at most one other, and all follow one that is free."""
    mesh = make(labels=GRAINS, split_interfaces="all", split_connection="tied")
    mesh.save(tmp_path / "mesh.inp")
    found = read_inp(tmp_path / "mesh.inp")
    nodes = {words["NAME"]: [int(line) - 1 for line in lines] for keyword, words, lines in found
             if keyword == "*SURFACE" and words["TYPE"] == "NODE"}
    surfaces = {words["NAME"]: lines for keyword, words, lines in found
                if keyword == "*SURFACE" and words["TYPE"] == "ELEMENT"}
    corners = mesh.cells
    places = decks.ABAQUS_FACES[corners.shape[1]]
    follows = {}
    for keyword, words, lines in found:
        if keyword == "*TIE":
            slave, master = lines[0].split(",")
            points = set()
            for line in surfaces[master]:
                element, side = line.split(",S")
                points |= {corners[int(element) - 1][c - 1] for c in places[int(side) - 1]}
            copies = {mesh.original_ids[p]: p for p in points}
            for node in nodes[slave]:
                assert node not in follows
                follows[node] = copies[mesh.original_ids[node]]
        elif keyword == "*EQUATION":
            assert lines[0] == "2"
            a, d, one, b, e, minus = lines[1].split(",")
            assert d == e and float(one) == 1 and float(minus) == -1
            if d == "1":
                assert int(a) - 1 not in follows
                follows[int(a) - 1] = int(b) - 1
            assert follows[int(a) - 1] == int(b) - 1
    ends = set()
    for node in range(len(mesh.points)):
        end = node
        for _ in range(100):
            end = follows.get(end, end)
        assert end not in follows
        ends.add((mesh.original_ids[node], end))
    assert len(ends) == len(np.unique(mesh.original_ids))
    sets = {words["NSET"]: lines for keyword, words, lines in found if keyword == "*NSET"}
    for name in ("%s_%s" % pair for pair in product("XYZ", ("MIN", "MAX"))):
        listed = {int(word) - 1 for line in sets[name] for word in line.split(",") if word}
        assert listed and not listed & set(follows)


def run_ccx(folder, name):
    told = subprocess.run(["ccx", name], cwd=folder, capture_output=True, text=True,
                          env={**os.environ, "OMP_NUM_THREADS": "1"})
    assert "Job finished" in told.stdout and "*ERROR" not in told.stdout, told.stdout


RUN = """%s*STEP
*STATIC
*BOUNDARY
Z_MIN, 1, 3
Z_MAX, 1, 2
Z_MAX, 3, 3, 0.1
*NODE PRINT, NSET=NALL
U
*END STEP
"""


def solve(mesh, folder, name):
    """Returns the displacements of the nodes; grains have different moduli."""
    mesh.save(folder / (name + ".inp"))
    sections = "".join(
        "*MATERIAL, NAME=M%d\n*ELASTIC\n%d, 0.3\n*SOLID SECTION, ELSET=EB%d, MATERIAL=M%d\n"
        % (i, 1000 * (1 + i % 5), i, i) for i in mesh.materials["MaterialId"])
    with open(folder / (name + ".inp"), "a") as file:
        file.write(RUN % sections)
    run_ccx(folder, name)
    rows = [line.split() for line in (folder / (name + ".dat")).read_text().splitlines()[3:]]
    rows = np.array([row for row in rows if row], float)
    return rows[np.argsort(rows[:, 0]), 1:]


NEEDS_CCX = pytest.mark.skipif(not shutil.which("ccx"), reason="CalculiX (ccx) is not installed")


def all_nodes(mesh):
    """Returns corners and mid nodes of each element."""
    return mesh.cells if mesh.mids is None else np.hstack([mesh.cells, mesh.mids])


@NEEDS_CCX
@MAKERS
@pytest.mark.parametrize("labels, order, layers", [
    (FEW, "linear", 0), (make_grains(60, 10), "linear", 0), (make_grains(6, 5), "quadratic", 0),
    (make_grains(8, 5), "quadratic", 2)], ids=["12 grains", "60 grains", "curved", "layers"])
def test_tied_grains_move_as_whole_ones(make, labels, order, layers, tmp_path):
    if layers and make is vfm.tets:
        pytest.skip("tetrahedra have no layers")
    options = {"labels": labels, "element_order": order, "label_smoothing": 2 * (order != "linear")}
    options.update({"layers": layers} if layers else {})
    whole = make(**options)
    tied = make(**options, split_interfaces="all", split_connection="tied")
    expected = solve(whole, tmp_path, "whole")
    found = solve(tied, tmp_path, "tied")
    before = np.zeros(len(tied.points), int)
    before[all_nodes(tied)] = all_nodes(whole)
    assert len(tied.points) > len(whole.points)
    assert np.array_equal(tied.points, whole.points[before])
    assert abs(expected).max() > 0.09
    assert abs(found - expected[before]).max() < 1e-7  # 1e-6 of the largest displacement


PRESS = """*MATERIAL, NAME=M
*ELASTIC
1000, 0.
*SOLID SECTION, ELSET=EALL, MATERIAL=M
*STEP
*STATIC
*BOUNDARY
Z_MIN, 1, 3
Z_MAX, 1, 2
Z_MAX, 3, 3, %g
*NODE PRINT, NSET=Z_MIN, TOTALS=ONLY
RF
*END STEP
"""


@NEEDS_CCX
@pytest.mark.parametrize("connection, moved, force", [
    ("contact", -0.06, 360.0), ("none", -0.06, 0.0), ("tied", 0.06, -360.0)])
def test_pressed_layers(connection, moved, force, tmp_path):
    """Contact transmits pressure, a tie also tension; free sides transmit nothing."""
    labels = np.ones((6, 6, 6), np.int32)
    labels[..., 3:] = 2
    mesh = vfm.hexes(labels=labels, split_interfaces="1/2", split_connection=connection)
    mesh.save(tmp_path / "layers.inp")
    with open(tmp_path / "layers.inp", "a") as file:
        file.write(PRESS % moved)
    run_ccx(tmp_path, "layers")
    found = float((tmp_path / "layers.dat").read_text().split()[-1])
    assert abs(found - force) < 2  # the contact of CalculiX is not rigid


@MAKERS
def test_ls_dyna_has_both_sides(make, tmp_path):
    mesh = make(labels=FEW, split_interfaces="all")
    mesh.save(tmp_path / "mesh.k")
    deck = decks.read_keyword_file(tmp_path / "mesh.k")
    whole = make(labels=FEW)
    whole.save(tmp_path / "whole.k")
    before = decks.read_keyword_file(tmp_path / "whole.k")
    added = set(deck.surfaces) - set(before.surfaces)
    pairs = [name for name in before.surfaces if "_to_" in name]
    assert added == {"_to_".join(name.split("_to_")[::-1]) for name in pairs} and pairs
    for name in pairs:
        other = deck.surfaces["_to_".join(name.split("_to_")[::-1])]
        one = deck.surfaces[name]
        assert len(one[1]) == len(other[1])
        assert not set(np.ravel(one[1])) & set(np.ravel(other[1]))
