#include "Smoothing/Guard.h"

#include "Smoothing/ForFlagged.h"

#include <atomic>

namespace vfm
{
namespace
{

constexpr int Rings = 2; // around points that go back, and around those again

void Add(const std::vector<unsigned char>& flags, std::vector<unsigned char>& to)
{
  std::transform(flags.begin(), flags.end(), to.begin(), to.begin(), std::bit_or<unsigned char>());
}

} // namespace

void Guard::NoteMoved(const Flags& points)
{
  if (!this->Unchecked.empty())
  {
    Add(points, this->Unchecked);
  }
}

/// Marks the active points of lost elements. Returns whether any is not known, on any rank.
/// @param where  points at whose elements it looks; empty: all
bool Guard::MarkLost(
  const Flags& known, const Flags& returned, const Flags& where, Flags& lost) const
{
  lost.assign(this->Mesh.X.size(), 0);
  bool isNew = false;
  if (this->Energy.MarkLost(this->Mesh, this->Run, returned, where, lost))
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

/// Adds rings of points. Only owners know all elements at a point, so they decide. Begins at the
/// flagged points, which are few.
void Guard::Grow(int rings, Flags& flags) const
{
  const std::vector<CornerPosition>& corners = this->Mesh.CornerOffset;
  this->Exchange(flags);
  for (int ring = 0; ring < rings; ++ring)
  {
    Flags reached(flags.size(), 0);
    ForFlagged(this->Run, flags,
      [&](Index p)
      {
        // A ghost may have no element here.
        if (this->Mesh.IsActive[p] && corners[p] < corners[p + 1])
        {
          this->Mesh.ForAround(static_cast<int>(p),
            [&](int other) { __atomic_store_n(&reached[other], 1, __ATOMIC_RELAXED); });
        }
      });
    this->Mesh.ForOwned(this->Run, [&](int p) { flags[p] |= reached[p] & this->Mesh.IsActive[p]; });
    this->Exchange(flags);
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
    ForFlagged(this->Run, lost, [&](Index p) { points[p] = before[p]; });
    Add(lost, this->PutBackNow);
    rings = laterRings;
  } while (findMore(lost));
}

bool Guard::PutBack(const std::vector<Vector3>& before, std::vector<Vector3>& points)
{
  Flags lost;
  const bool isNew = this->MarkLost(this->Guarded, {}, this->Unchecked, lost);
  this->Unchecked = lost;
  if (!isNew)
  {
    return false;
  }
  // All points of lost elements go back, so others are lost only at points that went back.
  this->Return(lost, before, points, 0,
    [&](Flags& more)
    { return this->MarkLost(this->PutBackNow, this->PutBackNow, this->PutBackNow, more); });
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
      const bool isLost = this->MarkLost(this->PutBackNow, {}, {}, more);
      return this->MarkNegative(this->PutBackNow, stage, more) || isLost;
    });
}

} // namespace vfm
