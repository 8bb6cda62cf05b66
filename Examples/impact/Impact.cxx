#include "Impact.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace impact
{
namespace
{

// Size of the grid, mm, rounded to a multiple of the cell size.
constexpr double Width = 10., Depth = 6., Height = 4.5;
constexpr double SpacingUnit = 1. / 1024.; // the spacing is a multiple of it: exact in binary
constexpr double PlateTop = 1.5;
constexpr double PlateMargin = .25;  // distance of the plate's edges from the grid's sides
constexpr double StartMargin = .3;   // distance of the ball from the grid's side
constexpr double StartGap = .5;      // distance of the ball from the plate
constexpr int PointsPerCell = 2;     // number of points along each axis of a cell
constexpr int Samples = 8;           // number of samples along each axis of a point's box
constexpr double SmallestPart = .02; // filled part of a point's box; below it, no point is made
constexpr double GrainSize = 1., WeakWidth = .4; // size of grains, width of weak zones between them
constexpr double Weakest = .03, Toughest = 6.;   // toughness at grain boundaries, inside grains

struct Box
{
  Vector Lower, Upper;
  double Volume() const
  {
    return (this->Upper[0] - this->Lower[0]) * (this->Upper[1] - this->Lower[1]) *
      (this->Upper[2] - this->Lower[2]);
  }
};

/// Part of a box that a body fills, as a box of the same volume, centre and spread.
struct Part
{
  double Volume = 0.;
  Vector Centre{}, Size{};
};

struct Scene
{
  Vector BallCentre, BallVelocity;
  double BallRadius;
  Box PlateBox;
};

double SpacingOf(const Options& options)
{
  return std::max(1., std::round(Width / options.Cells / SpacingUnit)) * SpacingUnit;
}

Index3 CellsOf(const Options& options)
{
  const double spacing = SpacingOf(options);
  return { options.Cells, std::llround(Depth / spacing), std::llround(Height / spacing) };
}

Scene MakeScene(const Options& options)
{
  const double angle = options.Angle * std::acos(-1.) / 180.;
  const Vector direction{ std::sin(angle), 0., -std::cos(angle) };
  Scene scene;
  scene.BallRadius = .5 * options.Diameter;
  scene.BallCentre = { scene.BallRadius + StartMargin, .5 * Depth,
    PlateTop + StartGap + scene.BallRadius };
  for (int a = 0; a < 3; ++a)
  {
    scene.BallVelocity[a] = options.Speed * direction[a];
  }
  scene.PlateBox = { { PlateMargin, PlateMargin, PlateTop - options.Thickness },
    { Width - PlateMargin, Depth - PlateMargin, PlateTop } };
  return scene;
}

Part CutByPlate(const Scene& scene, Box box)
{
  for (int a = 0; a < 3; ++a)
  {
    box.Lower[a] = std::max(box.Lower[a], scene.PlateBox.Lower[a]);
    box.Upper[a] = std::max(box.Lower[a], std::min(box.Upper[a], scene.PlateBox.Upper[a]));
  }
  Part part;
  part.Volume = box.Volume();
  for (int a = 0; a < 3; ++a)
  {
    part.Centre[a] = .5 * (box.Lower[a] + box.Upper[a]);
    part.Size[a] = box.Upper[a] - box.Lower[a];
  }
  return part;
}

/// Returns the part of the box inside the ball, found by samples. It is exact for a box that the
/// ball's surface does not cut.
Part CutByBall(const Scene& scene, const Box& box)
{
  constexpr int all = Samples * Samples * Samples;
  int inside = 0;
  Vector sum{}, squares{}, edge;
  for (int a = 0; a < 3; ++a)
  {
    edge[a] = box.Upper[a] - box.Lower[a];
  }
  for (int n = 0; n < all; ++n)
  {
    const int index[3] = { n % Samples, n / Samples % Samples, n / Samples / Samples };
    Vector x; // position of the sample in the box, -.5 to .5
    double distance = 0.;
    for (int a = 0; a < 3; ++a)
    {
      x[a] = (index[a] + .5) / Samples - .5;
      const double d = .5 * (box.Lower[a] + box.Upper[a]) + edge[a] * x[a] - scene.BallCentre[a];
      distance += d * d;
    }
    if (distance < scene.BallRadius * scene.BallRadius)
    {
      ++inside;
      for (int a = 0; a < 3; ++a)
      {
        sum[a] += x[a];
        squares[a] += x[a] * x[a];
      }
    }
  }
  Part part;
  if (inside == 0)
  {
    return part;
  }
  part.Volume = box.Volume() * inside / all;
  double scale = part.Volume;
  for (int a = 0; a < 3; ++a)
  {
    const double mean = sum[a] / inside;
    part.Centre[a] = .5 * (box.Lower[a] + box.Upper[a]) + edge[a] * mean;
    // Width of a bar with this variance; at least the width of one sample.
    const double variance = squares[a] / inside - mean * mean;
    part.Size[a] = edge[a] * std::sqrt(12. * variance + 1. / (Samples * Samples));
    scale /= part.Size[a];
  }
  for (double& size : part.Size)
  {
    size *= std::cbrt(scale);
  }
  return part;
}

/// Returns a number from 0 to 1 that depends only on the integers (finaliser of MurmurHash3,
/// Appleby).
double Hash(std::int64_t i, std::int64_t j, std::int64_t k)
{
  std::uint64_t h = static_cast<std::uint64_t>(i) * 0x9e3779b97f4a7c15ULL ^
    static_cast<std::uint64_t>(j) * 0xc2b2ae3d27d4eb4fULL ^
    static_cast<std::uint64_t>(k) * 0x165667b19e3779f9ULL;
  h = (h ^ h >> 33) * 0xff51afd7ed558ccdULL;
  h = (h ^ h >> 33) * 0xc4ceb9fe1a85ec53ULL;
  return static_cast<double>((h ^ h >> 33) >> 11) * 0x1p-53;
}

/// Returns the toughness of the ball: low near the faces of a Voronoi diagram, high inside its
/// cells. The diagram has one random seed in each cube of width GrainSize.
double ToughnessAt(const Vector& position)
{
  std::int64_t cube[3];
  for (int a = 0; a < 3; ++a)
  {
    cube[a] = static_cast<std::int64_t>(std::floor(position[a] / GrainSize));
  }
  double first = 1e30, second = 1e30; // distances to the two nearest seeds
  for (int n = 0; n < 125; ++n)
  {
    const std::int64_t i = cube[0] + n % 5 - 2, j = cube[1] + n / 5 % 5 - 2,
                       k = cube[2] + n / 25 - 2;
    const double x = (i + Hash(i, j, 3 * k)) * GrainSize - position[0];
    const double y = (j + Hash(i, j, 3 * k + 1)) * GrainSize - position[1];
    const double z = (k + Hash(i, j, 3 * k + 2)) * GrainSize - position[2];
    const double distance = std::sqrt(x * x + y * y + z * z);
    second = std::min(second, std::max(first, distance));
    first = std::min(first, distance);
  }
  const double t = std::min(1., (second - first) / WeakWidth);
  return Weakest + (Toughest - Weakest) * t * t * (3. - 2. * t);
}

MaterialPoint MakePoint(Body owner, const Part& part, const Vector& velocity)
{
  MaterialPoint point{};
  point.Position = part.Centre;
  point.Velocity = velocity;
  point.Size = part.Size;
  point.Volume0 = part.Volume;
  point.Ratio = 1.;
  point.Toughness = owner == Ball ? ToughnessAt(part.Centre) : 1.;
  point.Owner = owner;
  return point;
}

/// Returns the points in the cells that this rank owns.
std::vector<MaterialPoint> MakePoints(const Domain& grid, const Scene& scene)
{
  std::vector<MaterialPoint> points;
  const double side = grid.GetSpacing() / PointsPerCell;
  const double smallest = SmallestPart * side * side * side;
  grid.ForEachCell(
    [&](const Index3& cell, std::int64_t)
    {
      for (int n = 0; n < PointsPerCell * PointsPerCell * PointsPerCell; ++n)
      {
        const int index[3] = { n % PointsPerCell, n / PointsPerCell % PointsPerCell,
          n / PointsPerCell / PointsPerCell };
        Box box;
        for (int a = 0; a < 3; ++a)
        {
          box.Lower[a] = (cell[a] * PointsPerCell + index[a]) * side;
          box.Upper[a] = box.Lower[a] + side;
        }
        const Part ball = CutByBall(scene, box), plate = CutByPlate(scene, box);
        if (ball.Volume > smallest)
        {
          points.push_back(MakePoint(Ball, ball, scene.BallVelocity));
        }
        if (plate.Volume > smallest)
        {
          points.push_back(MakePoint(Plate, plate, Vector{}));
        }
      }
    });
  return points;
}

} // namespace

Impact::Impact(MPI_Comm communicator, const Options& options) :
  Grid(communicator, CellsOf(options), SpacingOf(options)),
  Motion(this->Grid, MakePoints(this->Grid, MakeScene(options)), options.Speed),
  Output(this->Grid, !options.Restart.empty()),
  Table(this->Grid, options.History)
{
  this->Steps = options.Steps > 0
    ? options.Steps
    : static_cast<std::int64_t>(std::ceil(options.EndTime / this->Motion.GetTimeStep()));
  this->Every = options.Every > 0 ? options.Every : std::max<std::int64_t>(1, this->Steps / 24);
}

void Impact::Run(const std::vector<Sink*>& sinks)
{
  double started = MPI_Wtime();
  std::int64_t reported = 0;
  for (std::int64_t step = 0;; ++step)
  {
    this->Table.Add(step, this->Motion);
    if (step % this->Every == 0 || step == this->Steps)
    {
      this->Report(step,
        (MPI_Wtime() - started) / static_cast<double>(std::max<std::int64_t>(1, step - reported)));
      const Fields& fields = this->Output.Compute(
        this->Motion.GetPoints(), step, static_cast<double>(step) * this->Motion.GetTimeStep());
      for (Sink* sink : sinks)
      {
        sink->Take(fields);
      }
      reported = step;
      started = MPI_Wtime();
    }
    if (step == this->Steps)
    {
      return;
    }
    this->Motion.Step();
  }
}

void Impact::Report(std::int64_t step, double seconds) const
{
  double energy = 0., mass = 0., lost = 0.;
  for (const Totals& body : this->Motion.TotalsInside())
  {
    energy += body.Kinetic;
    mass += body.Mass;
  }
  for (const Totals& body : this->Motion.TotalsOutside())
  {
    lost += body.Mass;
  }
  if (this->Grid.GetRank() == 0)
  {
    std::printf("step %5lld  time %.4f us  %.4f s/step  kinetic energy %.6g J  "
                "mass %.9g mg, of it %.3g left the grid\n",
      static_cast<long long>(step), static_cast<double>(step) * this->Motion.GetTimeStep(), seconds,
      energy, mass + lost, lost);
    std::fflush(stdout);
  }
}

} // namespace impact
