#include "Meshes/Vtk/WriteGeometry.h"

#include "FileSuffix.h"
#include "Meshes/Files/OutputFile.h"
#include "Meshes/Vtk/VtuText.h"
#include "Meshes/Vtk/WriteVtp.h"
#include "Ranks/WorkTogether.h"
#include "Report/Gather/GatherGeometry.h"

#include <filesystem>

namespace vfm
{
namespace
{

namespace fs = std::filesystem;

void WriteParts(
  std::vector<GeometryPart> parts, const std::optional<double>& time, const std::string& path)
{
  const fs::path folder = fs::path(path).replace_extension();
  const std::string name = folder.filename().string();
  OutputSet files(path);
  files.MakeFolder(folder.string());
  OutputFile file(path, files);
  file.Add(VtuHead("vtkMultiBlockDataSet", "1.0") + "<vtkMultiBlockDataSet>\n");
  for (std::size_t p = 0; p < parts.size(); ++p)
  {
    GeometryPart& part = parts[p];
    const std::string number = std::to_string(p);
    const std::string piece = name + "_" + number + ".vtp";
    part.Cells.Data.Time = time;
    WriteVtp(part.Cells.Data, (folder / piece).string(), files);
    file.Add("<DataSet index=\"" + number + "\" name=\"" + part.Name + "\" file=\"" +
      XmlText(name + "/" + piece) + "\"/>\n");
  }
  file.Add("</vtkMultiBlockDataSet>\n</VTKFile>\n");
  file.Close();
  files.Rename();
}

} // namespace

std::string FindGeometryProblem(const std::string& path)
{
  return HasSuffix(path, ".vtm")
    ? ""
    : "The geometry " + path + " is of an unknown format. Supported format: .vtm.";
}

void WriteGeometry(
  const Mesh& mesh, const std::optional<double>& time, const std::string& path, Ranks& ranks)
{
  std::vector<GeometryPart> parts = GatherGeometry(mesh, ranks);
  WorkTogether(ranks,
    [&]
    {
      if (ranks.Rank() == 0)
      {
        WriteParts(std::move(parts), time, path);
      }
    });
}

} // namespace vfm
