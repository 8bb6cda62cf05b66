/**
 * PointValues: values of mesh points from the ranks that own the points.
 */
#pragma once

#include "Base/Partition.h"
#include "Elements/Mesh.h"

namespace vfm
{

/// Exchange of the values of selected points. The partition must outlive this object.
class PointValues
{
public:
  /// Requests points from the ranks that own their nodes.
  /// @param points  points of the mesh of this rank; owned points are ignored
  /// @pre Collective among peers.
  PointValues(const std::vector<Index>& points, const Mesh& mesh, const Partition& partition);

  /// Calls received(point, value) with the owner's value of each requested point. The value is T()
  /// if the owner does not have the point.
  /// @param values  value of every point of the mesh
  /// @pre Collective among peers.
  template <class T, class Received>
  void Fetch(const std::vector<T>& values, const Received& received) const
  {
    const std::vector<std::vector<T>> answers = this->Parts.Exchange(
      MapLists(this->ToSend, [&values](Index p) { return p < 0 ? T() : values[p]; }));
    for (std::size_t peer = 0; peer < answers.size(); ++peer)
    {
      for (std::size_t i = 0; i < answers[peer].size(); ++i)
      {
        received(this->Requested[peer][i], answers[peer][i]);
      }
    }
  }

private:
  const Partition& Parts;
  std::vector<std::vector<Index>> Requested; // points requested from each peer
  std::vector<std::vector<Index>> ToSend;    // points to send to each peer; -1: not in the mesh
};

} // namespace vfm
