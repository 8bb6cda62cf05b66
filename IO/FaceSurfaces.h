/**
 * FaceSurfaces: of which smooth side the faces and points of a mesh are, where its interfaces have several.
 *
 * A face is of the surface of its points that lie inside one; the field data EdgeFacets name those without such points. Surfaces that the
 * field data SurfaceParts do not count as sides are 0 here.
 */
#pragma once

#include "MatchFaces.h"
#include "MeshFaces.h"

#include "vtkSmartPointer.h"

#include <array>
#include <map>
#include <vector>

class vtkDataArray;
class vtkIdTypeArray;
class vtkUnstructuredGrid;

namespace vfm
{

class FaceSurfaces
{
public:
  /// mesh: as for FindMeshSets; it may lack the arrays, then there are no sides.
  explicit FaceSurfaces(vtkUnstructuredGrid* mesh);

  /// The surface of a face, or 0. Keeps in mind which points are at its rim.
  int Find(const MeshFace& face);

  /// Once all faces were found: whether a point of the mesh is of a face of a surface on any rank. ShareRims is collective.
  void ShareRims(Ranks& ranks);
  bool Contains(int surface, vtkIdType point) const;

private:
  bool IsInside(vtkIdType point) const;
  int SurfaceOf(vtkIdType point) const;

  vtkDataArray *Parts, *Dimensions, *Ids;
  vtkSmartPointer<vtkIdTypeArray> PointIds; // null: no sides
  std::map<FaceIds, int> EdgeFacets;
  std::vector<std::array<Index, 2>> Rims; // surfaces and ids of points on them that are inside none
};

} // namespace vfm
