/**
 * Second-order meshes of several ranks by global ids, to compare them with that of one rank.
 */
#pragma once

#include "Mesher.h"
#include "Report/Sets/MeshSets.h"
#include "State/ViewMesh.h"

#include <gtest/gtest.h>

#include <map>
#include <mutex>
#include <set>

namespace vfm
{
namespace testing
{

inline MeshData ViewOf(const MesherResult& result)
{
  return ViewMesh(result.TheMesh, result.State, result.Fields);
}

/// Nodes of a second-order mesh of all ranks, by global ids.
struct NodesById
{
  std::map<Index, std::array<double, 7>> Points; // position, geometry, partner, original id
  std::map<Index, std::vector<Index>> Nodes;     // corners and mid nodes of each element
  std::set<std::pair<Index, Index>> InNodeSets;  // set and point

  /// Collective.
  void Add(const MesherResult& result, Ranks& ranks, std::mutex& mutex)
  {
    const MeshData mesh = ViewOf(result);
    const std::vector<NodeSet> sets = FindMeshSets(mesh, ranks).NodeSets;
    const std::lock_guard<std::mutex> lock(mutex);
    const auto valueOf = [](const Index* ids, Index point)
    { return ids ? static_cast<double>(ids[point]) : 0.0; };
    for (Index p = 0; p < mesh.NumberOfPoints; ++p)
    {
      const Vector3 x = mesh.PointAt(p);
      const std::array<double, 7> point{ { x[0], x[1], x[2],
        static_cast<double>(mesh.GeometryDimension[p]), static_cast<double>(mesh.GeometryId[p]),
        valueOf(mesh.PeriodicPartner, p), valueOf(mesh.OriginalPointIds, p) } };
      const auto added = this->Points.emplace(mesh.PointIds[p], point);
      EXPECT_EQ(added.first->second, point) << "id " << mesh.PointIds[p];
    }
    for (Index e = 0; e < mesh.NumberOfElements; ++e)
    {
      std::vector<Index>& nodes = this->Nodes[mesh.ElementIds[e]];
      mesh.ForNodes(e,
        [&](const Index* first, const Index* last)
        {
          std::transform(first, last, std::back_inserter(nodes),
            [&mesh](Index point) { return mesh.PointIds[point]; });
        });
    }
    for (const NodeSet& set : sets)
    {
      for (Index point : set.Points)
      {
        this->InNodeSets.emplace(set.Id, mesh.PointIds[point]);
      }
    }
  }
};

} // namespace testing
} // namespace vfm
