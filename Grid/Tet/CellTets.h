/**
 * The tets of the method Cells.
 */
#pragma once

#include "Base/Runtime.h"
#include "Labels/Labels.h"
#include "Tet/TetTopology.h"

namespace vfm
{

class CoarseTets;

/// Every meshed cell with its centre, cut along its faces. labels: after ResolveLabels. Interfaces are faces of the grid,
/// each quad cut by the diagonal of its parity. coarse: the tets beside those of finest cells.
TetTopology BuildCellTets(const CartesianGrid& grid, const LabelArray& labels, bool meshVoid,
  Runtime& runtime, const CoarseTets& coarse);

} // namespace vfm
