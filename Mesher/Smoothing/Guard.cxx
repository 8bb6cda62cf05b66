#include "Smoothing/Guard.h"

#include <atomic>

namespace vfm
{
namespace
{

constexpr int Rings = 2; // around points that go back, and around those again

void Add(const std::vector<unsigned char>& flags, std::vector<unsigned char>& to)
{
  for (std::size_t p = 0; p < flags.size(); ++p)
  {
    to[p] |= flags[p];
  }
}

} // namespace

/// Marks the active points of lost elements. Returns whether any is not known, on any rank.
bool Guard::MarkLost(const Flags& known, const Flags& returned, Flags& lost) const
{
  lost.assign(this->Mesh.X.size(), 0);
  bool isNew = false;
  if (this->Energy.MarkLost(this->Mesh, this->Run, returned, lost))
  {
    for (std::size_t p = 0; p < lost.size(); ++p)
    {
      lost[p] &= this->Mesh.IsActive[p];
    }
    this->Mesh.ForOwned([&](int p) { isNew = isNew || (lost[p] && (known.empty() || !known[p])); });
  }
  return this->Run.Group().Any(isNew);
}

/// Adds the points that were put back and have an element that is not positive. Returns whether
/// there is one, on any rank.
bool Guard::MarkNegative(const Flags& returned, const SmoothingStage& stage, Flags& lost) const
{
  std::atomic<bool> isNegative(false);
  this->Mesh.ForOwned(this->Run,
    [&](int p)
    {
      if (returned[p] &&
        this->Energy.Evaluate(this->Mesh, p, this->Mesh.X[p], stage) >= InvalidEnergy)
      {
        lost[p] = 1;
        isNegative = true;
      }
    });
  return this->Run.Group().Any(isNegative);
}

/// Sets the flags of ghosts to those of their owners.
void Guard::Exchange(Flags& flags) const
{
  this->Mesh.Exchange.SendAll(
    [&](int p) { return flags[p]; }, [&](int p, unsigned char flag) { flags[p] = flag; });
}

/// Adds rings of points. Only owners know all elements at a point, so they decide.
void Guard::Grow(int rings, Flags& flags) const
{
  this->Exchange(flags);
  for (int ring = 0; ring < rings; ++ring)
  {
    Flags grown = flags;
    this->Mesh.ForOwned(this->Run,
      [&](int p)
      {
        if (this->Mesh.IsActive[p])
        {
          this->Mesh.ForAround(
            p, [&](int other) { grown[p] |= flags[other] && this->Mesh.IsActive[other]; });
        }
      });
    this->Exchange(grown);
    flags.swap(grown);
  }
}

/// Puts the lost points back, with two rings of points around them. While findMore(lost) finds more
/// points, puts these back with other rings.
template <class FindMore>
void Guard::Return(Flags& lost, const std::vector<Vector3>& before, std::vector<Vector3>& points,
  int laterRings, const FindMore& findMore)
{
  this->PutBackNow.assign(points.size(), 0);
  int rings = Rings;
  do
  {
    this->Grow(rings, lost);
    for (std::size_t p = 0; p < points.size(); ++p)
    {
      points[p] = lost[p] ? before[p] : points[p];
    }
    Add(lost, this->PutBackNow);
    rings = laterRings;
  } while (findMore(lost));
}

bool Guard::PutBack(const std::vector<Vector3>& before, std::vector<Vector3>& points)
{
  Flags lost;
  if (!this->MarkLost(this->Guarded, {}, lost))
  {
    return false;
  }
  this->Return(lost, before, points, 0,
    [&](Flags& more) { return this->MarkLost(this->PutBackNow, this->PutBackNow, more); });
  Flags guarded = this->PutBackNow;
  this->Grow(Rings, guarded);
  this->Guarded.resize(points.size(), 0);
  Add(guarded, this->Guarded);
  return true;
}

void Guard::PutBack(std::vector<unsigned char> points, const std::vector<Vector3>& before,
  std::vector<Vector3>& now, const SmoothingStage& stage)
{
  this->Return(points, before, now, Rings,
    [&](Flags& more)
    {
      const bool isLost = this->MarkLost(this->PutBackNow, {}, more);
      return this->MarkNegative(this->PutBackNow, stage, more) || isLost;
    });
}

} // namespace vfm
