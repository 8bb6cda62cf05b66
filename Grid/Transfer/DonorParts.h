/**
 * DonorParts: finds the parts of elements in donors, and the shapes of donors from these parts.
 * Sums over elements are in the order of their ids, so results do not depend on ranks.
 */
#pragma once

#include "Transfer/Donors.h"
#include "Transfer/Overlaps.h"

namespace vfm
{

/// Part of an element in a donor.
struct DonorPart
{
  double Volume;    ///< length units cubed
  Vector3 Centroid; ///< world coordinates
  int Donor;
};

/// Some elements and their parts. Element i has Parts[Offsets[i]] to before Parts[Offsets[i + 1]].
/// Parts of regular tets are not stored, because cutting them again is cheap.
struct DonorParts
{
  std::vector<Index> Elements; ///< indices in the mesh, ascending
  std::vector<int> Offsets;
  std::vector<DonorPart> Parts;
};

/// Donors of the cells that were searched last, because consecutive elements are mostly in the same
/// cells.
class RecentDonors
{
public:
  /// Returns the donor of a part.
  /// @param place  position of the part in its element
  /// @param search  search(cell, fragment) returns the donor if it is not a recent one
  template <class Search>
  int Find(std::size_t place, Index cell, int fragment, const Search& search)
  {
    Entry& entry = this->Recent[place % this->Recent.size()];
    if (entry.Cell != cell || entry.Fragment != fragment)
    {
      entry = { cell, fragment, search(cell, fragment) };
    }
    return entry.Donor;
  }

private:
  struct Entry
  {
    Index Cell = -1;
    int Fragment = 0, Donor = 0;
  };
  std::array<Entry, 8> Recent;
};

/// Reads the parts of elements whose donors exist. Each thread has its own reader. The arguments of
/// the constructor must outlive it.
class PartReader
{
public:
  PartReader(const Mesh& mesh, const CartesianGrid& grid, const RegularTets& regular,
    const DonorTable& donors) :
    TheMesh(mesh), Grid(grid), Regular(regular), Donors(donors)
  {
  }

  /// Calls body(part) for the parts of element i of a list.
  template <class Body>
  void ForParts(const DonorParts& some, std::size_t i, const Body& body)
  {
    if (some.Offsets[i] < some.Offsets[i + 1])
    {
      std::for_each(
        some.Parts.begin() + some.Offsets[i], some.Parts.begin() + some.Offsets[i + 1], body);
      return;
    }
    std::array<OverlapPart, 2> parts;
    const int count = this->Regular.Cut(some.Elements[i], parts);
    for (int p = 0; p < count; ++p)
    {
      body(DonorPart{
        parts[p].Volume, parts[p].Centroid, this->FindDonor(p, parts[p].Cell, some.Elements[i]) });
    }
  }

private:
  int FindDonor(std::size_t place, Index cell, Index element)
  {
    return this->Recent.Find(place, cell, this->TheMesh.Fragment[element],
      [this](Index of, int fragment)
      {
        const Index3 p = CellInBox(this->Grid.Local(), of);
        return this->Donors.Find(this->Grid.Linear(p), fragment);
      });
  }

  const Mesh& TheMesh;
  const CartesianGrid& Grid;
  const RegularTets& Regular;
  const DonorTable& Donors;
  RecentDonors Recent;
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

/// Cuts elements by cells, and makes the donors of their parts. Adds the parts to Donor::Overlap
/// and to the shapes of owned donors, and sets Donor::HasParts of copies.
/// @param mesh  elements owned by this rank, with fragments
/// @param elements  indices of the elements to cut, ascending
/// @param shapes  shapes of all donors; extended to the new ones
/// @return parts of all elements, in several lists to avoid reallocation
/// @pre Collective.
std::vector<DonorParts> FindDonorParts(const Mesh& mesh, const std::vector<Index>& elements,
  const CartesianGrid& grid, const RegularTets& regular, const Partition& partition,
  Runtime& runtime, DonorTable& donors, std::vector<DonorShape>& shapes);

/// Moves the centroid of each donor from the cell centre to the centroid of its parts, and makes
/// shapes relative to it.
void CentreShapes(DonorTable& donors, std::vector<DonorShape>& shapes);

} // namespace vfm
