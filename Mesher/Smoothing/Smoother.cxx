#include "Smoothing/Smoother.h"

#include "Base/Vector3.h"
#include "Smoothing/ForFlagged.h"
#include "Smoothing/Intersections.h"
#include "Smoothing/NewtonStep.h"

namespace vfm
{
namespace
{

constexpr double Backtrack = 0.4; // factor of the line search
constexpr int Backtracks = 8;
constexpr double Armijo = 1e-4; // share of the predicted decrease that a step must reach
constexpr double Noise = 1e-6;  // relative error of an energy, which may be a sum of floats
// Largest relative change of a determinant by a step whose energy is not evaluated.
constexpr double SureChange = 0.1;
constexpr double MoveRadius = 0.01; // in mean cells
// In mean cells. Without shorter steps, errors of fragments of 64 cells change by less than 1e-7.
constexpr double SmallestStep = 2e-8;
// Factor by which MoveAlongNormals may raise the barrier. Shorter moves of points of hexes than
// CheapMove, in mean cells, raise it too little to evaluate it.
constexpr double MovePrice = 1.05, CheapMove = 1e-4;
// Limit of an offset beyond 0 or beyond the position of its point, in cells.
constexpr double OffsetAhead = 0.25;
constexpr double LongestOffset = 1.0; // limit of long offsets, in cells
// Energy of the elements at a point up to which long offsets grow.
constexpr double LargestPrice = 10.0;
// Returned instead of a length by points that are not visited.
constexpr double NoVisit = -1.0;
constexpr unsigned char FixedOnAllAxes = 7; // ActiveMesh::Fixed
// Smallest shift of a target that marks its points, in mean cells.
constexpr double ShiftThatCounts = 1e-3;
constexpr double SmallestShift = 1e-5; // smaller ones are left out
// If less than this part of the points is shifted, a check of each move is cheaper than one of all
// elements.
constexpr double FewPoints = 1.0 / 32.0;
// Energy of the elements at a point that a snap may reach in any case.
constexpr double SnapEnergy = 20.0;
constexpr double SmallestSnap = 0.2; // part of a snap

} // namespace

Smoother::Smoother(
  ActiveMesh& mesh, const SurfaceTargets* targets, const ElementEnergy& energy, Runtime& runtime) :
  Mesh(mesh),
  Targets(targets),
  Energy(energy),
  Run(runtime),
  TheGuard(mesh, energy, runtime),
  Dirty(new unsigned char[mesh.X.size()]),
  Marked(mesh.X.size(), 0),
  HasMoved(mesh.X.size(), 1),
  MovedSince(mesh.X.size(), 0)
{
  std::vector<unsigned char> isGhost = mesh.IsActive;
  mesh.ForOwned(
    [&](int point)
    {
      ++this->NumberOfPoints;
      isGhost[point] = 0;
    });
  for (std::size_t point = 0; point < isGhost.size(); ++point)
  {
    if (isGhost[point])
    {
      this->Ghosts.push_back(static_cast<int>(point));
    }
  }
  if (mesh.CornerOffset.empty())
  {
    mesh.ListCorners();
  }
  if (mesh.HasHexes() && mesh.Rings.IsEmpty())
  {
    mesh.Rings = HexRings(mesh, runtime);
  }
}

/// Adds the points that have moved to the lists of those who look at them.
void Smoother::ListMoved()
{
  this->TheGuard.NoteMoved(this->HasMoved);
  std::transform(this->HasMoved.begin(), this->HasMoved.end(), this->MovedSince.begin(),
    this->MovedSince.begin(), std::bit_or<unsigned char>());
  std::fill(this->HasMoved.begin(), this->HasMoved.end(), 0);
  for (int ghost : this->Ghosts)
  {
    this->HasMoved[ghost] = 1; // its owner does not report whether it moves
  }
}

void Smoother::MarkAll()
{
  std::fill_n(this->Dirty.get(), this->Mesh.X.size(), 1);
}

/// Moves points. Where that violates conditions, points go back; moveReturned moves them again.
void Smoother::MoveAndCheck(
  const std::function<void()>& move, const std::function<void()>& moveReturned)
{
  this->Before.resize(this->Mesh.X.size());
  ForEach(this->Run, this->Before.size(), [this](Index p) { this->Before[p] = this->Mesh.X[p]; });
  move();
  const auto putsBack = [this]
  {
    this->ListMoved();
    return this->TheGuard.PutBack(this->Before, this->Mesh.X);
  };
  while (putsBack())
  {
    ForFlagged(
      this->Run, this->TheGuard.Returned(), [this](Index point) { this->HasMoved[point] = 1; });
    this->AlignColumns();
    moveReturned();
  }
}

/// Sweeps, then checks all elements. Points that go back move again.
void Smoother::SweepAndCheck(const SmoothingStage& stage, const std::function<void()>& sweep)
{
  this->MoveAndCheck(sweep,
    [&]
    {
      this->MarkReturned();
      this->RunSweeps(stage, [](double) {});
    });
}

void Smoother::RunStage(const SmoothingStage& stage, const std::function<void(double)>& report)
{
  this->SweepAndCheck(stage,
    [&]
    {
      this->MarkAll();
      for (int snap = 0; snap < stage.Snaps; ++snap)
      {
        ++this->NumberOfSweeps;
        this->ForPoints(nullptr,
          [&](int point)
          {
            this->SnapPoint(point, stage);
            return 0.0;
          });
      }
      this->RunSweeps(stage, report);
    });
}

bool Smoother::EndIntersections(const SmoothingStage& stage, bool moves)
{
  std::vector<Vector3>().swap(this->Before); // before the tree of boxes, which takes memory
  const std::vector<unsigned char> intersects = FindIntersections(this->Mesh, this->Run);
  bool isNew = false;
  this->Mesh.ForOwned(
    [&](int p)
    {
      isNew = isNew || (intersects[p] && this->Mesh.Fixed[p] != FixedOnAllAxes);
      this->Mesh.Fixed[p] = intersects[p] ? FixedOnAllAxes : this->Mesh.Fixed[p];
    });
  if (!this->Run.Group().Any(isNew))
  {
    return false;
  }
  this->Before.resize(this->Mesh.X.size());
  for (std::size_t p = 0; p < this->Before.size(); ++p)
  {
    this->Before[p] = this->Mesh.StartOf(static_cast<int>(p));
  }
  this->TheGuard.PutBack(intersects, this->Before, this->Mesh.X, stage);
  this->AlignColumns();
  if (moves)
  {
    this->MarkReturned();
    this->SweepWithChecks(stage);
  }
  return true;
}

/// Sweeps and checks each move.
void Smoother::SweepWithChecks(const SmoothingStage& stage)
{
  this->ChecksAll = true;
  this->RunSweeps(stage, [](double) {});
  this->ChecksAll = false;
}

/// Marks only the points that were put back and their neighbours.
void Smoother::MarkReturned()
{
  std::fill_n(this->Dirty.get(), this->Mesh.X.size(), 0);
  const std::vector<CornerPosition>& corners = this->Mesh.CornerOffset;
  ForFlagged(this->Run, this->TheGuard.Returned(),
    [&](Index point)
    {
      if (corners[point] < corners[point + 1]) // a ghost may have no element here
      {
        this->MarkNeighbours(static_cast<int>(point));
      }
    });
}

void Smoother::RunSweeps(const SmoothingStage& stage, const std::function<void(double)>& report)
{
  for (int sweep = 0; sweep < stage.Sweeps; ++sweep)
  {
    const double move = this->Sweep(stage);
    this->HasShifted = false;
    report((sweep + 1.0) / stage.Sweeps);
    if (move < stage.SmallestMove && !this->HasShifted)
    {
      break;
    }
  }
}

void Smoother::RunRamp(const SmoothingRamp& ramp)
{
  for (const SmoothingStage& stage : ramp)
  {
    this->RunStage(stage, [](double) {});
  }
}

/// Calls move(point) for the owned active points in their order; move returns a length or NoVisit.
/// Returns the largest length over all ranks.
/// @param where  flags of the points; others are left out; null: none
template <class Move>
double Smoother::ForPoints(const unsigned char* where, const Move& move)
{
  std::atomic<double> largest(0.0);
  std::fill(this->Marked.begin(), this->Marked.end(), 0);
  for (const MoveOrder::Step& step : this->Mesh.Order.Steps())
  {
    this->Run.For(0, static_cast<Index>(step.Tasks.size()) - 1,
      [&](Index first, Index last)
      {
        double longest = 0.0;
        Index visits = 0;
        this->Mesh.Order.ForPoints(step.Tasks[first], step.Tasks[last], where,
          [&](int point)
          {
            const double length = this->Mesh.IsActive[point] ? move(point) : NoVisit;
            longest = std::max(longest, length);
            visits += length != NoVisit;
          });
        this->NumberOfVisits.fetch_add(visits, std::memory_order_relaxed);
        for (double seen = largest;
             longest > seen && !largest.compare_exchange_weak(seen, longest);)
        {
        }
      });
    if (step.Colour >= 0)
    {
      this->Mesh.Exchange.Send(step.Colour, this->Mesh.X, this->Marked,
        [this](int point) { this->MarkNeighbours(point); });
    }
  }
  this->AlignColumns();
  return this->Run.Group().Max(largest);
}

/// Moves every marked point once; returns the largest move, in cells.
double Smoother::Sweep(const SmoothingStage& stage)
{
  ++this->NumberOfSweeps;
  return this->ForPoints(
    this->Dirty.get(), [&](int point) { return this->MovePoint(point, stage); });
}

/// Returns the lower and upper limit of the offset of an attachment with a long offset.
std::array<double, 2> Smoother::LongRange(
  int point, const Attachment& a, const SmoothingStage& stage) const
{
  if (this->Energy.Evaluate(this->Mesh, point, this->Mesh.X[point], stage) > LargestPrice)
  {
    return { { std::min(a.Offset, -OffsetAhead), std::max(a.Offset, OffsetAhead) } };
  }
  Vector3 gradient;
  const double now = this->Targets->Distance(a.Target, this->Mesh.X[point], gradient);
  return { { std::max(-LongestOffset, std::min(-OffsetAhead, now - OffsetAhead)),
    std::min(LongestOffset, std::max(OffsetAhead, now + OffsetAhead)) } };
}

void Smoother::Shift(
  const std::vector<double>& shifts, const HasLongOffset& isLong, const SmoothingStage& stage)
{
  const std::vector<CornerPosition>& offsets = this->Mesh.AttachmentOffset;
  ForEach(this->Run, this->Mesh.X.size(),
    [&](Index point)
    {
      for (Index i = offsets[point]; i < offsets[point + 1]; ++i)
      {
        if (std::fabs(shifts[i]) < SmallestShift)
        {
          continue;
        }
        Attachment& a = this->Mesh.Attachments[i];
        const double offset = a.Offset + shifts[i] * this->Targets->LocalScale(a.Target);
        const std::array<double, 2> range = isLong(a)
          ? this->LongRange(static_cast<int>(point), a, stage)
          : std::array<double, 2>{ { -OffsetAhead, OffsetAhead } };
        a.Offset = std::min(std::max(offset, range[0]), range[1]);
      }
    });
}

/// Returns whether an attachment of a point has a shift that counts.
bool Smoother::IsShifted(int point, const std::vector<double>& shifts) const
{
  const std::vector<CornerPosition>& offsets = this->Mesh.AttachmentOffset;
  return std::any_of(shifts.begin() + offsets[point], shifts.begin() + offsets[point + 1],
    [](double shift) { return std::fabs(shift) >= ShiftThatCounts; });
}

void Smoother::ShiftTargets(
  const std::vector<double>& shifts, const HasLongOffset& isLong, const SmoothingStage& stage)
{
  this->Shift(shifts, isLong, stage);
  std::atomic<bool> marks(false);
  this->Mesh.ForOwned(this->Run,
    [&](int point)
    {
      if (this->Mesh.IsActive[point] && this->IsShifted(point, shifts))
      {
        this->Dirty[point] = 1;
        marks = true;
      }
    });
  this->HasShifted = this->Run.Group().Any(marks);
}

bool Smoother::Follow(
  const std::vector<double>& shifts, const HasLongOffset& isLong, const SmoothingStage& stage)
{
  this->Shift(shifts, isLong, stage);
  std::fill_n(this->Dirty.get(), this->Mesh.X.size(), 0);
  this->ForPoints(nullptr,
    [&](int point)
    {
      if (this->IsShifted(point, shifts))
      {
        // The mark is sent to other ranks, which may not know all attachments of the point.
        this->Marked[point] = 1;
        this->MarkNeighbours(point);
      }
      return NoVisit;
    });
  std::vector<std::int64_t> sums{ std::count(this->Marked.begin(), this->Marked.end(), 1),
    this->NumberOfPoints };
  this->Run.Group().Sum(sums);
  const auto marked = static_cast<double>(sums[0]), points = static_cast<double>(sums[1]);
  if (marked == 0.0)
  {
    return false;
  }
  if (marked < FewPoints * points)
  {
    this->SweepWithChecks(stage);
  }
  else
  {
    this->SweepAndCheck(stage, [&] { this->RunSweeps(stage, [](double) {}); });
  }
  return true;
}

void Smoother::MoveAlongNormals(const std::vector<double>& shifts, const SmoothingStage& stage)
{
  const auto move = [&](int point)
  {
    this->MoveAlongNormal(point, shifts, stage);
    return NoVisit;
  };
  this->MoveAndCheck([&] { this->ForPoints(nullptr, move); },
    [&] { this->ForPoints(this->TheGuard.Returned().data(), move); });
}

void Smoother::MoveAlongNormal(
  int point, const std::vector<double>& shifts, const SmoothingStage& stage)
{
  const std::vector<CornerPosition>& offsets = this->Mesh.AttachmentOffset;
  double longest = 0.0; // step, if all normals are parallel
  for (Index i = offsets[point]; i < offsets[point + 1]; ++i)
  {
    longest += std::fabs(shifts[i]);
  }
  if (longest < SmallestStep)
  {
    return;
  }
  Vector3 step{ { 0.0, 0.0, 0.0 } };
  for (Index i = offsets[point]; i < offsets[point + 1]; ++i)
  {
    Vector3 gradient;
    this->Targets->Distance(this->Mesh.Attachments[i].Target, this->Mesh.X[point], gradient);
    step = step + shifts[i] * Unit(gradient);
  }
  step = this->AlongFreeAxes(point, step);
  const double length = Norm(step);
  if (length < SmallestStep)
  {
    return;
  }
  const Vector3 x = this->Moved(point, (length > MoveRadius ? MoveRadius / length : 1.0) * step);
  // TheGuard checks all hexes after the moves.
  const bool isCheap = this->Mesh.HasHexes() && length < CheapMove;
  if ((isCheap ||
        this->Energy.Evaluate(this->Mesh, point, x, stage) <=
          MovePrice * this->Energy.Evaluate(this->Mesh, point, this->Mesh.X[point], stage)) &&
    this->MayMove(point, x))
  {
    this->Mesh.X[point] = x;
    this->HasMoved[point] = 1;
  }
}

/// Begins to load what is read after the derivatives: the start of a point and its targets.
void Smoother::Prefetch(int point) const
{
  if (!this->Mesh.StaysNear.empty())
  {
    this->Mesh.PrefetchStart(point);
  }
  const std::vector<CornerPosition>& offsets = this->Mesh.AttachmentOffset;
  for (Index i = offsets[point]; i < offsets[point + 1]; ++i)
  {
    this->Targets->Prefetch(this->Mesh.Attachments[i].Target);
  }
}

/// Moves a point by one Newton step with a line search; returns its length in cells.
double Smoother::MovePoint(int point, const SmoothingStage& stage)
{
  __atomic_store_n(&this->Dirty[point], 0, __ATOMIC_RELAXED);
  this->Prefetch(point);
  Derivatives d = this->Energy.Differentiate(this->Mesh, point, stage);
  this->AddDistance(point, stage.Lambda, d);
  bool isFree;
  int held = 0, more = this->Mesh.Fixed[point];
  Vector3 step;
  do
  {
    held |= more;
    step = SolveNewton(held, d);
    isFree = this->StaysWithin(point, step);
    more = isFree ? 0 : this->FixedAxes(point, step) & ~held;
  } while (more != 0);
  const Vector3& widths = this->Mesh.Widths.size() == 1 // then the lists are not read
    ? this->Mesh.Widths[0]
    : this->Mesh.WidthsAt(this->Mesh.CornerList[this->Mesh.CornerOffset[point]]);
  const double length = Norm(Divided(step, widths));
  if (!(length > 0.0))
  {
    return 0.0;
  }
  const double cut = std::min(1.0, TrustRadius / length);
  const double slope = Dot(d.Gradient, step);
  if (isFree && length < TrustRadius && -0.5 * slope < FallThatCounts(stage.Pace, d.Value) &&
    d.Steepness * Norm(step) <= SureChange && this->MayMove(point, this->Mesh.X[point] + step))
  {
    this->Mesh.X[point] = this->Mesh.X[point] + step;
    this->HasMoved[point] = 1;
    return length;
  }
  double t = FirstFactor(stage.Pace, length, -slope, d.Value);
  step = cut * step;
  for (int trial = 0; trial <= Backtracks; ++trial, t = t > 1.0 ? 1.0 : t * Backtrack)
  {
    const bool staysWithin = isFree && t <= 1.0; // longer steps may leave the bounds
    const Vector3 x = staysWithin ? this->Mesh.X[point] + t * step : this->Moved(point, t * step);
    const double energy = this->Energy.Evaluate(this->Mesh, point, x, stage) +
      this->DistanceEnergy(point, x, stage.Lambda);
    if (energy <= (1.0 + Noise) * d.Value + Armijo * t * cut * slope && this->MayMove(point, x))
    {
      this->Mesh.X[point] = x;
      this->HasMoved[point] = 1;
      const double move = t * cut * length;
      if (move > stage.Pace.MoveThatCounts &&
        d.Value - energy >= FallThatCounts(stage.Pace, energy))
      {
        this->Marked[point] = 1;
        this->MarkNeighbours(point);
      }
      return move;
    }
  }
  return 0.0;
}

/// Returns the mean of the points around a point, moved onto the targets of the point.
Vector3 Smoother::SnappedPosition(int point) const
{
  Vector3 x{ { 0.0, 0.0, 0.0 } };
  int count = 0;
  this->Mesh.ForNear(point,
    [&](int other)
    {
      x = x + this->Mesh.X[other];
      ++count;
    });
  x = (1.0 / count) * x;
  const std::vector<CornerPosition>& offsets = this->Mesh.AttachmentOffset;
  for (Index i = offsets[point]; i < offsets[point + 1]; ++i)
  {
    const Attachment& a = this->Mesh.Attachments[i];
    Vector3 g;
    const double distance = this->Targets->Distance(a.Target, x, g) - a.Offset;
    x = x - (distance / Dot(g, g)) * g;
  }
  return x;
}

/// Moves a point towards its snapped position. Points near sharp features, whose targets meet at
/// angles, take a Newton step instead.
void Smoother::SnapPoint(int point, const SmoothingStage& stage)
{
  if (this->Mesh.IsNearFeature(point))
  {
    this->MovePoint(point, stage);
    return;
  }
  const Vector3 step =
    this->AlongFreeAxes(point, this->SnappedPosition(point) - this->Mesh.X[point]);
  double before = 0.0; // present energy, found once a place exceeds SnapEnergy
  for (double part = 1.0; part > SmallestSnap; part *= 0.5)
  {
    const Vector3 x = this->Moved(point, part * step);
    const double energy = this->Energy.Evaluate(this->Mesh, point, x, stage);
    if (energy > SnapEnergy && before == 0.0)
    {
      before = this->Energy.Evaluate(this->Mesh, point, this->Mesh.X[point], stage);
    }
    if (energy <= std::max(SnapEnergy, before) && this->MayMove(point, x))
    {
      this->Mesh.X[point] = x;
      this->HasMoved[point] = 1;
      return;
    }
  }
}

/// Returns the axes (bit a) along which the point is at a bound and the step leads outwards.
int Smoother::FixedAxes(int point, const Vector3& step) const
{
  int held = 0;
  const Vector3& x = this->Mesh.X[point];
  const MoveBounds& bounds = this->Mesh.BoundsOf(point);
  for (int a = 0; a < 3; ++a)
  {
    const bool isHeld =
      (step[a] < 0.0 && x[a] <= bounds.Lower[a]) || (step[a] > 0.0 && x[a] >= bounds.Upper[a]);
    held |= isHeld << a;
  }
  return held;
}

/// Returns a step without its components along fixed axes.
Vector3 Smoother::AlongFreeAxes(int point, Vector3 step) const
{
  for (int a = 0; a < 3; ++a)
  {
    step[a] = this->Mesh.Fixed[point] >> a & 1 ? 0.0 : step[a];
  }
  return step;
}

/// Returns the position after a step, limited by the bounds. A point outside the bounds does not
/// move farther out.
Vector3 Smoother::Moved(int point, const Vector3& step) const
{
  Vector3 x = this->Mesh.X[point] + step;
  const MoveBounds& bounds = this->Mesh.BoundsOf(point);
  for (int a = 0; a < 3; ++a)
  {
    const double before = this->Mesh.X[point][a];
    const double low = std::min(bounds.Lower[a], before);
    const double high = std::max(bounds.Upper[a], before);
    x[a] = std::min(std::max(x[a], low), high);
  }
  return x;
}

double Smoother::DistanceEnergy(int point, const Vector3& x, double lambda) const
{
  const std::vector<CornerPosition>& offsets = this->Mesh.AttachmentOffset;
  double energy = 0.0;
  Vector3 gradient;
  for (Index i = offsets[point]; i < offsets[point + 1]; ++i)
  {
    const Attachment& a = this->Mesh.Attachments[i];
    const double distance = this->Targets->Distance(a.Target, x, gradient) - a.Offset;
    energy += lambda * a.Weight * distance * distance;
  }
  return energy;
}

/// Adds the squared distances by Gauss-Newton: the Hessian omits the curvature of the targets.
void Smoother::AddDistance(int point, double lambda, Derivatives& d) const
{
  const std::vector<CornerPosition>& offsets = this->Mesh.AttachmentOffset;
  for (Index i = offsets[point]; i < offsets[point + 1]; ++i)
  {
    const Attachment& a = this->Mesh.Attachments[i];
    Vector3 g;
    const double distance = this->Targets->Distance(a.Target, this->Mesh.X[point], g) - a.Offset;
    const double weight = lambda * a.Weight;
    d.Value += weight * distance * distance;
    d.Gradient = d.Gradient + (2.0 * weight * distance) * g;
    const std::array<double, 6> outer{ { g[0] * g[0], g[1] * g[1], g[2] * g[2], g[0] * g[1],
      g[0] * g[2], g[1] * g[2] } };
    for (int k = 0; k < 6; ++k)
    {
      d.Hessian[k] += 2.0 * weight * outer[k];
    }
  }
}

void Smoother::MarkNeighbours(int point)
{
  this->Mark(point);
  this->Mesh.ForNear(point, [this](int other) { this->Mark(other); });
}

void Smoother::ReportMoves(MeshReport& report) const
{
  std::vector<std::int64_t> sums{ this->NumberOfPoints, this->NumberOfVisits };
  this->Run.Group().Sum(sums);
  report.SmoothedPoints = sums[0];
  report.Sweeps = this->NumberOfSweeps;
  report.Visits = sums[1];
}

} // namespace vfm
