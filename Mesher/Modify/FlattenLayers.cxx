#include "Modify/FlattenLayers.h"

#include "Base/Vector3.h"
#include "Ranks/Agreement.h"
#include "Ranks/MergeByKey.h"

#include <cmath>

namespace vfm
{
namespace
{

using Ends = std::vector<std::vector<double>>;

constexpr int Sweeps = 100;
constexpr double LargestBend = 0.5; // relative to the thickness of a layer
constexpr double Relaxation = 1.8;  // of the mean move
constexpr double Kept = 0.6;        // least share of the thickness of a layer
constexpr double Parts = 1LL << 40; // moves are summed as integers of this part of an edge

/// Moves of the end of a layer on an edge that faces request.
struct Requests
{
  Index Sum, Count;
};

/// The layers of a column.
struct ColumnShape
{
  std::array<Vector3, 4> Along; ///< edges from foot to top
  /// For each end, its corners.
  std::vector<std::array<Vector3, 4>> Faces;

  Vector3 CentreOf(int end) const
  {
    const std::array<Vector3, 4>& x = this->Faces[end];
    return 0.25 * (x[0] + x[1] + x[2] + x[3]);
  }
};

ColumnShape MakeShape(const Mesh& mesh, const LayerColumns& columns,
  const LayerColumns::Column& column, const Ends& ends)
{
  ColumnShape shape;
  shape.Faces.resize(ends[column.Edges[0]].size());
  for (int c = 0; c < 4; ++c)
  {
    const LayerColumns::Edge& edge = columns.Edges[column.Edges[c]];
    const Vector3 foot = mesh.PointAt(edge.Foot);
    shape.Along[c] = mesh.PointAt(edge.Top) - foot;
    for (std::size_t end = 0; end < shape.Faces.size(); ++end)
    {
      shape.Faces[end][c] = foot + ends[column.Edges[c]][end] * shape.Along[c];
    }
  }
  return shape;
}

/// Requests moves so that the bend of a face is not larger than its share of the thickness of the
/// layer above (step 1) or below it (step -1).
/// @param request (end, corner, move)
template <class Request>
void LimitBend(const ColumnShape& shape, int end, int step, const Request& request)
{
  const std::array<Vector3, 4>& x = shape.Faces[end];
  const Vector3 normal = Unit(Cross(x[3] - x[1], x[2] - x[0]));
  const double bend = 0.5 * Dot(x[0] - x[1] + x[2] - x[3], normal);
  const int other = end + step;
  const double thickness = step * Dot(shape.CentreOf(other) - shape.CentreOf(end), normal);
  const double excess = std::abs(bend) - LargestBend * thickness;
  if (!(excess > 0.0))
  {
    return;
  }
  const bool movesOther = other > 0 && other + 1 < static_cast<int>(shape.Faces.size());
  std::array<std::array<double, 4>, 2> slopes{}; // of the excess: corners of the face, of the other
  double sum = 0.0;
  for (int c = 0; c < 4; ++c)
  {
    const double rise = Dot(shape.Along[c], normal);
    const double widens = 0.25 * LargestBend * step * rise;
    slopes[0][c] = std::copysign(0.5, bend) * (c % 2 == 0 ? rise : -rise) + widens;
    slopes[1][c] = movesOther ? -widens : 0.0;
    sum += slopes[0][c] * slopes[0][c] + slopes[1][c] * slopes[1][c];
  }
  for (int c = 0; c < 4 && sum > 0.0; ++c)
  {
    request(end, c, -excess * slopes[0][c] / sum);
    if (movesOther)
    {
      request(other, c, -excess * slopes[1][c] / sum);
    }
  }
}

/// Adds the moves that a column requests.
/// @param requests for each edge and end
/// @return whether there are any
bool AddRequests(const Mesh& mesh, const LayerColumns& columns, const LayerColumns::Column& column,
  const Ends& ends, std::vector<Requests>& requests)
{
  const ColumnShape shape = MakeShape(mesh, columns, column, ends);
  const int tops = static_cast<int>(shape.Faces.size());
  bool isBent = false;
  const auto request = [&](int end, int corner, double move)
  {
    Requests& of = requests[column.Edges[corner] * tops + end];
    const double limited = std::min(1.0, std::max(-1.0, move));
    of = { of.Sum + std::llround(Parts * limited), of.Count + 1 };
    isBent = true;
  };
  for (int end = 1; end + 1 < tops; ++end)
  {
    LimitBend(shape, end, -1, request);
    LimitBend(shape, end, 1, request);
  }
  return isBent;
}

/// Merges requests at edges that several ranks have, or that have copies in a periodic mesh.
class SharedEdges
{
public:
  /// Collective.
  SharedEdges(const std::vector<std::array<Index, 2>>& keys, int tops, Ranks& ranks) : Group(ranks)
  {
    const std::vector<int> counts =
      MergeByKey(keys, std::vector<int>(keys.size(), 1), std::plus<int>(), ranks);
    for (std::size_t e = 0; e < keys.size(); ++e)
    {
      for (int end = 0; end < tops && counts[e] > 1; ++end)
      {
        this->Keys.push_back({ { keys[e][0], keys[e][1], end } });
        this->Places.push_back(static_cast<Index>(e) * tops + end);
      }
    }
    this->AnyShared = ranks.Any(!this->Keys.empty());
  }

  /// Collective.
  void Merge(std::vector<Requests>& requests) const
  {
    if (!this->AnyShared)
    {
      return;
    }
    std::vector<Requests> own;
    for (Index place : this->Places)
    {
      own.push_back(requests[place]);
    }
    own = MergeByKey(
      this->Keys, own,
      [](const Requests& a, const Requests& b) {
        return Requests{ a.Sum + b.Sum, a.Count + b.Count };
      },
      this->Group);
    for (std::size_t i = 0; i < own.size(); ++i)
    {
      requests[this->Places[i]] = own[i];
    }
  }

private:
  Ranks& Group;
  std::vector<std::array<Index, 3>> Keys; // edge and end
  std::vector<Index> Places;              // of requests
  bool AnyShared = false;
};

/// Moves the ends of layers on an edge.
/// @param before ends before the first sweep
/// @param requests for each end
/// @return whether any end moved
bool MoveEnds(
  const std::vector<double>& before, const Requests* requests, std::vector<double>& ends)
{
  const int layers = static_cast<int>(ends.size()) - 1;
  const std::vector<double> old = ends;
  const auto thickness = [&](int layer) { return Kept * (before[layer + 1] - before[layer]); };
  for (int end = 1; end < layers; ++end)
  {
    const Requests& of = requests[end];
    const double mean =
      of.Count == 0 ? 0.0 : static_cast<double>(of.Sum) / (Parts * static_cast<double>(of.Count));
    ends[end] = std::max(ends[end] + Relaxation * mean, ends[end - 1] + thickness(end - 1));
  }
  for (int end = layers - 1; end > 0; --end)
  {
    ends[end] = std::min(ends[end], ends[end + 1] - thickness(end));
  }
  return ends != old;
}

} // namespace

void FlattenLayers(const Mesh& mesh, const LayerColumns& columns, Ranks& ranks,
  std::vector<std::vector<double>>& ends)
{
  const Ends before = ends;
  const int tops = static_cast<int>(
    MaximumOverRanks(ends.empty() ? 0 : static_cast<Index>(ends[0].size()), ranks));
  const SharedEdges shared(columns.KeysOfEdges(mesh), tops, ranks);
  std::vector<char> hasMoved(ends.size(), 1), isBent(columns.Columns.size(), 0);
  bool changes = true;
  for (int sweep = 0; sweep < Sweeps && changes; ++sweep)
  {
    std::vector<Requests> requests(ends.size() * tops, Requests{ 0, 0 });
    for (std::size_t c = 0; c < columns.Columns.size(); ++c)
    {
      const LayerColumns::Column& column = columns.Columns[c];
      const bool isNew = std::any_of(
        column.Edges.begin(), column.Edges.end(), [&](Index edge) { return hasMoved[edge] != 0; });
      isBent[c] = isNew || isBent[c] != 0 ? AddRequests(mesh, columns, column, ends, requests) : 0;
    }
    shared.Merge(requests);
    for (std::size_t e = 0; e < ends.size(); ++e)
    {
      hasMoved[e] = MoveEnds(before[e], requests.data() + e * tops, ends[e]) ? 1 : 0;
    }
    changes =
      ranks.Any(std::any_of(hasMoved.begin(), hasMoved.end(), [](char m) { return m != 0; }));
  }
}

} // namespace vfm
