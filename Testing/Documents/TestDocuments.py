"""The pages agree with the tree: links, indexes, names of files, commands and tests, options,
messages, and the files of the code structure."""
import ast
import fnmatch
import glob
import os
import re
import sys
import unittest

from prose import read_messages

ROOT = os.path.abspath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
sys.path.insert(0, os.path.join(ROOT, "scripts"))
from options import figures

PAGES = sorted(os.path.relpath(path, ROOT)
               for pattern in ("*.md", "Data/*.md", "python/*.md", "Documentation/**/*.md")
               for path in glob.glob(os.path.join(ROOT, pattern), recursive=True))
CODE = re.compile(r"^```.*?^```$|^ {4}.*?$", re.DOTALL | re.MULTILINE)
LINK = re.compile(r"\]\(([^)\s]+)\)")
QUOTED = re.compile(r"`([^`\n]+)`")
TOPS = ("Data", "Documentation", "Examples", "Filters", "Grid", "IO", "InSitu", "Mesher",
        "Parallel", "Plugin", "Shapes", "Testing", "python", "scripts")
NAMED = re.compile(r"(?<![\w./-])(?:%s)/[\w./*-]*\w" % "|".join(TOPS))
PLUGIN_FROM_HERE = re.compile(r"LoadPlugins?\([\"'](?!/)")
NUMBER = re.compile(r"\d[\d,]*(?:\.\d+)?(?:e-\d+)?")
BOUND = re.compile(r"\bbelow (%s)" % NUMBER.pattern)
# A number with a point, not a version like 2025.1, and an exponent or a percent sign.
DECIMAL = re.compile(r"(?<![\w.])(?!20\d\d\.)(\d+\.\d+)(e-?\d+| %)?(?!\w|\.\d)")
GIVEN = {"0.216": "a solid fraction"}  # decimals of user pages that are not measured
BARE_FRACTION = re.compile(r"(?<![\w.\])*])\.\d")
ENDINGS = ("", ".h", ".cxx", ".py")
LONGEST_README = 150  # lines
INDEX, EXAMPLES = "Documentation/README.md", "Documentation/user/examples.md"
OPTIONS, MESSAGES = "Documentation/reference/options.md", "Documentation/reference/messages.md"
# Sections of validation whose tables hold no figures.
WITHOUT_FIGURES = ("The calls", "The commands")
# A row of an option: its names in ParaView, Python, sculptor and C, values and default.
OPTION = re.compile(r"^\| (\w+)(?: \*advanced\*)? \| `(\w+)` \| `(--[^`]+)` \| `([^`]+)` \|",
                    re.MULTILINE)


def read(path):
    with open(os.path.join(ROOT, path), encoding="utf-8") as file:
        return file.read()


def prose(path):
    """A page without its code."""
    return CODE.sub("", read(path))


def anchor(heading):
    """Returns the anchor that GitHub makes of a heading."""
    return re.sub(r"[^\w\- ]", "", heading.strip().lower()).replace(" ", "-")


def anchors(path):
    return {anchor(heading) for heading in re.findall(r"^#+ (.*)$", read(path), re.MULTILINE)}


def is_too_exact(number, unit):
    """Returns whether a decimal has more than two significant digits; three are allowed if the
    first is 1, and for numbers above one without a unit, such as versions."""
    digits = number.replace(".", "").lstrip("0")
    return len(digits) > (3 if digits[:1] == "1" or (not unit and float(number) >= 1) else 2)


def list_exact_decimals(text):
    """Returns the decimals in prose and tables that have too many digits for a measured figure."""
    text = LINK.sub("]", QUOTED.sub("", CODE.sub("", text)))
    return [number + unit for number, unit in DECIMAL.findall(text)
            if number not in GIVEN and is_too_exact(number, unit)]


def is_rounded(number, figures):
    """Returns whether one of these figures, rounded to the digits of the number, gives it."""
    plain = number.replace(",", "")
    if "." in plain or "e" in plain:
        digits, _, exponent = plain.partition("e")
        step = 10.0 ** (int(exponent or 0) - len(digits.partition(".")[2]))
    else:
        step = 10.0 ** (len(plain) - len(plain.rstrip("0")))
    return any(abs(float(plain) - figure) < 0.501 * step for figure in figures)


def list_sections(pages):
    """Returns the sections of these pages."""
    return [section for page in pages
            for section in re.split(r"^## ", read(page), flags=re.MULTILINE)]


def headers():
    """The folder and name of each header of the product."""
    for top in sorted({*TOPS, "Program"} - {"Examples", "Testing"}):
        for path, _, names in os.walk(os.path.join(ROOT, top)):
            yield from ((os.path.relpath(path, ROOT), name) for name in sorted(names)
                        if name.endswith(".h"))


def texts(ending, *folders):
    """Returns the texts of all files below these folders whose names have this ending."""
    for folder in folders:
        for path, _, names in os.walk(os.path.join(ROOT, folder)):
            yield from (read(os.path.join(path, name)) for name in names if name.endswith(ending))


def google_tests():
    """Returns Suite.Test of all sources, including parametrised and disabled tests."""
    found = set()
    for text in texts(".cxx", "Testing"):
        found.update(".".join(names)
                     for names in re.findall(r"\bTEST(?:_[FP])?\((\w+),\s*(\w+)\)", text))
    return found


class Documents(unittest.TestCase):
    def check(self, problems):
        self.assertGreater(len(PAGES), 10)
        self.assertFalse(problems, "\n" + "\n".join(problems))

    def test_links(self):
        problems = []
        for page in PAGES:
            for link in LINK.findall(prose(page)):
                file, _, heading = link.partition("#")
                target = os.path.normpath(os.path.join(os.path.dirname(page),
                                                       file)) if file else page
                if "://" not in link and not os.path.exists(os.path.join(ROOT, target)):
                    problems.append("%s: there is no %s" % (page, link))
                elif heading and "://" not in link and heading not in anchors(target):
                    problems.append("%s: no heading %s" % (page, link))
        self.check(problems)

    def test_named_files_exist(self):
        problems = []
        for page in PAGES:
            for name in NAMED.findall(read(page)):
                if not any(glob.glob(os.path.join(ROOT, name + ending)) for ending in ENDINGS):
                    problems.append("%s: there is no %s" % (page, name))
        self.check(problems)

    def test_every_page_is_in_the_index(self):
        linked = {os.path.normpath(os.path.join("Documentation", link.partition("#")[0]))
                  for link in LINK.findall(read(INDEX))}
        self.check(["%s is not in %s" % (page, INDEX) for page in PAGES
                    if page not in linked | {INDEX, "README.md"}])

    def test_every_example_is_in_the_index(self):
        text = read(EXAMPLES)
        named = {name.split("/")[-1] for name in re.findall(r"[\w./]*\w", text)}
        files = [os.path.relpath(os.path.join(path, name), ROOT)
                 for top in ("Examples", "python/examples")
                 for path, folders, names in os.walk(os.path.join(ROOT, top))
                 if "__pycache__" not in path for name in names]
        self.assertGreater(len(files), 30)
        # The program impact is one example.
        self.check(["%s is not in %s" % (file, EXAMPLES) for file in files
                    if os.path.basename(file) not in named
                    and not file.startswith("Examples/impact/")])
        self.assertIn("`Examples/impact`", text)

    def test_messages_exist(self):
        """The parts of each message between variable parts are in a string of the sources."""
        folders = ("Grid", "Mesher", "Filters", "IO", "Program", "Shapes")
        strings = " ".join(message for top in folders for text in texts((".cxx", ".h"), top)
                           for message in read_messages(text))
        strings += " ".join(node.value for text in texts(".py", "python/volume_fraction_mesh")
                            for node in ast.walk(ast.parse(text))
                            if isinstance(node, ast.Constant) and isinstance(node.value, str))
        rows = [line.split("|")[1] for line in read(MESSAGES).splitlines()
                if line.startswith("| *")]
        self.assertGreater(len(rows), 20)
        parts = [part.strip(" ,:'") for row in rows for message in re.findall(r"\*([^*]+)\*", row)
                 for part in message.split("..")]
        self.check(["%s: no message has %r" % (MESSAGES, part) for part in parts
                    if part not in strings])

    def test_pictures_are_shown(self):
        shown = {os.path.basename(link) for page in PAGES for link in LINK.findall(read(page))}
        self.check(sorted(set(os.listdir(os.path.join(ROOT, "Documentation", "gallery"))) - shown))

    def test_every_header_is_in_a_table(self):
        """scripts/generate writes the rows; folders and headers without a comment are missed."""
        page = read("Documentation/maintainer/code-structure.md")
        sections = page[page.index("files: generated"):].split("\n### ")[1:]
        named = {folder.split("\n", 1)[0]: set(re.findall(r"^\| `([^`]+)`", folder, re.MULTILINE))
                 for folder in sections}
        self.assertIn("Mesher/Elements/Tet", named)
        self.check(["%s/%s is in no table" % (folder, name) for folder, name in headers()
                    if not {name, name[:-2]} & named.get(folder, set())])

    def test_programs_and_tests_exist(self):
        tests, problems = google_tests(), []
        targets = " ".join(texts("CMakeLists.txt", *TOPS))
        for page in PAGES:
            text = read(page)
            problems += ["%s: no program %s" % (page, name)
                         for name in re.findall(r"build/bin/(\w+)", text)
                         if not re.search(r"\b%s\b" % name, targets)]
            for pattern in re.findall(r"--gtest_filter='([^']+)'", text):
                # The part before a slash is an instance, which a star also matches; a part after
                # the name of a test is a parameter.
                pattern = re.sub(r"(\.\w+)/[^/]*$", r"\1", pattern)
                if not any(fnmatch.fnmatchcase(prefix + name, pattern) for name in tests
                           for prefix in ("", "All/")):
                    problems.append("%s: no test %s" % (page, pattern))
            problems += ["%s: no test %s" % (page, name)
                         for name in re.findall(r"\bctest\b[^`\n]* -R ([\w.]+)", text)
                         if not glob.glob(os.path.join(ROOT, "Testing", "**",
                                                       "Test%s*.py" % name.split(".")[-1]),
                                                       recursive=True)]
        self.check(problems)

    def test_fractions_begin_with_zero(self):
        problems = []
        for page in PAGES:
            problems += ["%s: %s" % (page, line.strip()) for line in prose(page).splitlines()
                         if BARE_FRACTION.search(QUOTED.sub("", line))]
        self.check(problems)

    def test_plugins_are_loaded_by_whole_paths(self):
        """Since 5.13 ParaView takes any other path for a name."""
        scripts = list(texts(".py", "Data", "Examples", "scripts"))
        self.assertGreater(len(scripts), 20)
        lines = "\n".join([*map(read, PAGES), *scripts]).splitlines()
        self.check(sorted({line.strip() for line in lines if PLUGIN_FROM_HERE.search(line)}))

    def test_options_exist(self):
        """The package and the C interface have the names of the page."""
        rows = OPTION.findall(read(OPTIONS))
        self.assertGreater(len(rows), 40)
        mesher = set(re.findall(r"^    (\w+): ", read("python/volume_fraction_mesh/_tets.py"),
                                re.MULTILINE))
        calls = set(re.findall(r"\w+", read("InSitu/Sculptor.h")))
        self.check(["%s: no keyword %s" % (OPTIONS, python) for _, python, _, _ in rows
                    if python not in mesher]
                   + ["%s: no call %s" % (OPTIONS, name) for _, _, _, name in rows
                      if name.endswith("()") and name[:-2] not in calls])

    def test_figures_of_the_readme_are_measured(self):
        """They are rounded figures of a section of validation that has the command of the row.
        Bounds are in any section."""
        page = read("README.md")
        table = page[page.index("## Figures"):page.index("## Gallery")]
        rows = [line.split("|")[2:4] for line in table.splitlines() if line.startswith("| ")][1:]
        self.assertEqual(len(rows), 7)
        sections = list_sections(path for path in PAGES if "/validation/" in path)
        known, problems = set(NUMBER.findall(" ".join(sections))), []
        for text, command in rows:
            measured = " ".join(section for section in sections if command.strip(" `") in section)
            values = {float(number.replace(",", "")) for number in NUMBER.findall(measured)}
            problems += ["%s is in no page of validation" % number
                         for number in BOUND.findall(text) if number not in known]
            problems += ["%s is in no section with %s" % (number, command)
                         for number in NUMBER.findall(BOUND.sub("", text))
                         if not is_rounded(number, values)]
        self.check(problems)

    def test_user_pages_have_rounded_figures(self):
        """Two digits, so that a change of meshes does not change these pages."""
        pages = [page for page in PAGES
                 if page.startswith(("README.md", "python/", "Documentation/user/"))]
        self.assertGreater(len(pages), 10)
        self.check(["%s: round %s, or move it to Documentation/validation" % (page, number)
                    for page in pages for number in list_exact_decimals(read(page))])

    def test_tables_of_figures_are_generated(self):
        """scripts/generate fills them from the files of results; no other table has numbers."""
        problems, used = [], set()
        for page, fill in figures.files().items():
            text = read(page)
            used.update(name for _, name, _ in figures.MARKED.findall(text))
            if fill(text) != text:
                problems.append("%s is not current, run scripts/generate" % page)
            for section in re.split(r"^#+ ", figures.MARKED.sub("", text), flags=re.MULTILINE):
                if section.split("\n", 1)[0] not in WITHOUT_FIGURES:
                    problems += ["%s: not from a file of results: %s" % (page, row) for row
                                 in re.findall(r"^\|.*\d.*", section, re.MULTILINE)]
        self.assertGreater(len(used), 50)
        results = os.path.join(ROOT, figures.RESULTS)
        stored = {os.path.relpath(path, results)[:-len(".csv")]
                  for path in glob.glob(os.path.join(results, "*", "*.csv"))}
        self.check(problems + ["no page shows " + name for name in sorted(stored ^ used)])

    def test_readme_is_short(self):
        self.assertLessEqual(read("README.md").count("\n"), LONGEST_README)


class Searches(unittest.TestCase):
    """The tests above find what they search for."""

    def test_fraction(self):
        for text in (" .7 cell", "(.2, 1)", "| .113 |", "-.5"):
            self.assertTrue(BARE_FRACTION.search(text), text)
        for text in ("0.7", "mesh.e.4.0", "1.5", "[..](x).2"):
            self.assertFalse(BARE_FRACTION.search(text), text)

    def test_named_file(self):
        self.assertEqual(
            NAMED.findall("see `Parallel/Ranks/Ranks.h`, `build/Data/x` and Examples/impact."),
            ["Parallel/Ranks/Ranks.h", "Examples/impact"])

    def test_exact_decimal(self):
        for text in ("SJ 0.523", "| 0.750 |", "-2.650 %", "1.0512", "2.35e-2", "137.067 GPa"):
            self.assertEqual(len(list_exact_decimals(text)), 1, text)
        for text in ("SJ 0.52", "0.00148", "1.05e-2", "2.7 %", "ParaView 5.11.0", "5.11", "2025.1",
                     "0.216", "`0.523`", "[0.5](page.md#0.523)", "    print 0.523",
                     "```\n0.523\n```"):
            self.assertEqual(list_exact_decimals(text), [], text)

    def test_rounded(self):
        for number, figure in (("0.75", 0.748), ("0.40", 0.4), ("140", 138.8), ("1e-7", 1.2e-7),
                               ("280,000", 275000), ("64", 64)):
            self.assertTrue(is_rounded(number, [figure]), number)
        for number, figure in (("0.75", 0.756), ("0.40", 0.41), ("140", 146), ("1e-7", 1e-6),
                               ("280,000", 286000), ("64", 65)):
            self.assertFalse(is_rounded(number, [figure]), number)

    def test_path_of_a_plugin(self):
        self.assertTrue(PLUGIN_FROM_HERE.search('LoadPlugin("build/lib/VolumeFractionMesh.so"'))
        self.assertFalse(PLUGIN_FROM_HERE.search('LoadPlugin(os.path.abspath("build'))

    def test_anchor(self):
        self.assertEqual(anchor("Sculpt's published cases"), "sculpts-published-cases")
        self.assertEqual(anchor("Refined grids (AMR)"), "refined-grids-amr")

    def test_options(self):
        page = read(OPTIONS)
        for row in ("| Method | `method` | `--tetmesh [METHOD]` | `Method` "
                    "| TetGen, Cells, Lattice | Lattice |",
                    "| IsoValue *advanced* | `iso_value` | `--iso V` | `IsoValue` "
                    "| number above 0 and below 1 | 0.5 |",
                    "| Dimensions | 3 integers, 0 or more | 0 0 0 |"):
            self.assertIn(row, page)
        self.assertNotIn("FileName", page)


if __name__ == "__main__":
    unittest.main()
