#include "Meshes/Vtk/WriteVtp.h"

#include "Meshes/Files/OutputFile.h"
#include "Meshes/Vtk/VtuText.h"

namespace vfm
{

void WriteVtp(const MeshData& cells, const std::string& path, OutputSet& files)
{
  OutputFile file(path, files);
  const std::string kind = cells.Corners == 1 ? "Verts" : cells.Corners == 2 ? "Lines" : "Polys";
  file.Add(VtuHead("PolyData") + "<PolyData>\n");
  AddVtuFields(file, cells);
  file.Add("<Piece NumberOfPoints=\"" + std::to_string(cells.NumberOfPoints) + "\" NumberOf" +
    kind + "=\"" + std::to_string(cells.NumberOfElements) + "\">\n");
  AddVtuMesh(file, cells);
  file.Add("<" + kind + ">\n");
  AddVtuElements(file, cells);
  file.Add("</" + kind + ">\n</Piece>\n</PolyData>\n</VTKFile>\n");
  file.Close();
}

} // namespace vfm
