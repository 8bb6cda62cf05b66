"""Tests the quality report of a mesh."""

import html.parser
import os
import pickle
import re

import numpy as np
import pytest

import volume_fraction_mesh as vfm
from fields import BALL, LABELS, PLATE, STATE

NAMES = {1: "ball <1> & \"co\"", 2: "plate"}


class Page(html.parser.HTMLParser):
    """Texts of a page: cells of tables by the headings above them, and all others."""

    def __init__(self, path):
        super().__init__()
        self.rows, self.texts, self.tags, self.tag = {}, [], [], ""
        with open(path, encoding="utf-8") as file:
            self.feed(file.read())

    def handle_starttag(self, tag, attributes):
        self.tags.append(tag)
        self.tag = tag
        if tag == "tr":
            self.rows.setdefault(self.heading, []).append([])

    def handle_data(self, data):
        if self.tag == "h2" and data.strip():
            self.heading = data
        elif self.tag in ("th", "td") and data.strip():
            self.rows[self.heading][-1].append(data)
        if data.strip():
            self.texts.append(data)


def write(mesh, folder, **options):
    mesh.report(folder / "mesh.html", **options)
    return Page(folder / "mesh.html")


@pytest.mark.parametrize("make", [vfm.hexes, vfm.tets])
def test_content(make, tmp_path):
    mesh = make(labels=LABELS, names=NAMES, state={"T": STATE["temperature"]})
    page = write(mesh, tmp_path, title="a < b")
    assert page.texts.count("a < b") == 2  # title and heading
    table, rows = mesh.materials, page.rows["Materials"][1:-1]
    assert [row[0] for row in rows] == [NAMES[1], NAMES[2]]
    for m, row in enumerate(rows):
        numbers = [float(cell.replace(",", "")) for cell in row[1:]]
        columns = ("MaterialId", "Elements", "TargetVolume", "MeshVolume")
        assert np.allclose(numbers[:4], [table[name][m] for name in columns], rtol=1e-5)
        assert np.isclose(numbers[4], 100 * table["VolumeError"][m], rtol=1e-2, atol=1e-12)
        assert numbers[5:8] == [
            table[name][m] for name in ("Fragments", "LostCells", "GainedCells")]
        assert np.isclose(numbers[8], table["MinimumScaledJacobian"][m], atol=1e-4)
    worst = page.rows["Worst elements"][1:]
    order = np.lexsort((mesh.cell_ids, mesh.quality))[:10]
    assert [int(row[0]) for row in worst] == mesh.cell_ids[order].tolist()
    assert [row[1] for row in worst] == [NAMES[label] for label in mesh.material[order]]
    centres = mesh.points[mesh.cells[order]].mean(axis=1)
    assert np.allclose(np.array([row[3:] for row in worst], float), centres, atol=0.2)
    counts = [int(row[1].replace(",", "")) for row in page.rows["Scaled Jacobian"][1:]]
    assert counts == np.histogram(mesh.quality, 20, (0, 1))[0].tolist()
    assert ("Dihedral angles" in page.rows) == (make is vfm.tets)


def test_side_sets_are_those_of_files(tmp_path):
    mesh = vfm.hexes({"ball": BALL, "plate": PLATE})
    mesh.save(tmp_path / "mesh.inp")
    with open(tmp_path / "mesh.inp") as file:
        text = file.read()
    listed = {row[0].upper(): int(row[2].replace(",", ""))
              for row in write(mesh, tmp_path).rows["Side sets"][1:]}
    for name, lines in re.findall(r"\*SURFACE, NAME=(\w+), TYPE=ELEMENT\n((?:[^*]*\n)*)", text):
        assert listed.pop(name) == lines.count("\n")
    assert not listed


def test_run_is_reported(tmp_path):
    with pytest.warns(vfm.VolumeFractionMeshWarning) as caught:
        fractions = {"ball": BALL, "none": 0.01 * (BALL == 0)}
        mesh = vfm.hexes(fractions, iso_value=0.4, sharp_edges="off")
    assert mesh.run.options == {"iso_value": 0.4, "sharp_edges": "off"}
    assert mesh.run.warnings == [str(warning.message) for warning in caught]
    assert mesh.run.source == {"Grid": "12 x 12 x 12 cells",
                               "Materials from": "2 arrays of volume fractions"}
    assert pickle.loads(pickle.dumps(mesh)).run == mesh.run
    texts = write(mesh, tmp_path).texts
    for text in ("iso_value", "0.4", "12 x 12 x 12 cells", *mesh.run.warnings):
        assert text in texts
    assert vfm.hexes(BALL).run.options == {}


@pytest.mark.filterwarnings("ignore::volume_fraction_mesh.VolumeFractionMeshWarning")
def test_without_elements_or_quality(tmp_path):
    assert "The mesh has no elements." in write(vfm.hexes(0 * BALL), tmp_path).texts
    page = write(vfm.hexes(BALL, compute_quality=False), tmp_path)
    assert "svg" not in page.tags and "Worst elements" not in page.rows
    assert any("ComputeQuality is off" in text for text in page.texts)


def test_errors(tmp_path):
    mesh = vfm.hexes(BALL)
    for name in ("mesh.pdf", "mesh"):
        with pytest.raises(ValueError, match="give .html or .htm"):
            mesh.report(tmp_path / name)
    with pytest.raises(OSError, match="no/mesh.html: No such file"):
        mesh.report(tmp_path / "no" / "mesh.html")
    assert os.listdir(tmp_path) == []
