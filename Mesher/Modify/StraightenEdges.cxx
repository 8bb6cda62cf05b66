#include "Modify/StraightenEdges.h"

#include "Modify/CurvedElement.h"
#include "Ranks/Agreement.h"
#include "Ranks/MergeByKey.h"

namespace vfm
{
namespace
{

// Parts of its displacement that a mid node keeps, one after the other.
constexpr double KeptParts[] = { 1.0, 0.75, 0.5, 0.25, 0.1, 0.0 };
constexpr int LastPart = 5;
constexpr double SmallestRatio = 0.1; // of the coefficients of curved and straight elements

class Straightener
{
public:
  Straightener(const Mesh& mesh, Index firstMid, const PeriodImages& images, Runtime& runtime,
    CurvedEdges& edges) :
    TheMesh(mesh),
    FirstMid(firstMid),
    Images(images),
    Run(runtime),
    Edges(edges),
    Mids(mesh.Corners, mesh.MidsPerElement),
    Shape(GetCurvedElement(mesh.Corners)),
    Parts(edges.Ids.size(), 0)
  {
    this->ListElements();
  }

  CurvedReport Straighten()
  {
    std::vector<unsigned char> isOpen(this->Elements.size(), 1);
    while (this->MoveBack(this->FindFailures(isOpen), isOpen))
    {
    }
    CurvedReport report;
    this->Count(report);
    double least = 1.0;
    for (double ratio : this->Ratios)
    {
      least = std::min(least, ratio);
    }
    report.SmallestRatio = -this->Run.Group().Max(-least);
    for (std::size_t e = 0; e < this->Parts.size(); ++e)
    {
      this->Edges.Moves[e] = KeptParts[this->Parts[e]] * this->Edges.Moves[e];
    }
    return report;
  }

private:
  /// Returns the curved edge at a mid node of an element, or -1.
  Index CurvedAt(Index element, int mid) const
  {
    const Index point = this->TheMesh.MidPoints[this->Mids.Count * element + mid];
    return this->Edges.OfMidPoint[point - this->FirstMid];
  }

  void ListElements()
  {
    const auto elements = static_cast<Index>(this->TheMesh.ElementIds.size());
    for (Index element = 0; element < elements; ++element)
    {
      for (int mid = 0; mid < this->Mids.Edges; ++mid)
      {
        if (this->CurvedAt(element, mid) >= 0)
        {
          this->Elements.push_back(element);
          break;
        }
      }
    }
    this->Straight.assign(this->Elements.size(), 0.0);
    this->Ratios.assign(this->Elements.size(), 1.0);
    ForEach(this->Run, this->Elements.size(),
      [this](Index i) { this->Straight[i] = this->Smallest(this->Elements[i], false); });
  }

  double Smallest(Index element, bool isCurved) const
  {
    const Mesh& mesh = this->TheMesh;
    CurvedElement::Nodes nodes;
    for (int c = 0; c < mesh.Corners; ++c)
    {
      const Vector3 x = mesh.PointAt(mesh.Elements[mesh.Corners * element + c]);
      nodes[c] = c == 0 ? x : this->Images.Near(x, nodes[0]);
    }
    for (int mid = 0; mid < this->Mids.Edges; ++mid)
    {
      const int(&ends)[2] = this->Mids.EdgeCorners[mid];
      Vector3& node = nodes[mesh.Corners + mid];
      node = 0.5 * (nodes[ends[0]] + nodes[ends[1]]);
      const Index edge = isCurved ? this->CurvedAt(element, mid) : -1;
      if (edge >= 0)
      {
        node = node + KeptParts[this->Parts[edge]] * this->Edges.Moves[edge];
      }
    }
    return this->Shape.SmallestCoefficient(nodes);
  }

  /// Returns whether each open element is too poor.
  std::vector<unsigned char> FindFailures(const std::vector<unsigned char>& isOpen)
  {
    std::vector<unsigned char> fails(this->Elements.size(), 0);
    ForEach(this->Run, this->Elements.size(),
      [&](Index i)
      {
        if (isOpen[i])
        {
          this->Ratios[i] = this->Smallest(this->Elements[i], true) / this->Straight[i];
          fails[i] = !(this->Ratios[i] >= SmallestRatio);
        }
      });
    return fails;
  }

  /// Collective. Moves the mid nodes of poor elements back by one step. Opens the elements whose
  /// nodes have moved. Returns whether any has on any rank.
  bool MoveBack(const std::vector<unsigned char>& fails, std::vector<unsigned char>& isOpen)
  {
    std::vector<int> requests(this->Parts.size(), 0); // index in KeptParts of each curved edge
    bool hasAny = false;
    for (std::size_t i = 0; i < fails.size(); ++i)
    {
      for (int mid = 0; fails[i] && mid < this->Mids.Edges; ++mid)
      {
        const Index edge = this->CurvedAt(this->Elements[i], mid);
        if (edge >= 0 && this->Parts[edge] < LastPart)
        {
          requests[edge] = this->Parts[edge] + 1;
          hasAny = true;
        }
      }
    }
    if (!this->Run.Group().Any(hasAny))
    {
      return false;
    }
    const std::vector<int> parts = MergeByKey(
      this->Edges.Groups, requests, [](int a, int b) { return std::max(a, b); }, this->Run.Group());
    std::vector<unsigned char> isMoved(parts.size(), 0);
    for (std::size_t e = 0; e < parts.size(); ++e)
    {
      isMoved[e] = parts[e] > this->Parts[e];
      this->Parts[e] = std::max(this->Parts[e], parts[e]);
    }
    for (std::size_t i = 0; i < isOpen.size(); ++i)
    {
      isOpen[i] = 0;
      for (int mid = 0; mid < this->Mids.Edges; ++mid)
      {
        const Index edge = this->CurvedAt(this->Elements[i], mid);
        isOpen[i] |= edge >= 0 && isMoved[edge];
      }
    }
    return true;
  }

  /// Collective. Counts each edge on the lowest rank that has it.
  void Count(CurvedReport& report) const
  {
    Ranks& ranks = this->Run.Group();
    const std::vector<int> owners = MergeByKey(
      this->Edges.Ids, std::vector<int>(this->Parts.size(), ranks.Rank()),
      [](int a, int b) { return std::min(a, b); }, ranks);
    std::vector<std::int64_t> counts(2, 0);
    for (std::size_t e = 0; e < owners.size(); ++e)
    {
      const bool isCounted = owners[e] == ranks.Rank();
      counts[0] += isCounted;
      counts[1] += isCounted && this->Parts[e] > 0;
    }
    ranks.Sum(counts);
    report.Curved = counts[0];
    report.Straightened = counts[1];
  }

  const Mesh& TheMesh;
  const Index FirstMid;
  const PeriodImages& Images;
  Runtime& Run;
  CurvedEdges& Edges;
  const MidNodes Mids;
  const CurvedElement& Shape;
  std::vector<int> Parts;       // index in KeptParts of each curved edge
  std::vector<Index> Elements;  // elements with a curved edge
  std::vector<double> Straight; // smallest coefficient of each when straight
  std::vector<double> Ratios;   // of the present one and the straight one
};

} // namespace

CurvedReport StraightenEdges(const Mesh& mesh, Index firstMid, const PeriodImages& images,
  Runtime& runtime, CurvedEdges& edges)
{
  return Straightener(mesh, firstMid, images, runtime, edges).Straighten();
}

} // namespace vfm
