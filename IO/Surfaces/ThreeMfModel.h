/**
 * ThreeMfModel: objects and build items of a model part of a 3MF file.
 */
#pragma once

#include "Surfaces/ReadSurface.h"

#include <array>
#include <map>
#include <string_view>

namespace vfm
{

/// Movement of points: three rows for x, y and z, then the translation.
using ThreeMfTransform = std::array<double, 12>;

constexpr ThreeMfTransform NoTransform{ { 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0 } };

/// Object that is part of another one, or that is built.
struct ThreeMfUse
{
  std::string Path; ///< part of the archive that has the object; empty for the same part
  std::string Object;
  ThreeMfTransform Transform = NoTransform;
  std::string Name; ///< part number of an item
};

/// Property of a triangle: a group of properties, and the number of one in it.
struct ThreeMfProperty
{
  std::string Group;
  Index Number = 0;
};

struct ThreeMfObject
{
  std::string Name, Type;
  ThreeMfProperty Property; ///< of triangles without one
  std::vector<Vector3> Points;
  std::vector<PointTriangle> Triangles;
  std::vector<int> Properties; ///< of each triangle, in PropertyNames; -1 without
  std::vector<ThreeMfUse> Components;
};

struct ThreeMfModel
{
  std::map<std::string, ThreeMfObject> Objects; ///< by id
  std::vector<ThreeMfUse> Items;
  std::vector<std::string> PropertyNames; ///< of materials and colours
};

/// Reads a part of the archive.
/// @throws InputError  if it is not XML, or numbers are damaged
ThreeMfModel ReadThreeMfModel(std::string_view text);

} // namespace vfm
