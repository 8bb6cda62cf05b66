#include "Transfer/Overlaps.h"

#include "Base/HexNumbering.h"
#include "Base/Vector3.h"

namespace vfm
{
namespace
{

/// Of the box around an element; what is less is no part of it.
constexpr double Rounding = 4e-15;
constexpr Index ElementsAtOnce = 1024;

/// Corners of the faces of a tet, from outside counter-clockwise.
constexpr int TetFaces[4][3] = { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 } };

/// A convex one, in space: a triangle cut by six planes. Each adds one corner; rounding may make it half as many again at worst.
struct Polygon
{
  int Size = 0;
  std::array<Vector3, 28> Points;

  void Add(const Vector3& point) { this->Points[this->Size++] = point; }
};

/// Cuts a polygon in two. Both triangles at an edge get the same point: from its lower end.
template <int Axis>
void Split(const Polygon& polygon, double plane, Polygon& lower, Polygon& upper)
{
  lower.Size = upper.Size = 0;
  const Vector3* before = &polygon.Points[polygon.Size - 1];
  double heightBefore = (*before)[Axis] - plane;
  for (int i = 0; i < polygon.Size; ++i)
  {
    const Vector3* point = &polygon.Points[i];
    const double height = (*point)[Axis] - plane;
    if (height * heightBefore < 0.0)
    {
      const bool rises = height > 0.0;
      const Vector3 &a = rises ? *before : *point, &b = rises ? *point : *before;
      const double low = rises ? heightBefore : height, high = rises ? height : heightBefore;
      Vector3 cut = a + low / (low - high) * (b - a);
      cut[Axis] = plane;
      lower.Add(cut);
      upper.Add(cut);
    }
    if (height <= 0.0)
    {
      lower.Add(*point);
    }
    if (height >= 0.0)
    {
      upper.Add(*point);
    }
    before = point;
    heightBefore = height;
  }
}

/// Of an element's surface in a cell: integrals over the pieces' shadows along z, and over the columns between these and the cell's floor.
struct CellSums
{
  double Area = 0.0, AreaX = 0.0, AreaY = 0.0; ///< times 2, 6, 6
  double Volume = 0.0, X = 0.0, Y = 0.0;       ///< times 6, 24, 24
  double Z = 0.0;                              ///< times 48, from the floor

  void Add(const Polygon& polygon, double floor)
  {
    const Vector3& a = polygon.Points[0];
    const double ha = a[2] - floor;
    for (int i = 1; i + 1 < polygon.Size; ++i)
    {
      const Vector3 &b = polygon.Points[i], &c = polygon.Points[i + 1];
      const double area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
      const double hb = b[2] - floor, hc = c[2] - floor;
      const double x = a[0] + b[0] + c[0], y = a[1] + b[1] + c[1], h = ha + hb + hc;
      this->Area += area;
      this->AreaX += area * x;
      this->AreaY += area * y;
      this->Volume += area * h;
      this->X += area * (x * h + a[0] * ha + b[0] * hb + c[0] * hc);
      this->Y += area * (y * h + a[1] * ha + b[1] * hb + c[1] * hc);
      this->Z += area * (h * h + ha * ha + hb * hb + hc * hc);
    }
  }
};

/// The intervals between coordinates that something spans.
struct Span
{
  Index First = 0, Last = 0;
};

/// Cuts elements, one after another.
class ElementCutter
{
public:
  ElementCutter(const Mesh& mesh, const CartesianGrid& grid) : TheMesh(mesh), Grid(grid) {}

  void Cut(Index element, std::vector<OverlapPart>& parts)
  {
    this->ReadCorners(element);
    for (int a = 0; a < 3; ++a)
    {
      this->FindSpan(a);
    }
    if (this->TheMesh.Corners == 8 && this->IsBox())
    {
      this->CutBox(parts);
      return;
    }
    this->MakePlanes();
    this->AddSurface();
    this->FinishColumns();
    this->AddParts(parts);
  }

private:
  void ReadCorners(Index element)
  {
    const int corners = this->TheMesh.Corners;
    for (int c = 0; c < corners; ++c)
    {
      const Index point = this->TheMesh.Elements[corners * element + c];
      std::copy_n(this->TheMesh.Points.data() + 3 * point, 3,
        this->Corners[corners == 8 ? VtkCorner[c] : c].begin());
    }
    this->Lower = this->Upper = this->Corners[0];
    for (int c = 1; c < corners; ++c)
    {
      for (int a = 0; a < 3; ++a)
      {
        this->Lower[a] = std::min(this->Lower[a], this->Corners[c][a]);
        this->Upper[a] = std::max(this->Upper[a], this->Corners[c][a]);
      }
    }
  }

  /// The cells of the local box that the element spans along an axis. Elements come in an order in which the last span is near.
  void FindSpan(int a)
  {
    const std::vector<double>& x = this->Grid.Coordinates(a);
    const Index first = this->Grid.Local().Lower[a], end = this->Grid.Local().Upper[a];
    Span& span = this->Spans[a];
    const double low = this->Lower[a], high = this->Upper[a];
    Index i = std::min(std::max(span.First, first), end - 1);
    if ((i > first && x[i] > low) || (i + 2 < end && x[i + 2] <= low))
    {
      i = std::upper_bound(x.begin() + first, x.begin() + end, low) - x.begin() - 1;
      i = std::max(i, first);
    }
    for (; i + 1 < end && x[i + 1] <= low; ++i)
    {
    }
    span.First = span.Last = i;
    for (; span.Last + 1 < end && x[span.Last + 1] < high; ++span.Last)
    {
    }
  }

  /// Whether it is a hex with sides along the axes.
  bool IsBox() const
  {
    for (int c = 0; c < 8; ++c)
    {
      for (int a = 0; a < 3; ++a)
      {
        if (this->Corners[c][a] != (c >> a & 1 ? this->Upper[a] : this->Lower[a]))
        {
          return false;
        }
      }
    }
    return true;
  }

  template <class Body>
  void ForSpannedCells(const Body& body) const
  {
    Index3 p;
    for (p[2] = this->Spans[2].First; p[2] <= this->Spans[2].Last; ++p[2])
    {
      for (p[1] = this->Spans[1].First; p[1] <= this->Spans[1].Last; ++p[1])
      {
        for (p[0] = this->Spans[0].First; p[0] <= this->Spans[0].Last; ++p[0])
        {
          body(static_cast<const Index3&>(p));
        }
      }
    }
  }

  /// A box that is a cell is that cell, bit for bit.
  void CutBox(std::vector<OverlapPart>& parts) const
  {
    this->ForSpannedCells(
      [&](const Index3& cell)
      {
        OverlapPart part{ IndexInBox(this->Grid.Local(), cell), 1.0, {} };
        for (int a = 0; a < 3; ++a)
        {
          const std::vector<double>& x = this->Grid.Coordinates(a);
          const Span& span = this->Spans[a];
          const double low = cell[a] == span.First ? this->Lower[a] : x[cell[a]];
          const double high = cell[a] == span.Last ? this->Upper[a] : x[cell[a] + 1];
          part.Volume *= high - low;
          part.Centroid[a] = std::min(std::max(0.5 * (low + high), x[cell[a]]), x[cell[a] + 1]);
        }
        parts.push_back(part);
      });
  }

  /// From here on, lengths are from the lower corner of the box around the element.
  void MakePlanes()
  {
    std::size_t cells = 1;
    for (int a = 0; a < 3; ++a)
    {
      const Span& span = this->Spans[a];
      std::vector<double>& planes = this->Planes[a];
      planes.assign(1, 0.0);
      for (Index i = span.First + 1; i <= span.Last; ++i)
      {
        planes.push_back(this->Grid.Coordinates(a)[i] - this->Lower[a]);
      }
      cells *= planes.size();
    }
    this->Sums.assign(cells, CellSums());
    for (int c = 0; c < this->TheMesh.Corners; ++c)
    {
      this->Corners[c] = this->Corners[c] - this->Lower;
    }
  }

  void AddSurface()
  {
    if (this->TheMesh.Corners == 4)
    {
      for (const auto& face : TetFaces)
      {
        this->AddTriangle(this->Corners[face[0]], this->Corners[face[1]], this->Corners[face[2]]);
      }
      return;
    }
    for (const std::array<int, 4>& face : FaceCorners)
    {
      std::array<Vector3, 4> x;
      std::transform(face.begin(), face.end(), x.begin(), [&](int c) { return this->Corners[c]; });
      const Vector3 mean = 0.25 * ((x[0] + x[2]) + (x[1] + x[3]));
      for (int e = 0; e < 4; ++e)
      {
        this->AddTriangle(x[e], x[(e + 1) % 4], mean);
      }
    }
  }

  void AddTriangle(const Vector3& a, const Vector3& b, const Vector3& c)
  {
    Polygon triangle;
    triangle.Add(a);
    triangle.Add(b);
    triangle.Add(c);
    this->AddPolygon<0>(triangle, 0);
  }

  /// Cuts it by the planes along an axis and those that follow. cell: what it is in so far, in Sums.
  template <int Axis>
  void AddPolygon(const Polygon& polygon, Index cell)
  {
    const std::vector<double>& planes = this->Planes[Axis];
    const Index count = static_cast<Index>(planes.size());
    if (count == 1)
    {
      this->AddWithin<Axis>(polygon, cell, 0);
      return;
    }
    double low = polygon.Points[0][Axis], high = low;
    for (int i = 1; i < polygon.Size; ++i)
    {
      low = std::min(low, polygon.Points[i][Axis]);
      high = std::max(high, polygon.Points[i][Axis]);
    }
    Index at = 0;
    for (; at + 1 < count && planes[at + 1] <= low; ++at)
    {
    }
    if (at + 1 == count || high <= planes[at + 1])
    {
      this->AddWithin<Axis>(polygon, cell, at);
      return;
    }
    Polygon lower, uppers[2];
    const Polygon* rest = &polygon;
    for (; at + 1 < count && planes[at + 1] < high; ++at)
    {
      Polygon& upper = uppers[rest == &uppers[0]];
      Split<Axis>(*rest, planes[at + 1], lower, upper);
      this->AddWithin<Axis>(lower, cell, at);
      rest = &upper;
    }
    this->AddWithin<Axis>(*rest, cell, at);
  }

  template <int Axis>
  void AddWithin(const Polygon& polygon, Index cell, Index at)
  {
    cell = cell * static_cast<Index>(this->Planes[Axis].size()) + at;
    if constexpr (Axis < 2)
    {
      this->AddPolygon<Axis + 1>(polygon, cell);
    }
    else
    {
      this->Sums[cell].Add(polygon, this->Planes[2][at]);
    }
  }

  /// What an element has in a cell is under its surface there and, as high as the cell, under its surface above.
  void FinishColumns()
  {
    const Index nz = static_cast<Index>(this->Planes[2].size());
    for (std::size_t column = 0; column < this->Sums.size(); column += nz)
    {
      double area = 0.0, areaX = 0.0, areaY = 0.0; // of the surface above
      for (Index k = nz - 1; k >= 0; --k)
      {
        CellSums& s = this->Sums[column + k];
        const double height = k + 1 < nz ? this->Planes[2][k + 1] - this->Planes[2][k] : 0.0;
        s.Volume = s.Volume / 6.0 + area * height;
        s.X = s.X / 24.0 + areaX * height;
        s.Y = s.Y / 24.0 + areaY * height;
        s.Z = s.Z / 48.0 + 0.5 * area * height * height + s.Volume * this->Planes[2][k];
        area += s.Area / 2.0;
        areaX += s.AreaX / 6.0;
        areaY += s.AreaY / 6.0;
      }
    }
  }

  void AddParts(std::vector<OverlapPart>& parts) const
  {
    const Vector3 size = this->Upper - this->Lower;
    const double least = Rounding * size[0] * size[1] * size[2];
    const Index ny = static_cast<Index>(this->Planes[1].size());
    const Index nz = static_cast<Index>(this->Planes[2].size());
    this->ForSpannedCells(
      [&](const Index3& cell)
      {
        const Index i = cell[0] - this->Spans[0].First, j = cell[1] - this->Spans[1].First;
        const CellSums& s = this->Sums[(i * ny + j) * nz + cell[2] - this->Spans[2].First];
        if (s.Volume > least)
        {
          const Vector3 centroid = (1.0 / s.Volume) * Vector3{ { s.X, s.Y, s.Z } };
          parts.push_back({ IndexInBox(this->Grid.Local(), cell), s.Volume,
            this->MoveInside(cell, this->Lower + centroid) });
        }
      });
  }

  /// A centroid, which in a part of hardly any volume is anywhere, to the box around the element and the cell.
  Vector3 MoveInside(const Index3& cell, Vector3 x) const
  {
    for (int a = 0; a < 3; ++a)
    {
      const std::vector<double>& planes = this->Grid.Coordinates(a);
      x[a] = std::min(std::max(x[a], this->Lower[a]), this->Upper[a]);
      x[a] = std::min(std::max(x[a], planes[cell[a]]), planes[cell[a] + 1]);
    }
    return x;
  }

  const Mesh& TheMesh;
  const CartesianGrid& Grid;
  std::array<Vector3, 8> Corners;            // of a hex by their bits
  Vector3 Lower, Upper;                      // of the box around it
  std::array<Span, 3> Spans;                 // cells
  std::array<std::vector<double>, 3> Planes; // floors of these along each axis
  std::vector<CellSums> Sums;                // of these, z fastest
};

} // namespace

Overlaps FindOverlaps(
  const Mesh& mesh, const std::vector<Index>& elements, const CartesianGrid& grid, Runtime& runtime)
{
  const Index count = static_cast<Index>(elements.size());
  const Index pieces = (count + ElementsAtOnce - 1) / ElementsAtOnce;
  std::vector<std::vector<OverlapPart>> parts(pieces);
  Overlaps overlaps;
  overlaps.Offsets.assign(count + 1, 0);
  ForEach(runtime, pieces,
    [&](Index piece)
    {
      ElementCutter cutter(mesh, grid);
      const Index end = std::min(count, (piece + 1) * ElementsAtOnce);
      for (Index i = piece * ElementsAtOnce; i < end; ++i)
      {
        cutter.Cut(elements[i], parts[piece]);
        overlaps.Offsets[i + 1] = static_cast<Index>(parts[piece].size());
      }
    });
  std::vector<Index> first(pieces + 1, 0);
  for (Index piece = 0; piece < pieces; ++piece)
  {
    first[piece + 1] = first[piece] + static_cast<Index>(parts[piece].size());
  }
  overlaps.Parts.resize(first[pieces]);
  ForEach(runtime, pieces,
    [&](Index piece)
    {
      const Index end = std::min(count, (piece + 1) * ElementsAtOnce);
      for (Index i = piece * ElementsAtOnce; i < end; ++i)
      {
        overlaps.Offsets[i + 1] += first[piece];
      }
      std::copy(parts[piece].begin(), parts[piece].end(), overlaps.Parts.begin() + first[piece]);
      parts[piece] = {};
    });
  return overlaps;
}

} // namespace vfm
