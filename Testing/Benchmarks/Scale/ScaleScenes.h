/**
 * ScaleScenes: bodies of any number in any number of cells, of which each rank fills its own part.
 */
#pragma once

#include "Base/CartesianGrid.h"

#include <functional>
#include <string>
#include <vector>

namespace vfm
{
namespace testing
{

/// A grid of unit cells and what is in them.
struct ScaleScene
{
  Index3 Cells;
  bool AreLabels = false; ///< values are labels; otherwise fractions of one material
  /// Returns the values of the cells of a box, x fastest.
  std::function<std::vector<float>(const IndexBox&)> Fractions;
  std::function<std::vector<int>(const IndexBox&)> Labels;
};

/// Sizes of a spray, in cells.
struct SpraySizes
{
  Index Spacing = 6;                 ///< one drop per cube of this width
  double Least = 1.0, Largest = 1.9; ///< radii
};

/// Returns a scene.
/// @param name  spray: drops of random radius and place in void; grains: labels of Voronoi cells of
///   seeds, one per cube of `sizes.Spacing` cells; ball: radius .4 of the width; gyroid: period 16
///   cells, in void
/// @param size  drops or grains, or cells of a ball and a gyroid, along each axis
/// @throws InputError  if the name is unknown
ScaleScene MakeScaleScene(const std::string& name, const Index3& size, const SpraySizes& sizes);

} // namespace testing
} // namespace vfm
