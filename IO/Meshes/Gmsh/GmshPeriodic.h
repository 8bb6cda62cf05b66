/**
 * GmshPeriodic: pairs of nodes on opposite sides of the domain, the section $Periodic of Gmsh.
 *
 * Each surface on an upper side has a link with the surface on the lower side that has the copies
 * of its faces, or with several of them where volumes meet on the sides. A link has the translation
 * by one period and the pairs of nodes. Files of version 2.2 have no links: Gmsh reads them before
 * it has the surfaces, and MFEM takes the ids for numbers of nodes.
 */
#pragma once

#include "Meshes/Gmsh/GmshFile.h"
#include "Meshes/Gmsh/GmshModel.h"

namespace vfm
{

/// Copies of the nodes of a surface on another one.
struct GmshLink
{
  int Copy, Master;                        ///< surfaces, from 1
  int Axis;                                ///< axis of the image along which they are copies
  std::vector<std::array<Index, 2>> Nodes; ///< points on the copy and on the master, ascending
};

/// Returns the links of a mesh, by surfaces; none if the mesh is not periodic.
/// @throws InputError if FindPeriodicPairs does
std::vector<GmshLink> FindGmshLinks(const GmshModel& model);

/// Writes the section, or nothing if there are no links.
void WriteLinks(GmshFile& file, const MeshData& mesh, const std::vector<GmshLink>& links);

} // namespace vfm
