/**
 * TetAttach: attaches the points of an active tetrahedral mesh to targets on interfaces.
 */
#pragma once

#include "Base/Options.h"
#include "Elements/Facet.h"
#include "Interface/LevelInterfaces.h"
#include "Smoothing/ActiveMesh.h"

namespace vfm
{

/// Attaches every active point on interfaces to one target per pair of labels that meet there. In
/// method Cells, it is the target of the point's own node, if there is one. Else it is the target
/// of a mixed node, at most two nodes away, whose surface point is nearest. If interfaces cross
/// levels, it is a target of the finest level of the leaves at the point, or else of a coarser
/// one (LevelInterfaces::FindTarget). Pairs without a target have no attachment.
/// @param mesh,facets  the whole mesh of this rank and its facets
/// @param method  TetMethod::Lattice, or another value for meshes of Cells
/// @param active  active part of the mesh; gets the attachments
void AttachTets(const LevelInterfaces& interfaces, const Mesh& mesh,
  const std::vector<Facet>& facets, TetMethod method, Runtime& runtime, ActiveMesh& active);

} // namespace vfm
