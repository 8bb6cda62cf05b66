#include "Volumes/CoarsestLevel.h"

#include <Eigen/SparseCholesky>

namespace vfm
{

class CoarsestLevel::Factors
{
public:
  Factors() = default;
  explicit Factors(const Eigen::SparseMatrix<double>& matrix) : Solver(matrix) {}

  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> Solver;
};

namespace
{

using Entry = std::array<Index, 2>;

/// Returns the entries of the matrix that this rank counts, ascending.
std::vector<Entry> ListEntries(const IslandLevel& level)
{
  std::vector<Entry> entries;
  const std::vector<int>& ids = level.Share.Ids;
  for (std::size_t g = 1; g < level.Share.Size(); ++g)
  {
    if (level.Share.IsMine[g])
    {
      entries.push_back({ { ids[g], ids[g] } });
    }
  }
  for (std::size_t p = 0; p < level.Pairs.Size(); ++p)
  {
    const auto& [a, b] = level.Pairs.Pairs()[p];
    if (a > 0 && level.Pairs.IsMine(p))
    {
      entries.push_back({ { ids[a], ids[b] } });
    }
  }
  SortUnique(entries);
  return entries;
}

} // namespace

CoarsestLevel::CoarsestLevel(const IslandLevel& level)
{
  const auto atFirst = [](const auto&) { return 0; };
  this->Groups =
    KeyMerge<Index>(std::vector<Index>(level.Share.Ids.begin() + 1, level.Share.Ids.end()), atFirst,
      *level.Share.Group);
  this->Entries = KeyMerge<Entry>(ListEntries(level), atFirst, *level.Share.Group);
}

std::shared_ptr<const CoarsestLevel::Factors> CoarsestLevel::Factor(
  const IslandLevel& level, const IslandValues& values) const
{
  const std::vector<Entry> own = ListEntries(level);
  std::vector<double> list(own.size());
  const auto valueOf = [&](int a, int b) -> double& {
    return list[FindSorted(own, Entry{ { level.Share.Ids[a], level.Share.Ids[b] } })];
  };
  for (std::size_t g = 1; g < level.Share.Size(); ++g)
  {
    if (level.Share.IsMine[g])
    {
      const int group = static_cast<int>(g);
      valueOf(group, group) = values.Diagonal[g];
    }
  }
  for (std::size_t p = 0; p < level.Pairs.Size(); ++p)
  {
    const auto& [a, b] = level.Pairs.Pairs()[p];
    if (a > 0 && level.Pairs.IsMine(p))
    {
      valueOf(a, b) = -values.Areas[p];
    }
  }
  list = this->Entries.ToHome(std::move(list), 1, [](double& a, double b) { a += b; });
  const std::vector<Index>& groups = this->Groups.HomeKeys();
  if (groups.empty())
  {
    return std::make_shared<Factors>();
  }
  std::vector<Eigen::Triplet<double>> triplets;
  for (std::size_t e = 0; e < list.size(); ++e)
  {
    const auto& [first, second] = this->Entries.HomeKeys()[e];
    const int i = static_cast<int>(FindSorted(groups, first)),
              j = static_cast<int>(FindSorted(groups, second));
    triplets.emplace_back(i, j, list[e]);
    if (i != j)
    {
      triplets.emplace_back(j, i, list[e]);
    }
  }
  const auto count = static_cast<Eigen::Index>(groups.size());
  Eigen::SparseMatrix<double> matrix(count, count);
  matrix.setFromTriplets(triplets.begin(), triplets.end());
  return std::make_shared<Factors>(matrix);
}

std::vector<double> CoarsestLevel::Solve(
  const Factors& factors, const std::vector<double>& right) const
{
  // A group has the same value on all its ranks.
  std::vector<double> values = this->Groups.ToHome(
    std::vector<double>(right.begin() + 1, right.end()), 1, [](double&, double) {});
  if (!values.empty())
  {
    const Eigen::VectorXd solved = factors.Solver.solve(
      Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size())));
    values.assign(solved.data(), solved.data() + solved.size());
  }
  values = this->Groups.FromHome(std::move(values), 1);
  values.insert(values.begin(), 0.0);
  return values;
}

} // namespace vfm
