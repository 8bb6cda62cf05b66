#include "Ranks/Agreement.h"
#include "Transfer/CoarseGraph.h"

#include <atomic>
#include <cmath>

namespace vfm
{
namespace
{

constexpr double Accuracy = 3e-15; // rms, of the size of a node's cell
constexpr int MaximumSteps = 20000;
constexpr double Near =
  1e8; // times what is small, in squares: from there on rounding may undo what steps do
constexpr double Worse = 4.0; // times the least so far: it does
constexpr int BitsOfSum = 36;

/// In what unit integers sum numbers that are together as large as this.
double UnitOf(double like)
{
  return std::ldexp(1.0, std::ilogb(like) - BitsOfSum);
}

/// Conjugate gradients. Before each step, what nodes have too much is divided by the widths of their ways, and what blocks of nodes
/// have in all flows between these.
struct Work
{
  const FlowGraph& Graph;
  const std::vector<double>& Sizes;
  Runtime& Run;
  std::vector<double>
    Residual; // by node of this rank, as Inverse (of the diagonal), Image, Correction
  CoarseGraph Blocks{ Graph, Run.Group() };
  std::vector<double> Inverse = std::vector<double>(Residual.size()), Image = Inverse,
                      Correction = Inverse;
  /// Copies too.
  std::vector<double> Direction = std::vector<double>(Residual.size() + Graph.Copies),
                      Potential = Direction;
  double Largest = 0.0; // size
};

/// Sums term(node) over the nodes of all ranks. like: about as large as the sum, or more.
template <class Term>
double Sum(Work& work, double like, const Term& term)
{
  const double unit = UnitOf(like), units = 1.0 / unit;
  std::atomic<std::int64_t> total{ 0 };
  work.Run.For(0, static_cast<Index>(work.Residual.size()),
    [&](Index begin, Index end)
    {
      std::int64_t part = 0;
      for (Index i = begin; i < end; ++i)
      {
        part += static_cast<std::int64_t>(term(i) * units);
      }
      total += part;
    });
  return static_cast<double>(SumOverRanks(total, work.Run.Group())) * unit;
}

/// A sum of terms >= 0 whose size is not known.
template <class Term>
double FirstSum(Work& work, const Term& term)
{
  double largest = 0.0;
  for (std::size_t i = 0; i < work.Residual.size(); ++i)
  {
    largest = std::max(largest, term(static_cast<Index>(i)));
  }
  largest = work.Run.Group().Max(largest);
  return largest > 0.0 && std::isfinite(largest) ? Sum(work, largest, term) : 0.0;
}

/// Finds what to go on by; returns its product with the residual. residual: no less than any; product: the last one, 0 at first.
double Correct(Work& work, double residual, double product)
{
  const double unit = UnitOf(residual);
  std::vector<std::int64_t> sums(work.Blocks.NumberOfBlocks(), 0);
  for (std::size_t i = 0; i < work.Residual.size(); ++i)
  {
    sums[work.Blocks.BlockOf(i)] += static_cast<std::int64_t>(work.Residual[i] / unit);
  }
  work.Run.Group().Sum(sums);
  Eigen::VectorXd excess(sums.size());
  for (std::size_t b = 0; b < sums.size(); ++b)
  {
    excess[b] = static_cast<double>(sums[b]) * unit;
  }
  const Eigen::VectorXd& coarse = work.Blocks.Solve(std::move(excess));
  const auto term = [&](Index i)
  {
    work.Correction[i] = work.Inverse[i] * work.Residual[i] + coarse[work.Blocks.BlockOf(i)];
    return work.Residual[i] * work.Correction[i];
  };
  return product > 0.0 ? Sum(work, product, term) : FirstSum(work, term);
}

void Turn(Work& work, double ratio)
{
  ForEach(work.Run, work.Residual.size(),
    [&](Index i) { work.Direction[i] = work.Correction[i] + ratio * work.Direction[i]; });
  work.Graph.Update(work.Direction);
}

double FindCurvature(Work& work, double like)
{
  return !(like > 0.0) ? 0.0
                       : Sum(work, like,
                           [&](Index i)
                           {
                             const FlowNode& node = work.Graph.Nodes[i];
                             const double own = work.Direction[i];
                             double sum = 0.0;
                             for (int f = 0; f < 6; ++f)
                             {
                               sum += node.Widths[f] * (own - work.Direction[node.Others[f]]);
                             }
                             work.Image[i] = sum;
                             return own * sum;
                           });
}

} // namespace

std::vector<double> FindPotential(const FlowGraph& graph, std::vector<double> excess,
  const std::vector<double>& sizes, Runtime& runtime)
{
  Work work{ graph, sizes, runtime, std::move(excess) };
  for (std::size_t i = 0; i < work.Inverse.size(); ++i)
  {
    const std::array<double, 6>& w = graph.Nodes[i].Widths;
    const double sum = ((w[0] + w[1]) + (w[2] + w[3])) + (w[4] + w[5]);
    work.Inverse[i] = sum > 0.0 ? 1.0 / sum : 0.0;
    work.Largest = std::max(work.Largest, sizes[i]);
  }
  work.Largest = runtime.Group().Max(work.Largest);
  const auto mismatch = [&](Index i)
  {
    const double part = work.Residual[i] / work.Sizes[i];
    return part * part;
  };
  const double small = Accuracy * Accuracy * Sum(work, 1e9, [](Index) { return 1.0; });
  double square = FirstSum(work, mismatch), least = square;
  double product = 0.0; // of residual and correction
  for (int step = 0; step < MaximumSteps && square > small; ++step)
  {
    if (least < Near * small && square > Worse * least)
    {
      break;
    }
    least = std::min(least, square);
    const double next = Correct(work, std::sqrt(square) * work.Largest, product);
    Turn(work, step > 0 ? next / product : 0.0);
    const double curvature = FindCurvature(work, next);
    if (!(next > 0.0 && curvature > 0.0))
    {
      break;
    }
    product = next;
    const double length = product / curvature;
    square = Sum(work, square,
      [&](Index i)
      {
        work.Potential[i] += length * work.Direction[i];
        work.Residual[i] -= length * work.Image[i];
        return mismatch(i);
      });
  }
  work.Graph.Update(work.Potential);
  return std::move(work.Potential);
}

} // namespace vfm
