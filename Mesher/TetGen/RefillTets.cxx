#include "TetGen/RefillTets.h"

#include "Smoothing/ActiveMesh.h"

#include "Base/PortableMath.h"
#include "Base/Vector3.h"
#include "Elements/FacetSides.h"
#include "Elements/Tet/TetFacets.h"
#include "Octree/LevelIds.h"
#include "Ranks/Agreement.h"
#include "Ranks/NumberKeys.h"
#include "Smoothing/Tet/TetImprove.h"

#include <functional>
#include <memory>
#include <numeric>

namespace vfm
{
namespace
{

// Share of the time of a part that filling takes. The rest is for moving its points.
constexpr double FillShare = 0.8;

/// Target edge length: the cell width at interfaces, increasing with the distance from them.
class SizeField
{
public:
  SizeField(const CartesianGrid& grid, const LabelArray& labels, const TetGenOptions& options) :
    Grid(grid), Options(options), Layer(grid.NumberOfEntries(), Far)
  {
    std::vector<Index> front = this->FindInterfaceCells(labels);
    for (unsigned char layer = 1; !front.empty() && layer < Far; ++layer)
    {
      front = this->Advance(front, layer);
    }
  }

  /// x: grid coordinates.
  double operator()(const Vector3& x) const
  {
    Vector3 point;
    for (int a = 0; a < 3; ++a)
    {
      point[a] = this->Grid.Coordinates(a)[0] + x[a] * this->Grid.MeanWidth();
    }
    const Index3 cell = this->Grid.Local().Nearest(this->Grid.CellAt(point));
    double volume = 1.0;
    for (int a = 0; a < 3; ++a)
    {
      volume *= this->Grid.Width(a, cell[a]) / this->Grid.MeanWidth();
    }
    return CubeRoot(volume) * this->Options.RelativeSize *
      (1.0 + this->Options.Growth * this->Layer[this->Grid.Linear(cell)]);
  }

private:
  static constexpr unsigned char Far = 255;

  std::vector<Index> FindInterfaceCells(const LabelArray& labels)
  {
    std::vector<Index> cells;
    ForCells(this->Grid.Local(),
      [&](const Index3& p)
      {
        const Index cell = this->Grid.Linear(p);
        for (int face = 0; face < 6 && this->Layer[cell] == Far; ++face)
        {
          if (labels[this->Grid.Neighbour(cell, face)] != labels[cell])
          {
            this->Layer[cell] = 0;
            cells.push_back(cell);
          }
        }
      });
    return cells;
  }

  std::vector<Index> Advance(const std::vector<Index>& front, unsigned char layer)
  {
    std::vector<Index> next;
    for (Index cell : front)
    {
      for (int face = 0; face < 6; ++face)
      {
        const Index other = this->Grid.Neighbour(cell, face);
        if (this->Layer[other] == Far && this->Grid.Local().Contains(this->Grid.Position(other)))
        {
          this->Layer[other] = layer;
          next.push_back(other);
        }
      }
    }
    return next;
  }

  const CartesianGrid& Grid;
  const TetGenOptions& Options;
  std::vector<unsigned char> Layer; // number of cells to the nearest interface
};

/// Tets of a local fragment, and its boundary.
struct Part
{
  std::vector<Index> Tets;
  std::vector<Index> Points; // mesh points on the boundary
  TetGenPart Surface;
};

std::vector<Part> FindParts(const Mesh& mesh, const CartesianGrid& grid)
{
  const int fragments =
    mesh.Fragment.empty() ? 0 : *std::max_element(mesh.Fragment.begin(), mesh.Fragment.end());
  std::vector<Part> parts(fragments + 1);
  for (std::size_t t = 0; t < mesh.ElementIds.size(); ++t)
  {
    parts[mesh.Fragment[t]].Tets.push_back(static_cast<Index>(t));
  }
  parts.erase(
    std::remove_if(parts.begin(), parts.end(), [](const Part& part) { return part.Tets.empty(); }),
    parts.end());
  std::vector<int> position(mesh.PointIds.size(), -1);
  for (Part& part : parts)
  {
    for (const std::array<Index, 3>& face : FindBoundary(mesh, part.Tets))
    {
      std::array<int, 3> triangle;
      for (int c = 0; c < 3; ++c)
      {
        const Index p = face[c];
        if (position[p] < 0)
        {
          position[p] = static_cast<int>(part.Points.size());
          part.Points.push_back(p);
          part.Surface.Points.push_back(ToGrid(grid, mesh.Points.data() + 3 * p));
        }
        triangle[c] = position[p];
      }
      part.Surface.Triangles.push_back(triangle);
    }
    for (Index p : part.Points)
    {
      position[p] = -1;
    }
  }
  return parts;
}

/// The new mesh, assembled part after part.
class Refilled
{
public:
  Refilled(Mesh& mesh, const CartesianGrid& grid) :
    Old(mesh), Grid(grid), NewIndex(mesh.PointIds.size(), -1)
  {
  }

  /// Adds the tets of TetGen in a part.
  void AddPart(const Part& part, const TetGenFill& fill)
  {
    const Index first = part.Tets.front();
    const Index offset = static_cast<Index>(this->Added.size());
    const int kept = static_cast<int>(part.Points.size());
    for (std::size_t p = kept; p < fill.Points.size(); ++p)
    {
      this->Added.push_back({ fill.Points[p], this->Old.Fragment[first] });
    }
    for (Index p : part.Points)
    {
      this->NewIndex[p] = 0;
    }
    for (const std::array<int, 4>& tet : fill.Tets)
    {
      std::array<Index, 4> points;
      for (int c = 0; c < 4; ++c)
      {
        points[c] = tet[c] < kept ? part.Points[tet[c]] : ~(offset + tet[c] - kept);
      }
      this->Tets.push_back({ points, this->Old.Material[first], this->Old.Fragment[first] });
    }
  }

  /// Adds a part with its old tets.
  void StorePart(const Part& part)
  {
    for (Index t : part.Tets)
    {
      std::array<Index, 4> points;
      std::copy_n(this->Old.Elements.data() + 4 * t, 4, points.begin());
      for (Index p : points)
      {
        this->NewIndex[p] = 0;
      }
      this->Tets.push_back({ points, this->Old.Material[t], this->Old.Fragment[t] });
    }
  }

  /// Writes the points, tets and facets into the mesh. Collective.
  void Finish(Runtime& runtime)
  {
    std::vector<Index> kept;
    for (std::size_t p = 0; p < this->NewIndex.size(); ++p)
    {
      if (this->NewIndex[p] == 0)
      {
        this->NewIndex[p] = static_cast<Index>(kept.size());
        kept.push_back(static_cast<Index>(p));
      }
    }
    std::vector<FacetSide> facets = ListPointsOfFacets(this->Old);
    this->FillPoints(kept, runtime.Group());
    this->FillTets(static_cast<Index>(kept.size()), runtime.Group());
    for (FacetSide& facet : facets)
    {
      std::transform(facet.Points.begin(), facet.Points.begin() + 3, facet.Points.begin(),
        [this](Index point) { return this->NewIndex[point]; });
    }
    this->Old.Facets = FindElements(std::move(facets), this->Old, runtime);
    for (Buffer<Index>* points :
      { &this->Old.Surfaces.Points, &this->Old.Curves.Points, &this->Old.Vertices.Points })
    {
      for (Index& p : *points)
      {
        p = this->NewIndex[p];
      }
    }
  }

private:
  struct NewPoint
  {
    Vector3 X; // grid coordinates
    int Fragment;
  };
  struct Tet
  {
    std::array<Index, 4> Points; // points of the old mesh, or ~(new point)
    int Material, Fragment;
  };

  void FillPoints(const std::vector<Index>& kept, Ranks& ranks)
  {
    const std::size_t count = kept.size() + this->Added.size();
    Mesh& mesh = this->Old;
    Buffer<double> points(3 * count);
    Buffer<Index> ids(count);
    Buffer<int> dimension(count, 3), geometry(count);
    for (std::size_t p = 0; p < kept.size(); ++p)
    {
      std::copy_n(mesh.Points.data() + 3 * kept[p], 3, points.data() + 3 * p);
      ids[p] = mesh.PointIds[kept[p]];
      dimension[p] = mesh.GeometryDimension[kept[p]];
      geometry[p] = mesh.GeometryId[kept[p]];
    }
    Index id = EndOfPointIds(*mesh.Levels, mesh.Ids.PointSlots) +
      SumOfLowerRanks(static_cast<Index>(this->Added.size()), ranks);
    for (std::size_t p = 0; p < this->Added.size(); ++p)
    {
      const NewPoint& added = this->Added[p];
      for (int a = 0; a < 3; ++a)
      {
        points[3 * (kept.size() + p) + a] =
          this->Grid.Coordinates(a)[0] + this->Grid.MeanWidth() * added.X[a];
      }
      ids[kept.size() + p] = id++;
      geometry[kept.size() + p] = added.Fragment;
    }
    mesh.Points = std::move(points);
    mesh.PointIds = std::move(ids);
    mesh.GeometryDimension = std::move(dimension);
    mesh.GeometryId = std::move(geometry);
  }

  void FillTets(Index kept, Ranks& ranks)
  {
    Mesh& mesh = this->Old;
    const std::size_t count = this->Tets.size();
    mesh.Ids.ElementSlots = 0;
    mesh.Elements = Buffer<Index>(4 * count);
    mesh.ElementIds = Buffer<Index>(count);
    mesh.Material = Buffer<int>(count);
    mesh.Fragment = Buffer<int>(count);
    const Index first = SumOfLowerRanks(static_cast<Index>(count), ranks) + 1;
    for (std::size_t t = 0; t < count; ++t)
    {
      const Tet& tet = this->Tets[t];
      for (int c = 0; c < 4; ++c)
      {
        const Index p = tet.Points[c];
        mesh.Elements[4 * t + c] = p < 0 ? kept + ~p : this->NewIndex[p];
      }
      mesh.ElementIds[t] = first + static_cast<Index>(t);
      mesh.Material[t] = tet.Material;
      mesh.Fragment[t] = tet.Fragment;
    }
  }

  Mesh& Old;
  const CartesianGrid& Grid;
  std::vector<Index> NewIndex; // new index of each old point, or -1 if it is dropped
  std::vector<NewPoint> Added;
  std::vector<Tet> Tets;
};

} // namespace

void RefillTets(Mesh& mesh, const CartesianGrid& grid, const LabelArray& labels,
  const MeshOptions& options, const FillProgress& progress, Runtime& runtime, MeshReport& report)
{
  const SizeField sizes(grid, labels, options);
  const TetEnergy energy(FloorsOf(options));
  const double share = 1.0 / std::max<double>(1.0, static_cast<double>(mesh.ElementIds.size()));
  double done = 0.0; // share of all tets
  Refilled refilled(mesh, grid);
  Index rejected = 0;
  for (const Part& part : FindParts(mesh, grid))
  {
    const double weight = share * static_cast<double>(part.Tets.size());
    TetGenFill fill = FillWithTetGen(part.Surface, options, std::cref(sizes),
      [&](double fraction) { progress(done + weight * FillShare * fraction); });
    if (fill.Refusal.empty())
    {
      ImproveInside(energy, part.Surface.Points.size(), fill.Tets, fill.Points,
        [&](double fraction)
        { progress(done + weight * (FillShare + (1.0 - FillShare) * fraction)); });
      refilled.AddPart(part, fill);
    }
    else
    {
      refilled.StorePart(part);
      ++rejected;
    }
    done += weight;
    progress(done);
  }
  refilled.Finish(runtime);
  report.RefusedParts = SumOverRanks(rejected, runtime.Group());
}

} // namespace vfm
