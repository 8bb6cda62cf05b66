#include "Meshes/Decks/WriteAbaqus.h"

#include "Meshes/Decks/AbaqusText.h"
#include "Meshes/Files/OutputFile.h"
#include "Meshes/Files/WriteWhole.h"
#include "Summary/MeshMaterials.h"
#include "Summary/MeshSets.h"

#include <algorithm>
#include <cctype>
#include <map>

namespace vfm
{
namespace
{

constexpr Index LargestNumber = 999999999;
constexpr std::size_t NumbersInLine = 8;
/// Numbers of the faces in Abaqus, indexed by the numbers in VTK. S1 of a hexahedron has its
/// corners 1 to 4.
constexpr int HexFaces[6] = { 6, 4, 3, 5, 1, 2 };
constexpr int TetFaces[4] = { 2, 3, 4, 1 };

bool IsVelocity(const MeshArray& array)
{
  std::string name = array.Name;
  std::transform(
    name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
  return name.find("velocity") != std::string::npos && array.Components == 3;
}

/// Returns a text for a comment line, without control characters or characters outside of ASCII.
std::string PlainText(std::string text)
{
  constexpr std::size_t longest = 120;
  std::replace_if(
    text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return text.substr(0, longest);
}

/// Elements of a material.
struct Section
{
  int Material;
  std::string Name; ///< name of the material
  std::string Set;  ///< name of the element set
  std::vector<Index> Elements;
};

/// Returns one section per material, by material id.
std::vector<Section> MakeSections(const MeshData& mesh, AbaqusNames& names)
{
  std::map<int, std::vector<Index>> elements;
  for (Index element = 0; element < mesh.NumberOfElements; ++element)
  {
    elements[mesh.Material[element]].push_back(element);
  }
  const std::map<int, std::string> ofMesh = NamesOfMaterials(mesh);
  std::vector<Section> sections;
  for (auto& [material, list] : elements)
  {
    const std::string name = NameOfMaterial(ofMesh, material);
    sections.push_back({ material, name, names.Add(name), std::move(list) });
  }
  return sections;
}

struct Surface
{
  std::string Name;
  const std::vector<MeshSide>* Sides; ///< sides of a side set
};

/// Returns the surfaces of all sides of the domain, or all other surfaces.
std::vector<Surface> MakeSurfaces(
  const std::vector<SideSet>& sets, AbaqusNames& names, bool ofDomain)
{
  std::vector<Surface> surfaces;
  for (const SideSet& set : sets)
  {
    if ((set.DomainSide != NoSide) == ofDomain)
    {
      surfaces.push_back({ names.Add(set.Name), &set.Sides });
    }
  }
  return surfaces;
}

void WriteHeading(OutputFile& file, const MeshData& mesh, const std::vector<Section>& sections)
{
  file.Add("*HEADING\nMesh by VolumeFractionMesh " VFM_VERSION ": ");
  file.Add(mesh.NumberOfPoints);
  file.Add(" nodes, ");
  file.Add(mesh.NumberOfElements);
  file.Add(mesh.Corners == 8 ? " hexahedra\n" : " tetrahedra\n");
  for (const Section& section : sections)
  {
    file.Add("** " + section.Set + ": material " + std::to_string(section.Material) + ", " +
      PlainText(section.Name) + "\n");
  }
}

void WriteNodes(OutputFile& file, const MeshData& mesh)
{
  file.Add("*NODE, NSET=NALL\n");
  for (Index point = 0; point < mesh.NumberOfPoints; ++point)
  {
    file.Add(point + 1);
    for (int axis = 0; axis < 3; ++axis)
    {
      file.Add(",");
      file.Add(AbaqusNumber(mesh.Point(point)[axis]).Text());
    }
    file.Add("\n");
  }
}

/// Writes the elements of a section. The corners of C3D8 and C3D4 have the same order as in VTK.
void WriteElements(OutputFile& file, const MeshData& mesh, const Section& section)
{
  file.Add("*ELEMENT, TYPE=");
  file.Add(mesh.Corners == 8 ? "C3D8" : "C3D4");
  file.Add(", ELSET=" + section.Set + "\n");
  for (Index element : section.Elements)
  {
    file.Add(element + 1);
    for (int c = 0; c < mesh.Corners; ++c)
    {
      file.Add(",");
      file.Add(mesh.Element(element)[c] + 1);
    }
    file.Add("\n");
  }
}

/// Writes a set of all elements, one section per line. Lines with a single entry require a comma.
void WriteAllElements(OutputFile& file, const std::vector<Section>& sections)
{
  file.Add("*ELSET, ELSET=EALL\n");
  for (const Section& section : sections)
  {
    file.Add(section.Set + ",\n");
  }
}

void WriteNodeSet(OutputFile& file, const std::string& name, const std::vector<Index>& points)
{
  file.Add("*NSET, NSET=" + name + "\n");
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    file.Add(points[p] + 1);
    file.Add(p % NumbersInLine + 1 == NumbersInLine || p + 1 == points.size() ? ",\n" : ",");
  }
}

/// Writes lines with a node, a direction from 1, and the component of the velocity.
void WriteVelocity(OutputFile& file, const MeshData& mesh, const MeshArray& velocity)
{
  file.Add("*INITIAL CONDITIONS, TYPE=VELOCITY\n");
  for (Index point = 0; point < mesh.NumberOfPoints; ++point)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      file.Add(point + 1);
      file.Add(",");
      file.Add(axis + 1);
      file.Add(",");
      file.Add(AbaqusNumber(ValueAt(velocity, point, axis)).Text());
      file.Add("\n");
    }
  }
}

void WriteSurface(OutputFile& file, const Surface& surface, bool ofHexes)
{
  file.Add("*SURFACE, NAME=" + surface.Name + ", TYPE=ELEMENT\n");
  for (const MeshSide& side : *surface.Sides)
  {
    file.Add(side.Element + 1);
    file.Add(",S");
    file.Add((ofHexes ? HexFaces : TetFaces)[side.Side]);
    file.Add("\n");
  }
}

/// Writes the whole mesh. The sides of the domain get their names first, so that X_MIN is a side of
/// the domain even if a material has this name.
void WriteFile(const MeshData& mesh, const std::string& path)
{
  if (std::max(mesh.NumberOfPoints, mesh.NumberOfElements) > LargestNumber)
  {
    throw InputError(
      "The mesh has more than 999,999,999 nodes or elements, which Abaqus cannot number.");
  }
  Ranks alone;
  const MeshSets sets = FindMeshSets(mesh, alone);
  AbaqusNames names, nodeNames;
  names.Add("EALL");
  nodeNames.Add("NALL");
  std::vector<Surface> surfaces = MakeSurfaces(sets.SideSets, names, true);
  const std::vector<Section> sections = MakeSections(mesh, names);
  for (Surface& surface : MakeSurfaces(sets.SideSets, names, false))
  {
    surfaces.push_back(std::move(surface));
  }

  OutputFile file(path);
  WriteHeading(file, mesh, sections);
  WriteNodes(file, mesh);
  for (const Section& section : sections)
  {
    WriteElements(file, mesh, section);
  }
  WriteAllElements(file, sections);
  for (const NodeSet& set : sets.NodeSets)
  {
    WriteNodeSet(file, nodeNames.Add(set.Name), set.Points);
  }
  for (const Surface& surface : surfaces)
  {
    WriteSurface(file, surface, mesh.Corners == 8);
  }
  const auto velocity = std::find_if(mesh.PointArrays.begin(), mesh.PointArrays.end(), IsVelocity);
  if (velocity != mesh.PointArrays.end())
  {
    WriteVelocity(file, mesh, *velocity);
  }
  file.Close();
}

} // namespace

void WriteAbaqus(const MeshData& mesh, const std::string& path, Ranks& ranks)
{
  WriteWhole(
    mesh, ranks, [&](const MeshData& whole) { WriteFile(whole, path); }, IsVelocity);
}

} // namespace vfm
