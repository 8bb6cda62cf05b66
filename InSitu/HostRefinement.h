/**
 * HostRefinement: user-selected cells of one rank, which are refined in the next mesh.
 */
#pragma once

#include "HostGrid.h"
#include "Mesher.h"
#include "Ranks/Ranks.h"

#include <map>

namespace vfm
{

/// Refinement requests of a host by box. Their values belong to the host.
class HostRefinement
{
public:
  /// Sets the request of a box.
  /// @param box  index of the box in HostGrid::Boxes
  /// @param halvings  number of halvings along each axis per cell, not copied; null: no requests
  void Set(std::size_t box, const int* halvings) { this->Halvings[box] = halvings; }

  /// Adds the requests as arrays to all boxes, with zeros for boxes without requests, if any rank
  /// has requests. The zeros belong to this object.
  /// @return whether arrays were added, equal on all ranks
  /// @pre Collective
  bool AddTo(HostGrid& grid, Ranks& ranks);

private:
  std::map<std::size_t, const int*> Halvings;
  std::vector<std::vector<int>> Zeros; // arrays of boxes without requests
};

/// Changes the options so that the requests added by AddTo are met, in addition to the refinement
/// that the options request.
void RefineNamedCells(MesherOptions& options);

} // namespace vfm
