/**
 * StraightenEdges: moves mid nodes back towards the middles of their edges until the elements there
 * are positive throughout.
 *
 * An element is positive if all Bezier coefficients of its Jacobian are (CurvedElement.h). Straight
 * elements are, so the search ends. The smallest coefficient also stays above a part of that of the
 * straight element, so that elements keep some of their quality.
 */
#pragma once

#include "Base/Runtime.h"
#include "Elements/Mesh.h"
#include "Modify/PeriodImages.h"

#include <vector>

namespace vfm
{

/// Edges whose mid node is off the middle.
struct CurvedEdges
{
  std::vector<EdgeIds> Ids;      ///< the same on all ranks that have the edge
  std::vector<EdgeIds> Groups;   ///< edges of a group are moved back by the same part
  std::vector<Vector3> Moves;    ///< displacement of each mid node
  std::vector<Index> OfMidPoint; ///< for each mid point of an edge, from 0: its curved edge, or -1
};

/// Counts over all ranks.
struct CurvedReport
{
  Index Curved = 0, Straightened = 0; ///< mid nodes off the middle; of these, moved back
  double SmallestRatio = 1.0;         ///< of the coefficients of curved and straight elements
};

/// Scales the displacements of mid nodes.
/// @param mesh  with MidPoints, at straight positions
/// @param firstMid  first point that is a mid point of an edge
/// @param images  places the corners of elements near to each other
/// @pre Collective over runtime.Group().
CurvedReport StraightenEdges(const Mesh& mesh, Index firstMid, const PeriodImages& images,
  Runtime& runtime, CurvedEdges& edges);

} // namespace vfm
