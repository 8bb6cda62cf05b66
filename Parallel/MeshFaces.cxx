#include "MeshFaces.h"

#include "Base/Runtime.h"
#include "MeshArrays.h"
#include "Ranks/Agreement.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkHexahedron.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkTetra.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace vfm
{
namespace
{

constexpr int DimensionInside = 3;

/// Corners of the faces of a cell type; throws on others.
struct FaceTable
{
  explicit FaceTable(int type)
  {
    if (type != VTK_HEXAHEDRON && type != VTK_TETRA)
    {
      throw InputError("The mesh has cells that are neither hexahedra nor tetrahedra (VTK type " +
        std::to_string(type) + ").");
    }
    this->Faces = type == VTK_HEXAHEDRON ? 6 : 4;
    this->Corners = type == VTK_HEXAHEDRON ? 4 : 3;
    for (int f = 0; f < this->Faces; ++f)
    {
      const vtkIdType* corners =
        type == VTK_HEXAHEDRON ? vtkHexahedron::GetFaceArray(f) : vtkTetra::GetFaceArray(f);
      std::copy_n(corners, this->Corners, this->Table[f]);
    }
  }
  int Faces, Corners;
  vtkIdType Table[6][4];
};

/// The faces that can be on a surface, and the values of their elements.
void CollectFaces(vtkUnstructuredGrid* mesh, const std::string& name, std::vector<MeshFace>& faces,
  std::vector<int>& values)
{
  vtkDataArray* array = FindMeshArray(mesh->GetCellData(), name);
  vtkDataArray* dimensions = mesh->GetPointData()->GetArray("GeometryDimension");
  const auto isInside = [dimensions](vtkIdType point)
  { return dimensions && dimensions->GetComponent(point, 0) >= DimensionInside; };
  vtkCellArray* cells = mesh->GetCells();
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    const FaceTable table(mesh->GetCellType(cell));
    vtkIdType size = 0;
    const vtkIdType* points = nullptr;
    cells->GetCellAtId(cell, size, points);
    for (int f = 0; f < table.Faces; ++f)
    {
      MeshFace face{ cell, f, table.Corners, { -1, -1, -1, -1 }, NothingBehind };
      std::transform(table.Table[f], table.Table[f] + table.Corners, face.Points,
        [points](vtkIdType corner) { return points[corner]; });
      if (std::none_of(face.Points, face.Points + face.Corners, isInside))
      {
        faces.push_back(face);
        values.push_back(static_cast<int>(array->GetComponent(cell, 0)));
      }
    }
  }
}

FaceIds GlobalIds(const MeshFace& face, vtkIdTypeArray* pointIds)
{
  FaceIds ids{ { -1, -1, -1, -1 } };
  for (int c = 0; c < face.Corners; ++c)
  {
    ids[3 - c] = pointIds->GetValue(face.Points[c]);
  }
  std::sort(ids.begin(), ids.end());
  return ids;
}

} // namespace

std::vector<MeshFace> FindMeshFaces(
  vtkUnstructuredGrid* mesh, const std::string& name, Ranks& ranks)
{
  std::vector<MeshFace> faces;
  std::vector<int> values;
  std::vector<FaceIds> ids;
  WorkTogether(ranks,
    [&]
    {
      if (mesh->GetNumberOfCells() > 0)
      {
        CollectFaces(mesh, name, faces, values);
        const auto pointIds = FindMeshIds(mesh->GetPointData(), "GlobalPointIds");
        std::transform(faces.begin(), faces.end(), std::back_inserter(ids),
          [&pointIds](const MeshFace& face) { return GlobalIds(face, pointIds); });
      }
    });
  const std::vector<int> behind = MatchFaces(ids, values, ranks);
  std::vector<MeshFace> found;
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    if (behind[f] != values[f])
    {
      found.push_back(faces[f]);
      found.back().Behind = behind[f];
    }
  }
  return found;
}

} // namespace vfm
