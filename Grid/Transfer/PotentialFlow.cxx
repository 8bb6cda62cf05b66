#include "Transfer/PotentialFlow.h"

#include <atomic>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace vfm
{
namespace
{

constexpr double Accuracy = 1e-15; // rms, of the size of a node
constexpr int MostSteps = 20000;

/// Sums over the nodes of all ranks, in integers: no order matters.
class NodeSums
{
public:
  NodeSums(std::size_t nodes, Runtime& runtime) : Nodes(nodes), Run(runtime) {}

  /// like: about as large as the sum, or more. term(begin, end, add) calls add(value) for each node.
  template <class Terms>
  double Sum(double like, const Terms& terms)
  {
    const double unit = std::ldexp(1.0, std::ilogb(like) - BitsOfSum), units = 1.0 / unit;
    std::atomic<std::int64_t> total{ 0 };
    this->Run.For(0, static_cast<Index>(this->Nodes),
      [&](Index begin, Index end)
      {
        std::int64_t part = 0;
        terms(begin, end,
          [&](double value) { part += static_cast<std::int64_t>(value * units); });
        total += part;
      });
    std::vector<std::int64_t> sum{ total };
    this->Run.Group().Sum(sum);
    return static_cast<double>(sum[0]) * unit;
  }

private:
  static constexpr int BitsOfSum = 40;
  std::size_t Nodes;
  Runtime& Run;
};

class Solver
{
public:
  Solver(const FlowGraph& graph, std::vector<double> excess, Runtime& runtime) :
    Graph(graph),
    Run(runtime),
    Sums(excess.size(), runtime),
    Residual(std::move(excess)),
    Inverse(this->Residual.size()),
    Image(this->Residual.size()),
    Direction(this->Residual.size() + graph.Copies, 0.0),
    Potential(this->Direction)
  {
    for (std::size_t i = 0; i < this->Inverse.size(); ++i)
    {
      const std::array<double, 6>& w = graph.Nodes[i].Widths;
      const double sum = ((w[0] + w[1]) + (w[2] + w[3])) + (w[4] + w[5]);
      this->Inverse[i] = sum > 0.0 ? 1.0 / sum : 0.0;
    }
  }

  std::vector<double> Solve(const std::vector<double>& size)
  {
    double square = this->SumOfSquares(this->Residual);
    const double small = Accuracy * Accuracy * this->SumOfSquares(size);
    this->For([this](Index i) { this->Direction[i] = this->Inverse[i] * this->Residual[i]; });
    for (int step = 0; step < MostSteps && square > small; ++step)
    {
      const double next = this->Step(square); ++Steps;
      if (!(next >= 0.0))
      {
        break;
      }
      const double ratio = next / square;
      this->For(
        [&](Index i)
        {
          this->Direction[i] =
            this->Inverse[i] * this->Residual[i] + ratio * this->Direction[i];
        });
      square = next;
    }
    if (getenv("VFM_DEBUG")) std::printf("DEBUG square %g small %g nodes %zu steps %d\n", square, small, this->Residual.size(), Steps);
    this->Graph.Update(this->Potential);
    return std::move(this->Potential);
  }

private:
  template <class Body>
  void For(const Body& body)
  {
    ForEach(this->Run, this->Residual.size(), body);
  }

  /// Over the diagonal.
  double SumOfSquares(const std::vector<double>& values)
  {
    double largest = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      largest = std::max(largest, values[i] * this->Inverse[i] * values[i]);
    }
    largest = this->Run.Group().Max(largest);
    return !(largest > 0.0) || std::isinf(largest)
      ? 0.0
      : this->Sums.Sum(16.0 * largest,
          [&](Index begin, Index end, const auto& add)
          {
            for (Index i = begin; i < end; ++i)
            {
              add(values[i] * this->Inverse[i] * values[i]);
            }
          });
  }

  /// Goes along the direction; returns the square of what is left, or -1 where rounding is all there is.
  double Step(double square)
  {
    this->Graph.Update(this->Direction);
    const double curvature = this->Sums.Sum(square,
      [&](Index begin, Index end, const auto& add)
      {
        for (Index i = begin; i < end; ++i)
        {
          const FlowNode& node = this->Graph.Nodes[i];
          const double own = this->Direction[i];
          double sum = 0.0;
          for (int f = 0; f < 6; ++f)
          {
            sum += node.Widths[f] * (own - this->Direction[node.Others[f]]);
          }
          this->Image[i] = sum;
          add(own * sum);
        }
      });
    if (!(curvature > 0.0))
    {
      return -1.0;
    }
    const double length = square / curvature;
    return this->Sums.Sum(square,
      [&](Index begin, Index end, const auto& add)
      {
        for (Index i = begin; i < end; ++i)
        {
          this->Potential[i] += length * this->Direction[i];
          const double rest = this->Residual[i] - length * this->Image[i];
          this->Residual[i] = rest;
          add(rest * this->Inverse[i] * rest);
        }
      });
  }

  int Steps = 0;
  const FlowGraph& Graph;
  Runtime& Run;
  NodeSums Sums;
  std::vector<double> Residual, Inverse, Image; // by node of this rank; Inverse of the diagonal
  std::vector<double> Direction, Potential;     // copies too
};

} // namespace

std::vector<double> FindPotential(const FlowGraph& graph, std::vector<double> excess,
  const std::vector<double>& size, Runtime& runtime)
{
  return Solver(graph, std::move(excess), runtime).Solve(size);
}

} // namespace vfm
