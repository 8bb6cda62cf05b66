"""The page that `sculptor --report` writes: the same from any number of ranks, with the numbers of
the printed table, the warnings and the options."""
import os
import re

import numpy as np

from sculptor_program import mesh_file, refused, rows, sculptor
from vfmtest import ball_and_plate, fraction_image, image, in_folder, labels, main, write


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def section(page, title):
    return page.partition("<h2>%s</h2>" % title)[2].partition("</section>")[0]


def table(page, title):
    """Returns the rows of the first table below a title, without its head."""
    body = section(page, title).partition("<tbody>")[2].partition("</table>")[0]
    return [re.findall(r"<t[hd][^>]*>([^<]*)</t[hd]>", row) for row in body.split("</tr>")[:-1]]


@in_folder
def test_same_from_any_ranks(at):
    path = write(fraction_image(), at("in.vti"))
    for kind in ([], ["--tetmesh", "Lattice"]):
        for ranks in (1, 3):
            os.makedirs(at("%d" % ranks), exist_ok=True)
            mesh_file(path, at("out.vtu"), "--report", at("%d/mesh.html" % ranks), *kind,
                      ranks=ranks)
        page = read(at("1/mesh.html"))
        assert page == read(at("3/mesh.html"))
        assert page.startswith("<!DOCTYPE html>") and page.endswith("</html>\n")
        assert ("Dihedral angles" in page) == bool(kind)


@in_folder
def test_numbers_are_those_of_the_printed_table(at):
    path = write(fraction_image(), at("in.vti"))
    text = mesh_file(path, at("out.vtu"), "--report", at("mesh.html"), "--iso", "0.4", ranks=2)
    page, printed = read(at("mesh.html")), rows(text)
    materials = table(page, "Materials")
    assert [row[0] for row in materials] == ["ball", "plate", "All"]
    for name, *cells in materials:
        values = [float(cell.replace(",", "") or 0) for cell in cells]
        (number, elements, target, volume, error), (least, mean) = values[:5], values[-2:]
        line = printed["all" if name == "All" else "%d %s" % (number, name)]
        assert [elements, least, mean] == [line[0], line[2], line[3]], (name, line)
        assert np.allclose([volume, target], [line[4], line[5]], rtol=1e-5)
        assert abs(error - line[6]) < 1e-5 + 0.01 * abs(error)
    assert "<dt>Points</dt><dd>%d</dd>" % printed["all"][1] in page.replace(",", "")
    for fact in (("Input", path), ("Mesh", at("out.vtu")), ("IsoValue", "0.4")):
        assert "<dt>%s</dt><dd>%s</dd>" % fact in page
    assert len(table(page, "Worst elements")) == 10
    sides = {name: int(count.replace(",", "")) for name, _, count in table(page, "Side sets")}
    assert sides["ball_to_plate"] == sides["plate_to_ball"] > 0


@in_folder
def test_warnings(at):
    ball, plate = ball_and_plate()
    path = write(image({"ball": 1.01 * ball, "plate": plate, "lost": 1e-3 * ball}), at("in.vti"))
    for ranks in (1, 2):
        result = sculptor(path, at("out.vtu"), "--clip", "0.02", "--report", at("mesh.html"),
                          ranks=ranks)
        warnings = [line.partition("warning: ")[2] for line in result.stderr.splitlines()]
        assert result.returncode == 0 and len(warnings) > 1, result
        assert re.findall("<li>(.*?)</li>", read(at("mesh.html"))) == warnings


@in_folder
def test_names_are_escaped(at):
    path = write(image({"id": labels()}), at("in.vti"))
    with open(at("names.txt"), "w", encoding="utf-8") as file:
        file.write('1\t<b>&"\n')
    mesh_file(path, at("out.vtu"), "--labels", "id", "--label-names", at("names.txt"), "--report",
              at("mesh.html"), ranks=2)
    page = read(at("mesh.html"))
    assert table(page, "Materials")[0][0] == "&lt;b>&amp;&quot;" and "<b>" not in page
    assert table(page, "Worst elements") and '<dt>LabelNames</dt>' in page


@in_folder
def test_refused(at):
    path = write(fraction_image(), at("in.vti"))
    refused(1, "Supported formats: .html, .htm.", path, at("out.vtu"), "--report", at("mesh.txt"))
    for ranks in (1, 2):
        refused(4, at("no/mesh.html") + ": No such file", path, at("out.vtu"), "--report",
                at("no/mesh.html"), ranks=ranks)
        os.symlink("/dev/full", at("full.html"))
        refused(4, at("full.html") + ": No space left on device", path, at("out.vtu"), "--report",
                at("full.html"), "--quiet", ranks=ranks)
        os.remove(at("full.html"))


if __name__ == "__main__":
    main(globals())
