#include "Atlas.h"

#include "Base/Vector3.h"
#include "MeshChecks.h"
#include "RandomDraw.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>

namespace vfm
{
namespace testing
{
namespace
{

constexpr double CellsShare = 0.4, BlobsShare = 0.25,
                 SheetsShare = 0.1;    // share of all labels; the rest are chains
constexpr double SmallestWeight = 0.1; // weight of a Voronoi cell
constexpr double Roughness = 0.6;      // roughness of sides of Voronoi cells, in cells
constexpr double SheetThickness = 0.8, Never = 1e30;
constexpr int LargestChain = 8, SmallestBlob = 9, LargestBlob = 600;

/// Draws an atlas into an array of the cells of a cube.
class AtlasPainter
{
public:
  AtlasPainter(Index n, unsigned seed) : N(n), Draw(seed), Labels(n * n * n, 0) {}

  void PaintCells(int count);
  void PaintBlob();
  void PaintSheet();
  void PaintChain();
  int NumberOfLabels() const { return this->Count; }
  int LabelAt(const Index3& p) const { return this->Labels[this->At(p)]; }

private:
  double Random() { return this->Draw.Between(0.0, 1.0); }
  Index At(const Index3& p) const { return p[0] + this->N * (p[1] + this->N * p[2]); }
  bool Contains(const Index3& p) const
  {
    return std::all_of(p.begin(), p.end(), [this](Index i) { return i >= 0 && i < this->N; });
  }
  /// Returns the largest size of blobs. It is reduced in a small cube, which they would fill.
  double SizeOfBlobs() const
  {
    return std::min<double>(LargestBlob, static_cast<double>(this->Labels.size()) / 150.0);
  }
  Vector3 Warp(const Vector3& x) const;
  double FieldOfBody(const Vector3& x) const;
  bool MayTake(const Index3& p) const;
  bool IsOnInterface(const Index3& p) const;
  Index3 DrawStart(bool onInterface);
  void Grow(const Index3& start, Index size, const std::function<double(const Index3&)>& distance);

  Index N;
  RandomDraw Draw;
  std::vector<int> Labels;
  int Count = 0;    // labels so far
  int LastCell = 0; // last label of a Voronoi cell
  std::vector<Index> Sizes;
};

Vector3 AtlasPainter::Warp(const Vector3& x) const
{
  const double k = 2.0 * M_PI / static_cast<double>(this->N),
               a = 0.035 * static_cast<double>(this->N);
  return { { x[0] + a * std::sin(2.0 * k * x[1] + 1.0) + 0.3 * a * std::sin(7.0 * k * x[2]),
    x[1] + a * std::sin(3.0 * k * x[2] + 2.0) + 0.3 * a * std::sin(6.0 * k * x[0]),
    x[2] + a * std::sin(2.0 * k * x[0] + 3.0) + 0.3 * a * std::sin(8.0 * k * x[1]) } };
}

/// Returns a function that is below 1 inside the body.
double AtlasPainter::FieldOfBody(const Vector3& x) const
{
  const double n = static_cast<double>(this->N);
  const Vector3 y{ { (x[0] / n - 0.5) / 0.38, (x[1] / n - 0.5) / 0.44, (x[2] / n - 0.5) / 0.35 } };
  return Norm(y);
}

void AtlasPainter::PaintCells(int count)
{
  std::vector<Vector3> seeds;
  std::vector<double> weights;
  while (static_cast<int>(seeds.size()) < count)
  {
    Vector3 x;
    for (double& c : x)
    {
      c = this->Random() * static_cast<double>(this->N);
    }
    if (this->FieldOfBody(x) < 1.0)
    {
      seeds.push_back(x);
      weights.push_back(std::pow(SmallestWeight, this->Random()));
    }
  }
  std::vector<int> drawn(this->Labels.size(), 0);
  ForCells({ { { 0, 0, 0 } }, { { this->N, this->N, this->N } } },
    [&](const Index3& p)
    {
      Vector3 x{ { p[0] + 0.5, p[1] + 0.5, p[2] + 0.5 } };
      x = this->Warp(x);
      for (double& c : x)
      {
        c += Roughness * (2.0 * this->Random() - 1.0);
      }
      if (this->FieldOfBody(x) >= 1.0)
      {
        return;
      }
      double least = 1e300;
      for (int s = 0; s < count; ++s)
      {
        const Vector3 d = x - seeds[s];
        const double distance = Dot(d, d) / (weights[s] * weights[s]);
        if (distance < least)
        {
          least = distance;
          drawn[this->At(p)] = s + 1;
        }
      }
    });
  std::vector<int> numbers(count + 1, 0);
  for (std::size_t c = 0; c < drawn.size(); ++c)
  {
    int& number = numbers[drawn[c]];
    number = drawn[c] > 0 && number == 0 ? ++this->Count : number;
    this->Labels[c] = number;
  }
  this->LastCell = this->Count;
  this->Sizes.assign(this->Count + 1, 0);
  for (int label : this->Labels)
  {
    ++this->Sizes[label];
  }
}

/// Returns whether a cell can be repainted: it belongs to the Voronoi diagram
/// and is not the last of its label.
bool AtlasPainter::MayTake(const Index3& p) const
{
  const int label = this->Contains(p) ? this->LabelAt(p) : 0;
  return label > 0 && label <= this->LastCell && this->Sizes[label] > 1;
}

bool AtlasPainter::IsOnInterface(const Index3& p) const
{
  for (int face = 0; face < 6; ++face)
  {
    Index3 q = p;
    q[face / 2] += face & 1 ? 1 : -1;
    if (this->Contains(q) && this->LabelAt(q) != this->LabelAt(p))
    {
      return true;
    }
  }
  return false;
}

/// Returns a random cell, on an interface or not; any cell if none is found in 1000 tries.
Index3 AtlasPainter::DrawStart(bool onInterface)
{
  constexpr int Tries = 1000;
  for (int tries = 0;; ++tries)
  {
    Index3 p;
    for (Index& i : p)
    {
      i = static_cast<Index>(this->Draw.Whole(0, static_cast<int>(this->N) - 1));
    }
    if (this->MayTake(p) && (tries > Tries || this->IsOnInterface(p) == onInterface))
    {
      return p;
    }
  }
}

/// Paints a new label from start on, up to `size` cells. The next cell is a neighbour of the label
/// with the smallest distance(cell) plus a random number.
void AtlasPainter::Grow(
  const Index3& start, Index size, const std::function<double(const Index3&)>& distance)
{
  const int label = ++this->Count;
  std::set<std::pair<double, Index3>> front{ { 0.0, start } };
  for (Index cells = 0; cells < size && !front.empty();)
  {
    const Index3 p = front.begin()->second;
    front.erase(front.begin());
    if (!this->MayTake(p))
    {
      continue;
    }
    --this->Sizes[this->LabelAt(p)];
    this->Labels[this->At(p)] = label;
    ++cells;
    for (int v = 0; v < 27; ++v)
    {
      const Index3 q = CellAround(p, v);
      if (const double d = distance(q); d < Never)
      {
        front.insert({ d + this->Random(), q });
      }
    }
  }
}

double Between(const Index3& p, const Index3& q)
{
  return Norm({ { 1.0 * (p[0] - q[0]), 1.0 * (p[1] - q[1]), 1.0 * (p[2] - q[2]) } });
}

void AtlasPainter::PaintBlob()
{
  const double ratio = this->SizeOfBlobs() / SmallestBlob;
  const double size = SmallestBlob * std::pow(ratio, this->Random());
  const Index3 start = this->DrawStart(this->Random() < 0.5);
  this->Grow(start, static_cast<Index>(size), [&](const Index3& p) { return Between(p, start); });
}

/// Paints part of a spherical shell.
void AtlasPainter::PaintSheet()
{
  const double radius = 4.0 + 6.0 * this->Random(), size = this->SizeOfBlobs() * this->Random();
  const Index3 start = this->DrawStart(false);
  const Index3 centre{ { start[0], start[1], start[2] - static_cast<Index>(radius) } };
  this->Grow(start, 1 + static_cast<Index>(size),
    [&](const Index3& p) {
      return std::fabs(Between(p, centre) - radius) < SheetThickness ? Between(p, start) : Never;
    });
}

/// Paints a chain whose cells may be connected only by edges or corners.
void AtlasPainter::PaintChain()
{
  const Index size = 1 + static_cast<Index>(this->Random() * LargestChain);
  const Index3 start = this->DrawStart(this->Random() < 0.5);
  this->Grow(start, size, [&](const Index3& p) { return 0.5 * Between(p, start); });
}

} // namespace

FractionField MakeAtlas(const CartesianGrid& grid, int labels, unsigned seed)
{
  AtlasPainter painter(grid.Global().Size(0), seed);
  painter.PaintCells(static_cast<int>(CellsShare * labels));
  const int blobs = static_cast<int>(BlobsShare * labels);
  for (int blob = 0; blob < blobs; ++blob)
  {
    painter.PaintBlob();
  }
  const int sheets = static_cast<int>(SheetsShare * labels);
  for (int sheet = 0; sheet < sheets; ++sheet)
  {
    painter.PaintSheet();
  }
  while (painter.NumberOfLabels() < labels)
  {
    painter.PaintChain();
  }
  return MakeLabels(
    grid, painter.NumberOfLabels(), [&](const Index3& p) { return painter.LabelAt(p); });
}

std::vector<AtlasClass> MeasureAtlas(
  const CartesianGrid& grid, const FractionField& labels, const MeshReport& report)
{
  std::vector<Index> sizes(labels.NumberOfMaterials() + 1, 0);
  ForCells(grid.Owned(), [&](const Index3& p) { ++sizes[labels.Label(grid.Linear(p))]; });
  std::vector<AtlasClass> classes{ { 1, 1 }, { 2, 4 }, { 5, 7 }, { 8, 29 }, { 30, 499 },
    { 500, grid.Owned().NumberOfCells() } };
  for (std::size_t m = 1; m < sizes.size(); ++m)
  {
    const Index size = sizes[m];
    AtlasClass& c = *std::find_if(classes.begin(), classes.end(),
      [size](const AtlasClass& k) { return size >= k.Smallest && size <= k.Largest; });
    const double error = std::fabs(report.MeshVolume[m] / static_cast<double>(size) - 1.0);
    const bool isLost = !(report.MeshVolume[m] > 0.0);
    ++c.Labels;
    c.Lost += isLost;
    c.WorstError = std::max(c.WorstError, isLost ? 0.0 : error);
    c.MeanError += error;
    c.Above1 += error > 0.01;
    c.Above20 += error > 0.2;
  }
  for (AtlasClass& c : classes)
  {
    c.MeanError /= std::max(c.Labels, 1);
  }
  return classes;
}

std::string FormatAtlas(const std::vector<AtlasClass>& classes)
{
  std::string table =
    "| cells | labels | lost | worst error % | mean error % | above 1 % | above 20 % |\n"
    "|---|---|---|---|---|---|---|\n";
  for (const AtlasClass& c : classes)
  {
    char row[160];
    std::snprintf(row, sizeof(row), "| %lld to %lld | %d | %d | %.4f | %.4f | %d | %d |\n",
      static_cast<long long>(c.Smallest), static_cast<long long>(c.Largest), c.Labels, c.Lost,
      100.0 * c.WorstError, 100.0 * c.MeanError, c.Above1, c.Above20);
    table += row;
  }
  return table;
}

} // namespace testing
} // namespace vfm
