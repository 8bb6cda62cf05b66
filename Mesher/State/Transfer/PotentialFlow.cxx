#include "Ranks/Agreement.h"
#include "State/Transfer/CoarseGraph.h"

#include <atomic>
#include <cmath>

namespace vfm
{
namespace
{

// Target of the root mean square residual, relative to the volumes of cells.
constexpr double Accuracy = 3e-15;
constexpr int MaximumSteps = 20000;
// Near the target, rounding may undo progress. Iterations end if the squared residual was below
// Near times its target and then exceeds Worse times its minimum.
constexpr double Near = 1e8;
constexpr double Worse = 4.0;
constexpr int BitsOfSum = 36;

/// Returns the unit of integers for sums of about this magnitude.
double UnitOf(double like)
{
  return std::ldexp(1.0, std::ilogb(like) - BitsOfSum);
}

/// Sums over the nodes of all ranks.
class NodeSums
{
public:
  /// @param nodes  number of nodes of this rank
  NodeSums(Index nodes, Runtime& runtime) : Nodes(nodes), Run(runtime) {}

  /// Sums term(node). like: approximately the sum, or larger.
  template <class Term>
  double Sum(double like, const Term& term)
  {
    const double unit = UnitOf(like), units = 1.0 / unit;
    std::atomic<std::int64_t> total{ 0 };
    this->Run.For(0, this->Nodes,
      [&](Index begin, Index end)
      {
        std::int64_t part = 0;
        for (Index i = begin; i < end; ++i)
        {
          part += static_cast<std::int64_t>(term(i) * units);
        }
        total += part;
      });
    return static_cast<double>(SumOverRanks(total, this->Run.Group())) * unit;
  }

  /// Sums terms >= 0. like: approximately the sum, or 0 if its magnitude is unknown.
  template <class Term>
  double SumPositive(double like, const Term& term)
  {
    return like > 0.0 ? this->Sum(like, term) : this->FirstSum(term);
  }

private:
  template <class Term>
  double FirstSum(const Term& term)
  {
    double largest = 0.0;
    for (Index i = 0; i < this->Nodes; ++i)
    {
      largest = std::max(largest, term(i));
    }
    largest = this->Run.Group().Max(largest);
    return largest > 0.0 && std::isfinite(largest) ? this->Sum(largest, term) : 0.0;
  }

  Index Nodes;
  Runtime& Run;
};

/// Returns the inverse of the diagonal of the Laplacian, 0 for nodes without neighbours.
std::vector<double> InvertDiagonal(const FlowGraph& graph)
{
  std::vector<double> inverse;
  inverse.reserve(graph.Nodes.size());
  for (const FlowNode& node : graph.Nodes)
  {
    const std::array<double, 6>& w = node.Widths;
    const double sum = ((w[0] + w[1]) + (w[2] + w[3])) + (w[4] + w[5]);
    inverse.push_back(sum > 0.0 ? 1.0 / sum : 0.0);
  }
  return inverse;
}

/// Returns the potential of the blocks of nodes of this rank for a residual. Collective.
/// @param most  upper bound of all residuals
std::vector<double> SolveBlocks(
  const CoarseGraph& blocks, const std::vector<double>& residual, double most)
{
  const double unit = UnitOf(most), units = 1.0 / unit; // exact
  std::vector<std::int64_t> sums(blocks.NumberOfBlocks(), 0);
  for (std::size_t i = 0; i < residual.size(); ++i)
  {
    sums[blocks.BlockOf(i)] += static_cast<std::int64_t>(residual[i] * units);
  }
  return blocks.Solve(sums, unit);
}

/// Returns the Laplacian of values at a node.
double FindLaplacian(const FlowNode& node, double own, const std::vector<double>& values)
{
  double sum = 0.0;
  for (int f = 0; f < 6; ++f)
  {
    sum += node.Widths[f] * (own - values[node.Others[f]]);
  }
  return sum;
}

} // namespace

std::vector<double> FindPotential(const FlowGraph& graph, std::vector<double> excess,
  const std::vector<double>& sizes, Runtime& runtime)
{
  const Index nodes = static_cast<Index>(excess.size());
  NodeSums sums(nodes, runtime);
  const CoarseGraph blocks(graph, runtime.Group());
  const std::vector<double> inverse = InvertDiagonal(graph);
  // Per node of this rank: residual, preconditioned residual, Laplacian of the direction.
  std::vector<double> residual = std::move(excess), correction(nodes), image(nodes);
  // Per node, copies included.
  std::vector<double> direction(nodes + graph.Copies), potential(direction.size());
  std::vector<double> perSize(nodes);
  double largest = 0.0;
  for (Index i = 0; i < nodes; ++i)
  {
    largest = std::max(largest, sizes[i]);
    perSize[i] = 1.0 / sizes[i];
  }
  largest = runtime.Group().Max(largest);
  const auto mismatch = [&](Index i)
  {
    const double part = residual[i] * perSize[i];
    return part * part;
  };
  const double small = Accuracy * Accuracy * sums.Sum(1e9, [](Index) { return 1.0; });
  double square = sums.SumPositive(0.0, mismatch), least = square;
  double product = 0.0; // product of residual and correction
  for (int step = 0; step < MaximumSteps && square > small; ++step)
  {
    if (least < Near * small && square > Worse * least)
    {
      break;
    }
    least = std::min(least, square);
    const std::vector<double> coarse = SolveBlocks(blocks, residual, std::sqrt(square) * largest);
    const auto correct = [&](Index i)
    {
      correction[i] = inverse[i] * residual[i] + coarse[blocks.BlockOf(i)];
      return residual[i] * correction[i];
    };
    const double next = sums.SumPositive(product, correct);
    const double ratio = step > 0 ? next / product : 0.0;
    ForEach(runtime, nodes, [&](Index i) { direction[i] = correction[i] + ratio * direction[i]; });
    graph.Update(direction);
    const auto findImage = [&](Index i)
    {
      image[i] = FindLaplacian(graph.Nodes[i], direction[i], direction);
      return direction[i] * image[i];
    };
    const double curvature = next > 0.0 ? sums.Sum(next, findImage) : 0.0;
    if (!(next > 0.0 && curvature > 0.0))
    {
      break;
    }
    product = next;
    const double length = product / curvature;
    square = sums.Sum(square,
      [&](Index i)
      {
        potential[i] += length * direction[i];
        residual[i] -= length * image[i];
        return mismatch(i);
      });
  }
  graph.Update(potential);
  return potential;
}

} // namespace vfm
