"""Writes the tables of files in Documentation/maintainer/code-structure.md: one row per file, with
the first sentence of the comment at its top.
"""
import ast
import os
import re

from options.table import ROOT, put, read

PAGE = "Documentation/maintainer/code-structure.md"
# Folders from bottom to top: a file includes files of folders above its own in this list only.
FOLDERS = (
    ("Parallel/Ranks", "Communication between ranks. It depends on nothing else."),
    ("Grid/Base", "Grids, memory, threads, exact sums and geometry. No file depends on fractions, "
                  "labels or meshes."),
    ("Grid/Surfaces", "Closed surfaces of triangles: their repair, edges, sides and thickness."),
    ("Grid/Fractions", "The contents of cells."),
    ("Grid/Octree", "The cells that are refined, and the hexes between levels."),
    ("Grid/Labels", "One material per cell."),
    ("Mesher/Elements", "The mesh, its ids and facets."),
    ("Mesher/Elements/Hex", "Hexahedra from labels."),
    ("Mesher/Elements/Tet", "Tetrahedra from labels or fractions."),
    ("Mesher/Geometry", "Surfaces, curves, vertices and smooth sides of a mesh; its quality; sides "
                        "of periodic meshes."),
    ("Mesher/Interface", "The position of the true interface."),
    ("Mesher/SharpFeatures", "Edges and corners found in fractions: "
                             "[algorithm](../theory/algorithm.md#sharp-edges-and-corners)."),
    ("Mesher/GivenSurfaces", "Targets, edges and lost parts of interfaces from the surfaces of the "
                             "input: [algorithm](../theory/algorithm.md#given-surfaces)."),
    ("Mesher/Smoothing", "The points that move, and the energies that move them."),
    ("Mesher/Smoothing/Hex", "The energies and active meshes of hexahedra, and transitions between "
                             "levels."),
    ("Mesher/Smoothing/Tet", "The energies and active meshes of tetrahedra."),
    ("Mesher/Volumes", "The volumes of fragments, and how smoothing and corrections reach them."),
    ("Mesher/TetGen", "Fragments filled by TetGen."),
    ("Mesher/Options", "The options of a run."),
    ("Mesher/Input", "Blocks of cells, and their distribution over ranks."),
    ("Mesher/Materials", "What arrays hold, and which of them are materials."),
    ("Mesher/Levels", "The levels of a refined grid."),
    ("Mesher/Report", "Reports, faces and parts of a finished mesh."),
    ("Mesher/Report/Fragments", "The table of fragments."),
    ("Mesher/Report/Gather", "A mesh as messages, and on one rank."),
    ("Mesher/Report/Sets", "Named surfaces, and pairs of periodic points."),
    ("Mesher/State/Transfer", "Transfer of state from cells to elements: "
                              "[state transfer](../theory/state-transfer.md)."),
    ("Mesher/State", "State arrays of the input, on the elements."),
    ("Mesher/Modify", "Changes of a finished mesh: layers, split interfaces, mid nodes."),
    ("Mesher/Phases", "The pipelines, which call the stages of all modules."),
    ("Mesher", "One run, from blocks to a mesh."),
    ("Shapes", "Solids with exact fractions. They depend on Grid/Base, Grid/Surfaces and "
               "Grid/Fractions only."),
    ("Parallel/Mpi", "Ranks over MPI, without VTK."),
    ("Parallel/Vtk", "Ranks over vtkMPIController, and the differences between versions of VTK."),
    ("IO", "Voxel files."),
    ("IO/Labels", "Tables of label names."),
    ("IO/GridFiles", "Checks of VTK's files before VTK's readers open them."),
    ("IO/Images", "Images of labels and fractions."),
    ("IO/Images/Pictures", "Pictures, TIFF stacks and slices."),
    ("IO/Blocks", "SpyPlot files and AMReX plotfiles."),
    ("IO/Meshes/Files", "Parts of all writers of meshes."),
    ("IO/Meshes/Particles", "Particles of all writers, and files with only particles."),
    ("IO/Meshes/Vtk", "VTK's XML files."),
    ("IO/Meshes/Exodus", "Exodus files, with netCDF."),
    ("IO/Meshes/Gmsh", "Files of Gmsh."),
    ("IO/Meshes/OpenFoam", "Cases of OpenFOAM."),
    ("IO/Meshes/Polyhedra", "Polyhedra around the nodes of tetrahedra."),
    ("IO/Meshes/Decks", "Input files of solvers."),
    ("IO/Meshes/Xdmf", "XDMF files for dolfinx."),
    ("IO/Meshes/Surfaces", "Surfaces of materials."),
    ("IO/Meshes", "Files of meshes."),
    ("IO/Report", "Quality reports of meshes."),
    ("IO/Surfaces", "Readers of surfaces of triangles."),
    ("Filters/Data", "VTK meshes as plain arrays."),
    ("Filters", "The VTK filters and sources."),
    ("Filters/Files", "VTK readers and writers."),
    ("InSitu", "The C, C++ and Fortran library."),
    ("InSitu/Catalyst", "Adaptors for Catalyst."),
    ("InSitu/Catalyst/Legacy", "Legacy Catalyst."),
    ("InSitu/Catalyst/Catalyst2", "Catalyst 2."),
    ("Program", "The command-line tool `sculptor`."),
    ("Program/Process", "The process of the program: signals and standard streams."),
    ("Program/VtkFiles", "Compressed values of VTK's files."),
    ("Plugin", "The ParaView plugin."),
    ("Plugin/Domains", "Domains of the plugin's properties."),
    ("python/src", "The compiled module of the Python package."),
    ("python/volume_fraction_mesh", "The Python package."),
    ("python/volume_fraction_mesh/_convert", "Meshes as objects of other packages."),
    ("python/volume_fraction_mesh/_readers", "Readers of files for `_read.py`."),
    ("python/volume_fraction_mesh/_plugins", "Plugins of other packages, which import them."),
    ("python/volume_fraction_mesh/_grains", "Orientations and phases of grains."),
)
HEADERS, SOURCES = (".h", ".hpp"), (".cxx", ".cpp")
COMMENT = re.compile(r"/\*\*?(.*?)\*/", re.DOTALL)
# A full stop ends a sentence where a capital follows, except after an initial, as in A. Name.
SENTENCE = re.compile(r"(?<![\s(][A-Z])[.](?=\s+[A-Z(*`])")
# Identifiers with underscores or of the standard library, and names of files.
CODE = re.compile(r"(?<![\w`*./])((?:\w+/)*\w[\w.]*\.(?:hpp|h|cxx|pyi|f90)\b|\w*_\w+(?:\.\w+)?"
                  r"|std::\w+(?:<[^>]*>)?)")


def list_files(folder):
    """Returns the names of a folder's headers, Python modules, and sources without a header."""
    names = sorted(os.listdir(os.path.join(ROOT, folder)), key=str.lower)
    stems = {os.path.splitext(name)[0] for name in names if name.endswith(HEADERS)}
    return [name for name in names if name.endswith(HEADERS + (".py",))
            or name.endswith(SOURCES) and os.path.splitext(name)[0] not in stems]


def comment_of(path):
    """Returns the first paragraph of the comment at the top of a file, or ""."""
    text = read(path)
    if path.endswith(".py"):
        comment = ast.get_docstring(ast.parse(text)) or ""
    else:
        found = COMMENT.search(text)
        before = text[:found.start()] if found else "namespace"
        if re.search(r"^(namespace|class|struct)\b", before, re.MULTILINE):
            return ""
        comment = re.sub(r"^\s*\* ?", "", found.group(1), flags=re.MULTILINE).strip()
    return " ".join(re.split(r"\n\s*\n(?!\s*@brief)", comment)[0].split())


def describe(path):
    """Returns the first sentence of the comment of a file, without the name of the file."""
    text = re.sub(r"^@class.*?(?=@brief)|@brief\s+|^@file\s+\S+\s*", "", comment_of(path))
    text = re.sub(r"^@brief\s+", "", text)
    stem = os.path.splitext(os.path.basename(path))[0]
    text = re.sub(r"^%s(\.\w+)?:\s+" % re.escape(stem), "", text)
    text = SENTENCE.split(text)[0].rstrip(".:").replace("|", "\\|")
    if not CODE.match(text):
        text = text[:1].upper() + text[1:]
    return CODE.sub(r"`\1`", text)


def shown(name):
    """Returns the name of a file as the tables show it: Mesh for Mesh.h."""
    return name[:-2] if re.fullmatch(r"\w+\.h", name) else name


def make_tables():
    lines = []
    for folder, about in FOLDERS:
        rows = [(shown(name), describe(folder + "/" + name)) for name in list_files(folder)]
        lines += ["", "### " + folder, about, "", "| file | content |", "|---|---|"]
        lines += ["| `%s` | %s |" % row for row in rows if row[1]]
    return lines + [""]


def files():
    """Returns how the page becomes current, as a function of its text."""
    return {PAGE: lambda text: put(text, "files: generated", "end of files", make_tables())}
