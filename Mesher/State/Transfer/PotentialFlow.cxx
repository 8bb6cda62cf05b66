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

/// State of the conjugate gradients. The preconditioner divides the residual by the diagonal, and
/// adds the potential of blocks of nodes.
struct Work
{
  const FlowGraph& Graph;
  Runtime& Run;
  std::vector<double> Residual; // one per node of this rank
  CoarseGraph Blocks{ Graph, Run.Group() };
  // Inverse of the diagonal, Laplacian of Direction, preconditioned residual, as Residual.
  std::vector<double> Inverse = std::vector<double>(Residual.size()), Image = Inverse,
                      Correction = Inverse;
  // Values per node, copies included.
  std::vector<double> Direction = std::vector<double>(Residual.size() + Graph.Copies),
                      Potential = Direction;
  double Largest = 0.0; // largest size
};

/// Sums term(node) over the nodes of all ranks. like: approximately the sum, or larger.
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

/// Sums terms >= 0 if the magnitude of the sum is unknown.
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

/// Computes Correction, the preconditioned residual. Returns its product with the residual.
/// @param residual  upper bound of all residuals
/// @param product  previous result, 0 in the first step
double Correct(Work& work, double residual, double product)
{
  const double unit = UnitOf(residual), units = 1.0 / unit; // exact
  std::vector<std::int64_t> sums(work.Blocks.NumberOfBlocks(), 0);
  for (std::size_t i = 0; i < work.Residual.size(); ++i)
  {
    sums[work.Blocks.BlockOf(i)] += static_cast<std::int64_t>(work.Residual[i] * units);
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

/// Updates Direction.
void Turn(Work& work, double ratio)
{
  ForEach(work.Run, work.Residual.size(),
    [&](Index i) { work.Direction[i] = work.Correction[i] + ratio * work.Direction[i]; });
  work.Graph.Update(work.Direction);
}

/// Computes Image. Returns its product with Direction, or 0 if like,
/// its magnitude, is not positive.
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
  Work work{ graph, runtime, std::move(excess) };
  std::vector<double> perSize(sizes.size());
  for (std::size_t i = 0; i < work.Inverse.size(); ++i)
  {
    const std::array<double, 6>& w = graph.Nodes[i].Widths;
    const double sum = ((w[0] + w[1]) + (w[2] + w[3])) + (w[4] + w[5]);
    work.Inverse[i] = sum > 0.0 ? 1.0 / sum : 0.0;
    work.Largest = std::max(work.Largest, sizes[i]);
    perSize[i] = 1.0 / sizes[i];
  }
  work.Largest = runtime.Group().Max(work.Largest);
  const auto mismatch = [&](Index i)
  {
    const double part = work.Residual[i] * perSize[i];
    return part * part;
  };
  const double small = Accuracy * Accuracy * Sum(work, 1e9, [](Index) { return 1.0; });
  double square = FirstSum(work, mismatch), least = square;
  double product = 0.0; // product of residual and correction
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
