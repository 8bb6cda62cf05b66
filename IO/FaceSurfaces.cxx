#include "FaceSurfaces.h"

#include "MeshArrays.h"
#include "Ranks/Agreement.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace vfm
{
namespace
{

constexpr int DimensionOfSurfaces = 2;

} // namespace

FaceSurfaces::FaceSurfaces(vtkUnstructuredGrid* mesh) :
  Parts(mesh->GetFieldData()->GetArray("SurfaceParts")),
  Dimensions(mesh->GetPointData()->GetArray("GeometryDimension")),
  Ids(mesh->GetPointData()->GetArray("GeometryId"))
{
  if (this->Parts && this->Dimensions && this->Ids &&
    mesh->GetPointData()->GetArray("GlobalPointIds"))
  {
    this->PointIds = FindMeshIds(mesh->GetPointData(), "GlobalPointIds");
  }
  vtkDataArray* facets = mesh->GetFieldData()->GetArray("EdgeFacets");
  const bool isTable = facets && facets->GetNumberOfComponents() == 5;
  for (vtkIdType row = 0; isTable && row < facets->GetNumberOfTuples(); ++row)
  {
    FaceIds points;
    for (int c = 0; c < 4; ++c)
    {
      points[c] = static_cast<Index>(facets->GetComponent(row, c));
    }
    this->EdgeFacets[points] = static_cast<int>(facets->GetComponent(row, 4));
  }
}

bool FaceSurfaces::IsInside(vtkIdType point) const
{
  return this->Dimensions->GetComponent(point, 0) == DimensionOfSurfaces;
}

int FaceSurfaces::SurfaceOf(vtkIdType point) const
{
  return this->IsInside(point) ? static_cast<int>(this->Ids->GetComponent(point, 0)) : 0;
}

int FaceSurfaces::Find(const MeshFace& face)
{
  if (!this->PointIds)
  {
    return 0;
  }
  FaceIds ids{ { -1, -1, -1, -1 } };
  int surface = 0;
  for (int c = 0; c < face.Corners; ++c)
  {
    ids[3 - c] = this->PointIds->GetValue(face.Points[c]);
    surface = std::max(surface, this->SurfaceOf(face.Points[c]));
  }
  std::sort(ids.begin(), ids.end());
  const auto told = this->EdgeFacets.find(ids);
  surface = told == this->EdgeFacets.end() ? surface : told->second;
  if (surface < 1 || surface > this->Parts->GetNumberOfTuples() ||
    this->Parts->GetComponent(surface - 1, 0) < 1)
  {
    return 0;
  }
  for (int c = 0; c < face.Corners; ++c)
  {
    if (!this->IsInside(face.Points[c]))
    {
      this->Rims.push_back({ { surface, this->PointIds->GetValue(face.Points[c]) } });
    }
  }
  return surface;
}

void FaceSurfaces::ShareRims(Ranks& ranks)
{
  this->Rims = Unite(ranks, std::move(this->Rims));
}

bool FaceSurfaces::Contains(int surface, vtkIdType point) const
{
  if (!this->PointIds)
  {
    return false;
  }
  const std::array<Index, 2> rim{ { surface, this->PointIds->GetValue(point) } };
  return this->SurfaceOf(point) == surface ||
    std::binary_search(this->Rims.begin(), this->Rims.end(), rim);
}

} // namespace vfm
