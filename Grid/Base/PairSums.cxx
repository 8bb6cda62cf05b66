#include "Base/PairSums.h"

#include <Eigen/SparseCholesky>

namespace vfm
{

std::vector<PairSum> GatherPairSums(const PairSumMap& mine, Ranks& ranks)
{
  std::vector<PairSum> items;
  for (const auto& sum : mine)
  {
    items.push_back({ sum.first.first, sum.first.second, sum.second });
  }
  PairSumMap all;
  for (const PairSum& sum : GatherItems(ranks, items))
  {
    all[{ sum.First, sum.Second }].Add(sum.Value);
  }
  items.clear();
  for (const auto& sum : all)
  {
    items.push_back({ sum.first.first, sum.first.second, sum.second });
  }
  return items;
}

std::vector<double> SolveForLack(const std::vector<PairSum>& sums, const std::vector<double>& lack)
{
  const int count = static_cast<int>(lack.size()) - 1;
  std::vector<Eigen::Triplet<double>> entries;
  for (int f = 0; f < count; ++f)
  {
    entries.emplace_back(f, f, RegularDiagonal);
  }
  for (const PairSum& sum : sums)
  {
    const int a = sum.First - 1, b = sum.Second - 1; // -1: mu is fixed to 0
    const double value = sum.Value.Value();
    for (int side : { a, b })
    {
      if (side >= 0)
      {
        entries.emplace_back(side, side, value);
      }
    }
    if (a >= 0 && b >= 0)
    {
      entries.emplace_back(a, b, -value);
      entries.emplace_back(b, a, -value);
    }
  }
  Eigen::SparseMatrix<double> A(count, count);
  A.setFromTriplets(entries.begin(), entries.end());
  const Eigen::VectorXd right = Eigen::Map<const Eigen::VectorXd>(lack.data() + 1, count);
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(A);
  const Eigen::VectorXd mu = solver.solve(right);
  std::vector<double> result(1, 0.0);
  result.insert(result.end(), mu.data(), mu.data() + count);
  return result;
}

} // namespace vfm
