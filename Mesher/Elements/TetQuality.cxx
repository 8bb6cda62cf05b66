#include "Elements/TetQuality.h"

#include "Base/Lanes.h"
#include "Base/PortableMath.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace vfm
{
namespace
{

/// Ends of the edges; edge 5 - e is opposite to edge e.
constexpr int EdgeEnds[6][2] = { { 0, 1 }, { 0, 2 }, { 0, 3 }, { 1, 2 }, { 1, 3 }, { 2, 3 } };

struct TetShape
{
  Vector3 Edge[6];    // times LengthScale
  double Determinant; // 6 V
};

TetShape ShapeOf(const double* points, const Index* tet)
{
  TetShape shape;
  const double scale = LengthScale(points, tet, 4);
  for (int e = 0; e < 6; ++e)
  {
    const double* from = points + 3 * tet[EdgeEnds[e][0]];
    const double* to = points + 3 * tet[EdgeEnds[e][1]];
    shape.Edge[e] = scale * Vector3{ { to[0] - from[0], to[1] - from[1], to[2] - from[2] } };
  }
  shape.Determinant = Dot(shape.Edge[0], Cross(shape.Edge[1], shape.Edge[2]));
  return shape;
}

/// Returns the scaled Jacobian.
/// @param largest  largest product, over the corners, of the squared edge lengths
VFM_INLINE double ScaledJacobianOf(double determinant, double largest)
{
  return largest > 0.0 ? std::sqrt(2.0) * determinant / std::sqrt(largest) : 0.0;
}

double Degrees()
{
  return 180.0 / Pi;
}

} // namespace

double LengthScale(const double* points, const Index* element, int corners)
{
  double longest = 0.0;
  for (int c = 1; c < corners; ++c)
  {
    for (int a = 0; a < 3; ++a)
    {
      longest =
        std::max(longest, std::fabs(points[3 * element[c] + a] - points[3 * element[0] + a]));
    }
  }
  int exponent = 0;
  std::frexp(longest, &exponent);
  return std::ldexp(1.0, std::min(-exponent, 1000)); // finite
}

double TetScaledJacobian(const double* points, const Index* tet)
{
  const TetShape shape = ShapeOf(points, tet);
  double product[4] = { 1.0, 1.0, 1.0, 1.0 };
  for (int e = 0; e < 6; ++e)
  {
    const double square = Dot(shape.Edge[e], shape.Edge[e]);
    product[EdgeEnds[e][0]] *= square;
    product[EdgeEnds[e][1]] *= square;
  }
  return ScaledJacobianOf(shape.Determinant, *std::max_element(product, product + 4));
}

void DihedralAngles(const double* points, const Index* tet, double angles[6])
{
  const TetShape shape = ShapeOf(points, tet);
  const Vector3* edge = shape.Edge;
  // Normals of the faces opposite to corners 0..3, all outward or all inward.
  const Vector3 normal[4] = { Cross(edge[3], edge[4]), Cross(edge[2], edge[1]),
    Cross(edge[0], edge[2]), Cross(edge[1], edge[0]) };
  for (int e = 0; e < 6; ++e)
  {
    // The faces at an edge are opposite to the ends of the other edge; |n x m| = 6 |V| l. The
    // difference 0.0 - 0.0 is +0, which makes the angle 0.
    const int* ends = EdgeEnds[5 - e];
    angles[e] = Degrees() *
      ArcTangent(
        std::abs(shape.Determinant) * Norm(edge[e]), 0.0 - Dot(normal[ends[0]], normal[ends[1]]));
  }
}

void AngleStatistics::Add(const AngleStatistics& other)
{
  for (std::size_t bin = 0; bin < this->Counts.size(); ++bin)
  {
    this->Counts[bin] += other.Counts[bin];
  }
  this->Smallest = std::min(this->Smallest, other.Smallest);
  this->Largest = std::max(this->Largest, other.Largest);
}

namespace
{

constexpr int Width = ElementLanes<double>::Count;
constexpr int Bins = std::tuple_size<decltype(AngleStatistics::Counts)>::value;
constexpr double BelowLimit = 1e-6; // degrees

// Angles are represented by s, the square of their cotangent with its sign. It needs no square root
// and decreases with the angle.

double SquareOfCotangent(double angle)
{
  const double cotangent = Cosine(angle / Degrees()) / Sine(angle / Degrees());
  return std::copysign(cotangent * cotangent, cotangent);
}

double AngleOf(double square)
{
  return Degrees() * ArcTangent(1.0, std::copysign(std::sqrt(std::fabs(square)), square));
}

/// Table that finds the bin of ten degrees of an angle. It has steps of s / (1 + |s|), from -1 to
/// 1, with at most one bin limit per step.
class AngleTable
{
public:
  static constexpr int Steps = 128;

  AngleTable()
  {
    for (int step = 0; step < Steps; ++step)
    {
      const double low = step * (2.0 / Steps) - 1.0, high = low + 2.0 / Steps;
      Step& s = this->Of[step];
      s = { 0, -1e300 };
      for (int bin = 1; bin < Bins; ++bin)
      {
        const double limit = SquareOfCotangent(180.0 / Bins * bin - BelowLimit);
        const double place = limit / (1.0 + std::fabs(limit));
        s.Bin += place >= high;
        s.Limit = place >= low && place < high ? limit : s.Limit;
      }
    }
  }
  VFM_INLINE int BinOf(double square, double step) const
  {
    const Step& s = this->Of[std::min(static_cast<int>(step), Steps - 1)];
    return s.Bin + (square <= s.Limit);
  }

private:
  struct Step
  {
    int Bin;      // bin at the begin of the step
    double Limit; // the next bin contains the values of s up to this limit
  };
  Step Of[Steps];
};

/// Shapes of four tets, one per lane.
struct LaneShapes
{
  Double4 Length[6]; // squared lengths
  Double4 Across[6]; // product of the outward normals of the faces at the edge
  Double4 Determinant;
};

/// Returns corner c of four tets.
/// @param scale  factor of the coordinates, a power of two
VFM_INLINE VectorLanes<double> CornersOf(
  const double* points, const Index* const (&tets)[Width], int c, double scale)
{
  const auto along = [&](int a)
  {
    return scale *
      Double4{ points[3 * tets[0][c] + a], points[3 * tets[1][c] + a], points[3 * tets[2][c] + a],
        points[3 * tets[3][c] + a] };
  };
  return { along(0), along(1), along(2) };
}

VFM_INLINE LaneShapes ShapesOf(
  const double* points, const Index* const (&tets)[Width], double scale)
{
  const VectorLanes<double> x[4] = { CornersOf(points, tets, 0, scale),
    CornersOf(points, tets, 1, scale), CornersOf(points, tets, 2, scale),
    CornersOf(points, tets, 3, scale) };
  VectorLanes<double> edge[6];
  LaneShapes shapes;
  for (int e = 0; e < 6; ++e)
  {
    edge[e] = x[EdgeEnds[e][1]] - x[EdgeEnds[e][0]];
    shapes.Length[e] = Dot(edge[e], edge[e]);
  }
  shapes.Determinant = Dot(edge[0], Cross(edge[1], edge[2]));
  const VectorLanes<double> normal[4] = { Cross(edge[3], edge[4]), Cross(edge[2], edge[1]),
    Cross(edge[0], edge[2]), Cross(edge[1], edge[0]) };
  for (int e = 0; e < 6; ++e)
  {
    shapes.Across[e] = Dot(normal[EdgeEnds[5 - e][0]], normal[EdgeEnds[5 - e][1]]);
  }
  return shapes;
}

VFM_INLINE void CopyScaledJacobians(const LaneShapes& shapes, int count, float* scaledJacobians)
{
  Double4 product[4] = { Fill(1.0), Fill(1.0), Fill(1.0), Fill(1.0) };
  for (int e = 0; e < 6; ++e)
  {
    product[EdgeEnds[e][0]] *= shapes.Length[e];
    product[EdgeEnds[e][1]] *= shapes.Length[e];
  }
  Double4 largest = product[0];
  for (int c = 1; c < 4; ++c)
  {
    largest = product[c] > largest ? product[c] : largest;
  }
  for (int lane = 0; lane < count; ++lane)
  {
    scaledJacobians[lane] =
      static_cast<float>(ScaledJacobianOf(shapes.Determinant[lane], largest[lane]));
  }
}

/// Statistics of dihedral angles as values of s.
struct Cotangents
{
  const AngleTable Table;
  Double4 Smallest = Fill(1e300), Largest = Fill(-1e300);
  std::array<std::int64_t, Bins> Counts{};

  VFM_INLINE void Add(const LaneShapes& shapes, int count)
  {
    const Double4 perArea = 1.0 / (shapes.Determinant * shapes.Determinant);
    for (int e = 0; e < 6; ++e)
    {
      const Double4 across = shapes.Across[e];
      const Double4 size = across * across * perArea / shapes.Length[e];
      const Double4 square = across < Double4{} ? size : -size;
      this->Smallest = square < this->Smallest ? square : this->Smallest;
      this->Largest = square > this->Largest ? square : this->Largest;
      const Double4 step = (square / (1.0 + size) + 1.0) * (0.5 * AngleTable::Steps);
      for (int lane = 0; lane < count; ++lane)
      {
        ++this->Counts[this->Table.BinOf(square[lane], step[lane])];
      }
    }
  }
  VFM_INLINE AngleStatistics Angles() const
  {
    AngleStatistics angles;
    angles.Counts = this->Counts;
    for (int lane = 0; lane < Width; ++lane)
    {
      angles.Smallest = std::min(angles.Smallest, AngleOf(this->Largest[lane]));
      angles.Largest = std::max(angles.Largest, AngleOf(this->Smallest[lane]));
    }
    return angles;
  }
};

/// Returns the statistics of a tet that may be flat.
AngleStatistics AnglesOf(const double* points, const Index* tet)
{
  AngleStatistics statistics;
  double angles[6];
  DihedralAngles(points, tet, angles);
  for (double angle : angles)
  {
    statistics.Smallest = std::min(statistics.Smallest, angle);
    statistics.Largest = std::max(statistics.Largest, angle);
    ++statistics
        .Counts[std::min(static_cast<int>((angle + BelowLimit) * (Bins / 180.0)), Bins - 1)];
  }
  return statistics;
}

VFM_INLINE bool HasFlat(const LaneShapes& shapes)
{
  const Double4 square = shapes.Determinant * shapes.Determinant;
  return !(square[0] > 0.0 && square[1] > 0.0 && square[2] > 0.0 && square[3] > 0.0);
}

} // namespace

VFM_CLONES
AngleStatistics MeasureTets(
  const double* points, const Index* tets, Index count, float* scaledJacobians)
{
  AngleStatistics flat;
  Cotangents cotangents;
  const double scale =
    count > 0 ? LengthScale(points, tets, 4) : 1.0; // the others have similar lengths
  for (Index first = 0; first < count; first += Width)
  {
    const int lanes = static_cast<int>(std::min<Index>(Width, count - first));
    const Index* four[Width];
    for (int lane = 0; lane < Width; ++lane)
    {
      four[lane] = tets + 4 * (first + std::min(lane, lanes - 1));
    }
    const LaneShapes shapes = ShapesOf(points, four, scale);
    CopyScaledJacobians(shapes, lanes, scaledJacobians + first);
    if (!HasFlat(shapes))
    {
      cotangents.Add(shapes, lanes);
      continue;
    }
    for (int lane = 0; lane < lanes; ++lane)
    {
      flat.Add(AnglesOf(points, four[lane]));
    }
  }
  flat.Add(cotangents.Angles());
  return flat;
}

} // namespace vfm
