/**
 * Which parts of elements lie in which donors, and what shape donors have from these: sums over elements in the order of their ids, so
 * that ranks change nothing.
 */
#pragma once

#include "Transfer/Donors.h"
#include "Transfer/Overlaps.h"

namespace vfm
{

struct DonorPart
{
  double Volume;
  Vector3 Centroid;
  int Donor;
};

/// Some elements and their parts: those of the i-th are Parts[Offsets[i]] to Parts[Offsets[i + 1]].
struct DonorParts
{
  std::vector<Index> Elements; ///< ascending
  std::vector<int> Offsets;
  std::vector<DonorPart> Parts;
};

/// Sums over the parts of elements in a donor; places are from the centre of its cell.
struct DonorShape
{
  Vector3 First{};                ///< of volume x place
  std::array<double, 6> Second{}; ///< of volume x place x place: xx yy zz xy xz yz
  Vector3 Lower{ { 1e300, 1e300, 1e300 } },
    Upper{ { -1e300, -1e300, -1e300 } }; ///< of the box around the places
};

/// Makes the donors that elements (ascending) need, and the sums over them: Overlap of those that this rank owns, and their shapes. What it
/// returns is in pieces, so that memory is not moved. Collective.
std::vector<DonorParts> FindDonorParts(const Mesh& mesh, const std::vector<Index>& elements,
  const CartesianGrid& grid, const Partition& partition, Runtime& runtime, DonorTable& donors,
  std::vector<DonorShape>& shapes);

/// Sets the centroids of the donors, from which places in their shapes are from then on.
void CentreShapes(DonorTable& donors, std::vector<DonorShape>& shapes);

} // namespace vfm
