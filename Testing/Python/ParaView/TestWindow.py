"""Clicks of a user in the ParaView GUI, from loading the plugin to saving the mesh."""
import os
from xml.sax.saxutils import quoteattr

from paraview import simple

from exodus_dump import Dump
from exodus_of_mesh import check
from mpi_run import mpi_run
from vfmtest import in_folder, main, VolumeFractionToHex

FIELD = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..", "Data",
                     "fin.vti")
MENUS, PANEL, MANAGER = "menubar/menu", "propertiesDock/propertiesPanel/", "PluginManagerDialog/"
LOAD_PLUGIN = [
    (MENUS + "Tools", "activate", "actionManage_Plugins"),
    (MANAGER + "splitter/localGroup/loadLocal", "activate", ""),
    (MANAGER + "1pqFileDialog0", "filesSelected", os.path.realpath(os.environ["VFM_PLUGIN"])),
    (MANAGER + "buttonBox/1QPushButton0", "activate", "")]
PROPERTIES = (PANEL + "scrollArea/qt_scrollarea_viewport/scrollAreaWidgetContents/"
              "PropertiesFrame/ProxyPanel/")
WIDTH, COUNT = PROPERTIES + "CellWidth/CellWidth", PROPERTIES + "CellCount/CellCount"
MAKE_MESH = [
    (MENUS + "_File", "activate", "actionFileOpen"),
    ("FileOpenDialog", "filesSelected", os.path.realpath(FIELD)),
    (PANEL + "Accept", "activate", ""),
    (MENUS + "Filters/Alphabetical", "activate", "VolumeFractionToHex"),
    (COUNT, "text", "40 x 32 x 32 of width 0.0625"), (WIDTH, "set_string", "0.125"),
    (COUNT, "text", "20 x 16 x 16 of width 0.125"), (WIDTH, "set_string", "0"),
    (COUNT, "text", "40 x 32 x 32 of width 0.0625"),
    (PANEL + "Accept", "activate", "")]


def save(path):
    """Returns the clicks that save the mesh; the writers have a dialog of options."""
    return [(MENUS + "_File", "activate", "actionFileSaveData"),
            ("FileSaveDialog", "filesSelected", path),
            ("WriterSettingsDialog/widget/OKButton", "activate", "")]


def play(clicks, folder):
    """Plays the clicks, and checks texts, in a new ParaView without settings, on a screen of its
    own."""
    script = os.path.join(folder, "clicks.xml")
    with open(script, "w") as file:
        file.write('<?xml version="1.0"?>\n<pqevents>\n')
        for what, command, value in clicks:
            event = "pqcheck object=%s property=%s" if command == "text" else (
                "pqevent object=%s command=%s")
            file.write("<" + event % (quoteattr("pqClientMainWindow/" + what), quoteattr(command))
                       + " arguments=%s/>\n" % quoteattr(value))
        file.write("</pqevents>\n")
    return mpi_run(1,
                   ["xvfb-run", "-a", "-s", "-screen 0 1280x1024x24 -noreset", "paraview", "--dr",
                    "--test-directory=" + folder,
                       "--test-script=" + script, "--exit"], HOME=folder,
                       without=["PV_PLUGIN_PATH"])


@in_folder
def test_from_plugin_to_files(at):
    """A single array is selected by default, the panel shows the cells of a width before Apply, and
    the saved files hold the mesh."""
    saves = [click for end in ("exo", "e", "inp") for click in save(at("mesh." + end))]
    window = play(LOAD_PLUGIN + MAKE_MESH + saves, at(""))
    text = window.stdout + window.stderr
    assert window.returncode == 0 and "ERR|" not in text and "WARN|" not in text, text
    mesher = VolumeFractionToHex(Input=simple.OpenDataFile(FIELD), VolumeFractionArrays=["body"])
    mesher.UpdatePipeline()
    mesh = mesher.GetClientSideObject().GetOutputDataObject(0)
    for end in ("exo", "e"):
        check([Dump(at("mesh." + end))], mesh)
    simple.SaveData(at("script.inp"), proxy=mesher)
    with open(at("mesh.inp")) as by_window, open(at("script.inp")) as by_script:
        assert by_window.read() == by_script.read()


main(globals())
