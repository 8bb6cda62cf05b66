"""Rules of the structure: allowed includes, dependencies of Grid, installed headers, lengths of
files."""
import ast
import collections
import os
import re

# Modules of Grid and Mesher, from bottom to top. A module may include only modules before it; the
# root of Mesher is above all its modules.
RANKS = ("Parallel/Ranks",)
GRID = RANKS + tuple("Grid/" + module for module in (
    "Base", "Surfaces", "Fractions", "Octree", "Labels"))
MODULES = tuple("Mesher/" + module for module in (
    "Elements", "Elements/Hex", "Elements/Tet", "Interface", "SharpFeatures", "GivenSurfaces",
    "Geometry", "Smoothing", "Smoothing/Hex", "Smoothing/Tet", "Volumes", "Options", "TetGen",
    "Input", "Materials", "Levels", "Report", "Report/Gather", "Report/Sets", "Report/Fragments",
    "State/Transfer", "State", "Modify", "Phases"))
MESHER = MODULES + ("Mesher",)
IN_MODULES = frozenset(GRID + MODULES)
BASE = RANKS + ("Grid/Base",)
MESHES = GRID + MESHER
WITH_MODULES = ("Grid", "Mesher", "Parallel", "Testing")

# Other folders that a folder may include.
ALLOWED = {place: MESHES[:level] for level, place in enumerate(MESHES)}
ALLOWED.update({
    "Shapes": BASE + ("Grid/Surfaces", "Grid/Fractions"),
    "Parallel/Mpi": BASE,
    "Parallel/Vtk": BASE + ("Parallel/Mpi",),
    "Filters/Data": MESHES + ("Parallel/Vtk",),
    "IO": BASE + MESHER,
    "IO/GridFiles": BASE + ("IO",),
    "IO/Images": BASE + MESHER + ("IO",),
    "IO/Blocks": BASE + MESHER + ("IO",),
    "IO/Labels": BASE + ("Mesher/Input", "Mesher/Report", "IO"),
    "IO/Meshes": BASE + MESHER + ("IO",),
    "IO/Report": BASE + MESHER + ("IO", "IO/Meshes"),
    "IO/Surfaces": BASE + ("Grid/Surfaces", "IO", "IO/GridFiles"),
    "Filters": MESHES + ("Shapes", "Parallel/Vtk", "IO/Blocks", "IO/Labels", "Filters/Data"),
    "Filters/Files": BASE + MESHER + (
        "Parallel/Vtk", "IO", "IO/Images", "IO/Meshes", "Filters/Data"),
    "InSitu": BASE + MESHER + ("Parallel/Mpi", "IO/Labels", "IO/Meshes"),
    "InSitu/Catalyst": BASE + ("Parallel/Mpi", "InSitu"),
    "Program": BASE + MESHER + (
        "Parallel/Vtk", "Parallel/Mpi", "IO", "IO/Blocks", "IO/GridFiles", "IO/Images",
        "IO/Labels", "IO/Meshes", "IO/Report", "IO/Surfaces", "Filters", "Filters/Data",
        "Grid/Surfaces", "Shapes"),
    "Plugin": ("Filters", "Mesher/Input", "Mesher/Materials", "Mesher/Options"),
    "python": MESHES + (
        "Shapes", "IO", "IO/Blocks", "IO/GridFiles", "IO/Labels", "IO/Meshes", "IO/Report",
        "IO/Surfaces"),
    "Examples": ("InSitu", "InSitu/Catalyst"),
    "Testing/Support": MESHES + ("Shapes",),
    "Testing/Inputs": MESHES,
    "Testing/Grid": MESHES + ("Shapes", "Testing/Support"),
    "Testing/Shapes": BASE + ("Grid/Surfaces", "Grid/Fractions", "Shapes", "Testing/Support"),
    "Testing/Fuzz": MESHES + (
        "Shapes", "IO", "IO/Blocks", "IO/GridFiles", "IO/Images", "IO/Labels", "IO/Meshes",
        "IO/Report", "IO/Surfaces", "Filters", "InSitu", "Program", "Testing/Inputs",
        "Testing/Support"),
    "Testing/Benchmarks": MESHES + (
        "IO", "IO/Images", "IO/Surfaces", "Shapes", "Filters", "Testing/Inputs", "Testing/Support"),
    "Testing/IO": MESHES + (
        "Shapes", "IO", "IO/Blocks", "IO/GridFiles", "IO/Images", "IO/Labels", "IO/Meshes",
        "IO/Report", "IO/Surfaces", "Testing/Inputs", "Testing/Support"),
    "Testing/Mesher": MESHES + ("Shapes", "Testing/Fuzz", "Testing/Inputs", "Testing/Support"),
    "Testing/Parallel": BASE + ("Parallel/Vtk", "Testing/Support"),
    "Testing/Digests": MESHES + ("Shapes", "Testing/Inputs"),
    "Testing/InSitu": BASE + ("Parallel/Vtk", "Filters", "Filters/Data", "InSitu",
                              "InSitu/Catalyst"),
    "Testing/Program": MESHER + ("InSitu", "Program"),
})

# PLAIN: folders without VTK. WITHOUT_MPI: folders without VTK and MPI.
WITHOUT_MPI = MESHES + (
    "Shapes", "IO", "IO/Blocks", "IO/GridFiles", "IO/Images", "IO/Labels", "IO/Meshes", "IO/Report",
    "IO/Surfaces", "python",
    "Testing/IO", "Testing/Inputs", "Testing/Support", "Testing/Grid", "Testing/Mesher",
    "Testing/Shapes")
PLAIN = WITHOUT_MPI + ("Parallel/Mpi", "InSitu")
VTK = re.compile(r"(vtk|paraview|pv|pq)", re.IGNORECASE)
MPI = re.compile(r"mpi", re.IGNORECASE)
INCLUDE = re.compile(r'\s*#\s*include\s*([<"])([^>"]+)')

CODE = (".h", ".hpp", ".cxx", ".cpp", ".c")
SOURCES = CODE + (".f90", ".py", ".xml", ".txt", ".cmake")
LONGEST = 650 # lines
MOST_AT_ROOT = 5  # files of Mesher outside its modules
MOST_IN_FOLDER = 40 # files
# folders in which each source has a header of its name
HAVE_HEADERS = MESHES + ("Shapes", "Parallel/Vtk", "IO", "IO/GridFiles", "IO/Labels",
                         "IO/Meshes", "IO/Report", "IO/Surfaces", "Filters/Data", "Filters/Files")
# Sources without a test of their header; the list may only become shorter.
UNTESTED = "Testing/Structure/untested_sources.txt"
# Tests that include modules above their own; no test may be added.
HIGH_TESTS = frozenset("Testing/%sTest.cxx" % name for name in (
    "Grid/Base/PagedArray", "Grid/Fractions/CellDivision", "Grid/Labels/NarrowVoid",
    "Grid/Labels/SmallLabels", "Mesher/Modify/SecondOrderAccuracy",
    "Mesher/Report/Gather/GatherMesh", "Mesher/Report/MeshFacets",
    "Mesher/Report/PeriodicFragments", "Mesher/Report/Sets/NamedSurfaces",
    "Mesher/Smoothing/AttachFeatures",
    "Mesher/Volumes/FreeFragments", "Mesher/Volumes/LeafVolumes"))
PACKAGE = "python/volume_fraction_mesh"
# Headers that users of the installed package include, and the list of the installed headers.
PUBLIC = ("Mesher/Mesher.h", "Mesher/Input/InputLevels.h", "Mesher/Input/PlainArrays.h",
          "Mesher/Phases/MeshOfCells.h", "Grid/Base/ThreadRuntime.h", "InSitu/HostGrid.h")
INSTALLED = re.compile(r"vfm_install_library\(\w+ \w+ (\.+)((?:\s+[\w/]+\.h)*)\)")


def read_tree(root):
    """Returns {path: lines} of all sources; other files in Mesher have no lines."""
    tree = {}
    for folder, folders, files in os.walk(root):
        folders[:] = [f for f in folders if not f.startswith((".", "build"))
                      and f not in ("out", "__pycache__")]
        if "CMakeCache.txt" in files:
            folders[:], files = [], []
        for name in files:
            path = os.path.relpath(os.path.join(folder, name), root).replace(os.sep, "/")
            if name.endswith(SOURCES):
                with open(os.path.join(root, path), encoding="utf-8") as file:
                    tree[path] = file.readlines()
            elif path.startswith("Mesher/"):
                tree[path] = []
    return tree


def place_of(path):
    """Returns the module or folder of a file."""
    folders = path.split("/")[:-1]
    for depth in (3, 2):
        if "/".join(folders[:depth]) in ALLOWED:
            return "/".join(folders[:depth])
    return "/".join(folders[:2 if folders and folders[0] in WITH_MODULES else 1])


def find_file(tree, folders, path, name):
    """Returns the file that an include names, or None.

    It is in the folder of the including file, or in one of `folders`.
    """
    beside = os.path.normpath(os.path.join(os.path.dirname(path), name))
    if beside in tree:
        return beside
    found = [os.path.join(folder, name) for folder in folders if os.path.join(folder, name) in tree]
    return min(found, key=lambda other: (place_of(other) != place_of(path), other), default=None)


def list_includes(tree):
    """Yields (path, "path:line", bracket, name, file or None) for each include.

    Modules are not searched as folders.
    """
    folders = {os.path.dirname(path) for path in tree} - IN_MODULES
    folders |= {"", *(place.split("/")[0] for place in IN_MODULES)}
    for path in sorted(tree):
        for number, line in enumerate(tree[path] if path.endswith(CODE) else (), 1):
            match = INCLUDE.match(line)
            if match:
                bracket, name = match.groups()
                yield (path, "%s:%d" % (path, number), bracket, name,
                       find_file(tree, folders, path, name))


def find_include_problem(path, bracket, name, file):
    """Returns the problem of an include, or an empty text."""
    place = place_of(path)
    if place in PLAIN and VTK.match(name):
        return "%s does not know VTK: %s" % (place, name)
    if place in WITHOUT_MPI and MPI.match(name):
        return "%s does not know MPI: %s" % (place, name)
    if file is None or bracket == "<":
        return "there is no %s" % name if bracket == '"' and place in PLAIN else ""
    other = place_of(file)
    if other in IN_MODULES and name != file.split("/", 1)[1]:
        return "%s does not name its module" % name
    if other != place and other not in ALLOWED.get(place, ()):
        return "%s must not include %s of %s" % (place, name, other)
    return ""


def find_circles(after):
    """Returns a message for each circle; `after`: {file: files that it includes or imports}."""
    done, problems = set(), []

    def visit(path, trail):
        if path in trail:
            problems.append("circle: " + " > ".join(trail[trail.index(path):] + [path]))
        elif path not in done:
            for other in after.get(path, ()):
                visit(other, trail + [path])
            done.add(path)

    for path in sorted(after):
        visit(path, [])
    return problems


def map_includes(tree):
    """Returns the files that each file includes."""
    after = {}
    for path, _, bracket, _, file in list_includes(tree):
        if bracket == '"' and file:
            after.setdefault(path, []).append(file)
    return after


def map_imports(tree):
    """Returns the modules of the Python package that each module imports: at load time, in
    functions, and for types only."""
    after = {}
    for path in tree:
        if path.startswith(PACKAGE + "/") and path.endswith(".py"):
            for node in ast.walk(ast.parse("".join(tree[path]))):
                if isinstance(node, ast.ImportFrom) and node.level:
                    folder = "/".join(path.split("/")[:-node.level])
                    names = [node.module] if node.module else [alias.name for alias in node.names]
                    files = ("%s/%s.py" % (folder, name.replace(".", "/")) for name in names)
                    after.setdefault(path, []).extend(file for file in files if file in tree)
    return after


LEXEMES = re.compile(
    r"""//[^\n]*|/\*.*?\*/|R"\(.*?\)"|"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])'|[{};]|[^{};"'/]+|.""",
    re.DOTALL)
SCOPE = re.compile(
    r"(?:^|\s)(namespace|struct|class|enum class|enum|union)(?:\s+[A-Z_]+)?(?:\s+(\w[\w:]*))?"
    r"(?:\s+final)?\s*(?::[^:].*)?$", re.DOTALL)
TEMPLATE = re.compile(r"template\s*<.*>\s*(?=struct|class|union)", re.DOTALL)


def read_scope(statement):
    """Returns (kind, name) of the scope that a statement opens.

    Both are empty for scopes without a relevant name, such as functions and specializations.
    """
    match = SCOPE.search(TEMPLATE.sub("", statement).strip())
    return (match.group(1), match.group(2) or "") if match else ("", "")


def list_types(lines):
    """Yields the types that a C++ file defines in named namespaces, with their namespaces.

    Macros are not expanded.
    """
    text = "".join(line for line in lines if not line.lstrip().startswith("#"))
    scopes, statement = [], ""  # for each open brace: the namespace, or None
    for match in LEXEMES.finditer(text):
        token = match.group()
        if token == "{":
            kind, name = read_scope(statement)
            if kind not in ("", "namespace") and name and "::" not in name and None not in scopes:
                yield "::".join(scopes + [name])
            scopes.append(name if kind == "namespace" and name else None)
        elif token == "}" and scopes:
            scopes.pop()
        if token in ("{", "}", ";"):
            statement = ""
        elif not token.startswith(("//", "/*")):
            statement += token


def find_twice(tree):
    """Returns a message for each type that is defined twice in one namespace."""
    places = {}
    for path in sorted(tree):
        if path.endswith(CODE) and not path.startswith(("Testing/", "Examples/")):
            for name in list_types(tree[path]):
                places.setdefault(name, []).append(path)
    return ["%s is in %s" % (name, " and ".join(paths)) for name, paths in sorted(places.items())
            if len(paths) > 1 and "::" in name]


def find_bare_sources(tree):
    """Returns a message for each source that has no header of its name and is not a program."""
    return ["%s has no header of its name" % path for path in sorted(tree)
            if place_of(path) in HAVE_HEADERS and path.endswith(".cxx")
            and path[:-4] + ".h" not in tree
            and not any(line.startswith("int main(") for line in tree[path])]


def find_untested(tree):
    """Returns messages for sources of Grid, Mesher and Parallel/Ranks whose header no test
    includes, and which UNTESTED does not list, or the reverse."""
    tested = {file for path, files in map_includes(tree).items()
              if path.startswith("Testing/") and path.endswith("Test.cxx") for file in files}
    found = {path for path in tree if place_of(path) in IN_MODULES and path.endswith(".cxx")
             and path[:-4] + ".h" in tree and path[:-4] + ".h" not in tested}
    listed = {line.strip() for line in tree.get(UNTESTED, ())}
    return (["no test includes the header of %s" % path for path in sorted(found - listed)] +
            ["%s lists %s in vain" % (UNTESTED, path) for path in sorted(listed - found)])


def find_high_tests(tree):
    """Returns a message for each test of a module that includes a module above it."""
    problems = []
    for path, at, _, name, file in list_includes(tree):
        place = place_of(path.removeprefix("Testing/"))
        if (path.startswith("Testing/") and path.endswith("Test.cxx") and place in IN_MODULES
                and file and place_of(file) in MESHES and path not in HIGH_TESTS
                and MESHES.index(place_of(file)) > MESHES.index(place)):
            problems.append("%s: a test of %s must not include %s" % (at, place, name))
    return problems


def find_crowds(tree):
    """Returns a message for each folder with too many files."""
    counts = collections.Counter(os.path.dirname(path) for path in tree)
    return ["%s has %d files" % (folder, count) for folder, count in sorted(counts.items())
            if count > MOST_IN_FOLDER]


def find_install_problems(tree):
    """Returns messages for headers that are installed but not needed, or needed but not installed.

    Headers beside HostGrid.h are installed elsewhere.
    """
    needed, left, after = set(), [path for path in PUBLIC if path in tree], map_includes(tree)
    while left:
        path = left.pop()
        if path not in needed:
            needed.add(path)
            left += after.get(path, ())
    needed = {path for path in needed if place_of(path) in MESHES}
    installed = {os.path.normpath(os.path.join(os.path.dirname(path), folder, name))
                 for path in tree if path.endswith("CMakeLists.txt")
                 for folder, names in INSTALLED.findall("".join(tree[path]))
                 for name in names.split()}
    return (["%s is not installed (vfm_install_library)" % path
             for path in sorted(needed - installed)] +
            ["%s is installed, but no public header includes it" % path
             for path in sorted(installed - needed)])


def find_problems(tree):
    """Returns all violations of the rules."""
    problems = ["%s has %d lines" % (path, len(lines)) for path, lines in sorted(tree.items())
                if len(lines) > LONGEST]
    places = {place_of(path) for path in tree if path.endswith(CODE)}
    problems += ["%s is not in the table" % place for place in sorted(places - set(ALLOWED))]
    at_root = [path for path in tree if place_of(path) == "Mesher"]
    if len(at_root) > MOST_AT_ROOT:
        problems.append("Mesher's root has %d files" % len(at_root))
    for path, at, bracket, name, file in list_includes(tree):
        problem = find_include_problem(path, bracket, name, file)
        if problem:
            problems.append("%s: %s" % (at, problem))
    problems += find_twice(tree) + find_bare_sources(tree) + find_crowds(tree)
    problems += find_untested(tree) + find_high_tests(tree)
    problems += find_install_problems(tree)
    return problems + find_circles(map_includes(tree)) + find_circles(map_imports(tree))
