/**
 * ExodusLayout: describes an Exodus file in terms of netCDF (Schoof and Yarberry, EXODUS II,
 * SAND92-2137; names of dimensions and variables as in exodusII_int.h of SEACAS).
 */
#pragma once

#include "Meshes/Exodus/ExodusModel.h"
#include "Meshes/Exodus/NetcdfLayout.h"

namespace vfm
{

/// Describes the file of this rank.
/// @param model  mesh; the layout refers to it, so it must exist until the file is written
/// @param ranks  number of ranks; the file has Nemesis data if there are several
NetcdfLayout MakeExodusLayout(const ExodusModel& model, int ranks);

/// Appends a variable, unless one of its dimensions is NoDimension.
/// @param parts  used instead of values, if it is a function
void AddVariable(NetcdfLayout& layout, const std::string& name, NetcdfKind kind,
  std::vector<std::size_t> dimensions, std::function<NetcdfValues()> values,
  std::vector<NetcdfText> attributes = {}, NetcdfParts parts = {});

constexpr std::size_t NoDimension = static_cast<std::size_t>(-1);
/// Appends a dimension, unless its length is 0, which files do not support.
/// @return its index in the layout, or NoDimension if the length is 0
std::size_t AddDimension(NetcdfLayout& layout, const std::string& name, Index length);

/// Returns the type of counts and of numbers of nodes and elements: 64 bits if the mesh has more
/// than 2^31 - 1 nodes or elements, otherwise 32 bits.
NetcdfKind KindOfNumbers(const ExodusModel& model);

} // namespace vfm
