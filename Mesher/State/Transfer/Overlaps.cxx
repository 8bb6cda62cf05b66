#include "State/Transfer/Overlaps.h"

#include "Base/HexNumbering.h"
#include "Octree/RefinedGrid.h"
#include "State/Transfer/CellSums.h"
#include "State/Transfer/StateCells.h"

namespace vfm
{
namespace
{

/// Parts are dropped if they are at most this fraction of the volume of the element's bounding box.
constexpr double Rounding = 4e-15;
constexpr Index ElementsAtOnce = 1024;

/// Corners of the faces of a tet, counterclockwise as seen from outside.
constexpr int TetFaces[4][3] = { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 } };

/// Cells in which elements may lie. On a graded grid, smoothing may move an element across many
/// thin cells, out of the local box of a rank.
class ElementReach
{
public:
  ElementReach(const Mesh& mesh, const CartesianGrid& grid) :
    TheMesh(mesh),
    Grid(grid),
    IsLimited(mesh.Levels && mesh.Ids.ElementSlots > 0 && IsGraded(mesh.Levels->Finest()))
  {
  }

  IndexBox Of(Index element) const
  {
    if (!this->IsLimited)
    {
      return this->Grid.Local();
    }
    const CartesianGrid& finest = this->TheMesh.Levels->Finest();
    const IndexBox cells =
      Grow(CellsOfElement(finest, this->TheMesh, this->TheMesh.ElementIds[element]), StateReach,
        finest.Global());
    IndexBox box;
    for (int a = 0; a < 3; ++a)
    {
      const std::vector<double>&x = this->Grid.Coordinates(a), &y = finest.Coordinates(a);
      box.Lower[a] = std::upper_bound(x.begin(), x.end(), y[cells.Lower[a]]) - x.begin() - 1;
      box.Upper[a] = std::lower_bound(x.begin(), x.end(), y[cells.Upper[a]]) - x.begin();
    }
    return Intersect(box, this->Grid.Local());
  }

private:
  static bool IsGraded(const CartesianGrid& grid)
  {
    bool isGraded = false;
    for (int a = 0; a < 3; ++a)
    {
      const std::vector<double>& x = grid.Coordinates(a);
      double least = grid.Width(a, 0), most = least;
      for (Index i = 1; i + 1 < static_cast<Index>(x.size()); ++i)
      {
        least = std::min(least, grid.Width(a, i));
        most = std::max(most, grid.Width(a, i));
      }
      isGraded = isGraded || most > MaximumGrading * least;
    }
    return isGraded;
  }

  // Ratio of widths up to which elements stay in the local box.
  static constexpr double MaximumGrading = 2.0;

  const Mesh& TheMesh;
  const CartesianGrid& Grid;
  const bool IsLimited;
};

/// Range of cells along an axis, including Last.
struct Span
{
  Index First = 0, Last = 0;
};

/// Cuts elements one after another.
class ElementCutter
{
public:
  ElementCutter(const Mesh& mesh, const CartesianGrid& grid, const ElementReach& reach) :
    TheMesh(mesh), Grid(grid), Reach(reach)
  {
  }

  void Cut(Index element, std::vector<OverlapPart>& parts)
  {
    this->ReadCorners(element);
    const IndexBox reach = this->Reach.Of(element);
    for (int a = 0; a < 3; ++a)
    {
      this->FindSpan(a, reach.Lower[a], reach.Upper[a]);
    }
    if (this->TheMesh.HasHexes() && this->IsBox())
    {
      this->CutBox(parts);
      return;
    }
    this->FindOrigin();
    this->IsStar ? this->StartCones() : this->StartColumns();
    this->AddSurface();
    this->IsStar ? this->FinishCones() : this->FinishColumns();
    this->IsStar ? this->AddPartsOfStar(parts) : this->AddParts(parts);
  }

private:
  void ReadCorners(Index element)
  {
    const int corners = this->TheMesh.Corners;
    for (int c = 0; c < corners; ++c)
    {
      this->Corners[AreHexes(corners) ? VtkCorner[c] : c] =
        this->TheMesh.PointAt(this->TheMesh.Elements[corners * element + c]);
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

  /// Finds the cells from first to before end that the element spans along an axis. The search
  /// begins at the previous span, which is near in the order of elements.
  void FindSpan(int a, Index first, Index end)
  {
    const std::vector<double>& x = this->Grid.Coordinates(a);
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

  /// Returns whether the hex is a box with sides along the axes.
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

  /// Cuts a box. If it is a cell, its volume is bitwise identical to the volume of the cell.
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

  /// Finds the axes along which planes cut the element, and makes coordinates relative to the
  /// origin. Along each axis, the origin is on the first plane, or on the lower side of the
  /// bounding box if no plane cuts the element. If a corner is on all planes, it is the origin.
  void FindOrigin()
  {
    this->IsStar = true;
    this->CutAxes = 0;
    for (int a = 0; a < 3; ++a)
    {
      const Span& span = this->Spans[a];
      const bool isCut = span.First < span.Last;
      this->Origin[a] = isCut ? this->Grid.Coordinates(a)[span.First + 1] : this->Lower[a];
      this->CutAxes |= isCut << a;
      this->IsStar = this->IsStar && span.Last - span.First < 2;
    }
    this->Apex = this->IsStar ? this->FindApex() : -1;
    this->Shift = this->Apex < 0 ? this->Origin : this->Corners[this->Apex];
    for (int c = 0; c < this->TheMesh.Corners; ++c)
    {
      this->Corners[c] = this->Corners[c] - this->Shift;
    }
  }

  bool IsCut(int axis) const { return this->CutAxes >> axis & 1; }

  /// Calls body(octant) for the cells of a star. Octants are on the lower side of axes that are not
  /// cut.
  template <class Body>
  void ForOctants(const Body& body) const
  {
    for (int octant = 0; octant < 8; ++octant)
    {
      if ((octant & ~this->CutAxes) == 0)
      {
        body(octant);
      }
    }
  }

  void StartCones()
  {
    this->ForOctants([&](int octant) { this->Octants[octant] = CellSums(); });
  }

  /// Starts the sums of an element that is no star, and lists its planes.
  void StartColumns()
  {
    std::size_t cells = 1;
    for (int a = 0; a < 3; ++a)
    {
      const Span& span = this->Spans[a];
      const std::vector<double>& x = this->Grid.Coordinates(a);
      std::vector<double>& planes = this->Planes[a];
      planes.clear();
      for (Index i = span.First + 1; i <= span.Last; ++i)
      {
        planes.push_back(x[i] - this->Origin[a]);
      }
      cells *= planes.size() + 1;
    }
    this->Sums.assign(cells, CellSums());
  }

  /// Returns a corner that is on all planes, or -1 if there is none. Lattice tets have one.
  int FindApex() const
  {
    for (int c = 0; c < this->TheMesh.Corners; ++c)
    {
      bool isApex = true;
      for (int a = 0; a < 3; ++a)
      {
        isApex = isApex && (!this->IsCut(a) || this->Corners[c][a] == this->Origin[a]);
      }
      if (isApex)
      {
        return c;
      }
    }
    return -1;
  }

  /// Adds the triangles of the surface, except at the apex, where cones are flat.
  void AddSurface()
  {
    const auto& x = this->Corners;
    if (this->TheMesh.Corners == 4)
    {
      for (const auto& f : TetFaces)
      {
        if (std::count(f, f + 3, this->Apex) == 0)
        {
          this->AddFace(x[f[0]], x[f[1]], x[f[2]]);
        }
      }
      return;
    }
    for (const std::array<int, 4>& f : FaceCorners)
    {
      const Vector3 mean = 0.25 * ((x[f[0]] + x[f[2]]) + (x[f[1]] + x[f[3]]));
      for (int e = 0; e < 4; ++e)
      {
        const int begin = f[e], end = f[(e + 1) % 4];
        if (begin != this->Apex && end != this->Apex)
        {
          this->AddFace(x[begin], x[end], mean);
        }
      }
    }
  }

  void AddFace(const Vector3& a, const Vector3& b, const Vector3& c)
  {
    this->IsStar ? this->AddToStar<0>(a, b, c, 0) : this->AddTriangle<0>(a, b, c, 0, 0);
  }

  /// Adds a triangle if at most one plane per axis cuts the element. Then all cells meet at the
  /// origin. A part is bounded by the element's surface and planes through the origin, so it
  /// consists of the cones from the origin to its surface.
  /// @param octant  bit a is set if the triangle is above the plane of axis a, for a < Axis
  template <int Axis>
  void AddToStar(const Vector3& a, const Vector3& b, const Vector3& c, int octant)
  {
    if constexpr (Axis == 3)
    {
      this->Octants[octant].AddCone(a, b, c);
    }
    else
    {
      const bool isAbove[3] = { a[Axis] > 0.0, b[Axis] > 0.0, c[Axis] > 0.0 };
      if (!this->IsCut(Axis) || !(isAbove[0] || isAbove[1] || isAbove[2]))
      {
        this->AddToStar<Axis + 1>(a, b, c, octant);
      }
      else if (a[Axis] >= 0.0 && b[Axis] >= 0.0 && c[Axis] >= 0.0)
      {
        this->AddToStar<Axis + 1>(a, b, c, octant | 1 << Axis);
      }
      else if (isAbove[1] == isAbove[2])
      {
        this->CutInStar<Axis>(a, b, c, octant);
      }
      else if (isAbove[2] == isAbove[0])
      {
        this->CutInStar<Axis>(b, c, a, octant);
      }
      else
      {
        this->CutInStar<Axis>(c, a, b, octant);
      }
    }
  }

  /// Cuts a triangle by the plane of an axis, which separates its first corner from the others.
  template <int Axis>
  void CutInStar(const Vector3& a, const Vector3& b, const Vector3& c, int octant)
  {
    const Vector3 ab = CutEdge<Axis>(a, b, 0.0), ac = CutEdge<Axis>(a, c, 0.0);
    const int above = octant | 1 << Axis;
    const int near = a[Axis] > 0.0 ? above : octant, far = a[Axis] > 0.0 ? octant : above;
    this->AddToStar<Axis + 1>(a, ab, ac, near);
    this->AddToStar<Axis + 1>(ab, b, c, far);
    this->AddToStar<Axis + 1>(ab, c, ac, far);
  }

  /// Cuts a triangle by the planes of an axis, then by the planes of the next axes.
  /// @param cell  index in Sums from the previous axes
  /// @param plane  first plane that may cut the triangle
  template <int Axis>
  void AddTriangle(
    const Vector3& a, const Vector3& b, const Vector3& c, Index cell, std::size_t plane)
  {
    const std::vector<double>& planes = this->Planes[Axis];
    const double low = std::min(std::min(a[Axis], b[Axis]), c[Axis]);
    for (; plane < planes.size() && planes[plane] <= low; ++plane)
    {
    }
    if (plane == planes.size() || std::max(std::max(a[Axis], b[Axis]), c[Axis]) <= planes[plane])
    {
      this->AddWithin<Axis>(a, b, c, cell, plane);
      return;
    }
    const double x = planes[plane];
    const bool isAbove[3] = { a[Axis] > x, b[Axis] > x, c[Axis] > x };
    if (isAbove[1] == isAbove[2])
    {
      this->CutCorner<Axis>(a, b, c, cell, plane);
    }
    else if (isAbove[2] == isAbove[0])
    {
      this->CutCorner<Axis>(b, c, a, cell, plane);
    }
    else
    {
      this->CutCorner<Axis>(c, a, b, cell, plane);
    }
  }

  /// Cuts a triangle by a plane that separates its first corner from the others.
  template <int Axis>
  void CutCorner(
    const Vector3& a, const Vector3& b, const Vector3& c, Index cell, std::size_t plane)
  {
    const double x = this->Planes[Axis][plane];
    const Vector3 ab = CutEdge<Axis>(a, b, x), ac = CutEdge<Axis>(a, c, x);
    if (a[Axis] > x)
    {
      this->AddWithin<Axis>(ab, b, c, cell, plane);
      this->AddWithin<Axis>(ab, c, ac, cell, plane);
      this->AddTriangle<Axis>(a, ab, ac, cell, plane + 1);
      return;
    }
    this->AddWithin<Axis>(a, ab, ac, cell, plane);
    this->AddTriangle<Axis>(ab, b, c, cell, plane + 1);
    this->AddTriangle<Axis>(ab, c, ac, cell, plane + 1);
  }

  template <int Axis>
  void AddWithin(
    const Vector3& a, const Vector3& b, const Vector3& c, Index cell, std::size_t layer)
  {
    cell = cell * static_cast<Index>(this->Planes[Axis].size() + 1) + static_cast<Index>(layer);
    if constexpr (Axis < 2)
    {
      this->AddTriangle<Axis + 1>(a, b, c, cell, 0);
    }
    else
    {
      this->AddPiece(a, b, c, cell, layer);
    }
  }

  /// Adds a triangle that is in one cell. A part consists, by the divergence theorem, of the
  /// columns along z under its surface. A column reaches the floor of its own cell and crosses the
  /// cells below, in its shadow. The floor of the lowest layer is its roof.
  void AddPiece(const Vector3& a, const Vector3& b, const Vector3& c, Index cell, std::size_t layer)
  {
    CellSums& sums = this->Sums[cell];
    if (layer < 2)
    {
      sums.AddColumn(a, b, c);
      return;
    }
    const Vector3 floor{ { 0.0, 0.0, this->Planes[2][layer - 1] } };
    sums.AddColumn(a - floor, b - floor, c - floor);
    sums.AddShadow(a, b, c);
  }

  void FinishCones()
  {
    this->ForOctants(
      [&](int octant)
      {
        CellSums& s = this->Octants[octant];
        if (s.Volume > 0.0) // others are dropped
        {
          s.Volume /= 6.0;
          s.X /= 24.0;
          s.Y /= 24.0;
          s.Z /= 24.0;
        }
      });
  }

  void FinishColumns()
  {
    const std::vector<double>& planes = this->Planes[2];
    const Index layers = static_cast<Index>(planes.size()) + 1;
    for (std::size_t column = 0; column < this->Sums.size(); column += layers)
    {
      double area = 0.0, areaX = 0.0, areaY = 0.0; // shadows of the layers above
      for (Index k = layers - 1; k >= 0; --k)
      {
        CellSums& s = this->Sums[column + k];
        const double floor = k > 1 ? planes[k - 1] : 0.0;
        const double height = k > 0 && k + 1 < layers ? planes[k] - floor : 0.0;
        s.Volume = s.Volume / 6.0 + area * height;
        s.X = s.X / 24.0 + areaX * height;
        s.Y = s.Y / 24.0 + areaY * height;
        s.Z = s.Z / 48.0 + 0.5 * area * height * height + s.Volume * floor;
        area += s.Area / 2.0;
        areaX += s.AreaX / 6.0;
        areaY += s.AreaY / 6.0;
      }
    }
  }

  /// Returns the volume up to which parts are dropped.
  double LeastVolume() const
  {
    const Vector3 size = this->Upper - this->Lower;
    return Rounding * size[0] * size[1] * size[2];
  }

  void AddParts(std::vector<OverlapPart>& parts) const
  {
    const double least = this->LeastVolume();
    const Index ny = static_cast<Index>(this->Planes[1].size()) + 1;
    const Index nz = static_cast<Index>(this->Planes[2].size()) + 1;
    this->ForSpannedCells(
      [&](const Index3& cell)
      {
        const Index i = cell[0] - this->Spans[0].First, j = cell[1] - this->Spans[1].First,
                    k = cell[2] - this->Spans[2].First;
        this->AddPart(this->Sums[(i * ny + j) * nz + k], cell, least, parts);
      });
  }

  void AddPartsOfStar(std::vector<OverlapPart>& parts) const
  {
    const double least = this->LeastVolume();
    const std::array<Span, 3>& from = this->Spans;
    this->ForOctants(
      [&](int octant)
      {
        const Index3 cell{ { from[0].First + (octant & 1), from[1].First + (octant >> 1 & 1),
          from[2].First + (octant >> 2) } };
        this->AddPart(this->Octants[octant], cell, least, parts);
      });
  }

  void AddPart(
    const CellSums& s, const Index3& cell, double least, std::vector<OverlapPart>& parts) const
  {
    if (s.Volume > least)
    {
      const Vector3 centroid = (1.0 / s.Volume) * Vector3{ { s.X, s.Y, s.Z } };
      parts.push_back({ IndexInBox(this->Grid.Local(), cell), s.Volume,
        this->MoveInside(cell, this->Shift + centroid) });
    }
  }

  /// Moves a centroid into the cell and the bounding box of the element. The centroid of a part
  /// with almost no volume may be anywhere.
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
  const ElementReach& Reach;
  std::array<Vector3, 8> Corners;            // corners; of hexes, numbered by bits
  Vector3 Lower, Upper;                      // bounding box
  Vector3 Origin;                            // point on the first plane of each axis
  Vector3 Shift;                             // origin of coordinates while the element is cut
  std::array<Span, 3> Spans;                 // cells along each axis
  std::array<std::vector<double>, 3> Planes; // planes between these cells unless it is a star
  int CutAxes = 0;                           // bit a is set if planes of axis a cut the element
  bool IsStar = false;                       // whether each axis has at most one plane
  int Apex = -1;                             // corner of a star at the origin, or -1
  std::vector<CellSums> Sums;                // of the cells, z fastest
  std::array<CellSums, 8> Octants;           // of the cells of a star, by bits, x lowest
};

} // namespace

OverlapFinder::OverlapFinder(const Mesh& mesh, const CartesianGrid& grid, Runtime& runtime) :
  TheMesh(mesh), Grid(grid), Run(runtime)
{
}

const Overlaps& OverlapFinder::Find(const std::vector<Index>& elements)
{
  const Index count = static_cast<Index>(elements.size());
  const Index pieces = (count + ElementsAtOnce - 1) / ElementsAtOnce;
  this->Pieces.resize(std::max<std::size_t>(this->Pieces.size(), pieces));
  const ElementReach reach(this->TheMesh, this->Grid);
  Overlaps& overlaps = this->Found;
  overlaps.Offsets.assign(count + 1, 0);
  ForEach(this->Run, pieces,
    [&](Index piece)
    {
      std::vector<OverlapPart>& parts = this->Pieces[piece];
      parts.clear();
      ElementCutter cutter(this->TheMesh, this->Grid, reach);
      const Index end = std::min(count, (piece + 1) * ElementsAtOnce);
      for (Index i = piece * ElementsAtOnce; i < end; ++i)
      {
        cutter.Cut(elements[i], parts);
        overlaps.Offsets[i + 1] = static_cast<Index>(parts.size());
      }
    });
  std::vector<Index> first(pieces + 1, 0);
  for (Index piece = 0; piece < pieces; ++piece)
  {
    first[piece + 1] = first[piece] + static_cast<Index>(this->Pieces[piece].size());
  }
  overlaps.Parts.resize(first[pieces]);
  ForEach(this->Run, pieces,
    [&](Index piece)
    {
      const Index end = std::min(count, (piece + 1) * ElementsAtOnce);
      for (Index i = piece * ElementsAtOnce; i < end; ++i)
      {
        overlaps.Offsets[i + 1] += first[piece];
      }
      std::copy(this->Pieces[piece].begin(), this->Pieces[piece].end(),
        overlaps.Parts.begin() + first[piece]);
    });
  return overlaps;
}

Overlaps FindOverlaps(
  const Mesh& mesh, const std::vector<Index>& elements, const CartesianGrid& grid, Runtime& runtime)
{
  return OverlapFinder(mesh, grid, runtime).Find(elements);
}

} // namespace vfm
