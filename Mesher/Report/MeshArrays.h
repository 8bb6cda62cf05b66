/**
 * MeshArrays: names of the arrays of a mesh in outputs and files.
 */
#pragma once

#include "Elements/Mesh.h"

namespace vfm
{

///@{ Calls visit(name, buffer) for each array, in the order of files. TheMesh: Mesh or const Mesh.
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
  if (!mesh.Layer.empty())
  {
    visit("Layer", mesh.Layer);
  }
}

template <class TheMesh, class Visit>
void VisitPointArrays(TheMesh& mesh, const Visit& visit)
{
  visit("GlobalPointIds", mesh.PointIds);
  visit("GeometryDimension", mesh.GeometryDimension);
  visit("GeometryId", mesh.GeometryId);
  if (!mesh.PeriodicPartner.empty())
  {
    visit("PeriodicPartner", mesh.PeriodicPartner);
  }
  if (!mesh.OriginalPointIds.empty())
  {
    visit("OriginalPointIds", mesh.OriginalPointIds);
  }
}
///@}

} // namespace vfm
