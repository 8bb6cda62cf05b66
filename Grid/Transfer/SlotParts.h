/**
 * Which parts of elements lie in which slots, and what shape slots have from these: sums over elements in the order of their ids, so
 * that ranks change nothing.
 */
#pragma once

#include "Transfer/Overlaps.h"
#include "Transfer/Slots.h"

namespace vfm
{

struct SlotPart
{
  double Volume;
  Vector3 Centroid;
  int Slot;
};

/// Some elements and their parts: those of the i-th are Parts[Offsets[i]] to Parts[Offsets[i + 1]].
struct SlotParts
{
  std::vector<Index> Elements; ///< ascending
  std::vector<int> Offsets;
  std::vector<SlotPart> Parts;
};

/// Sums over the parts of elements in a slot; places are from the centre of its cell.
struct SlotShape
{
  Vector3 First{};                ///< of volume x place
  std::array<double, 6> Second{}; ///< of volume x place x place: xx yy zz xy xz yz
  Vector3 Lower{ { 1e300, 1e300, 1e300 } },
    Upper{ { -1e300, -1e300, -1e300 } }; ///< of the box around the places
};

/// Makes the slots that elements (ascending) need, and the sums over them: Overlap of those that this rank owns, and their shapes. What it
/// returns is in pieces, so that memory is not moved. Collective.
std::vector<SlotParts> FindSlotParts(const Mesh& mesh, const std::vector<Index>& elements,
  const CartesianGrid& grid, const Partition& partition, Runtime& runtime, SlotTable& slots,
  std::vector<SlotShape>& shapes);

/// Sets the centroids of the slots, from which places in their shapes are from then on.
void CentreShapes(SlotTable& slots, std::vector<SlotShape>& shapes);

} // namespace vfm
