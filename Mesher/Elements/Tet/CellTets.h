/**
 * CellTets: the tets of the method Cells, whose interfaces are faces of the grid.
 */
#pragma once

#include "Base/Runtime.h"
#include "Elements/Tet/TetTopology.h"
#include "Labels/NarrowVoid.h"

namespace vfm
{

class CoarseTets;

/// Divides every meshed cell around its centre into tets. Four tets surround the edge between the
/// centres of two cells of one label. A quad on an interface or the domain boundary is divided
/// along the diagonal of its parity.
/// @param labels  labels of the cells, after ResolveLabels
/// @param narrow  void cells that get tets as a barrier; empty if void is meshed
/// @param coarse  tets of the coarse cells; they are added after the tets of the finest cells
/// @return points and tets in CartesianGrid::HexBox, ordered by id
/// @throws InputError  if ids or numbers of points are too large
/// @pre Collective.
TetTopology BuildCellTets(const LabelArray& labels, bool meshVoid, const NarrowVoid& narrow,
  Runtime& runtime, const CoarseTets& coarse);

} // namespace vfm
