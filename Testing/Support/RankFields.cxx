#include "RankFields.h"

#include "Labels/ResolveLabels.h"
#include "RandomDraw.h"

#include <atomic>
#include <cmath>
#include <thread>

namespace vfm
{
namespace testing
{

void ThreadedRuntime::For(Index first, Index last, const std::function<void(Index, Index)>& body)
{
  const Index count = last - first, pieces = std::min<Index>(count, 5);
  std::vector<std::thread> threads;
  for (Index p = pieces; p-- > 0;)
  {
    threads.emplace_back(body, first + count * p / pieces, first + count * (p + 1) / pieces);
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
}

std::vector<IndexBox> CutBox(const IndexBox& box, int parts, int axis)
{
  if (parts == 1)
  {
    return { box };
  }
  int a = axis;
  for (int b = 0; axis < 0 && b < 3; ++b)
  {
    a = a < 0 || box.Size(b) > box.Size(a) ? b : a;
  }
  const int first = parts / 2;
  IndexBox low = box, high = box;
  low.Upper[a] = high.Lower[a] =
    box.Lower[a] + std::min(box.Size(a), (box.Size(a) * first + parts - 1) / parts);
  std::vector<IndexBox> boxes = CutBox(low, first, axis);
  const std::vector<IndexBox> others = CutBox(high, parts - first, axis);
  boxes.insert(boxes.end(), others.begin(), others.end());
  return boxes;
}

FractionField CopyToLocal(
  const CartesianGrid& whole, const FractionField& from, const CartesianGrid& grid)
{
  FractionField field(grid, from.NumberOfMaterials());
  const IndexBox& box = grid.Local();
  ForCells(box, [&](const Index3& p) { field.CopyCell(grid.Linear(p), from, whole.Linear(p)); });
  return field;
}

LabelArray MakeResolvedLabels(const CartesianGrid& grid, const FractionField& fractions,
  const Partition& partition, Runtime& runtime)
{
  LabelArray labels = AssignMaterials(grid, fractions, 0.5);
  ResolveLabels(grid, fractions, labels, partition, runtime);
  return labels;
}

CartesianGrid MakeUnevenGrid(int n)
{
  std::array<std::vector<double>, 3> x;
  for (int a = 0; a < 3; ++a)
  {
    double at = 0.0;
    for (int i = 0; i <= n; ++i)
    {
      x[a].push_back(at);
      at += (1.0 + 0.5 * a) * (1.0 + 0.25 * std::sin(0.9 * i + a));
    }
  }
  return CartesianGrid(x);
}

bool HaveSameParts(const FractionField& a, Index i, const FractionField& b, Index j)
{
  if (a.IsMixed(i) != b.IsMixed(j))
  {
    return false;
  }
  return a.IsMixed(i)
    ? std::equal(a.Parts(i).begin(), a.Parts(i).end(), b.Parts(j).begin(), b.Parts(j).end(),
        [](const FractionField::Part& p, const FractionField::Part& q)
        { return p.Material == q.Material && p.Fraction == q.Fraction; })
    : a.Label(i) == b.Label(j);
}

FractionField MakePatchyFractions(const CartesianGrid& grid, int materials, unsigned seed)
{
  FractionField field(grid, materials);
  RandomDraw draw(seed);
  ForCells(grid.Local(),
    [&](const Index3& p)
    {
      const Index cell = grid.Linear(p);
      if (draw.Chance(0.5))
      {
        field.SetLabel(cell, static_cast<int>(draw.Between(0.0, 1.0) * (materials + 1)));
        return;
      }
      std::vector<FractionField::Part> parts;
      double rest = 1.0;
      for (int m = 1; m <= materials; ++m)
      {
        const double fraction =
          rest * std::pow(draw.Between(0.0, 1.0), draw.Chance(0.2) ? 12.0 : 1.0);
        if (fraction > 1e-9 && draw.Chance(0.7))
        {
          parts.push_back({ m, fraction });
          rest -= fraction;
        }
      }
      field.SetParts(cell, parts);
    });
  return field;
}

std::string FindRankProblem(
  const CartesianGrid& whole, const FractionField& field, const FieldChange& change)
{
  Runtime alone;
  FractionField expected = field;
  change(whole, Partition(whole, alone.Group()), alone, expected);
  for (const std::array<int, 2>& cut :
    { std::array<int, 2>{ { 2, -1 } }, { { 3, 0 } }, { { 4, -1 } }, { { 8, -1 } }, { { 6, 2 } } })
  {
    std::vector<IndexBox> boxes = CutBox(whole.Domain(), cut[0], cut[1]);
    boxes.push_back(IndexBox());
    std::atomic<Index> differences{ 0 };
    RunOnRanks(static_cast<int>(boxes.size()),
      [&](Ranks& ranks)
      {
        RankRuntime runtime(ranks);
        const CartesianGrid grid = MakeRankGrid(whole, boxes[ranks.Rank()]);
        FractionField mine = CopyToLocal(whole, field, grid);
        change(grid, Partition(grid, ranks), runtime, mine);
        ForCells(grid.Local(),
          [&](const Index3& p)
          { differences += !HaveSameParts(mine, grid.Linear(p), expected, whole.Linear(p)); });
      });
    if (differences > 0)
    {
      return std::to_string(cut[0]) + " ranks: " + std::to_string(differences) + " other cells";
    }
  }
  return "";
}

} // namespace testing
} // namespace vfm
