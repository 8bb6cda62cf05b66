/**
 * HostRefinement: the cells that a host names to be refined, on one rank, for its next mesh.
 */
#pragma once

#include "HostGrid.h"
#include "Mesher.h"
#include "Ranks/Ranks.h"

#include <map>

namespace vfm
{

class HostRefinement
{
public:
  /// How many times each cell of a box is to be halved, by the place of the box in the grid of this rank; not copied. Null: none.
  void Set(std::size_t box, const int* halvings) { this->Halvings[box] = halvings; }

  /// Collective: whether any rank names cells; then all boxes get an array of them, those without one of zeros, which must not outlive this.
  bool AddTo(HostGrid& grid, Ranks& ranks);

private:
  std::map<std::size_t, const int*> Halvings;
  std::vector<std::vector<int>> Zeros; // of boxes
};

/// Sets the options for a mesh whose cells are refined where AddTo says, besides what they ask.
void RefineNamedCells(MesherOptions& options);

} // namespace vfm
