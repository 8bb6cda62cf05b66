/**
 * DonorParts: finds the parts of elements in donors, and the shapes of donors from these parts.
 * Sums over regular tets are of integers, and sums over other elements are in the order of their
 * ids, so results do not depend on ranks.
 */
#pragma once

#include "State/Transfer/Donors.h"
#include "State/Transfer/Overlaps.h"
#include "State/Transfer/RegularTets.h"

namespace vfm
{

/// Part of an element in a donor.
struct DonorPart
{
  double Volume;    ///< length units cubed
  Vector3 Centroid; ///< world coordinates
  int Donor;
};

/// Donors of the parts of a regular tet, -1 if there is no such part, and their kinds.
struct RegularDonors
{
  std::array<int, 2> Donor{ { -1, -1 } };
  std::array<std::uint8_t, 2> Kind{};
};

/// Some elements and their parts. Element i has Parts[Offsets[i]] to before Parts[Offsets[i + 1]],
/// or if it is a regular tet, the parts Regular[i]. Regular is empty for hexes.
struct DonorParts
{
  Index First = 0;           ///< index in the mesh from which Elements count
  std::vector<int> Elements; ///< indices in the mesh minus First, ascending
  std::vector<int> Offsets;
  std::vector<DonorPart> Parts;
  std::vector<RegularDonors> Regular;

  Index ElementAt(std::size_t i) const { return this->First + this->Elements[i]; }
};

/// Moments of the parts in a donor. Positions are the centroids
/// of parts, relative to Donor::Centroid.
struct DonorShape
{
  Vector3 First{};                ///< sum of volume x position, before CentreShapes
  std::array<double, 6> Second{}; ///< sum of volume x position x position: xx yy zz xy xz yz
  /// Bounding box of the positions.
  Vector3 Lower{ { 1e300, 1e300, 1e300 } }, Upper{ { -1e300, -1e300, -1e300 } };
};

using DonorShapes = std::vector<DonorShape>;

/// Cuts elements by cells, and makes the donors of their parts. Adds the parts to Donor::Overlap
/// and to the shapes of owned donors, and sets Donor::HasParts of copies.
/// @param mesh  elements owned by this rank, with fragments
/// @param isNeeded  isNeeded(element) returns whether to cut an element of the mesh
/// @param shapes  shapes of all donors; extended to the new ones
/// @return parts of all elements, in several lists to avoid reallocation
/// @pre Collective.
std::vector<DonorParts> FindDonorParts(const Mesh& mesh,
  const std::function<bool(Index element)>& isNeeded, const CartesianGrid& grid,
  const RegularTets& regular, const Partition& partition, Runtime& runtime, DonorTable& donors,
  DonorShapes& shapes);

/// Moves the centroid of each donor from the cell centre to the centroid of its parts, and makes
/// shapes relative to it.
void CentreShapes(DonorTable& donors, DonorShapes& shapes);

} // namespace vfm
