#include "Geometry/MeasureSurfaces.h"

#include "Base/ExactSum.h"
#include "Base/Vector3.h"
#include "Geometry/EntityNumbers.h"
#include "Octree/RefinedGrid.h"

#include <mutex>

namespace vfm
{
namespace
{

constexpr int SumsOfSurface = 7;      // area, first moments, vector area
constexpr Index FacetsOfBlock = 4096; // per task

/// Adds the sums of a facet.
/// @param x  corners
void AddFacet(const std::array<Vector3, 4>& x, int corners, ExactSum* sum)
{
  for (int c = 2; c < corners; ++c)
  {
    const Vector3 vector = 0.5 * Cross(x[c - 1] - x[0], x[c] - x[0]);
    const double area = Norm(vector);
    const Vector3 moment = (area / 3.0) * (x[0] + x[c - 1] + x[c]);
    sum[0].Add(area);
    for (int axis = 0; axis < 3; ++axis)
    {
      sum[1 + axis].Add(moment[axis]);
      sum[4 + axis].Add(vector[axis]);
    }
  }
}

/// Sums of the facets of a block, by surface.
class BlockSums
{
public:
  /// @param rows  row of each facet, or -1
  explicit BlockSums(const std::vector<Index>& rows) : Rows(rows)
  {
    SortUnique(this->Rows);
    this->Sums.resize(SumsOfSurface * this->Rows.size());
  }
  ExactSum* At(Index row)
  {
    return this->Sums.data() + SumsOfSurface * FindSorted(this->Rows, row);
  }
  void AddTo(std::vector<ExactSum>& all) const
  {
    for (std::size_t i = 0; i < this->Sums.size(); ++i)
    {
      const Index row = this->Rows[i / SumsOfSurface];
      if (row >= 0)
      {
        all[SumsOfSurface * row + i % SumsOfSurface].Add(this->Sums[i]);
      }
    }
  }

private:
  std::vector<Index> Rows;
  std::vector<ExactSum> Sums;
};

/// Returns the sums of the owned facets by surface, in units of `unit` and relative to `origin`.
/// Loops over blocks of facets, which are on few surfaces, so that a thread needs little memory.
std::vector<ExactSum> SumFacets(const Mesh& mesh, const std::vector<int>& ids,
  const Vector3& origin, double unit, Runtime& runtime)
{
  std::vector<ExactSum> sums(SumsOfSurface * ids.size());
  const SurfaceFacets& facets = mesh.Surfaces;
  const auto count = static_cast<Index>(facets.SurfaceId.size());
  const int corners = mesh.CornersOfFacet();
  const double scale = 1.0 / unit;
  std::mutex lock;
  ForEach(runtime, (count + FacetsOfBlock - 1) / FacetsOfBlock,
    [&](Index block)
    {
      const Index first = FacetsOfBlock * block, last = std::min(count, first + FacetsOfBlock);
      std::vector<Index> rows;
      for (Index f = first; f < last; ++f)
      {
        rows.push_back(facets.IsOwned[f] ? FindSorted(ids, facets.SurfaceId[f]) : -1);
      }
      BlockSums own(rows);
      for (Index f = first; f < last; ++f)
      {
        if (rows[f - first] < 0)
        {
          continue;
        }
        std::array<Vector3, 4> x;
        for (int c = 0; c < corners; ++c)
        {
          x[c] = scale * (mesh.PointAt(facets.Points[corners * f + c]) - origin);
        }
        AddFacet(x, corners, own.At(rows[f - first]));
      }
      const std::lock_guard<std::mutex> guard(lock);
      own.AddTo(sums);
    });
  return sums;
}

} // namespace

void MeasureSurfaces(const std::vector<int>& ids, const std::vector<unsigned char>& isShared,
  Mesh& mesh, Runtime& runtime)
{
  const CartesianGrid& grid = mesh.Levels->Finest();
  const double unit = grid.MeanWidth();
  const Vector3 origin{ { grid.Coordinates(0)[0], grid.Coordinates(1)[0],
    grid.Coordinates(2)[0] } };
  std::vector<ExactSum> sums = SumFacets(mesh, ids, origin, unit, runtime);
  SharedRows(ids, isShared, runtime.Group())
    .Merge(sums, SumsOfSurface, [](ExactSum& a, const ExactSum& b) { a.Add(b); });
  GeometryTables& tables = mesh.Tables;
  for (std::size_t at = 0; at < sums.size(); at += SumsOfSurface)
  {
    std::array<double, SumsOfSurface> sum;
    std::transform(sums.begin() + at, sums.begin() + at + SumsOfSurface, sum.begin(),
      [](const ExactSum& exact) { return exact.Value(); });
    const double share = sum[0] > 0.0 ? 1.0 / sum[0] : 0.0;
    tables.SurfaceAreas.push_back(unit * unit * sum[0]);
    tables.SurfaceCentroids.push_back(
      origin + (unit * share) * Vector3{ { sum[1], sum[2], sum[3] } });
    tables.SurfaceNormals.push_back(share * Vector3{ { sum[4], sum[5], sum[6] } });
  }
}

} // namespace vfm
