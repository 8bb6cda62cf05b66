#include "Volumes/ScaleFragments.h"

#include "Base/ExactSum.h"

#include <atomic>

namespace vfm
{
namespace
{

constexpr double LargestFactor = 3.0; // of lengths
// Energy of the elements at a point up to which any scaling is accepted.
constexpr double LargestEnergy = 20.0;
constexpr double Rounding = 1e-9; // of positions, in mean cells
constexpr double NoLimit = 1e300;

/// Scales the fragments of a mesh whose factor is not 1.
class Scaling
{
public:
  Scaling(const ElementEnergy& energy, const SmoothingStage& stage, const FragmentShare& share,
    std::vector<double> factors, Runtime& runtime, ActiveMesh& mesh) :
    Energy(energy),
    Stage(stage),
    Share(share),
    Factors(std::move(factors)),
    Run(runtime),
    Mesh(mesh),
    Leaves(Factors.size(), 0)
  {
  }

  /// Scales the fragments that may be scaled.
  void Apply();
  /// Shifts the targets of the points that have moved to where they are now. Returns these points.
  std::vector<int> ShiftTargets(const SurfaceTargets& targets);

private:
  bool IsScaled(int fragment) const { return this->Factors[fragment] != 1.0; }
  bool AreAny() const // on any rank
  {
    return this->Run.Group().Any(std::any_of(
      this->Factors.begin(), this->Factors.end(), [](double factor) { return factor != 1.0; }));
  }
  void Leave(int fragment) { __atomic_store_n(&this->Leaves[fragment], 1, __ATOMIC_RELAXED); }
  bool LeaveMarked();
  void LeaveTouching();
  void LabelSurfaces();
  bool LabelRing();
  int FindLabelAround(int point) const;
  int LabelAt(int point) const
  {
    return __atomic_load_n(&this->FragmentOf[point], __ATOMIC_RELAXED);
  }
  void ListPoints();
  void KeepScaledPoints();
  void FindTranslations();
  Vector3 Scaled(int point, const Vector3& x) const;
  void Move();
  bool MayStay(std::size_t n) const;
  void SendPositions();
  bool LeavePoor();
  void PutBack();
  /// Calls visit(corners) for the elements at a point that are not only a barrier.
  template <class Visitor>
  void ForElements(int point, const Visitor& visit) const
  {
    for (CornerPosition at = this->Mesh.CornerOffset[point];
         at < this->Mesh.CornerOffset[point + 1]; ++at)
    {
      const CornerPosition position = this->Mesh.CornerList[at];
      if (!this->Mesh.IsBarrierAt(position))
      {
        visit(
          this->Mesh.Elements.data() + Index(this->Mesh.ElementAt(position)) * this->Mesh.Corners);
      }
    }
  }

  const ElementEnergy& Energy;
  const SmoothingStage& Stage;
  const FragmentShare& Share;
  std::vector<double> Factors;
  Runtime& Run;
  ActiveMesh& Mesh;
  std::vector<unsigned char> Leaves; // fragments that are not to be scaled after all
  std::vector<Vector3> Translations; // of each fragment: x becomes factor * x + translation
  std::vector<int> FragmentOf;       // fragment of each point, 0 if it stays
  std::vector<int> Points;           // points of this rank with a fragment
  std::vector<Vector3> Before;       // their positions
  std::vector<double> Energies;      // their energies there
};

/// Leaves the marked fragments as they are. Returns whether there were any, on any rank.
bool Scaling::LeaveMarked()
{
  this->Share.Unite(this->Leaves);
  bool leaves = false;
  for (std::size_t f = 0; f < this->Leaves.size(); ++f)
  {
    leaves = leaves || (this->Leaves[f] && this->Factors[f] != 1.0);
    this->Factors[f] = this->Leaves[f] ? 1.0 : this->Factors[f];
  }
  std::fill(this->Leaves.begin(), this->Leaves.end(), 0);
  return this->Run.Group().Any(leaves);
}

void Scaling::LeaveTouching()
{
  for (const ActiveFacet& facet : this->Mesh.Facets)
  {
    if (facet.Fragments[0] > 0 && facet.Fragments[1] > 0)
    {
      this->Leave(facet.Fragments[0]);
      this->Leave(facet.Fragments[1]);
    }
  }
  for (std::size_t f = 0; f < this->Factors.size(); ++f)
  {
    if (!(this->Factors[f] >= 1.0 / LargestFactor && this->Factors[f] <= LargestFactor))
    {
      this->Leave(static_cast<int>(f));
    }
  }
  this->LeaveMarked();
}

/// Labels the points of surfaces. Leaves fragments that touch others only at points or edges.
void Scaling::LabelSurfaces()
{
  this->Mesh.ForOwned(
    [this](int point)
    {
      const auto begin = this->Mesh.Attachments.begin();
      int known = 0;
      std::for_each(begin + this->Mesh.AttachmentOffset[point],
        begin + this->Mesh.AttachmentOffset[point + 1],
        [&](const Attachment& a)
        {
          const int fragment = std::max(a.Fragments[0], a.Fragments[1]);
          if (known > 0 && known != fragment)
          {
            this->Leave(known);
            this->Leave(fragment);
          }
          known = fragment;
        });
      this->FragmentOf[point] = this->IsScaled(known) ? known : 0;
    });
}

/// Labels the points next to labelled ones in elements. Returns whether there are any, on any rank.
bool Scaling::LabelRing()
{
  this->Mesh.Exchange.SendPositions([this](int p) { return this->Share.Ids[this->FragmentOf[p]]; },
    [this](int p, int id, const Vector3& translation)
    {
      const int fragment = this->Share.Find(id);
      this->FragmentOf[p] = fragment;
      if (translation != Vector3{})
      {
        this->Leave(fragment); // the mean of its points is not inside it
      }
    });
  const std::vector<CornerPosition>& corners = this->Mesh.CornerOffset;
  std::vector<unsigned char> isReached(this->FragmentOf.size(), 0); // from labelled points
  std::atomic<bool> areUnknown(false); // some points around labelled ones
  ForEach(this->Run, this->FragmentOf.size(),
    [&](Index point)
    {
      if (this->FragmentOf[point] == 0)
      {
        return;
      }
      if (corners[point] == corners[point + 1])
      {
        areUnknown = true;
        return;
      }
      this->Mesh.ForAround(static_cast<int>(point),
        [&](int other) { __atomic_store_n(&isReached[other], 1, __ATOMIC_RELAXED); });
    });
  std::atomic<bool> isNew(false);
  this->Mesh.ForOwned(this->Run,
    [&](int point)
    {
      const bool mayBeNew = (isReached[point] || areUnknown) && this->LabelAt(point) == 0;
      const int fragment = mayBeNew ? this->FindLabelAround(point) : 0;
      if (fragment != 0)
      {
        __atomic_store_n(&this->FragmentOf[point], fragment, __ATOMIC_RELAXED);
        isNew = true;
      }
    });
  return this->Run.Group().Any(isNew);
}

/// Returns the label of the elements at a point. The order in which points are labelled does not
/// matter, because all points of an element belong to one fragment.
int Scaling::FindLabelAround(int point) const
{
  int fragment = 0;
  this->ForElements(point,
    [&](const int* corners)
    {
      for (int c = 0; c < this->Mesh.Corners; ++c)
      {
        fragment = std::max(fragment, this->LabelAt(corners[c]));
      }
    });
  return fragment;
}

/// Lists the labelled points. Leaves fragments that have other points, too.
void Scaling::ListPoints()
{
  this->Mesh.ForOwned(
    [this](int point)
    {
      const int fragment = this->FragmentOf[point];
      if (fragment == 0)
      {
        return;
      }
      this->Points.push_back(point);
      bool isWhole = true;
      this->ForElements(point,
        [&](const int* corners)
        {
          isWhole = isWhole &&
            std::all_of(corners, corners + this->Mesh.Corners,
              [&](int corner) { return this->FragmentOf[corner] == fragment; });
        });
      if (!isWhole)
      {
        this->Leave(fragment);
      }
    });
}

/// Finds translations that keep the means of the points in place, or else as near as the limits of
/// the points permit. Leaves fragments whose points cannot all stay within their limits.
void Scaling::FindTranslations()
{
  const std::size_t count = this->Factors.size();
  std::vector<ExactSum> sums(4 * count);           // of positions along each axis, and their number
  std::vector<double> limits(6 * count, -NoLimit); // lower limits, and minus the upper ones
  for (int point : this->Points)
  {
    const int at = this->FragmentOf[point];
    const MoveBounds range = this->Mesh.RangeOf(point);
    sums[4 * at + 3].Add(1.0);
    for (int a = 0; a < 3; ++a)
    {
      const double x = this->Mesh.X[point][a], scaled = this->Factors[at] * x;
      sums[4 * at + a].Add(x);
      double* own = &limits[6 * at + a];
      own[0] = std::max(own[0], range.Lower[a] - scaled);
      own[3] = std::max(own[3], scaled - range.Upper[a]);
    }
  }
  const std::vector<double> means = this->Share.Sum(std::move(sums), 4);
  this->Share.Merge(limits, 6, [](double& a, double b) { a = std::max(a, b); });
  this->Translations.resize(count);
  for (std::size_t f = 0; f < count; ++f)
  {
    for (int a = 0; a < 3 && this->Factors[f] != 1.0; ++a)
    {
      const double lower = limits[6 * f + a], upper = -limits[6 * f + 3 + a];
      const double still = (1.0 - this->Factors[f]) * means[4 * f + a] / means[4 * f + 3];
      this->Translations[f][a] = std::max(lower, std::min(upper, still));
      if (!(lower <= upper + Rounding))
      {
        this->Leave(static_cast<int>(f));
      }
    }
  }
}

/// Returns the position of a labelled point after its fragment is scaled.
Vector3 Scaling::Scaled(int point, const Vector3& x) const
{
  const int fragment = this->FragmentOf[point];
  Vector3 scaled = this->Factors[fragment] * x + this->Translations[fragment];
  for (int a = 0; a < 3; ++a)
  {
    scaled[a] = this->Mesh.Fixed[point] >> a & 1 ? x[a] : scaled[a];
  }
  return scaled;
}

/// Removes the points of fragments that are not scaled.
void Scaling::KeepScaledPoints()
{
  this->Points.erase(std::remove_if(this->Points.begin(), this->Points.end(),
                       [this](int point) { return !this->IsScaled(this->FragmentOf[point]); }),
    this->Points.end());
}

/// Moves the points of all fragments that may move as a whole.
void Scaling::Move()
{
  this->LeaveMarked();
  this->KeepScaledPoints();
  this->Before.resize(this->Points.size());
  this->Energies.resize(this->Points.size());
  ForEach(this->Run, this->Points.size(),
    [this](Index n)
    {
      const int point = this->Points[n];
      this->Before[n] = this->Mesh.X[point];
      this->Energies[n] = this->Energy.Evaluate(this->Mesh, point, this->Before[n], this->Stage);
    });
  for (std::size_t n = 0; n < this->Points.size(); ++n)
  {
    this->Mesh.X[this->Points[n]] = this->Scaled(this->Points[n], this->Before[n]);
  }
  this->SendPositions();
}

void Scaling::SendPositions()
{
  this->Mesh.Exchange.SendPositions([this](int p) { return this->Mesh.X[p]; },
    [this](int p, const Vector3& x, const Vector3& translation)
    { this->Mesh.X[p] = x + translation; });
}

/// Returns whether the elements at point n that has moved are good enough.
bool Scaling::MayStay(std::size_t n) const
{
  const int point = this->Points[n];
  const Vector3& x = this->Mesh.X[point];
  return this->Energy.Evaluate(this->Mesh, point, x, this->Stage) <=
    std::max(LargestEnergy, this->Energies[n]) &&
    this->Energy.KeepsAt(this->Mesh, point, x);
}

/// Leaves the fragments with elements that are not good enough. Returns whether there are any, on
/// any rank.
bool Scaling::LeavePoor()
{
  ForEach(this->Run, this->Points.size(),
    [this](Index n)
    {
      const int fragment = this->FragmentOf[this->Points[n]];
      if (this->IsScaled(fragment) && !this->MayStay(n))
      {
        this->Leave(fragment);
      }
    });
  return this->LeaveMarked();
}

/// Puts fragments back until all elements are good enough.
void Scaling::PutBack()
{
  while (this->LeavePoor())
  {
    for (std::size_t n = 0; n < this->Points.size(); ++n)
    {
      const int point = this->Points[n];
      this->Mesh.X[point] =
        this->IsScaled(this->FragmentOf[point]) ? this->Mesh.X[point] : this->Before[n];
    }
    this->SendPositions();
  }
}

void Scaling::Apply()
{
  this->LeaveTouching();
  if (!this->AreAny())
  {
    return;
  }
  this->FragmentOf.assign(this->Mesh.X.size(), 0);
  this->LabelSurfaces();
  while (this->LabelRing())
  {
  }
  this->ListPoints();
  this->LeaveMarked();
  this->KeepScaledPoints();
  this->FindTranslations();
  this->Move();
  this->PutBack();
}

std::vector<int> Scaling::ShiftTargets(const SurfaceTargets& targets)
{
  this->KeepScaledPoints();
  ForEach(this->Run, this->Points.size(),
    [&](Index n)
    {
      const int point = this->Points[n];
      const std::vector<CornerPosition>& offsets = this->Mesh.AttachmentOffset;
      for (Index i = offsets[point]; i < offsets[point + 1]; ++i)
      {
        Attachment& a = this->Mesh.Attachments[i];
        Vector3 gradient;
        a.Offset = targets.Distance(a.Target, this->Mesh.X[point], gradient);
      }
    });
  return std::move(this->Points);
}

} // namespace

std::vector<int> ScaleFragments(const SurfaceTargets& targets, const ElementEnergy& energy,
  const SmoothingStage& stage, const FragmentShare& share, std::vector<double> factors,
  Runtime& runtime, ActiveMesh& mesh)
{
  Scaling scaling(energy, stage, share, std::move(factors), runtime, mesh);
  scaling.Apply();
  return scaling.ShiftTargets(targets);
}

} // namespace vfm
