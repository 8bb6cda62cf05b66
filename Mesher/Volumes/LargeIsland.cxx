#include "Volumes/LargeIsland.h"

#include "Base/PairSums.h"
#include "Base/WideSum.h"

namespace vfm
{
namespace
{

constexpr double Residual = 1e-9; // relative
constexpr int LargestIterations = 5000;

/// The system on this rank.
class System
{
public:
  System(const FragmentShare& share, const PairShare& pairs, const std::vector<double>& areas) :
    Share(share), Pairs(pairs), Areas(areas)
  {
    std::vector<ExactSum> sums(share.Size());
    for (std::size_t p = 0; p < pairs.Size(); ++p)
    {
      if (pairs.IsMine(p))
      {
        sums[pairs.Pairs()[p][0]].Add(areas[p]);
        sums[pairs.Pairs()[p][1]].Add(areas[p]);
      }
    }
    this->Diagonal = share.Sum(std::move(sums));
    for (double& value : this->Diagonal)
    {
      value += RegularDiagonal;
    }
  }

  std::vector<double> Multiply(const std::vector<double>& x) const
  {
    std::vector<ExactSum> sums(x.size());
    for (std::size_t p = 0; p < this->Pairs.Size(); ++p)
    {
      if (this->Pairs.IsMine(p))
      {
        const auto& [a, b] = this->Pairs.Pairs()[p];
        ExactSum flow;
        flow.Add(this->Areas[p] * (x[b] - x[a])); // x[0] is 0
        sums[b].Add(flow);
        sums[a].Subtract(flow);
      }
    }
    for (std::size_t f = 1; f < x.size(); ++f)
    {
      sums[f].Add(this->Share.IsMine[f] ? RegularDiagonal * x[f] : 0.0);
    }
    return this->Share.Sum(std::move(sums));
  }

  double Dot(const std::vector<double>& x, const std::vector<double>& y) const
  {
    std::vector<WideSum> sum(1);
    for (std::size_t f = 1; f < x.size(); ++f)
    {
      if (this->Share.IsMine[f])
      {
        sum[0].Add(x[f] * y[f]);
      }
    }
    WideSum::SumOverRanks(sum, *this->Share.Group);
    return sum[0].Value();
  }

  const FragmentShare& Share;
  const PairShare& Pairs;
  const std::vector<double>& Areas;
  std::vector<double> Diagonal;
};

/// Adds `factor` times one list to another.
void AddTimes(double factor, const std::vector<double>& from, std::vector<double>& to)
{
  for (std::size_t i = 0; i < to.size(); ++i)
  {
    to[i] += factor * from[i];
  }
}

} // namespace

LargeIsland::LargeIsland(
  FragmentShare share, std::vector<FragmentPair> pairs, const std::vector<double>& areas) :
  Share(std::move(share)), Pairs(this->Share, std::move(pairs))
{
  (void)areas;
}

std::vector<double> LargeIsland::Solve(
  const std::vector<double>& areas, const std::vector<double>& lack, int* iterations) const
{
  const System system(this->Share, this->Pairs, areas);
  double largest = 0.0;
  for (std::size_t f = 1; f < lack.size(); ++f)
  {
    largest = std::max(largest, std::fabs(lack[f]));
  }
  largest = this->Share.Group->Max(largest);
  std::vector<double> x(lack.size(), 0.0), r(lack), p(lack.size(), 0.0), z(p);
  if (largest == 0.0)
  {
    return x;
  }
  // A power of two keeps the bits, and the sums within the range of ExactSum.
  const double unit = std::ldexp(1.0, std::ilogb(largest));
  r[0] = 0.0;
  for (double& value : r)
  {
    value /= unit;
  }
  const double start = system.Dot(r, r);
  double last = 1.0, residual = start;
  int iteration = 0;
  for (; residual > Residual * Residual * start && iteration < LargestIterations; ++iteration)
  {
    for (std::size_t f = 1; f < r.size(); ++f)
    {
      z[f] = r[f] / system.Diagonal[f];
    }
    const double next = system.Dot(r, z);
    const double beta = iteration > 0 ? next / last : 0.0;
    last = next;
    for (std::size_t f = 1; f < r.size(); ++f)
    {
      p[f] = z[f] + beta * p[f];
    }
    const std::vector<double> q = system.Multiply(p);
    const double alpha = last / system.Dot(p, q);
    AddTimes(alpha, p, x);
    AddTimes(-alpha, q, r);
    r[0] = 0.0;
    residual = system.Dot(r, r);
  }
  if (iterations)
  {
    *iterations = iteration;
  }
  for (double& value : x)
  {
    value *= unit;
  }
  return x;
}

} // namespace vfm
