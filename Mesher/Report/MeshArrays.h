/**
 * MeshArrays: the arrays of a mesh, with their names and types in outputs and files.
 */
#pragma once

#include "Input/ValueType.h"

#include <optional>
#include <string>

namespace vfm
{

/// An array with one value per point or element.
struct KnownArray
{
  const char* Name;
  int Type;                ///< ValueType of the values in Mesh and MeshData
  bool IsOptional = false; ///< outputs have the array only if it has values
  bool IsShown = false;    ///< only people and ModifyMesh read the array

  /// Returns whether outputs have the array.
  template <class Values>
  bool IsOutput(const Values& values) const
  {
    return !this->IsOptional || !values.empty();
  }
};

///@{ Calls visit(KnownArray, values of each of the meshes) for each array, in the order of files.
/// The meshes are of type Mesh or MeshData, which have the same names.
template <class Visit, class... Meshes>
void VisitPointArrays(const Visit& visit, Meshes&... meshes)
{
  visit(KnownArray{ "GlobalPointIds", ValueType::Id }, meshes.PointIds...);
  visit(KnownArray{ "GeometryDimension", ValueType::Int }, meshes.GeometryDimension...);
  visit(KnownArray{ "GeometryId", ValueType::Int }, meshes.GeometryId...);
  visit(KnownArray{ "PeriodicPartner", ValueType::Id, true }, meshes.PeriodicPartner...);
  visit(KnownArray{ "OriginalPointIds", ValueType::Id, true }, meshes.OriginalPointIds...);
}

template <class Visit, class... Meshes>
void VisitElementArrays(const Visit& visit, Meshes&... meshes)
{
  visit(KnownArray{ "MaterialId", ValueType::Int }, meshes.Material...);
  visit(KnownArray{ "FragmentId", ValueType::Int }, meshes.Fragment...);
  visit(KnownArray{ "GlobalCellIds", ValueType::Id }, meshes.ElementIds...);
  visit(KnownArray{ "ScaledJacobian", ValueType::Float, true, true }, meshes.ScaledJacobian...);
  visit(KnownArray{ "Layer", ValueType::Int, true, true }, meshes.Layer...);
}
///@}

/// Returns the array of points or elements with a name.
inline std::optional<KnownArray> FindKnownArray(const std::string& name)
{
  std::optional<KnownArray> found;
  const auto check = [&](const KnownArray& array)
  {
    if (name == array.Name)
    {
      found = array;
    }
  };
  VisitPointArrays(check);
  VisitElementArrays(check);
  return found;
}

} // namespace vfm
