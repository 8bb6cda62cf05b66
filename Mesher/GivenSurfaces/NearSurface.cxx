#include "GivenSurfaces/NearSurface.h"

#include "Base/Sorted.h"

#include <algorithm>
#include <numeric>

namespace vfm
{
namespace
{

constexpr double Spacing = 0.25;    // of samples, in cells
constexpr double EdgeSpacing = 0.5; // of the points of edges that are put into bins
constexpr Index Margin = 5;         // layers of bins around the local box
constexpr double OnSide = 1e-6;     // distance of a triangle from a side of the domain
constexpr double Tolerance = 1e-12; // smallest length that counts, cells

/// Divides a length into equal parts no longer than a spacing.
int CountParts(double length, double spacing)
{
  return std::max(1, static_cast<int>(std::ceil(length / spacing)));
}

/// Triangle with its longest side first, in cells of mean width.
struct Slope
{
  Vector3 From, To, Apex;
  double Base, Height;
};

Slope SlopeOf(const std::array<Vector3, 3>& corners, const Vector3& widths)
{
  std::array<Vector3, 3> x;
  std::array<double, 3> lengths;
  for (int c = 0; c < 3; ++c)
  {
    x[c] = Divided(corners[c], widths);
  }
  for (int c = 0; c < 3; ++c)
  {
    lengths[c] = Norm(x[(c + 1) % 3] - x[c]);
  }
  const int longest =
    static_cast<int>(std::max_element(lengths.begin(), lengths.end()) - lengths.begin());
  Slope slope{ x[longest], x[(longest + 1) % 3], x[(longest + 2) % 3], lengths[longest], 0.0 };
  const double area = Norm(Cross(slope.To - slope.From, slope.Apex - slope.From));
  slope.Height = slope.Base > Tolerance ? area / slope.Base : 0.0;
  return slope;
}

/// Returns a number in [0, 1) that depends on the triangle only.
double NumberOf(int triangle)
{
  const auto mixed = (static_cast<std::uint64_t>(triangle) + 1) * 0x9E3779B97F4A7C15u;
  return static_cast<double>(mixed >> 11) * 0x1p-53;
}

bool Overlaps(const IndexBox& box, const Index3& lower, const Index3& upper)
{
  for (int a = 0; a < 3; ++a)
  {
    if (upper[a] < box.Lower[a] || lower[a] >= box.Upper[a])
    {
      return false;
    }
  }
  return true;
}

Vector3 NearestOfSegment(const Vector3& a, const Vector3& b)
{
  const Vector3 along = b - a;
  const double squared = Dot(along, along);
  const double t = squared > 0.0 ? std::clamp(-Dot(a, along) / squared, 0.0, 1.0) : 0.0;
  return a + t * along;
}

/// Returns the lengths of the domain with its copies, in grid coordinates, where it begins at 0.
Vector3 LengthsOf(const Interface& interface)
{
  Vector3 lengths;
  for (int a = 0; a < 3; ++a)
  {
    const std::vector<double>& x = interface.Grid().Coordinates(a);
    lengths[a] = (x.back() - x.front()) / interface.Scale();
  }
  return lengths;
}

/// Cuts a segment to the box from 0 to its lengths; returns false if nothing is left.
bool CutToBox(const Vector3& lengths, std::array<Vector3, 2>& ends)
{
  double from = 0.0, to = 1.0;
  const Vector3 start = ends[0], along = ends[1] - ends[0];
  for (int a = 0; a < 3; ++a)
  {
    const double low = -start[a], high = lengths[a] - start[a];
    if (along[a] == 0.0 && (low > 0.0 || high < 0.0))
    {
      return false;
    }
    if (along[a] != 0.0)
    {
      from = std::max(from, std::min(low / along[a], high / along[a]));
      to = std::min(to, std::max(low / along[a], high / along[a]));
    }
  }
  ends = { start + from * along, start + to * along };
  return from <= to;
}

/// Returns whether a triangle lies in a side of the domain.
bool LiesInSide(const Triangle& corners, const Bounds& domain)
{
  for (int a = 0; a < 3; ++a)
  {
    const auto isAt = [&](double side)
    {
      return std::all_of(corners.begin(), corners.end(),
        [&](const Vector3& x) { return std::fabs(x[a] - side) < OnSide; });
    };
    if (isAt(domain.Lower[a]) || isAt(domain.Upper[a]))
    {
      return true;
    }
  }
  return false;
}

/// Returns a normal in the frame of a node, in which lengths are divided by its widths.
Vector3 NormalIn(const NodeFrame& frame, const Vector3& normal)
{
  return Unit(Scaled(normal, frame.Widths));
}

Vector3 MeanWidths(const Interface& interface)
{
  Vector3 widths = LengthsOf(interface);
  for (int a = 0; a < 3; ++a)
  {
    widths[a] /= static_cast<double>(interface.Grid().Coordinates(a).size() - 1);
  }
  return widths;
}

/// Returns the positions of the copies of a body that repeats, relative to it.
std::vector<Vector3> ListShifts(const Vector3& periods, const CartesianGrid& grid)
{
  IndexBox copies;
  for (int a = 0; a < 3; ++a)
  {
    const Index period = grid.Period(a);
    const Index around = period > 0 ? (grid.Global().Size(a) + period - 1) / period : 0;
    copies.Lower[a] = -around;
    copies.Upper[a] = around + 1;
  }
  std::vector<Vector3> shifts;
  ForCells(copies,
    [&](const Index3& n)
    {
      shifts.push_back({ { static_cast<double>(n[0]) * periods[0],
        static_cast<double>(n[1]) * periods[1], static_cast<double>(n[2]) * periods[2] } });
    });
  return shifts;
}

} // namespace

NearSurface::NearSurface(
  const BodySurfaces& bodies, int body, double ratio, const Interface& interface) :
  Lengths(LengthsOf(interface)),
  Widths(MeanWidths(interface)),
  SheetOf(bodies.Bodies()[body].Sheets.SheetOf)
{
  const GivenBody& given = bodies.Bodies()[body];
  this->PlaceBox(interface.Grid(), interface);
  this->SetNormals(given, bodies.Domain());
  for (const Vector3& shift : ListShifts(bodies.Periods(), interface.Grid()))
  {
    Points points = given.Boundary.Points;
    std::for_each(
      points.begin(), points.end(), [&](Vector3& x) { x = (1.0 / ratio) * (x + shift); });
    for (std::size_t t = 0; t < this->Normals.size(); ++t)
    {
      this->AddSamples(points, given.Boundary.Triangles[t], static_cast<int>(t));
    }
    this->AddEdges(points, given.Sheets);
    this->AddCorners(points, given.Sheets);
  }
  this->FillBins();
}

void NearSurface::SetNormals(const GivenBody& body, const Bounds& domain)
{
  for (const Triangle& corners : PlaceTriangles(body.Boundary))
  {
    this->Normals.push_back(LiesInSide(corners, domain)
        ? Vector3{}
        : Unit(Cross(corners[1] - corners[0], corners[2] - corners[0])));
  }
}

void NearSurface::PlaceBox(const CartesianGrid& grid, const Interface& interface)
{
  const IndexBox& local = grid.Local();
  this->Box.Lower = this->BinOf(interface.NodePoint(grid.Linear(local.Lower)));
  this->Box.Upper = this->BinOf(interface.NodePoint(grid.Linear(local.Upper)));
  for (int a = 0; a < 3; ++a)
  {
    this->Box.Lower[a] -= Margin;
    this->Box.Upper[a] += Margin + 1;
  }
}

void NearSurface::FillBins()
{
  std::vector<BinnedItem> items;
  const IndexBox& box = this->Box;
  const auto put = [&](const Vector3& x, std::size_t item)
  {
    const Index3 bin = this->BinOf(x);
    if (box.Contains(bin))
    {
      const Index row = (bin[2] - box.Lower[2]) * box.Size(1) + bin[1] - box.Lower[1];
      items.emplace_back(row * box.Size(0) + bin[0] - box.Lower[0], static_cast<int>(item));
    }
  };
  const auto make = [&](Bins& bins)
  {
    bins = this->MakeBins(std::move(items));
    items.clear();
  };
  for (std::size_t s = 0; s < this->Samples.size(); ++s)
  {
    put(this->Samples[s].At, s);
  }
  make(this->SampleBins);
  for (std::size_t e = 0; e < this->Edges.size(); ++e)
  {
    const auto& [a, b] = this->Edges[e].Ends;
    const int parts = CountParts(Norm(Divided(b - a, this->Widths)), EdgeSpacing);
    for (int i = 0; i <= parts; ++i)
    {
      put(a + (static_cast<double>(i) / parts) * (b - a), e);
    }
  }
  make(this->EdgeBins);
  for (std::size_t c = 0; c < this->Corners.size(); ++c)
  {
    put(this->Corners[c].At, c);
  }
  make(this->CornerBins);
}

Index3 NearSurface::BinOf(const Vector3& x) const
{
  Index3 bin;
  for (int a = 0; a < 3; ++a)
  {
    bin[a] = static_cast<Index>(std::floor(x[a] / this->Widths[a]));
  }
  return bin;
}

/// Adds points in rows parallel to the longest side. Of triangles smaller than the square of the
/// spacing only some are kept, with the area of all.
void NearSurface::AddSamples(const Points& points, const PointTriangle& corners, int triangle)
{
  const Slope slope =
    SlopeOf({ points[corners[0]], points[corners[1]], points[corners[2]] }, this->Widths);
  const double area = 0.5 * slope.Base * slope.Height;
  if (!(area > 0.0) || this->Normals[triangle] == Vector3{})
  {
    return;
  }
  const int rows = CountParts(slope.Height, Spacing);
  const double share = area / (Spacing * Spacing);
  if (slope.Base <= Spacing && share < 1.0 && NumberOf(triangle) >= share)
  {
    return;
  }
  for (int row = 0; row < rows; ++row)
  {
    const double up = (row + 0.5) / rows;
    const Vector3 begin = slope.From + up * (slope.Apex - slope.From);
    const Vector3 end = slope.To + up * (slope.Apex - slope.To);
    Index3 lower, upper;
    for (int a = 0; a < 3; ++a)
    {
      lower[a] = static_cast<Index>(std::floor(std::min(begin[a], end[a])));
      upper[a] = static_cast<Index>(std::floor(std::max(begin[a], end[a])));
    }
    if (!Overlaps(this->Box, lower, upper))
    {
      continue;
    }
    const double rowArea = slope.Base * (1.0 - up) * slope.Height / rows;
    const int parts = CountParts(slope.Base * (1.0 - up), Spacing);
    for (int i = 0; i < parts; ++i)
    {
      const Vector3 at = begin + ((i + 0.5) / parts) * (end - begin);
      const double weight =
        slope.Base <= Spacing ? std::max(area, Spacing * Spacing) : rowArea / parts;
      this->Samples.push_back({ Scaled(at, this->Widths), weight, triangle });
    }
  }
}

void NearSurface::AddEdges(const Points& points, const SurfaceSheets& sheets)
{
  for (const SharpEdge& edge : sheets.Edges)
  {
    Edge placed;
    placed.IsConvex = edge.IsConvex;
    for (int i = 0; i < 2; ++i)
    {
      placed.Ends[i] = points[edge.Points[i]];
      placed.Triangles[i] = static_cast<int>(edge.Triangles[i]);
      placed.Sheets[i] = this->SheetOf[edge.Triangles[i]];
    }
    if (this->Counts(placed.Triangles) && CutToBox(this->Lengths, placed.Ends))
    {
      this->Edges.push_back(placed);
    }
  }
}

void NearSurface::AddCorners(const Points& points, const SurfaceSheets& sheets)
{
  std::vector<std::pair<Index, Index>> ends; // points of edges and their triangles
  for (const SharpEdge& edge : sheets.Edges)
  {
    const bool counts =
      this->Counts({ static_cast<int>(edge.Triangles[0]), static_cast<int>(edge.Triangles[1]) });
    for (std::size_t i = 0; counts && i < edge.Points.size(); ++i)
    {
      const Index point = edge.Points[i];
      ends.emplace_back(point, edge.Triangles[0]);
      ends.emplace_back(point, edge.Triangles[1]);
    }
  }
  SortUnique(ends);
  for (std::size_t begin = 0, end; begin < ends.size(); begin = end)
  {
    Corner corner{ points[ends[begin].first], {}, {} };
    for (end = begin; end < ends.size() && ends[end].first == ends[begin].first; ++end)
    {
      const int sheet = this->SheetOf[ends[end].second];
      if (std::find(corner.Sheets.begin(), corner.Sheets.end(), sheet) == corner.Sheets.end())
      {
        corner.Sheets.push_back(sheet);
        corner.Triangles.push_back(static_cast<int>(ends[end].second));
      }
    }
    std::array<Vector3, 2> place{ corner.At, corner.At };
    if (corner.Sheets.size() >= 3 && CutToBox(this->Lengths, place))
    {
      this->Corners.push_back(std::move(corner));
    }
  }
}

NearSurface::Bins NearSurface::MakeBins(std::vector<BinnedItem> items) const
{
  SortUnique(items);
  const Index length = this->Box.Size(0), rows = this->Box.Size(1) * this->Box.Size(2);
  Bins bins;
  bins.RowBegin.assign(rows + 1, 0);
  for (const auto& [cell, item] : items)
  {
    ++bins.RowBegin[cell / length + 1];
    bins.Cells.push_back(static_cast<int>(cell % length));
    bins.Items.push_back(item);
  }
  std::partial_sum(bins.RowBegin.begin(), bins.RowBegin.end(), bins.RowBegin.begin());
  return bins;
}

/// Calls visit(item) for the items in the bins within a radius of a node.
template <class Visitor>
void NearSurface::Visit(
  const Bins& bins, const NodeFrame& frame, double radius, const Visitor& visit) const
{
  const Index3 low = this->BinOf(frame.Origin - radius * frame.Widths);
  const Index3 high = this->BinOf(frame.Origin + radius * frame.Widths);
  const IndexBox& box = this->Box;
  const auto cellOf = [&](Index i) { return static_cast<int>(i - box.Lower[0]); };
  for (Index k = std::max(low[2], box.Lower[2]); k <= std::min(high[2], box.Upper[2] - 1); ++k)
  {
    for (Index j = std::max(low[1], box.Lower[1]); j <= std::min(high[1], box.Upper[1] - 1); ++j)
    {
      const Index row = (k - box.Lower[2]) * box.Size(1) + j - box.Lower[1];
      const auto begin = bins.Cells.begin() + bins.RowBegin[row];
      const auto end = bins.Cells.begin() + bins.RowBegin[row + 1];
      const auto first = std::lower_bound(begin, end, cellOf(low[0]));
      for (auto at = first; at != end && *at <= cellOf(high[0]); ++at)
      {
        visit(bins.Items[at - bins.Cells.begin()]);
      }
    }
  }
}

void NearSurface::ListSamples(
  const NodeFrame& frame, double radius, std::vector<NearSample>& samples) const
{
  samples.clear();
  this->Visit(this->SampleBins, frame, radius,
    [&](int item)
    {
      const Sample& sample = this->Samples[item];
      const Vector3 at = Divided(sample.At - frame.Origin, frame.Widths);
      if (Dot(at, at) <= radius * radius)
      {
        samples.push_back({ at, NormalIn(frame, this->Normals[sample.Triangle]), sample.Area,
          this->SheetOf[sample.Triangle] });
      }
    });
}

void NearSurface::ListEdges(
  const NodeFrame& frame, double radius, std::vector<NearEdge>& edges) const
{
  edges.clear();
  std::vector<int> found;
  this->Visit(
    this->EdgeBins, frame, radius + 0.5 * EdgeSpacing, [&](int item) { found.push_back(item); });
  SortUnique(found);
  for (int item : found)
  {
    const Edge& edge = this->Edges[item];
    const Vector3 at = NearestOfSegment(Divided(edge.Ends[0] - frame.Origin, frame.Widths),
      Divided(edge.Ends[1] - frame.Origin, frame.Widths));
    if (Dot(at, at) <= radius * radius)
    {
      edges.push_back({ at, Norm(at), edge.Sheets,
        { NormalIn(frame, this->Normals[edge.Triangles[0]]),
          NormalIn(frame, this->Normals[edge.Triangles[1]]) },
        edge.IsConvex });
    }
  }
}

void NearSurface::ListCorners(
  const NodeFrame& frame, double radius, std::vector<NearCorner>& corners) const
{
  corners.clear();
  this->Visit(this->CornerBins, frame, radius,
    [&](int item)
    {
      const Corner& corner = this->Corners[item];
      const Vector3 at = Divided(corner.At - frame.Origin, frame.Widths);
      if (Dot(at, at) <= radius * radius)
      {
        corners.push_back({ at, Norm(at), corner.Sheets, {} });
        for (int triangle : corner.Triangles)
        {
          corners.back().Normals.push_back(NormalIn(frame, this->Normals[triangle]));
        }
      }
    });
}

} // namespace vfm
