/**
 * CreaseRules: which points of a mesh carry the edges and corners of its interfaces. All rules look at the facets of one pair of labels, quads or
 * triangles, and at all points at once, so that no order matters; after each a rank tells the others what has become of the points it owns.
 *
 * - Corner: of the points within three facets, the nearest to it.
 * - Cover: of two points on different sides that a mesh edge joins, the one nearer to its edge becomes a carrier. So no mesh edge
 *   joins two sides, and the chain of carriers has no gaps. In tets so does, then, a point on a side that is none of those of a carrier beside it.
 * - Zigzag, in hexes: of a quad that has carriers on one diagonal alone, the nearer of the others becomes one too, unless a quad would then have four: edges of
 *   interfaces run along mesh edges rather than across quads.
 * - Chains: carriers in pieces of fewer than nine, each beside the next with about the same angle between its surfaces, are none.
 * - Sides without a carrier within three facets are none.
 */
#pragma once

#include "Base/Vector3.h"
#include "Mesh/CreaseKind.h"
#include "Mesh/Facet.h"
#include "Smoothing/ActiveMesh.h"

namespace vfm
{

/// What is known of a point and a pair of labels from the model there. Distances in cells, from acute edges and their corners less: times their bluntness, because cells
/// beside these have less than half of the label, so its interface starts farther away.
struct CreasePoint
{
  CreaseKind Kind = CreaseKind::None;
  Vector3 Normal{};                     ///< of the side
  bool IsSheet = false;                 ///< a thin gap or film: it needs no edge near
  double EdgeDistance = 1e30;           ///< of the nearest edge
  std::array<Vector3, 2> EdgeNormals{}; ///< of the surfaces that meet there
  Vector3 Corner{};                     ///< grid coordinates
  double CornerDistance = 1e30;         ///< such: there is none
};

class CreaseRules
{
public:
  /// The labels of the pair that an attachment belongs to, the smaller first.
  using LabelsOf = std::function<std::array<int, 2>(const Attachment&)>;

  /// points: of each attachment of the mesh; those at points of other ranks come from these. Keeps references to the last and to active. Collective among peers, as all here.
  CreaseRules(const std::vector<Facet>& facets, const Mesh& mesh, const ActiveMesh& active,
    LabelsOf labelsOf, std::vector<CreasePoint>& points);

  /// Applies the rules: changes the kinds of the points.
  void Run();

  /// Of each point of the active mesh: the highest kind of its attachments, the same on all ranks that hold it.
  std::vector<CreaseKind> KindsOfPoints() const;

private:
  /// Attachments of the corners of a facet, -1: none.
  struct RuleFacet
  {
    std::array<int, 4> At;
    int Count;
  };

  int FindAttachment(Index meshPoint, const std::array<int, 2>& labels) const;
  void ListFacets(const std::vector<Facet>& facets);
  template <class Value>
  void Exchange(std::vector<Value>& values) const;
  template <class Value, class Merge>
  void Spread(std::vector<Value>& values, int rounds, const Merge& merge) const;
  template <class Visitor>
  void ForEdges(const Visitor& visit) const;
  void MakeCarriers(const std::vector<int>& chosen);
  void ExchangeKinds();
  bool IsCarrierAt(int attachment) const
  {
    return attachment >= 0 && IsCarrier(this->Points[attachment].Kind);
  }
  bool IsNearer(int a, int b) const;
  bool ShareSide(int a, int b) const;
  std::vector<unsigned char> FindWilling() const;

  void PickCorners();
  void Cover();
  void StraightenZigzags();
  void DropShortChains();
  void DropFarSides();

  const ActiveMesh& Active;
  const LabelsOf Labels;
  std::vector<CreasePoint>& Points;
  std::vector<Index> Ids; // of the point of each attachment
  std::vector<unsigned char>
    IsKnown; // of each attachment: its pair is among those of the point that ranks tell each other
  std::vector<RuleFacet> Facets;
};

} // namespace vfm
