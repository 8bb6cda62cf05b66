/**
 * WriteGeometry: writes the surfaces, curves and vertices of a mesh as VTK's XML file .vtm.
 */
#pragma once

#include "Ranks/Ranks.h"

#include <optional>
#include <string>

namespace vfm
{

struct Mesh;

/// Returns the reason why a file of this name is not supported, or "" if it is.
std::string FindGeometryProblem(const std::string& path);

/// Writes the blocks of GatherGeometry on rank 0: the file NAME.vtm and one file NAME/NAME_N.vtp
/// per block. Their contents do not depend on the number of ranks.
/// @param mesh  part of this rank
/// @param time  time of the data
/// @param path  path of NAME.vtm
/// @throws InputError  if a file cannot be written, on all ranks; contains the reason, not the path
/// @pre Collective
void WriteGeometry(
  const Mesh& mesh, const std::optional<double>& time, const std::string& path, Ranks& ranks);

} // namespace vfm
