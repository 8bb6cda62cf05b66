/**
 * FacetValues: values of facets from the ranks that own them.
 */
#pragma once

#include "Base/Partition.h"
#include "Elements/Facet.h"
#include "Elements/Mesh.h"

namespace vfm
{

/// Ids of the points of a facet, ascending, equal for its copies on a periodic grid.
using FacetKey = std::array<Index, 4>;
FacetKey KeyOfFacet(const Mesh& mesh, const Facet& facet);

/// Exchange of the values of facets. The partition must outlive this object.
class FacetValues
{
public:
  /// Requests facets from the ranks that own them.
  /// @param selected  facets, equal on all ranks that have them; owned ones are not requested
  /// @pre Collective among peers.
  FacetValues(const std::vector<int>& selected, const std::vector<Facet>& facets, const Mesh& mesh,
    const Partition& partition);

  /// Sets the values of the facets that other ranks own, or of their copies here.
  /// @param[in,out] values  of every facet
  /// @pre Collective among peers.
  template <class T>
  void Fetch(std::vector<T>& values) const
  {
    const std::vector<std::vector<T>> answers =
      this->Parts.Exchange(MapLists(this->ToSend, [&values](int f) { return values[f]; }));
    for (std::size_t peer = 0; peer < answers.size(); ++peer)
    {
      for (std::size_t i = 0; i < answers[peer].size(); ++i)
      {
        values[this->Requested[peer][i]] = answers[peer][i];
      }
    }
  }

private:
  const Partition& Parts;
  std::vector<std::vector<int>> Requested; // facets that each peer owns
  std::vector<std::vector<int>> ToSend;    // facets to send to each peer
};

} // namespace vfm
