/**
 * SidePoints: which smooth sides of interfaces the points of facets are inside of.
 *
 * Points carry edges as they are told to; an edge also goes on over some points around which the facets turn, so that gaps close. The others
 * that are on one interface alone, joined over the edges of facets, are the pieces that edges leave: the sides (SmoothSides.h).
 */
#pragma once

#include "Base/Groups.h"
#include "Base/Vector3.h"
#include "Labels/Fragments.h"
#include "Mesh/CreaseKind.h"
#include "Mesh/Facet.h"
#include "Mesh/PointValues.h"

namespace vfm
{

/// Of a facet, unit, out of the larger of SurfaceOf.
Vector3 NormalOf(const Mesh& mesh, const Facet& facet);

/// The facets for which isListed(facet) holds at each point of the mesh.
template <class Condition>
Groups<int> ListFacetsAt(
  const std::vector<Facet>& facets, const Mesh& mesh, const Condition& isListed)
{
  return MakeGroups<int>(mesh.PointIds.size(),
    [&](const auto& visit)
    {
      for (int f = 0; f < static_cast<int>(facets.size()); ++f)
      {
        for (int c = 0; isListed(f) && c < mesh.CornersOfFacet(); ++c)
        {
          visit(facets[f].Points[c], f);
        }
      }
    });
}

class SidePoints
{
public:
  /// As of FindSmoothSides; facets and mesh outlive it. Collective.
  SidePoints(const std::vector<Facet>& facets, const std::vector<CreaseKind>& kinds,
    const Mesh& mesh, const Partition& partition);

  /// The interface of a facet among those with edges, from 0; -1: it has none.
  int CutOf(std::size_t facet) const { return this->CutOfFacet[facet]; }
  int NumberOfCuts() const { return static_cast<int>(this->Cuts.size()); }
  /// The side of a point, numbered from 1 over all ranks by the lowest point; 0: on an edge, on several interfaces or on one without edges.
  int SideOf(Index point) const { return this->SideOfPoint[point]; }
  /// The interface of each side; [0] unused.
  const std::vector<int>& CutsOfSides() const { return this->CutOfSide; }

private:
  using Pair = std::array<int, 2>;
  /// Where a point lies on the interfaces.
  enum class Place : unsigned char
  {
    None,
    Inside,
    OnEdge,
    Between ///< on several surfaces
  };
  std::vector<Index> ListPoints() const;
  void FindPlaces(const std::vector<CreaseKind>& kinds);
  void CloseGaps();
  bool IsBesideEdge(const int* first, const int* last) const;
  bool IsSharp(const int* first, const int* last) const;
  void FindCuts();
  void NumberPoints();
  void NumberPieces(const std::vector<Piece>& pieces, const std::vector<Index>& pieceOf);

  const std::vector<Facet>& Facets;
  const Mesh& Input;
  const Partition& Parts;
  const int Corners; // of a facet
  const PointValues Shared;
  std::vector<Place> PlaceOf;  // of every point
  std::vector<Pair> Cuts;      // interfaces with edges, ascending
  std::vector<int> CutOfFacet; // position in Cuts, or -1
  std::vector<int> SideOfPoint, CutOfSide;
};

} // namespace vfm
