/**
 * PackedLists: ids and facets in less memory, while points move and nothing reads them.
 */
#pragma once

#include "Elements/Facet.h"
#include "Elements/Mesh.h"

#include <vector>

namespace vfm
{

/// Ids as differences of consecutive ids, in one byte each if they are small.
class PackedIds
{
public:
  /// Takes the ids.
  explicit PackedIds(Buffer<Index>& ids);
  /// Returns the ids.
  Buffer<Index> Unpack() const;

private:
  std::size_t Count;
  std::vector<unsigned char> Bytes;
};

/// Facets in 28 bytes each.
class PackedFacets
{
public:
  /// Takes the facets.
  /// @pre All cells of a fragment have one material, and cells without a fragment are void.
  explicit PackedFacets(std::vector<Facet>& facets);
  /// Returns the facets.
  std::vector<Facet> Unpack() const;

private:
  struct Packed
  {
    std::array<int, 4> Points;
    std::array<int, 2> Fragments;
    signed char DomainSide;
    bool IsOwned;
  };
  std::vector<Packed> Facets;
  std::vector<int> Materials; // material of each fragment
};

/// The ids of a mesh and its facets.
class PackedLists
{
public:
  /// Takes the lists.
  PackedLists(Mesh& mesh, std::vector<Facet>& facets) :
    PointIds(mesh.PointIds), ElementIds(mesh.ElementIds), Facets(facets)
  {
  }
  /// Gives them back.
  void Unpack(Mesh& mesh, std::vector<Facet>& facets) const
  {
    mesh.PointIds = this->PointIds.Unpack();
    mesh.ElementIds = this->ElementIds.Unpack();
    facets = this->Facets.Unpack();
  }

private:
  PackedIds PointIds, ElementIds;
  PackedFacets Facets;
};

} // namespace vfm
