/**
 * FlatData: what differs in the data of a mesh of a plane. Such a mesh has quads (4 corners) or
 * triangles (3), whose sides are edges: side s joins corner s and the next one.
 */
#pragma once

#include "Elements/ElementFaces.h"
#include "Report/MeshData.h"

namespace vfm
{

/// Name of the field with the axis across the plane. It is the first field of a mesh of a plane.
constexpr const char* FlatAxisName = "FlatAxis";
/// Name of the field with the thickness of the layer from which the plane was made.
constexpr const char* FlatThicknessName = "FlatThickness";

constexpr ElementShape FlatShapes[] = {
  { 4, 0, 4, 4, 2, 9, "quadrilaterals" }, // VTK_QUAD
  { 3, 0, 3, 3, 2, 5, "triangles" },      // VTK_TRIANGLE
};

/// Returns whether a mesh is one of a plane.
inline bool IsFlat(const MeshData& mesh)
{
  return !mesh.Fields.empty() && mesh.Fields.front().Name == FlatAxisName;
}

/// Returns the kind of the elements.
inline const ElementShape& ShapeOf(const MeshData& mesh)
{
  return IsFlat(mesh) ? FlatShapes[mesh.Corners == 4 ? 0 : 1] : mesh.Shape();
}

/// Returns the number of sides of every element.
inline int SidesOf(const MeshData& mesh)
{
  return ShapeOf(mesh).Faces;
}

/// Returns the number of corners of every side.
inline int CornersOfSide(const MeshData& mesh)
{
  return ShapeOf(mesh).CornersOfFace;
}

/// Returns the least dimension of points that are on no interface and on no side of the domain.
inline int DimensionInside(const MeshData& mesh)
{
  return IsFlat(mesh) ? DimensionOfSurfaces : DimensionOfVolumes;
}

/// Moves the field FlatAxis, if it exists, to the front.
inline void PutFlatAxisFirst(std::vector<FieldArray>& fields)
{
  const auto found = std::find_if(fields.begin(), fields.end(),
    [](const FieldArray& field) { return field.Name == FlatAxisName; });
  if (found != fields.end())
  {
    std::rotate(fields.begin(), found, found + 1);
  }
}

} // namespace vfm
