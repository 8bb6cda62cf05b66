#!/usr/bin/env pvpython
"""Meshes the fields in Data and writes meshes and pictures into a folder.

usage: pvpython demo.py PLUGIN OUT [CASE ...]

Writes for each case
  OUT/CASE.vtu           hexahedral mesh
  OUT/CASE.e             Exodus file with element blocks, side sets and node sets
  OUT/CASE.inp           file for Abaqus and CalculiX
  OUT/CASE.csv           table of fragments
  OUT/CASE_surface.png   surface with the edges of the hexahedra
  OUT/CASE_cut.png       hexahedra inside, coloured by scaled Jacobian
Files of tetrahedra are named CASE_tets, without a picture of the surface. The first case also gives
OUT/CASE_fractions_and_mesh.png: input and mesh side by side. Files that are newer than the input,
the plugin and the scripts are not made again. Needs an X server.
"""
import glob
import os
import sys
import time

from paraview import simple
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(HERE)
sys.path.insert(0, os.path.join(ROOT, "Examples"))
import gerris_to_vthb
import pictures
from load_plugin import load_plugin
from need_files import need_files
from write_exodus import write_exodus


class Case:
    """A field of Data with the options of its mesh and the cameras of its pictures (direction to
    the camera, zoom)."""

    def __init__(self, name, file, arrays, tet_method, camera, zoom, cut_normal, cut_camera,
                 cut_zoom, options=None):
        self.name, self.file, self.arrays = name, os.path.join(ROOT, "Data", file), arrays
        self.tet_method = tet_method  # Cells replaces TetGen if the plugin was built without it
        self.options = options or {}  # properties of both filters
        self.camera, self.zoom = camera, zoom
        self.cut_normal, self.cut_camera, self.cut_zoom = cut_normal, cut_camera, cut_zoom


LEAST_DRAWN = 0.01  # smallest volume fraction of cells in the picture of the input

CASES = [
    Case("splash", "splash_3500us.vti", ["water"], "TetGen", (0.75, -1.0, 0.65), 1.1, (0, 1, 0),
         (0.3, -1.0, 0.5), 1.6),
    Case("ball_and_plate", "ball_and_plate.vti", ["ball", "plate"], "Lattice", (0.7, -1.0, 0.5),
         1.25, (0, 1, 0), (0.3, -1.0, 0.35), 1.5),
    Case("drop", "Gerris/impact_0.24.txt.gz", ["T"], "Lattice", (0.7, -1.0, 0.7), 1.25, (0, 1, 0),
         (0.3, -1.0, 0.3), 1.5),
    Case("fin", "fin.vti", ["body"], "Cells", (0.5, -1.0, 0.8), 1.3, (0, 1, 0), (0.2, -1.0, 0.3),
         1.5, {"Refinement": "Automatic", "FineInterfaces": 0}),
]


def is_newer(outputs, inputs):
    """Returns whether all outputs exist and no input is newer."""
    if not all(os.path.exists(path) for path in outputs):
        return False
    return min(map(os.path.getmtime, outputs)) > max(map(os.path.getmtime, inputs))


def read_mesh(path):
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def hex_filter(case, source):
    return VolumeFractionToHex(Input=source, VolumeFractionArrays=case.arrays, **case.options)


def tet_filter(case, source):
    tets = VolumeFractionToTet(Input=source, VolumeFractionArrays=case.arrays, **case.options)
    tets.Method = ("Cells" if case.tet_method == "TetGen" and not tets.GetPropertyValue("HasTetGen")
                   else case.tet_method)
    return tets


def open_field(case, out):
    """Returns a reader of the field: an image, or all levels of a file of Gerris."""
    if case.file.endswith(".vti"):
        return simple.XMLImageDataReader(FileName=[case.file])
    levels = os.path.join(out, case.name + ".vthb")
    gerris_to_vthb.main(case.file, levels)
    return simple.XMLUniformGridAMRReader(FileName=[levels], DefaultNumberOfLevels=0)


def make_mesh(case, source, make_filter, vtu, exodus, abaqus, table):
    mesher = make_filter(case, source)
    start = time.time()
    mesher.UpdatePipeline()
    elements = mesher.GetDataInformation().GetNumberOfCells()
    if elements == 0:
        sys.exit("no mesh of " + case.file)
    print("%s: %d elements in %.1f s" % (os.path.basename(vtu), elements, time.time() - start))
    simple.SaveData(vtu, proxy=mesher, DataMode="Binary", CompressorType="ZLib")
    write_exodus(read_mesh(vtu), exodus)
    simple.SaveData(abaqus, proxy=mesher)
    simple.SaveData(table, proxy=VolumeFractionFragments(Input=mesher), Precision=16,
                    UseScientificNotation=1)
    simple.Delete(mesher)
    simple.Delete(source)


def draw_surface(case, mesh, path):
    """Saves a picture of the outside with one colour per material."""
    view = pictures.make_view()
    for material in range(1, len(case.arrays) + 1):
        pictures.show_material(mesh, view, material)
    pictures.aim(view, mesh.GetDataInformation().GetBounds(), case.camera, case.zoom)
    pictures.save(view, path)


def cut_origin(bounds):
    """Returns a point near the middle. The middle itself may lie in a plane of the grid."""
    return [0.495 * bounds[2 * a] + 0.505 * bounds[2 * a + 1] for a in range(3)]


def draw_fractions(case, out, bounds, path):
    """Saves a picture of the cells behind the plane of `draw_cut` that contain the first material,
    coloured by its volume fraction."""
    source = open_field(case, out)
    name = case.arrays[0]
    cells = simple.Threshold(Input=source, Scalars=["CELLS", name], LowerThreshold=LEAST_DRAWN,
                             UpperThreshold=1.0)
    view = pictures.make_view()
    display = pictures.show(pictures.cut(cells, cut_origin(bounds), case.cut_normal), view)
    pictures.colour_by(display, view, name, "Volume fraction", 0.0, "Blues", inverted=True)
    pictures.aim(view, bounds, case.cut_camera, case.cut_zoom)
    pictures.save(view, path)


def draw_cut(case, mesh, path):
    """Saves a picture of the elements behind a plane, coloured by scaled Jacobian."""
    information = mesh.GetDataInformation()
    bounds = information.GetBounds()
    lowest = information.GetCellDataInformation().GetArrayInformation(
        "ScaledJacobian").GetComponentRange(0)[0]
    view = pictures.make_view()
    display = pictures.show(pictures.cut(mesh, cut_origin(bounds), case.cut_normal), view)
    pictures.colour_by_quality(display, view, lowest)
    pictures.aim(view, bounds, case.cut_camera, case.cut_zoom)
    pictures.save(view, path)


def open_mesh(vtu):
    mesh = simple.XMLUnstructuredGridReader(FileName=[vtu])
    mesh.UpdatePipeline()
    return mesh


def field(mesh, name):
    array = mesh.GetFieldData().GetAbstractArray(name)
    return [array.GetValue(i) for i in range(array.GetNumberOfValues())]


def table_rows(name, mesh):
    """Yields a row per material: number of elements, minimum and mean of the scaled Jacobian,
    volume and its error."""
    materials, quality = (
        mesh.GetCellData().GetArray("MaterialId"), mesh.GetCellData().GetArray("ScaledJacobian"))
    per_material = {material: [] for material in field(mesh, "MaterialIds")}
    for cell in range(mesh.GetNumberOfCells()):
        per_material[materials.GetValue(cell)].append(quality.GetValue(cell))
    columns = zip(per_material.items(),
                  *(field(mesh, name) for name in ("MaterialNames", "MeshVolume", "TargetVolume")))
    for (_, values), material, volume, target in columns:
        error = 100 * (volume / target - 1)
        yield (name, material, str(len(values)), "%.3f" % min(values),
               "%.3f" % (sum(values) / len(values)), "%.6g" % volume, "%+.4f" % error)


def print_table(rows):
    rows = [("mesh", "material", "elements", "min SJ", "mean SJ", "volume", "error %")] + rows
    widths = [max(len(row[c]) for row in rows) for c in range(len(rows[0]))]
    for row in rows:
        left = "  ".join(cell.ljust(width) for cell, width in zip(row[:2], widths))
        print(left + "  " + "  ".join(cell.rjust(width)
                                      for cell, width in zip(row[2:], widths[2:])))


def main(plugin, out, names):
    need_files(plugin)
    unknown = set(names) - {case.name for case in CASES}
    if unknown:
        sys.exit("no case %s; cases are %s" % (
            ", ".join(sorted(unknown)), ", ".join(case.name for case in CASES)))
    load_plugin(plugin, globals())  # defines the filters
    simple._DisableFirstRenderCameraReset()
    os.makedirs(out, exist_ok=True)
    code = glob.glob(os.path.join(os.path.dirname(plugin), "*.so"))
    code += [os.path.abspath(__file__)]
    code += [os.path.join(ROOT, "Examples", name)
             for name in ("write_exodus.py", "gerris_to_vthb.py", "pictures.py")]
    fractions, pair = (os.path.join(out, CASES[0].name + ending)
                       for ending in ("_fractions.png", "_fractions_and_mesh.png"))
    rows = []
    for case in CASES:
        if names and case.name not in names:
            continue
        for name, make_filter in ((case.name, hex_filter), (case.name + "_tets", tet_filter)):
            vtu, exodus, abaqus, table, surface, cut = (
                os.path.join(out, name + ending)
                for ending in (".vtu", ".e", ".inp", ".csv", "_surface.png", "_cut.png"))
            if not is_newer([vtu, exodus, abaqus, table], [case.file] + code):
                make_mesh(case, open_field(case, out), make_filter, vtu, exodus, abaqus, table)
            if not is_newer([cut], [vtu] + code):
                draw_cut(case, open_mesh(vtu), cut)
            if make_filter is hex_filter and not is_newer([surface], [vtu] + code):
                draw_surface(case, open_mesh(vtu), surface)
            if make_filter is hex_filter and case is CASES[0] and not is_newer([pair], [cut]):
                draw_fractions(case, out, read_mesh(vtu).GetBounds(), fractions)
                pictures.join(fractions, cut, pair)
            rows += table_rows(name, read_mesh(vtu))
    print_table(rows)


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2], sys.argv[3:])
