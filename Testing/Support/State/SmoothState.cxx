#include "State/SmoothState.h"

#include "Base/Vector3.h"
#include "Phases/MeshOfCells.h"
#include "State/Transfer/Overlaps.h"

#include <cmath>
#include <numeric>

namespace vfm
{
namespace testing
{
namespace
{

constexpr int Samples = 8; // along each axis of a mixed cell

/// Accumulates the mean of a material: volume means per volume, mass means for quantities per mass.
class MeanOfMaterial
{
public:
  void Add(const double* values, double weight)
  {
    const double mass = weight * values[0];
    this->Volume += weight;
    this->Mass += mass;
    for (int c = 0; c < SmoothComponents; ++c)
    {
      this->Sums[c] += (IsPerVolume(c) ? weight : mass) * values[c];
    }
  }
  bool IsEmpty() const { return this->Volume == 0.0; }
  void Write(double* means) const
  {
    for (int c = 0; c < SmoothComponents; ++c)
    {
      means[c] = this->Sums[c] / (IsPerVolume(c) ? this->Volume : this->Mass);
    }
  }

private:
  static bool IsPerVolume(int component) { return component == 0 || component == 7; }

  double Volume = 0.0, Mass = 0.0;
  std::array<double, SmoothComponents> Sums{};
};

/// Calls body(point) for points of a cell; places: their coordinates, from 0 to 1 along each axis.
template <class Body>
void ForPoints(const CartesianGrid& grid, const Index3& cell, const std::vector<double>& places,
  const Body& body)
{
  const Vector3 lower = grid.NodePoint(cell);
  const Vector3 width = grid.NodePoint(CornerOfCell(cell, 7)) - lower;
  for (double z : places)
  {
    for (double y : places)
    {
      for (double x : places)
      {
        body(lower + Scaled(width, { { x, y, z } }));
      }
    }
  }
}

std::vector<double> GaussPlaces()
{
  return { 0.5 - std::sqrt(1.0 / 12.0), 0.5 + std::sqrt(1.0 / 12.0) };
}

std::vector<double> SamplePlaces()
{
  std::vector<double> places(Samples);
  for (int i = 0; i < Samples; ++i)
  {
    places[i] = (i + 0.5) / Samples;
  }
  return places;
}

} // namespace

std::vector<StateQuantity> ListSmoothQuantities()
{
  return { { StateKind::PerVolume, 1, -1 }, { StateKind::PerMass, 3, -1 },
    { StateKind::PerMass, 1, -1 }, { StateKind::PerMass, 1, -1 }, { StateKind::PerMass, 1, -1 },
    { StateKind::PerVolume, 1, -1 } };
}

void EvaluateSmoothState(const Vector3& x, int material, double* values)
{
  values[0] = (material == 2 ? 8.0 : 1.0) * (1.0 + 0.5 * x[0] + 0.3 * x[1] * x[1]);
  values[1] = std::sin(2.0 * x[0]) + x[2] + 0.3;
  values[2] = std::cos(3.0 * x[1] + material) - 0.5 * x[0];
  values[3] = x[0] * x[2] - 0.2;
  values[4] = 2.0 + x[1] * x[2] + 0.1 * material;
  values[5] = 300.0 + 50.0 * std::cos(2.0 * x[1] - x[2]);
  values[6] = 0.1 * (x[0] + x[1] * x[1] + std::sin(x[2]));
  values[7] = 1.0 + x[2] * x[2] - std::sin(3.0 * x[0]);
}

CellMeans::CellMeans(const CartesianGrid& grid, const FractionField& fractions,
  const StateFunction& function, const std::function<int(const Vector3&)>& materialAt) :
  Grid(grid),
  Materials(fractions.NumberOfMaterials() + 1),
  Means(static_cast<std::size_t>(grid.Local().NumberOfCells()) * this->Materials * SmoothComponents)
{
  const std::vector<double> gauss = GaussPlaces(), samples = SamplePlaces();
  std::size_t at = 0;
  ForCells(grid.Local(),
    [&](const Index3& cell)
    {
      const bool isMixed = fractions.IsMixed(grid.Linear(cell));
      std::vector<MeanOfMaterial> some(this->Materials), all(this->Materials);
      double values[SmoothComponents];
      ForPoints(grid, cell, isMixed ? samples : gauss,
        [&](const Vector3& x)
        {
          const int own = isMixed ? materialAt(x) : fractions.Label(grid.Linear(cell));
          function(x, own, values);
          some[own].Add(values, 1.0);
        });
      ForPoints(grid, cell, gauss,
        [&](const Vector3& x)
        {
          for (int m = 0; isMixed && m < this->Materials; ++m)
          {
            function(x, m, values);
            all[m].Add(values, 1.0); // used if a part is too small to contain a sample
          }
        });
      for (int m = 0; m < this->Materials; ++m, at += SmoothComponents)
      {
        if (!some[m].IsEmpty() || !all[m].IsEmpty())
        {
          (some[m].IsEmpty() ? all[m] : some[m]).Write(this->Means.data() + at);
        }
      }
    });
}

void CellMeans::Read(const Index3& cell, int material, double* values) const
{
  const std::size_t at = IndexInBox(this->Grid.Local(), cell) * this->Materials + material;
  std::copy_n(this->Means.data() + at * SmoothComponents, SmoothComponents, values);
}

CartesianGrid MakeUnitCube(int n)
{
  std::array<std::vector<double>, 3> x;
  for (int i = 0; i <= n; ++i)
  {
    x[0].push_back(static_cast<double>(i) / n);
  }
  x[1] = x[2] = x[0];
  return CartesianGrid(x);
}

Mesh MakeMesh(const CartesianGrid& grid, const FractionField& fractions, Elements elements)
{
  MeshOptions options;
  options.Method = elements == Elements::Cells ? TetMethod::Cells : TetMethod::Lattice;
  Runtime runtime;
  MeshReport report;
  return (elements == Elements::Hexes ? MakeHexMesh : MakeTetMesh)(
    grid, fractions, options, runtime, report);
}

MeasuredShapes MeasureElements(const Mesh& mesh, const CartesianGrid& grid)
{
  std::vector<Index> elements(mesh.Material.size());
  std::iota(elements.begin(), elements.end(), 0);
  Runtime runtime;
  const Overlaps overlaps = FindOverlaps(mesh, elements, grid, runtime);
  MeasuredShapes shapes;
  for (Index e : elements)
  {
    double volume = 0.0;
    Vector3 moment{};
    for (Index p = overlaps.Offsets[e]; p < overlaps.Offsets[e + 1]; ++p)
    {
      volume += overlaps.Parts[p].Volume;
      moment = moment + overlaps.Parts[p].Volume * overlaps.Parts[p].Centroid;
    }
    shapes.Volumes.push_back(volume);
    shapes.Centroids.push_back(1.0 / volume * moment);
  }
  return shapes;
}

} // namespace testing
} // namespace vfm
