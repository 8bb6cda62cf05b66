/**
 * Cases like the data of users: label images of brains, sprays of drops, pores.
 */
#pragma once

#include "MeshCases.h"

namespace vfm
{
namespace testing
{

/// Returns a case whose true interface is not known.
MeshCase WithoutDistance(const CartesianGrid& grid, FractionField fractions);

/// Returns such a case of labels.
/// @param passes  label smoothing
MeshCase MakeSmoothedCase(const CartesianGrid& grid, FractionField labels, int passes);

/// Returns drops without contact in n^3 unit cells of void, radii .8 to 2.2 cells at random. Fewer
/// than `drops` if they do not fit.
MeshCase MakeSprayCase(int n, int drops, unsigned seed);

/// Returns labels of connected and other pores in n^3 unit cells: 60 % of smoothed noise. The other
/// 40 % are void.
MeshCase MakePoresCase(int n, int passes, unsigned seed);

/// Returns an image of labels (ReadLabelImage.h).
/// @param name  file in the folder of Debian's package mricron-data, without .nii.gz
/// @param passes  label smoothing
/// @param cells  size of the cube in the middle of the image that is read; 0: the whole image
/// @throws InputError  if the file cannot be read
MeshCase MakeImageCase(const std::string& name, int passes, Index cells = 0);

} // namespace testing
} // namespace vfm
