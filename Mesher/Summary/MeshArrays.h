/**
 * MeshArrays: the names under which outputs and files have the arrays of a mesh.
 */
#pragma once

#include "Mesh/Mesh.h"

namespace vfm
{

///@{ Calls visit(name, buffer) for each array, in the order of files. TheMesh: Mesh, const or not.
template <class TheMesh, class Visit>
void VisitElementArrays(TheMesh& mesh, const Visit& visit)
{
  visit("MaterialId", mesh.Material);
  visit("FragmentId", mesh.Fragment);
  visit("GlobalCellIds", mesh.ElementIds);
  if (!mesh.ScaledJacobian.empty())
  {
    visit("ScaledJacobian", mesh.ScaledJacobian);
  }
}

template <class TheMesh, class Visit>
void VisitPointArrays(TheMesh& mesh, const Visit& visit)
{
  visit("GlobalPointIds", mesh.PointIds);
  visit("GeometryDimension", mesh.GeometryDimension);
  visit("GeometryId", mesh.GeometryId);
}
///@}

} // namespace vfm
