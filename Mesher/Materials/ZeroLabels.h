/**
 * ZeroLabels: recognises label 0 that is a material, as in codes that number grains from 0.
 */
#pragma once

#include "Input/InputBlocks.h"

#include <string>

namespace vfm
{

/// Returns a note if cells with label 0 lie among the labels like a material, otherwise "".
/// Compared are, across each axis with more than one cell, the shares of cells with other labels:
/// at the sides of the domain nearly the share in the domain. The background of a
/// segmentation covers sides.
/// @param blocks blocks of the coarsest level, whose cells fill the domain
/// @param name array of labels, already checked
/// @pre Collective
std::string DescribeZeroLabel(const InputBlocks& blocks, const std::string& name, Ranks& ranks);

} // namespace vfm
