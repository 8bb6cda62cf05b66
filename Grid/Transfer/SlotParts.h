/**
 * Which parts of elements lie in which slots, and what shape slots have from these: sums over elements in the order of their ids, so
 * that ranks change nothing.
 */
#pragma once

#include "Transfer/Overlaps.h"
#include "Transfer/Slots.h"

namespace vfm
{

/// The parts of some elements.
struct SlotParts
{
  std::vector<Index> Elements; ///< ascending
  Overlaps Cells;              ///< of each of these
  std::vector<int> Slots;      ///< of each part
};

/// Sums over the parts of elements in a slot; places are from the centre of its cell.
struct SlotShape
{
  Vector3 First{};                ///< of volume x place
  std::array<double, 6> Second{}; ///< of volume x place x place: xx yy zz xy xz yz
  Vector3 Lower{ { 1e300, 1e300, 1e300 } },
    Upper{ { -1e300, -1e300, -1e300 } }; ///< of the box around the places
};

/// Makes the slots that elements need, and the sums over them: Overlap of those that this rank owns, and their shapes. Collective.
SlotParts FindSlotParts(const Mesh& mesh, std::vector<Index> elements, const CartesianGrid& grid,
  const Partition& partition, Runtime& runtime, SlotTable& slots, std::vector<SlotShape>& shapes);

/// Sets the centroids of the slots, from which places in their shapes are from then on.
void CentreShapes(SlotTable& slots, std::vector<SlotShape>& shapes);

} // namespace vfm
