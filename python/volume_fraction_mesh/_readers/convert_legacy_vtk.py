"""Program that converts a legacy .vtk file to a file of VTK in XML, for vtk_files.

VTK's reader of the legacy format may corrupt memory if the file is damaged, so it runs in a process
of its own. usage: convert_legacy_vtk.py INPUT FOLDER. Prints the errors of VTK, and then the name
of the file in the folder.
"""

import os
import sys

KINDS = ("Scalars", "Vectors", "Normals", "Tensors", "TCoords", "Fields")


def main(path: str, folder: str) -> None:
    from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow
    from vtkmodules.vtkIOLegacy import vtkGenericDataObjectReader
    from vtkmodules.vtkIOXML import vtkXMLDataSetWriter

    window = vtkStringOutputWindow()
    vtkOutputWindow.SetInstance(window)
    reader = vtkGenericDataObjectReader()
    for kind in KINDS:
        getattr(reader, "ReadAll%sOn" % kind)()
    reader.SetFileName(path)
    reader.Update()
    data = reader.GetOutputDataObject(0)
    print(window.GetOutput() or "", flush=True)
    if data is None or not data.IsA("vtkDataSet"):
        print("Error reading: it holds no grid.")
        return
    endings = {"vtkImageData": ".vti", "vtkStructuredPoints": ".vti", "vtkRectilinearGrid": ".vtr",
               "vtkStructuredGrid": ".vts", "vtkUnstructuredGrid": ".vtu", "vtkPolyData": ".vtp"}
    name = "data" + endings[data.GetClassName()]
    writer = vtkXMLDataSetWriter()
    writer.SetFileName(os.path.join(folder, name))
    writer.SetInputData(data)
    writer.SetCompressorTypeToNone()
    writer.SetDataModeToAppended()
    writer.EncodeAppendedDataOff()
    writer.Write()
    print(name)


if __name__ == "__main__":
    main(*sys.argv[1:])
