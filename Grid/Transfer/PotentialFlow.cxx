#include "Transfer/CoarseGraph.h"

#include <atomic>
#include <cmath>

namespace vfm
{
namespace
{

constexpr double Accuracy = 3e-15; // rms, of the size of a node's cell
constexpr int MostSteps = 20000;
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
class Solver
{
public:
  Solver(const FlowGraph& graph, std::vector<double> excess, const std::vector<double>& sizes,
    Runtime& runtime) :
    Graph(graph),
    Sizes(sizes),
    Run(runtime),
    Blocks(graph, runtime.Group()),
    Residual(std::move(excess)),
    Inverse(this->Residual.size(), 0.0),
    Image(this->Residual.size()),
    Correction(this->Residual.size()),
    Direction(this->Residual.size() + graph.Copies, 0.0),
    Potential(this->Direction)
  {
    for (std::size_t i = 0; i < this->Inverse.size(); ++i)
    {
      const std::array<double, 6>& w = graph.Nodes[i].Widths;
      const double sum = ((w[0] + w[1]) + (w[2] + w[3])) + (w[4] + w[5]);
      this->Inverse[i] = sum > 0.0 ? 1.0 / sum : 0.0;
      this->Largest = std::max(this->Largest, sizes[i]);
    }
    this->Largest = runtime.Group().Max(this->Largest);
  }

  std::vector<double> Solve()
  {
    const auto misfit = [this](Index i)
    {
      const double part = this->Residual[i] / this->Sizes[i];
      return part * part;
    };
    const double small = Accuracy * Accuracy * this->Sum(1e9, [](Index) { return 1.0; });
    double square = this->FirstSum(misfit), least = square;
    double product = 0.0; // of residual and correction
    for (int step = 0; step < MostSteps && square > small; ++step)
    {
      if (least < Near * small && square > Worse * least)
      {
        break;
      }
      least = std::min(least, square);
      const double next = this->Correct(std::sqrt(square) * this->Largest, product);
      this->Turn(step > 0 ? next / product : 0.0);
      const double curvature = this->FindCurvature(next);
      if (!(next > 0.0 && curvature > 0.0))
      {
        break;
      }
      product = next;
      const double length = product / curvature;
      square = this->Sum(square,
        [&](Index i)
        {
          this->Potential[i] += length * this->Direction[i];
          this->Residual[i] -= length * this->Image[i];
          return misfit(i);
        });
    }
    this->Graph.Update(this->Potential);
    return std::move(this->Potential);
  }

private:
  /// Sums term(node) over the nodes of all ranks. like: about as large as the sum, or more.
  template <class Term>
  double Sum(double like, const Term& term)
  {
    const double unit = UnitOf(like), units = 1.0 / unit;
    std::atomic<std::int64_t> total{ 0 };
    this->Run.For(0, static_cast<Index>(this->Residual.size()),
      [&](Index begin, Index end)
      {
        std::int64_t part = 0;
        for (Index i = begin; i < end; ++i)
        {
          part += static_cast<std::int64_t>(term(i) * units);
        }
        total += part;
      });
    std::vector<std::int64_t> sum{ total };
    this->Run.Group().Sum(sum);
    return static_cast<double>(sum[0]) * unit;
  }

  /// A sum of terms >= 0 whose size is not known.
  template <class Term>
  double FirstSum(const Term& term)
  {
    double largest = 0.0;
    for (std::size_t i = 0; i < this->Residual.size(); ++i)
    {
      largest = std::max(largest, term(static_cast<Index>(i)));
    }
    largest = this->Run.Group().Max(largest);
    return largest > 0.0 && std::isfinite(largest) ? this->Sum(largest, term) : 0.0;
  }

  /// Finds what to go on by; returns its product with the residual. residual: no less than any; product: the last one, 0 at first.
  double Correct(double residual, double product)
  {
    const double unit = UnitOf(residual);
    std::vector<std::int64_t> sums(this->Blocks.NumberOfBlocks(), 0);
    for (std::size_t i = 0; i < this->Residual.size(); ++i)
    {
      sums[this->Blocks.BlockOf(i)] += static_cast<std::int64_t>(this->Residual[i] / unit);
    }
    this->Run.Group().Sum(sums);
    Eigen::VectorXd excess(sums.size());
    for (std::size_t b = 0; b < sums.size(); ++b)
    {
      excess[b] = static_cast<double>(sums[b]) * unit;
    }
    const Eigen::VectorXd& coarse = this->Blocks.Solve(std::move(excess));
    const auto term = [&](Index i)
    {
      this->Correction[i] = this->Inverse[i] * this->Residual[i] + coarse[this->Blocks.BlockOf(i)];
      return this->Residual[i] * this->Correction[i];
    };
    return product > 0.0 ? this->Sum(product, term) : this->FirstSum(term);
  }

  void Turn(double ratio)
  {
    ForEach(this->Run, this->Residual.size(),
      [&](Index i) { this->Direction[i] = this->Correction[i] + ratio * this->Direction[i]; });
    this->Graph.Update(this->Direction);
  }

  double FindCurvature(double like)
  {
    return !(like > 0.0) ? 0.0
                         : this->Sum(like,
                             [&](Index i)
                             {
                               const FlowNode& node = this->Graph.Nodes[i];
                               const double own = this->Direction[i];
                               double sum = 0.0;
                               for (int f = 0; f < 6; ++f)
                               {
                                 sum += node.Widths[f] * (own - this->Direction[node.Others[f]]);
                               }
                               this->Image[i] = sum;
                               return own * sum;
                             });
  }

  const FlowGraph& Graph;
  const std::vector<double>& Sizes;
  Runtime& Run;
  CoarseGraph Blocks;
  std::vector<double> Residual, Inverse, Image,
    Correction;                             // by node of this rank; Inverse of the diagonal
  std::vector<double> Direction, Potential; // copies too
  double Largest = 0.0;                     // size
};

} // namespace

std::vector<double> FindPotential(const FlowGraph& graph, std::vector<double> excess,
  const std::vector<double>& sizes, Runtime& runtime)
{
  return Solver(graph, std::move(excess), sizes, runtime).Solve();
}

} // namespace vfm
