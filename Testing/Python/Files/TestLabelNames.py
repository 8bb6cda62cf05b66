"""Names of labels from tables in every supported form.

The names become MaterialNames and names of blocks and sets in files. An error in a table is
reported with its line, on all ranks.
"""
from xml.etree import ElementTree

import numpy as np

from image_files import save, write_nrrd
from inp_file import InpFile
from sculptor_program import mesh_file, refused, sculptor
from vfmtest import VolumeFractionToTet, exodus_parts, image, in_folder, main, mesh_of, run

LABELS = np.zeros((6, 6, 6), "i4")
LABELS[1:5, 1:5, 1:3], LABELS[1:5, 1:5, 3:5], LABELS[1:5, 3:5, 3:5] = 3, 7, 12
DATA = image({"id": LABELS})
NAMES = ["Frontal Pole", "Insula", "Material 12"]

TABLES = {
    "blanks": "# a comment\n\n3 Frontal Pole\n 7   Insula \n",
    "tabs": "0\tUnclassified\r\n3\tFrontal Pole\t255\r\n7\tInsula\t12\r\n99\tNowhere\r\n",
    "commas": "index,name,x\n3,Frontal Pole,1\n7, Insula,2\n",
    "semicolons": "3;Frontal Pole;rest\n7;Insula\n",
    "quotes": '3,"Frontal Pole",1\n7,"Insula",2\n',
    "ITK-SNAP": '################\n    0     0    0    0        0  0  0    "Clear Label"\n'
                '    3   255    0    0        1  1  1    "Frontal Pole"\n'
                '    7     0  255    0      0.5  1  1    "Insula"\n',
    "XML": '<?xml version="1.0" encoding="ISO-8859-1"?>\n'
           '<atlas version="1.0"><header><name>A</name><type>Probabilistic</type></header>\n'
           '<data><label index="2" x="48" y="94" z="35">Frontal\n  Pole</label>\n'
           '<label index="6" x="1" y="2" z="3">Insula</label>\n'
           "</data></atlas>\n",
    "XML of labels": '<atlas><header><type>Label</type></header><data>\n'
                     '<label index="3">Frontal P&#111;le</label>\n'
                     '<label index="7">Insula</label></data></atlas>\n',
}
WORDS = {  # names of one word, followed by numbers
    "FreeSurfer": "#No. Label Name:   R   G   B   A\n\n0   Unknown   0 0 0 0\n"
                  "3   Left-Cortex   205 62 78 0\n7   Insula   230 148 34 0\n",
    "MRIcron": "3 Left-Cortex 2001\n7 Insula 2002\n",
}


def names(text, at, **properties):
    return mesh_of(DATA, MaterialIdArray="id", LabelNames=save(at("names"), text.encode()),
                   **properties).field("MaterialNames")


@in_folder
def test_kinds_of_tables(at):
    """Each form of table gives the same names; labels without a name have a default."""
    for kind, text in TABLES.items():
        assert names(text, at) == NAMES, (kind, names(text, at))
    for kind, text in WORDS.items():
        assert names(text, at) == ["Left-Cortex", "Insula", "Material 12"], (kind, names(text, at))
    assert names("3 area 17\n7 area 18\n", at) == ["area 17", "area 18", "Material 12"]
    assert names("3 area 17\n7 Insula\n", at) == ["area 17", "Insula", "Material 12"]
    assert names("3 Größe\n7 Insula", at, make=VolumeFractionToTet,
                 Method="Lattice") == ["Größe", "Insula", "Material 12"]
    assert names("3 A\n", at, MeshVoid=1) == ["Void", "A", "Material 7", "Material 12"]


@in_folder
def test_fractions_have_their_own_names(at):
    """Tables of labels do not change the names of fractions."""
    data = image({"full": (LABELS > 0).astype(float)})
    result = mesh_of(data, VolumeFractionArrays=["full"], LabelNames=at("none"))
    assert result.field("MaterialNames") == ["full"]


@in_folder
def test_refused(at):
    """Errors in tables are reported with their line."""
    for text, problem in (
            ("3 A\n7 B\nx C\n",
             "line 3: it begins with 'x', which is not a label. Labels are integers from 0 to "
             "2147483647"),
            ("3 A\n-7 B\n", "line 2: it begins with '-7'"),
            ("Name 3\n3 A\n", "line 1: it begins with 'Name'"),
            ("3.5 A\n", "line 1: it begins with '3.5'"),
            ("9999999999 A\n", "line 1: it begins with '9999999999'"),
            ("3 A\n7\n", "line 2: label 7 has no name"),
            ("3 A\n7 B\n3 C\n", "line 3: label 3 is also in line 1."),
            ("3 A\n# B\n\n7 A\n", "line 4: the name 'A' also belongs to label 3 in line 1."),
            ("3 Material 12\n7 B\n", "Labels 3 and 12 are both called 'Material 12'"),
            ("", "the file is empty"), ("# nothing\n", "it contains no names of labels"),
            ("<html><p>x</html>\n", "it is not the XML file of an atlas"),
            ("<atlas><header><type>Label</type></header><data><label>A</label></data></atlas>\n",
             "element 1: it has no index or no name"),
            ("<atlas><header><type>Label</type></header><data><label index='3'>A</label>"
             "<label index='3'>B</label></data></atlas>\n",
             "element 2: label 3 is also in element 1.")):
        result = run(DATA, MaterialIdArray="id", LabelNames=save(at("names"), text.encode()))
        assert len(result.errors) == 1 and problem in result.errors[0], (text, result.errors)
        assert result.mesh.GetNumberOfCells() == 0
    result = run(DATA, MaterialIdArray="id", LabelNames=at("none"))
    assert "Cannot read the names of labels from %s: No such file" % at("none") in result.errors[
        0], result.errors


LATIN = ((b"3 M\xfcller\n7 Stra\xdfe \x80\n", ["Müller", "Straße €", "Material 12"], "line 1",
          "Müller"),
         ("3 Größe\n".encode() + b"7 rechts \xe4\n", ["Größe", "rechts ä", "Material 12"], "line 2",
          "rechts ä"),
         (b"\xef\xbb\xbf3 A\n7 B\n", ["A", "B", "Material 12"], None, None),
         (b"<atlas><header><type>Label</type></header><data><label index='3'>M\xfcller</label>"
          b"</data></atlas>", ["Müller", "Material 7", "Material 12"], None, None))
NO_TEXT = ((b"3 A\n7 \x81\n", "line 2: it is neither UTF-8 nor Windows-1252"),
           ("3 A\n".encode("utf-16"), "it is UTF-16. Save it as UTF-8."),
           (b"\xfe\xff\x003", "it is UTF-16. Save it as UTF-8."))


@in_folder
def test_encodings(at):
    """Tables in Latin-1 and Windows-1252 are converted with a warning; others are errors."""
    for text, expected, line, name in LATIN:
        result = run(DATA, MaterialIdArray="id", LabelNames=save(at("names"), text))
        assert result.field("MaterialNames") == expected, result.field("MaterialNames")
        assert len(result.warnings) == (1 if line else 0), result.warnings
        assert all(word in warning for warning in result.warnings
                   for word in (at("names"), line, "Windows-1252", name)), result.warnings
    for text, problem in NO_TEXT:
        result = run(DATA, MaterialIdArray="id", LabelNames=save(at("names"), text))
        assert len(result.errors) == 1 and problem in result.errors[0], (text, result.errors)


@in_folder
def test_encodings_in_files(at):
    """Files of a mesh whose label names were Latin-1 are UTF-8; sculptor warns once."""
    path = write_nrrd(at("a.nrrd"), LABELS.astype("u1"), (0, 0, 0))
    table = save(at("names.txt"), LATIN[0][0])
    for suffix in (".xdmf", ".msh", ".vtu", ".inp", ".k"):
        for ranks in (1, 3):
            result = sculptor(path, at("out" + suffix), "--label-names", table, "--quiet",
                              "--report", at("out.html"), ranks=ranks)
            assert result.returncode == 0 and result.stderr.count("\n") == 1, result
            assert result.stderr.startswith("sculptor: warning: ") and "Müller" in result.stderr
            for name in ("out" + suffix, "out.html"):
                with open(at(name), encoding="utf-8") as file:
                    text = file.read().lower()
                assert "ller" in text or name == "out.vtu", name  # which encodes its texts
    ElementTree.parse(at("out.xdmf"))
    for text, problem in NO_TEXT:
        refused(3, problem, path, at("out.vtu"), "--label-names", save(at("bad.txt"), text))


@in_folder
def test_sculptor(at):
    """The option of sculptor names materials in tables, files and errors, also on ranks."""
    path = write_nrrd(at("a.nrrd"), LABELS.astype("u1"), (0, 0, 0))
    table = save(at("names.txt"),
                 b"3\tPole, front (of it)\n7\tpole, FRONT (of it)\n12\t" + b"x" * 300 + b"\n")
    for ranks in (1, 3):
        printed = mesh_file(path, at("out.e"), "--label-names", table, "--single-file", ranks=ranks)
        assert "3 Pole, front (of it)" in printed, printed
        blocks = sorted(name for name, _ in exodus_parts(at("out.e")))
        # names as returned by the reader
        assert blocks == ["pole,_front_(of_it)", "pole,_front_(of_it)_7", "x" * 252 + "_12"], blocks
    mesh_file(path, at("out.inp"), "--label-names", table)
    sets = InpFile(at("out.inp")).element_sets
    assert {"POLE_FRONT_OF_IT", "POLE_FRONT_OF_IT_2", "X" * 80} <= set(sets), sorted(sets)
    save(at("bad.txt"), b"3 A\n3 B\n")
    for ranks in (1, 3):
        refused(3, "bad.txt, line 2: label 3 is also in line 1.", path, at("out.e"),
                "--label-names", at("bad.txt"), ranks=ranks)


main(globals())
