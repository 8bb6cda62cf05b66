/**
 * WriteGeometry: the surfaces, curves and vertices of a mesh as VTK's XML file of blocks, .vtm.
 */
#pragma once

#include "Ranks/Ranks.h"

#include <optional>
#include <string>

namespace vfm
{

struct Mesh;

/// Says why files of that name are not written; "" where they are.
std::string FindGeometryProblem(const std::string& path);

/// Collective: path, NAME.vtm, of the blocks of GatherGeometry, each of which is a file NAME/NAME_N.vtp. Rank 0 writes them, the same bytes
/// from any number of ranks. mesh: this rank's part. time: of the data. Throws InputError, with the reason but without the path, on all
/// ranks when the files cannot be written.
void WriteGeometry(
  const Mesh& mesh, const std::optional<double>& time, const std::string& path, Ranks& ranks);

} // namespace vfm
