#include "MeshOutput.h"

#include "AdoptBuffer.h"
#include "Elements/FlatMesh.h"
#include "EmptyOutput.h"
#include "FieldValues.h"
#include "Report/MeshArrays.h"
#include "Report/MeshFields.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <bitset>

namespace vfm
{
namespace
{

static_assert(sizeof(vtkIdType) == sizeof(Index), "VTK must be built with 64-bit ids");

vtkSmartPointer<vtkCellArray> AdoptCells(Buffer<Index>& buffer, int cellSize)
{
  Buffer<Index> offsets(buffer.size() / cellSize + 1); // VTK would allocate them on small pages
  for (std::size_t c = 0; c < offsets.size(); ++c)
  {
    offsets[c] = cellSize * static_cast<Index>(c);
  }
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(AdoptBuffer<Index, vtkTypeInt64Array>(offsets, nullptr),
    AdoptBuffer<Index, vtkTypeInt64Array>(buffer, "Connectivity"));
  return cells;
}

/// Adopts the elements, with their mid nodes.
vtkSmartPointer<vtkCellArray> AdoptElements(Mesh& mesh)
{
  if (mesh.MidsPerElement == 0)
  {
    return AdoptCells(mesh.Elements, mesh.Corners);
  }
  const int nodes = mesh.NodesPerElement();
  Buffer<Index> all(nodes * mesh.ElementIds.size());
  for (std::size_t e = 0; e < mesh.ElementIds.size(); ++e)
  {
    Index* to = all.data() + nodes * e;
    to = std::copy_n(mesh.Elements.data() + mesh.Corners * e, mesh.Corners, to);
    std::copy_n(mesh.MidPoints.data() + mesh.MidsPerElement * e, mesh.MidsPerElement, to);
  }
  mesh.Elements = Buffer<Index>();
  mesh.MidPoints = Buffer<Index>();
  return AdoptCells(all, nodes);
}

/// A subset of the numbers 0 .. end - 1, and the place of each in the subset.
class Subset
{
public:
  /// numbers: elements of the subset, in any order, also repeated.
  Subset(const Buffer<Index>& numbers, std::size_t end) : Bits((end + 63) / 64, 0)
  {
    for (Index n : numbers)
    {
      this->Bits[n / 64] |= std::uint64_t(1) << n % 64;
    }
    for (std::uint64_t bits : this->Bits)
    {
      this->Before.push_back(this->Count);
      this->Count += std::bitset<64>(bits).count();
    }
  }
  Index Size() const { return this->Count; }
  Index PlaceOf(Index n) const
  {
    const std::uint64_t lower = (std::uint64_t(1) << n % 64) - 1;
    return this->Before[n / 64] + std::bitset<64>(this->Bits[n / 64] & lower).count();
  }

private:
  std::vector<std::uint64_t> Bits;
  std::vector<Index> Before; // number of elements before each block of 64 numbers
  Index Count = 0;
};

/// Sets the points that surfaces, curves, vertices or cohesive elements use, in the order of the
/// mesh, and renumbers the users.
/// @param ids  of the points of the mesh
void SetUsedPoints(
  Buffer<Index>& users, const Mesh& mesh, const Buffer<Index>& ids, vtkPointSet* output)
{
  const Subset used(users, users.empty() ? 0 : mesh.PointIds.size());
  Buffer<double> usedPoints(3 * used.Size());
  Buffer<Index> usedIds(used.Size());
  for (Index& point : users)
  {
    const Index place = used.PlaceOf(point);
    std::copy_n(mesh.Points.data() + 3 * point, 3, usedPoints.data() + 3 * place);
    usedIds[place] = ids[point];
    point = place;
  }
  vtkNew<vtkPoints> vtkpoints;
  vtkpoints->SetData(AdoptBuffer(usedPoints, "Points", 3));
  output->SetPoints(vtkpoints);
  output->GetPointData()->SetGlobalIds(AdoptBuffer(usedIds, "GlobalPointIds"));
}

/// Returns a visitor that adds arrays, for VisitElementArrays and VisitPointArrays.
auto AdoptInto(vtkDataSetAttributes* arrays)
{
  return [arrays](const KnownArray& array, auto& values)
  {
    if (array.IsOutput(values))
    {
      arrays->AddArray(AdoptBuffer(values, array.Name));
    }
  };
}

void SetSurfaces(Mesh& mesh, vtkPolyData* surfaces)
{
  SurfaceFacets& facets = mesh.Surfaces;
  SetUsedPoints(facets.Points, mesh, mesh.UnsplitPointIds(), surfaces);
  surfaces->SetPolys(AdoptCells(facets.Points, mesh.CornersOfFacet()));
  vtkCellData* sides = surfaces->GetCellData();
  sides->SetScalars(AdoptBuffer(facets.SurfaceId, "SurfaceId"));
  sides->AddArray(AdoptBuffer(facets.MaterialPair, "MaterialPair", 2));
  sides->AddArray(AdoptBuffer(facets.DomainSide, "DomainSide"));
  AddFields(ListSurfaces(mesh.Tables), surfaces->GetFieldData());
}

void SetCurves(Mesh& mesh, vtkPolyData* curves)
{
  SetUsedPoints(mesh.Curves.Points, mesh, mesh.UnsplitPointIds(), curves);
  curves->SetLines(AdoptCells(mesh.Curves.Points, 2));
  curves->GetCellData()->SetScalars(AdoptBuffer(mesh.Curves.CurveId, "CurveId"));
  AddFields(ListCurves(mesh.Tables), curves->GetFieldData());
}

void SetVertices(Mesh& mesh, vtkPolyData* vertices)
{
  SetUsedPoints(mesh.Vertices.Points, mesh, mesh.UnsplitPointIds(), vertices);
  vertices->SetVerts(AdoptCells(mesh.Vertices.Points, 1));
  vertices->GetCellData()->SetScalars(AdoptBuffer(mesh.Vertices.VertexId, "VertexId"));
  AddFields(ListVertices(mesh.Tables), vertices->GetFieldData());
}

template <class T>
Buffer<T> CopyOf(const std::vector<T>& values)
{
  Buffer<T> copy(values.size());
  std::copy(values.begin(), values.end(), copy.begin());
  return copy;
}

} // namespace

void SetCohesiveOutput(
  const Mesh& mesh, const CohesiveElements& elements, vtkUnstructuredGrid* output)
{
  if (elements.Ids.empty())
  {
    return;
  }
  const int corners = 2 * mesh.CornersOfFacet();
  Buffer<Index> points = CopyOf(elements.Points), ids = CopyOf(elements.Ids);
  Buffer<int> materials = CopyOf(elements.Materials);
  SetUsedPoints(points, mesh, mesh.PointIds, output);
  output->SetCells(corners == 8 ? VTK_HEXAHEDRON : VTK_WEDGE, AdoptCells(points, corners));
  vtkCellData* cells = output->GetCellData();
  cells->AddArray(AdoptBuffer(materials, "MaterialPair", 2));
  cells->SetGlobalIds(AdoptBuffer(ids, "GlobalCellIds"));
}

void SetElementOutput(Mesh& mesh, vtkUnstructuredGrid* output)
{
  vtkNew<vtkPoints> points;
  points->SetData(AdoptBuffer(mesh.Points, "Points", 3));
  output->SetPoints(points);
  if (mesh.ElementIds.empty())
  {
    SetNoElements(output);
  }
  else
  {
    const int type = !IsFlat(mesh) ? mesh.Shape().VtkType
      : mesh.Corners == 4          ? VTK_QUAD
                                   : VTK_TRIANGLE;
    output->SetCells(type, AdoptElements(mesh));
  }
  vtkCellData* cells = output->GetCellData();
  VisitElementArrays(AdoptInto(cells), mesh);
  cells->SetActiveScalars("MaterialId");
  cells->SetActiveGlobalIds("GlobalCellIds");
  vtkPointData* nodes = output->GetPointData();
  VisitPointArrays(AdoptInto(nodes), mesh);
  nodes->SetActiveGlobalIds("GlobalPointIds");
}

void SetMeshOutput(Mesh& mesh, const CohesiveElements& cohesive, const MeshOutputs& outputs)
{
  SetCohesiveOutput(mesh, cohesive, outputs.Cohesive);
  SetSurfaces(mesh, outputs.Surfaces);
  SetCurves(mesh, outputs.Curves);
  SetVertices(mesh, outputs.Vertices);
  SetElementOutput(mesh, outputs.Mesh);
}

} // namespace vfm
