/**
 * ReadLabelImage: reads an image of labels for a benchmark.
 */
#pragma once

#include "Fractions/FractionField.h"

#include <string>

namespace vfm
{
namespace testing
{

/// An image of labels as whole cells of materials.
struct LabelImage
{
  CartesianGrid Grid;     ///< cells of width 1
  FractionField Labels;   ///< label n of the image, ascending, is material n; 0 is void
  std::vector<int> Names; ///< label in the image of each material; [0] is 0
};

/// Reads an image file of integers (ImageFile.h).
/// @param cells  size of the cube in the middle of the image that is read; 0: the whole image
/// @throws InputError  if the file cannot be read
LabelImage ReadLabelImage(const std::string& path, Index cells);

} // namespace testing
} // namespace vfm
