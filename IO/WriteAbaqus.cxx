#include "WriteAbaqus.h"

#include "AbaqusText.h"
#include "Base/Runtime.h"
#include "GatherMesh.h"
#include "MeshArrays.h"
#include "MeshDataOfGrid.h"
#include "Ranks/Agreement.h"
#include "Summary/MeshMaterials.h"
#include "Summary/MeshSets.h"
#include "TextFile.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cctype>
#include <map>

namespace vfm
{
namespace
{

using MeshPointer = vtkSmartPointer<vtkUnstructuredGrid>;

constexpr vtkIdType LargestNumber = 999999999;
constexpr const char* WrongCells = "The mesh must be all hexahedra or all tetrahedra.";
constexpr std::size_t NumbersInLine = 8;
constexpr int LastDomainSide = 6; // of the ids in MeshSets.h
/// The faces of VTK's cells, by the numbers that Abaqus gives them: S1 of a hexahedron has its corners 1 to 4.
constexpr int HexFaces[6] = { 6, 4, 3, 5, 1, 2 };
constexpr int TetFaces[4] = { 2, 3, 4, 1 };

/// The corners agree: those of VTK are the ones of C3D8 and C3D4.
bool IsHexMesh(vtkUnstructuredGrid* mesh)
{
  return mesh->GetCellType(0) == VTK_HEXAHEDRON;
}

/// Of the nodes; null: none.
vtkDataArray* FindVelocity(vtkUnstructuredGrid* mesh)
{
  vtkPointData* data = mesh->GetPointData();
  for (int a = 0; a < data->GetNumberOfArrays(); ++a)
  {
    vtkDataArray* array = data->GetArray(a);
    std::string name = array && array->GetName() ? array->GetName() : "";
    std::transform(
      name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
    if (name.find("velocity") != std::string::npos && array->GetNumberOfComponents() == 3)
    {
      return array;
    }
  }
  return nullptr;
}

/// What the file is made of, without the other arrays.
MeshPointer TakeMesh(vtkUnstructuredGrid* mesh)
{
  auto taken = MeshPointer::New();
  if (mesh->GetNumberOfCells() == 0)
  {
    return taken;
  }
  const int type = mesh->GetCellType(0);
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    if (mesh->GetCellType(cell) != type || (type != VTK_HEXAHEDRON && type != VTK_TETRA))
    {
      throw InputError(WrongCells);
    }
  }
  taken->SetPoints(mesh->GetPoints());
  taken->SetCells(type, mesh->GetCells());
  taken->GetCellData()->AddArray(FindMeshArray(mesh->GetCellData(), "MaterialId"));
  taken->GetCellData()->SetGlobalIds(FindMeshIds(mesh->GetCellData(), "GlobalCellIds"));
  taken->GetPointData()->SetGlobalIds(FindMeshIds(mesh->GetPointData(), "GlobalPointIds"));
  for (const char* name : { "GeometryDimension", "GeometryId" })
  {
    if (vtkDataArray* array = mesh->GetPointData()->GetArray(name))
    {
      taken->GetPointData()->AddArray(array);
    }
  }
  if (vtkDataArray* velocity = FindVelocity(mesh))
  {
    taken->GetPointData()->AddArray(velocity);
  }
  taken->GetFieldData()->ShallowCopy(mesh->GetFieldData());
  return taken;
}

/// Comment lines are for people: what could end or hide one is left out.
std::string PlainText(std::string text)
{
  constexpr std::size_t longest = 120;
  std::replace_if(
    text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return text.substr(0, longest);
}

/// The elements of a material.
struct Section
{
  int Material;
  std::string Name; ///< of the material
  std::string Set;
  std::vector<vtkIdType> Cells;
};

/// By material.
std::vector<Section> MakeSections(vtkUnstructuredGrid* mesh, AbaqusNames& names)
{
  std::map<int, std::vector<vtkIdType>> cells;
  vtkDataArray* materials = mesh->GetCellData()->GetArray("MaterialId");
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    cells[static_cast<int>(materials->GetComponent(cell, 0))].push_back(cell);
  }
  const std::map<int, std::string> ofMesh = NamesOfMaterials(MeshDataOf(mesh).Data);
  std::vector<Section> sections;
  for (auto& [material, list] : cells)
  {
    const std::string name = NameOfMaterial(ofMesh, material);
    sections.push_back({ material, name, names.Add(name), std::move(list) });
  }
  return sections;
}

struct Surface
{
  std::string Name;
  const std::vector<MeshSide>* Sides; ///< of the side set
};

/// Of the sides of the domain, or of pairs of materials.
std::vector<Surface> MakeSurfaces(
  const std::vector<SideSet>& sets, AbaqusNames& names, bool ofDomain)
{
  std::vector<Surface> surfaces;
  for (const SideSet& set : sets)
  {
    if ((set.Id <= LastDomainSide) == ofDomain)
    {
      surfaces.push_back({ names.Add(set.Name), &set.Sides });
    }
  }
  return surfaces;
}

void WriteHeading(TextFile& file, vtkUnstructuredGrid* mesh, const std::vector<Section>& sections)
{
  file.Add("*HEADING\nMesh by VolumeFractionMesh " VFM_VERSION ": ");
  file.Add(mesh->GetNumberOfPoints());
  file.Add(" nodes, ");
  file.Add(mesh->GetNumberOfCells());
  file.Add(IsHexMesh(mesh) ? " hexahedra\n" : " tetrahedra\n");
  for (const Section& section : sections)
  {
    file.Add("** " + section.Set + ": material " + std::to_string(section.Material) + ", " +
      PlainText(section.Name) + "\n");
  }
}

void WriteNodes(TextFile& file, vtkPoints* points)
{
  file.Add("*NODE, NSET=NALL\n");
  for (vtkIdType point = 0; point < points->GetNumberOfPoints(); ++point)
  {
    double position[3];
    points->GetPoint(point, position);
    file.Add(point + 1);
    for (double coordinate : position)
    {
      file.Add(",");
      file.Add(AbaqusNumber(coordinate).Text());
    }
    file.Add("\n");
  }
}

void WriteElements(TextFile& file, vtkUnstructuredGrid* mesh, const Section& section)
{
  file.Add("*ELEMENT, TYPE=");
  file.Add(IsHexMesh(mesh) ? "C3D8" : "C3D4");
  file.Add(", ELSET=" + section.Set + "\n");
  for (vtkIdType cell : section.Cells)
  {
    vtkIdType size = 0;
    const vtkIdType* points = nullptr;
    mesh->GetCells()->GetCellAtId(cell, size, points);
    file.Add(cell + 1);
    for (vtkIdType c = 0; c < size; ++c)
    {
      file.Add(",");
      file.Add(points[c] + 1);
    }
    file.Add("\n");
  }
}

/// One set a line; the comma is for lines of one entry, which need it.
void WriteAllElements(TextFile& file, const std::vector<Section>& sections)
{
  file.Add("*ELSET, ELSET=EALL\n");
  for (const Section& section : sections)
  {
    file.Add(section.Set + ",\n");
  }
}

void WriteNodeSet(TextFile& file, const std::string& name, const std::vector<Index>& points)
{
  file.Add("*NSET, NSET=" + name + "\n");
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    file.Add(points[p] + 1);
    file.Add(p % NumbersInLine + 1 == NumbersInLine || p + 1 == points.size() ? ",\n" : ",");
  }
}

/// A node, a direction from 1 and its component a line.
void WriteVelocity(TextFile& file, vtkDataArray* velocity)
{
  file.Add("*INITIAL CONDITIONS, TYPE=VELOCITY\n");
  for (vtkIdType point = 0; point < velocity->GetNumberOfTuples(); ++point)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      file.Add(point + 1);
      file.Add(",");
      file.Add(axis + 1);
      file.Add(",");
      file.Add(AbaqusNumber(velocity->GetComponent(point, axis)).Text());
      file.Add("\n");
    }
  }
}

void WriteSurface(TextFile& file, const Surface& surface, bool ofHexes)
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

/// mesh: the whole one. Names go to the sides of the domain first, so that X_MIN is one, then to materials and pairs.
void WriteFile(vtkUnstructuredGrid* mesh, const std::string& path)
{
  if (mesh->GetNumberOfCells() == 0)
  {
    throw InputError("The mesh is empty.");
  }
  if (std::max(mesh->GetNumberOfPoints(), mesh->GetNumberOfCells()) > LargestNumber)
  {
    throw InputError(
      "The mesh has more than 999,999,999 nodes or elements, which Abaqus cannot number.");
  }
  Ranks alone;
  const MeshSets sets = FindMeshSets(MeshDataOf(mesh).Data, alone);
  AbaqusNames names, nodeNames;
  names.Add("EALL");
  nodeNames.Add("NALL");
  std::vector<Surface> surfaces = MakeSurfaces(sets.SideSets, names, true);
  const std::vector<Section> sections = MakeSections(mesh, names);
  for (Surface& surface : MakeSurfaces(sets.SideSets, names, false))
  {
    surfaces.push_back(std::move(surface));
  }

  TextFile file(path);
  WriteHeading(file, mesh, sections);
  WriteNodes(file, mesh->GetPoints());
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
    WriteSurface(file, surface, IsHexMesh(mesh));
  }
  if (vtkDataArray* velocity = FindVelocity(mesh))
  {
    WriteVelocity(file, velocity);
  }
  file.Close();
}

} // namespace

void WriteAbaqus(vtkUnstructuredGrid* mesh, const std::string& path, Ranks& ranks)
{
  MeshPointer taken;
  WorkTogether(ranks, [&] { taken = TakeMesh(mesh); });
  const auto has = [&](int type)
  { return ranks.Any(taken->GetNumberOfCells() > 0 && taken->GetCellType(0) == type); };
  if (const bool hasHexes = has(VTK_HEXAHEDRON), hasTets = has(VTK_TETRA); hasHexes && hasTets)
  {
    throw InputError(WrongCells);
  }
  const MeshPointer whole = GatherMesh(taken, ranks);
  WorkTogether(ranks,
    [&]
    {
      if (ranks.Rank() == 0)
      {
        WriteFile(whole, path);
      }
    });
}

} // namespace vfm
