/**
 * ExodusLayout: an Exodus file in terms of netCDF (Schoof and Yarberry, EXODUS II, SAND92-2137; names of dimensions and
 * variables as in SEACAS' exodusII_int.h).
 */
#pragma once

#include "Meshes/ExodusModel.h"
#include "Meshes/NetcdfLayout.h"

namespace vfm
{

/// A file of one of several ranks, or of the only one. The layout refers to the model.
NetcdfLayout MakeExodusLayout(const ExodusModel& model, int ranks);

/// Appends a variable, unless a dimension is NoDimension.
void AddVariable(NetcdfLayout& layout, const std::string& name, NetcdfKind kind,
  std::vector<std::size_t> dimensions, std::function<NetcdfValues()> values,
  std::vector<NetcdfText> attributes = {});

constexpr std::size_t NoDimension = static_cast<std::size_t>(-1);
/// Appends a dimension. @return its place; NoDimension of length 0, which files do not have.
std::size_t AddDimension(NetcdfLayout& layout, const std::string& name, Index length);

/// Of counts, numbers and maps, which are wide where a mesh has more than 2^31 - 1 nodes or elements.
NetcdfKind KindOfNumbers(const ExodusModel& model);

} // namespace vfm
