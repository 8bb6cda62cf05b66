#include "Meshes/Xdmf/WriteXdmf.h"

#include "Meshes/Files/ElementNodes.h"
#include "Meshes/Files/MeshModel.h"
#include "Meshes/Files/OutputFile.h"
#include "Meshes/Files/WriteWhole.h"
#include "Meshes/Particles/WriteParticles.h"
#include "Meshes/Vtk/VtuText.h"
#include "Report/DomainSides.h"
#include "Report/FlatData.h"
#include "Report/MeshMaterials.h"
#include "Report/Sets/NamedSurfaces.h"

#include <filesystem>

namespace vfm
{
namespace
{

/// Number of each name.
using Numbers = std::vector<std::pair<std::string, int>>;

std::string Quoted(Index number)
{
  return "\"" + std::to_string(number) + "\"";
}

void BeginGrid(OutputFile& file, const char* name)
{
  file.Add("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<Xdmf Version=\"3.0\">\n<Domain>\n");
  file.Add(std::string("<Grid Name=\"") + name + "\" GridType=\"Uniform\">\n");
}

void EndGrid(OutputFile& file)
{
  file.Add("</Grid>\n</Domain>\n</Xdmf>\n");
  file.Close();
}

/// Returns a text for an attribute in a CDATA section, which must not contain the section's end.
std::string SectionText(const std::string& text)
{
  std::string safe;
  for (char c : XmlText(text))
  {
    safe += c == '>' ? "&gt;" : std::string(1, c);
  }
  return safe;
}

void AddNames(OutputFile& file, const char* title, const Numbers& numbers, int dimension)
{
  std::string object, map;
  for (const auto& [name, number] : numbers)
  {
    object += (object.empty() ? "\"" : ", \"") + name + "\": " + std::to_string(number);
    map += "<map key=\"" + SectionText(name) + "\" dim=" + Quoted(dimension) + ">" +
      std::to_string(number) + "</map>";
  }
  file.Add(std::string("<Information Name=\"") + title + "\" Value=\"" +
    XmlText("{" + object + "}") + "\"><![CDATA[<main>" + map + "</main>]]></Information>\n");
}

/// Begins an array of numbers as text.
/// @param type  type and bytes of a number
void BeginData(OutputFile& file, const char* type, Index rows, int columns)
{
  const std::string dimensions =
    std::to_string(rows) + (columns > 1 ? " " + std::to_string(columns) : "");
  file.Add(
    std::string("<DataItem Format=\"XML\" ") + type + " Dimensions=\"" + dimensions + "\">\n");
}

void AddTopology(OutputFile& file, const char* type, Index count, int corners,
  const std::function<const Index*(Index)>& cornersOf)
{
  file.Add(std::string("<Topology TopologyType=\"") + type +
    "\" NumberOfElements=" + Quoted(count) + " NodesPerElement=" + Quoted(corners) + ">\n");
  BeginData(file, "NumberType=\"Int\" Precision=\"8\"", count, corners);
  for (Index cell = 0; cell < count; ++cell)
  {
    const Index* points = cornersOf(cell);
    for (int c = 0; c < corners; ++c)
    {
      file.Add(points[c]);
      file.Add(c + 1 < corners ? " " : "\n");
    }
  }
  file.Add("</DataItem>\n</Topology>\n");
}

void AddPoints(OutputFile& file, const MeshData& mesh)
{
  const int axes = NumberOfAxes(mesh);
  file.Add(std::string("<Geometry GeometryType=\"") + (axes == 2 ? "XY" : "XYZ") + "\">\n");
  BeginData(file, "NumberType=\"Float\" Precision=\"8\"", mesh.NumberOfPoints, axes);
  for (Index point = 0; point < mesh.NumberOfPoints; ++point)
  {
    for (int axis = 0; axis < axes; ++axis)
    {
      file.AddReal(mesh.Point(point)[axis]);
      file.Add(axis + 1 < axes ? " " : "\n");
    }
  }
  file.Add("</DataItem>\n</Geometry>\n");
}

void AddTags(OutputFile& file, const char* name, const int* tags, Index count)
{
  file.Add(
    std::string("<Attribute Name=\"") + name + "\" AttributeType=\"Scalar\" Center=\"Cell\">\n");
  BeginData(file, "NumberType=\"Int\" Precision=\"4\"", count, 1);
  for (Index cell = 0; cell < count; ++cell)
  {
    file.Add(static_cast<Index>(tags[cell]));
    file.Add("\n");
  }
  file.Add("</DataItem>\n</Attribute>\n");
}

const char* TopologyOf(const MeshData& mesh)
{
  if (IsFlat(mesh))
  {
    return mesh.Corners == 4 ? "Quadrilateral" : "Triangle";
  }
  return mesh.HasHexes() ? "Hexahedron" : "Tetrahedron";
}

void WriteElements(const MeshData& mesh, const std::string& path, OutputSet& files)
{
  Ranks alone;
  UniqueNames used;
  Numbers numbers;
  for (const auto& [material, name] :
    NameMaterials(mesh, FindMaterials(mesh, alone), PlainName, used))
  {
    numbers.emplace_back(name, material);
  }
  OutputFile file(path, files);
  BeginGrid(file, "mesh");
  AddNames(file, "MaterialNames", numbers, IsFlat(mesh) ? 2 : 3);
  AddTopology(file, TopologyOf(mesh), mesh.NumberOfElements, mesh.Corners,
    [&mesh](Index element) { return mesh.Element(element); });
  AddPoints(file, mesh);
  AddTags(file, "MaterialId", mesh.Material, mesh.NumberOfElements);
  EndGrid(file);
}

void WriteFacets(const MeshData& mesh, const std::string& path, OutputSet& files)
{
  Ranks alone;
  const TaggedFaces facets = TagFaces(FindNamedSurfaces(mesh, alone));
  UniqueNames used;
  Numbers numbers;
  for (const auto& [tag, name] : facets.Names)
  {
    numbers.emplace_back(used.Add(PlainName(name)), tag);
  }
  const Index count = static_cast<Index>(facets.Faces.size());
  FaceIds points;
  OutputFile file(path, files);
  BeginGrid(file, "facets");
  AddNames(file, "SurfaceNames", numbers, IsFlat(mesh) ? 1 : 2);
  AddTopology(file,
    IsFlat(mesh)        ? "PolyLine"
      : mesh.HasHexes() ? "Quadrilateral"
                        : "Triangle",
    count, CornersOfSide(mesh),
    [&](Index facet)
    {
      points = PointsOfSide(mesh, facets.Faces[facet]);
      return points.data();
    });
  AddPoints(file, mesh);
  AddTags(file, "SurfaceId", facets.Tags.data(), count);
  EndGrid(file);
}

} // namespace

void WriteXdmf(const MeshData& mesh, const std::string& path, Ranks& ranks)
{
  std::filesystem::path facets(path);
  facets.replace_filename(facets.stem().string() + "_facets" + facets.extension().string());
  WriteWhole(mesh, ranks,
    [&](const MeshData& whole)
    {
      RequireNodes(whole, {}, "XDMF");
      OutputSet files(path);
      WriteElements(whole, path, files);
      WriteFacets(whole, facets.string(), files);
      WriteParticlesBeside(whole, path, files);
      files.Rename();
    });
}

} // namespace vfm
