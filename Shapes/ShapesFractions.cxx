#include "Shapes/ShapesFractions.h"

#include "Base/Vector3.h"
#include "Shapes/ShapesFit.h"

#include <atomic>
#include <mutex>
#include <thread>

namespace vfm
{
namespace
{

using Parts = std::vector<FractionField::Part>;

constexpr Index BlockWidth = 16;
constexpr int MaximumDepth = 10;
constexpr std::size_t MaximumSurfaces = 24; // boxes with more surfaces are halved first
// Weights of the sheet error. It counts if several surfaces cut the box, because each
// keeps its mean height only over the whole box, and for functions with sharp edges, whose
// mean is less accurate.
constexpr double SheetOfSeveral = 0.25;
constexpr double SheetOfFunction = 0.1;
constexpr double NegligiblePart = 1e-12;
constexpr int Body = -1; // number of the body among the surfaces; planes are numbered from 0

/// Shapes that meet a box, and the surfaces of each shape that cut it. A shape without surfaces
/// fills the box and is the last.
struct Candidates
{
  struct Item
  {
    int Shape;
    std::size_t First, Last; // range in Surfaces
  };
  std::vector<Item> Items;
  std::vector<int> Surfaces; // Body or number of a plane

  bool IsPure() const { return this->Items.empty() || this->Items[0].First == this->Items[0].Last; }
};

enum class Side
{
  Inside,
  Outside,
  Cut
};

/// Computes the fractions of one cell; holds the memory for it.
class CellWorker
{
public:
  CellWorker(const std::vector<Shape>& shapes, double tolerance) :
    Shapes(shapes), Tolerance(tolerance), Levels(MaximumDepth + 1), Sum(CountMaterials(shapes), 0.0)
  {
  }

  /// Selects the shapes and surfaces that meet a box.
  /// @param from  candidates of a larger box; null for all shapes
  /// @param caution  factor on the size of the box for curved surfaces
  void Select(const Candidates* from, const BoxGeometry& box, double caution, Candidates& to) const;

  /// Computes the parts in a cell.
  /// @param from  candidates of a box around the cell
  void Compute(const Candidates& from, const BoxGeometry& cell, Parts& parts);

private:
  Side Classify(int shape, int surface, const BoxGeometry& box, double caution) const;
  bool SelectShape(const Candidates* from, const Candidates::Item& item, const BoxGeometry& box,
    double caution, Candidates& to) const;
  void Recurse(const Candidates& from, const BoxGeometry& box, int depth);
  bool FitSurfaces(const Candidates& candidates, const BoxGeometry& box, int depth);
  void CutBox(const Candidates& candidates, const BoxGeometry& box);
  void Add(int shape, double volume);

  const std::vector<Shape>& Shapes;
  double Tolerance;
  double CellVolume = 0.0;
  std::vector<Candidates> Levels;
  std::vector<HalfSpace> Fitted; // planes of all surfaces of the candidates of a box
  std::vector<double> Sum;       // volume per material
  std::vector<int> Touched;      // materials with a part
  SurfaceFitter Fitter;
  std::vector<ConvexPiece> Pieces, Rest;
  std::vector<Vector3> Section;
};

Side CellWorker::Classify(int shape, int surface, const BoxGeometry& box, double caution) const
{
  double value, reach;
  if (surface == Body)
  {
    value = EvaluateBody(this->Shapes[shape], box.Center);
    reach = caution * Norm(box.Half);
  }
  else
  {
    HalfSpace plane;
    if (!GetPlane(this->Shapes[shape], surface, plane))
    {
      return Side::Inside;
    }
    value = Dot(plane.Normal, box.Center) - plane.Offset;
    reach = std::abs(plane.Normal[0]) * box.Half[0] + std::abs(plane.Normal[1]) * box.Half[1] +
      std::abs(plane.Normal[2]) * box.Half[2];
    reach *= caution > 1.0 ? 1.0 + 1e-9 : 1.0 - 1e-12;
  }
  return value >= reach ? Side::Outside : (value <= -reach ? Side::Inside : Side::Cut);
}

bool CellWorker::SelectShape(const Candidates* from, const Candidates::Item& item,
  const BoxGeometry& box, double caution, Candidates& to) const
{
  const std::size_t first = to.Surfaces.size();
  for (std::size_t s = item.First; s < item.Last; ++s)
  {
    const int surface = from ? from->Surfaces[s] : static_cast<int>(s) + Body;
    if (surface == Body && !HasBody(this->Shapes[item.Shape]))
    {
      continue;
    }
    const Side side = this->Classify(item.Shape, surface, box, caution);
    if (side == Side::Outside)
    {
      to.Surfaces.resize(first);
      return false;
    }
    if (side == Side::Cut)
    {
      to.Surfaces.push_back(surface);
    }
  }
  to.Items.push_back({ item.Shape, first, to.Surfaces.size() });
  return first == to.Surfaces.size();
}

void CellWorker::Select(
  const Candidates* from, const BoxGeometry& box, double caution, Candidates& to) const
{
  to.Items.clear();
  to.Surfaces.clear();
  const std::size_t count = from ? from->Items.size() : this->Shapes.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    const Candidates::Item item = from
      ? from->Items[i]
      : Candidates::Item{ static_cast<int>(i), 0, CountPlanes(this->Shapes[i]) + 1 };
    if (this->SelectShape(from, item, box, caution, to))
    {
      break; // the shape fills the box
    }
  }
}

void CellWorker::Compute(const Candidates& from, const BoxGeometry& cell, Parts& parts)
{
  parts.clear();
  this->CellVolume = cell.Volume();
  this->Recurse(from, cell, 0);
  std::sort(this->Touched.begin(), this->Touched.end());
  for (int material : this->Touched)
  {
    double& sum = this->Sum[material - 1];
    const double fraction = std::min(sum / this->CellVolume, 1.0);
    sum = 0.0;
    if (fraction >= NegligiblePart)
    {
      parts.push_back({ material, fraction });
    }
  }
  this->Touched.clear();
}

void CellWorker::Add(int shape, double volume)
{
  const int material = this->Shapes[shape].Material;
  if (std::find(this->Touched.begin(), this->Touched.end(), material) == this->Touched.end())
  {
    this->Touched.push_back(material);
  }
  this->Sum[material - 1] += volume;
}

void CellWorker::Recurse(const Candidates& from, const BoxGeometry& box, int depth)
{
  Candidates& candidates = this->Levels[depth];
  this->Select(&from, box, 1.0, candidates);
  if (candidates.IsPure())
  {
    if (!candidates.Items.empty())
    {
      this->Add(candidates.Items[0].Shape, box.Volume());
    }
    return;
  }
  if (this->FitSurfaces(candidates, box, depth) || depth == MaximumDepth)
  {
    this->CutBox(candidates, box);
    return;
  }
  for (int c = 0; c < 8; ++c)
  {
    this->Recurse(candidates, box.Child(c), depth + 1);
  }
}

/// Fits planes to all surfaces. Returns whether the error is within the tolerance.
bool CellWorker::FitSurfaces(const Candidates& candidates, const BoxGeometry& box, int depth)
{
  if (candidates.Surfaces.size() > MaximumSurfaces && depth < MaximumDepth)
  {
    return false;
  }
  this->Fitted.resize(candidates.Surfaces.size());
  // Each halving multiplies the boxes on a surface by about four, on an edge by two. The tolerance
  // is divided among them.
  const double onSurface = std::ldexp(1.0, 2 * depth) / this->CellVolume;
  const double onEdge = std::ldexp(1.0, depth) / this->CellVolume;
  double error = 0.0;
  for (const Candidates::Item& item : candidates.Items)
  {
    const Shape& shape = this->Shapes[item.Shape];
    const double sheet = candidates.Surfaces.size() > 1
      ? SheetOfSeveral
      : (shape.Kind == ShapeKind::Function ? SheetOfFunction : 0.0);
    for (std::size_t s = item.First; s < item.Last; ++s)
    {
      if (candidates.Surfaces[s] != Body)
      {
        GetPlane(shape, candidates.Surfaces[s], this->Fitted[s]);
        continue;
      }
      const FitError fit = this->Fitter.Fit(shape, box, this->Fitted[s]);
      error += onSurface * fit.Rim + (sheet > 0.0 ? onEdge * sheet * fit.Sheet : 0.0);
      if (error > this->Tolerance && depth < MaximumDepth)
      {
        return false;
      }
    }
  }
  return error <= this->Tolerance;
}

void CellWorker::CutBox(const Candidates& candidates, const BoxGeometry& box)
{
  this->Pieces.assign(1, MakeBoxPiece(box.Center - box.Half, box.Center + box.Half));
  ConvexPiece inner, outer;
  for (const Candidates::Item& item : candidates.Items)
  {
    this->Rest.clear();
    for (ConvexPiece& piece : this->Pieces)
    {
      for (std::size_t s = item.First; s < item.Last && !piece.IsEmpty(); ++s)
      {
        ClipPiece(piece, this->Fitted[s], inner, outer, this->Section);
        std::swap(piece, inner);
        if (!outer.IsEmpty())
        {
          this->Rest.push_back(std::move(outer));
        }
      }
      if (!piece.IsEmpty())
      {
        this->Add(item.Shape, ComputeVolume(piece));
      }
    }
    std::swap(this->Pieces, this->Rest);
  }
}

/// Computes one block of cells, which is halved down to single cells where shapes cut it.
class BlockWorker
{
public:
  BlockWorker(const std::array<std::vector<double>, 3>& coordinates,
    const std::vector<Shape>& shapes, double tolerance, const ShapePartsSink& sink) :
    X(coordinates), Shapes(shapes), Cell(shapes, tolerance), Sink(sink)
  {
  }

  void Compute(const Candidates* from, const IndexBox& cells)
  {
    const BoxGeometry box = this->Geometry(cells);
    // The factor sqrt(2) ensures that every shape discarded here would be discarded for each cell
    // of the box too: |center - box center| + |half cell| <= sqrt(2) |half box|.
    Candidates candidates;
    this->Cell.Select(from, box, 1.4143, candidates);
    if (candidates.Items.empty())
    {
      return;
    }
    if (candidates.IsPure())
    {
      this->Found.assign(1, { this->Shapes[candidates.Items[0].Shape].Material, 1.0 });
      this->Sink(cells, this->Found);
      return;
    }
    if (cells.NumberOfCells() == 1)
    {
      this->Cell.Compute(candidates, box, this->Found);
      if (!this->Found.empty())
      {
        this->Sink(cells, this->Found);
      }
      return;
    }
    this->ComputeHalves(candidates, cells);
  }

private:
  BoxGeometry Geometry(const IndexBox& cells) const
  {
    Vector3 lower, upper;
    for (int a = 0; a < 3; ++a)
    {
      lower[a] = this->X[a][cells.Lower[a]];
      upper[a] = this->X[a][cells.Upper[a]];
    }
    return MakeBoxGeometry(lower, upper);
  }

  void ComputeHalves(const Candidates& candidates, const IndexBox& cells)
  {
    int axis = 0;
    for (int a = 1; a < 3; ++a)
    {
      axis = cells.Size(a) > cells.Size(axis) ? a : axis;
    }
    IndexBox low = cells, high = cells;
    low.Upper[axis] = high.Lower[axis] = (cells.Lower[axis] + cells.Upper[axis]) / 2;
    this->Compute(&candidates, low);
    this->Compute(&candidates, high);
  }

  const std::array<std::vector<double>, 3>& X;
  const std::vector<Shape>& Shapes;
  CellWorker Cell;
  const ShapePartsSink& Sink;
  Parts Found;
};

/// Counter of finished blocks. The thread that made it reports the progress. If the report throws,
/// the other threads stop too.
class BlockCount
{
public:
  BlockCount(Index count, Runtime& runtime) : Count(count), Run(runtime) {}

  bool IsStopped() const { return this->Stopped; }

  void Add()
  {
    const Index percent = 100 * ++this->Done / this->Count;
    if (std::this_thread::get_id() != this->ReportingThread || percent == this->Reported)
    {
      return;
    }
    this->Reported = percent;
    try
    {
      this->Run.Progress(0.01 * static_cast<double>(percent), "Computing fractions");
    }
    catch (...)
    {
      this->Stopped = true;
      throw;
    }
  }

private:
  const Index Count;
  Runtime& Run;
  const std::thread::id ReportingThread = std::this_thread::get_id();
  std::atomic<Index> Done{ 0 };
  std::atomic<bool> Stopped{ false };
  Index Reported = 0; // last reported progress, percent
};

void CheckTolerance(double tolerance)
{
  if (!(tolerance > 0.0 && tolerance < 1.0))
  {
    throw InputError("The tolerance of the volume fractions is " + std::to_string(tolerance) +
      ": it must lie between 0 and 1.");
  }
}

} // namespace

std::vector<FractionField::Part> ComputeShapeParts(
  const std::vector<Shape>& shapes, const Vector3& lower, const Vector3& upper, double tolerance)
{
  CheckTolerance(tolerance);
  CellWorker worker(shapes, tolerance);
  Candidates all;
  const BoxGeometry box = MakeBoxGeometry(lower, upper);
  worker.Select(nullptr, box, 1.4143, all);
  Parts parts;
  worker.Compute(all, box, parts);
  return parts;
}

void ShapeFractions(const std::vector<Shape>& shapes, const Vector3& lower, const Vector3& upper,
  double tolerance, double* fractions)
{
  std::fill(fractions, fractions + CountMaterials(shapes), 0.0);
  for (const FractionField::Part& part : ComputeShapeParts(shapes, lower, upper, tolerance))
  {
    fractions[part.Material - 1] = part.Fraction;
  }
}

void ComputeShapeFractions(const std::array<std::vector<double>, 3>& coordinates,
  const IndexBox& box, const std::vector<Shape>& shapes, double tolerance, Runtime& runtime,
  const ShapePartsSink& sink)
{
  CheckTolerance(tolerance);
  Index3 blocks;
  for (int a = 0; a < 3; ++a)
  {
    blocks[a] = (box.Size(a) + BlockWidth - 1) / BlockWidth;
  }
  const Index count = blocks[0] * blocks[1] * blocks[2];
  BlockCount done(count, runtime);
  const auto work = [&](std::int64_t first, std::int64_t last)
  {
    BlockWorker worker(coordinates, shapes, tolerance, sink);
    for (std::int64_t n = first; n < last && !done.IsStopped(); ++n)
    {
      const Index3 position = CellInBox({ {}, blocks }, n);
      IndexBox cells;
      for (int a = 0; a < 3; ++a)
      {
        cells.Lower[a] = box.Lower[a] + position[a] * BlockWidth;
        cells.Upper[a] = std::min(cells.Lower[a] + BlockWidth, box.Upper[a]);
      }
      worker.Compute(nullptr, cells);
      done.Add();
    }
  };
  runtime.For(0, count, work);
}

std::vector<Buffer<double>> FractionArraysOfShapes(
  const std::array<std::vector<double>, 3>& coordinates, const IndexBox& box,
  const std::vector<Shape>& shapes, double tolerance, Runtime& runtime)
{
  std::vector<Buffer<double>> arrays;
  for (int m = 0; m < CountMaterials(shapes); ++m)
  {
    arrays.emplace_back(box.NumberOfCells(), 0.0);
  }
  const auto sink = [&](const IndexBox& cells, const Parts& parts)
  {
    for (const FractionField::Part& part : parts)
    {
      double* values = arrays[part.Material - 1].data();
      ForRows(cells,
        [&](Index j, Index k)
        {
          const Index row = IndexInBox(box, { { cells.Lower[0], j, k } });
          std::fill_n(values + row, cells.Size(0), part.Fraction);
        });
    }
  };
  runtime.Progress(0.0, "Computing fractions");
  ComputeShapeFractions(coordinates, box, shapes, tolerance, runtime, sink);
  return arrays;
}

FractionField FractionsOfShapes(const CartesianGrid& grid, const std::vector<Shape>& shapes,
  int materials, double tolerance, Runtime& runtime)
{
  FractionField field(grid, materials > 0 ? materials : CountMaterials(shapes));
  FractionField::RowWriter row(field);
  std::vector<std::pair<Index, Parts>> mixed;
  std::mutex mutex;
  const auto sink = [&](const IndexBox& cells, const Parts& parts)
  {
    const std::lock_guard<std::mutex> lock(mutex);
    if (parts.size() > 1 || parts[0].Fraction < 1.0)
    {
      mixed.emplace_back(grid.Linear(cells.Lower), parts);
      return;
    }
    ForRows(cells,
      [&](Index j, Index k)
      {
        row.Start(grid.Linear({ { cells.Lower[0], j, k } }));
        row.AddLabel(parts[0].Material, cells.Size(0));
        row.Finish();
      });
  };
  ComputeShapeFractions(grid.Coordinates(), grid.Local(), shapes, tolerance, runtime, sink);
  std::sort(
    mixed.begin(), mixed.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& cell : mixed)
  {
    field.SetParts(cell.first, cell.second);
  }
  return field;
}

FractionField FractionsOfShapes(
  const CartesianGrid& grid, const std::vector<Shape>& shapes, int materials, double tolerance)
{
  Runtime runtime;
  return FractionsOfShapes(grid, shapes, materials, tolerance, runtime);
}

} // namespace vfm
