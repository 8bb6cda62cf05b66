/**
 * PointValues: values of points of a mesh, from the ranks that own them.
 */
#pragma once

#include "Base/Partition.h"
#include "Mesh/Mesh.h"

namespace vfm
{

class PointValues
{
public:
  /// points: those of this rank's mesh whose values it wants to be as their owners have them. Collective among peers.
  PointValues(const std::vector<Index>& points, const Mesh& mesh, const Partition& partition);

  /// Calls received(point, value) with the owner's value of each point of another rank; T() where that has no such point. values: of every
  /// point of the mesh. Collective among peers.
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
  std::vector<std::vector<Index>> Requested; // of each peer
  std::vector<std::vector<Index>> ToSend;    // by each peer; -1: not here
};

} // namespace vfm
