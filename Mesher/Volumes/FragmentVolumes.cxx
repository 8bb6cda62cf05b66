#include "Volumes/FragmentVolumes.h"

#include "Base/PortableMath.h"
#include "Fractions/RowVolumes.h"

#include <mutex>
#include <tuple>

namespace vfm
{
namespace
{

// Largest part of its target by which a fragment compensates for resisting fragments.
constexpr double LargestTakeover = 0.1;
// Relative error above which a push is in vain and only makes elements worse.
constexpr double LargestPushedError = 0.5;

std::vector<double> Multiplied(std::vector<double> values, double factor)
{
  for (double& value : values)
  {
    value *= factor;
  }
  return values;
}

} // namespace

int FindNearestCell(const CartesianGrid& grid, const Index3& cell,
  const std::function<int(const Index3&)>& fragmentOf)
{
  int best = 0;
  Index nearest = 4;
  for (Index c = 0; c < 27; ++c)
  {
    const Index3 d{ { c % 3 - 1, c / 3 % 3 - 1, c / 9 - 1 } };
    const Index3 q{ { cell[0] + d[0], cell[1] + d[1], cell[2] + d[2] } };
    const Index distance = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
    const int fragment = distance < nearest && grid.HexBox().Contains(q) ? fragmentOf(q) : 0;
    if (fragment > 0)
    {
      best = fragment;
      nearest = distance;
    }
  }
  return best;
}

namespace
{

/// Sums the target volumes of the owned cells.
class TargetSums
{
public:
  TargetSums(const CartesianGrid& grid, const FractionField& fractions,
    const std::vector<int>& materials, const FragmentLocator& locator, bool leavesFar) :
    Targets(materials.size()),
    Cells(materials.size()),
    Totals(fractions.NumberOfMaterials() + 1),
    Grid(grid),
    Fractions(fractions),
    Materials(materials),
    Locator(locator),
    Volumes(grid),
    LeavesFar(leavesFar),
    VoidIsMeshed(std::find(materials.begin() + 1, materials.end(), 0) != materials.end())
  {
  }

  void AddRow(Index j, Index k)
  {
    this->Volumes.Start(j, k);
    this->Locator.ForRuns(j, k,
      [&](Index first, Index last, int fragment) { this->AddRun(first, last, j, k, fragment); });
  }

  std::vector<ExactSum> Targets; // target of each fragment, [0] unused
  std::vector<ExactSum> Cells;   // volume of the cells of each fragment
  std::vector<ExactSum> Totals;  // total of each material
  std::vector<FarMatter> Far;

  void Add(const TargetSums& other)
  {
    this->Far.insert(this->Far.end(), other.Far.begin(), other.Far.end());
    AddAll(other.Targets, this->Targets);
    AddAll(other.Cells, this->Cells);
    AddAll(other.Totals, this->Totals);
  }

private:
  static void AddAll(const std::vector<ExactSum>& from, std::vector<ExactSum>& to)
  {
    for (std::size_t i = 0; i < from.size(); ++i)
    {
      to[i].Add(from[i]);
    }
  }

  bool IsOwn(int fragment, int material) const
  {
    return fragment > 0 ? this->Materials[fragment] == material
                        : material == 0 && !this->VoidIsMeshed;
  }

  template <class Volume>
  void Add(int fragment, int material, const Volume& volume)
  {
    this->Totals[material].Add(volume);
    if (fragment > 0)
    {
      this->Targets[fragment].Add(volume);
    }
  }

  void AddPart(const Index3& p, int fragment, int material, double fraction, double volume)
  {
    const int own =
      this->IsOwn(fragment, material) ? fragment : this->Locator.FindNear(p, material);
    this->Add(own, material, volume);
    if (this->LeavesFar && own == 0 && material > 0 && fraction > 0.0)
    {
      this->Far.push_back({ this->Grid.CellKey(p), material, fraction * this->Grid.CellVolume(p) });
    }
  }

  void AddCell(const Index3& p, int fragment)
  {
    const Index cell = this->Grid.Linear(p);
    const double volume = this->Volumes.OfCell(p);
    this->Fractions.ForParts(cell,
      [&](int material, double fraction)
      { this->AddPart(p, fragment, material, fraction, fraction * volume); });
  }

  void AddRun(Index first, Index last, Index j, Index k, int fragment)
  {
    first = std::max(first, this->Grid.Owned().Lower[0]);
    last = std::min(last, this->Grid.Owned().Upper[0]);
    if (first >= last)
    {
      return;
    }
    this->Cells[fragment].Add(this->Volumes.Of(first, last));
    const Index row = this->Grid.Linear({ { 0, j, k } });
    const auto addCells = [&](Index begin, Index end)
    {
      for (Index cell = begin; cell < end; ++cell)
      {
        this->AddCell({ { cell - row, j, k } }, fragment);
      }
    };
    this->Fractions.Visit(
      row + first, row + last,
      [&](Index begin, Index end, int label)
      {
        if (this->IsOwn(fragment, label))
        {
          this->Add(fragment, label, this->Volumes.Of(begin - row, end - row));
          return;
        }
        addCells(begin, end);
      },
      addCells);
  }

  const CartesianGrid& Grid;
  const FractionField& Fractions;
  const std::vector<int>& Materials;
  const FragmentLocator& Locator;
  RowVolumes Volumes;
  bool LeavesFar, VoidIsMeshed;
};

} // namespace

FragmentVolumes::FragmentVolumes(const CartesianGrid& grid, const FractionField& fractions,
  FragmentShare share, const FragmentLocator& locator, bool leavesFar, Runtime& runtime) :
  Fragments(std::make_shared<const FragmentShare>(std::move(share))),
  Run(runtime),
  Swept(this->Fragments->Size(), 0.0)
{
  const IndexBox& owned = grid.Owned();
  const Index rows = owned.NumberOfCells() > 0 ? owned.Size(1) * owned.Size(2) : 0;
  TargetSums sums(grid, fractions, this->Fragments->Materials, locator, leavesFar);
  std::mutex lock;
  runtime.For(0, rows,
    [&](Index first, Index last)
    {
      TargetSums own(grid, fractions, this->Fragments->Materials, locator, leavesFar);
      for (Index row = first; row < last; ++row)
      {
        own.AddRow(owned.Lower[1] + row % owned.Size(1), owned.Lower[2] + row / owned.Size(1));
      }
      const std::lock_guard<std::mutex> guard(lock);
      sums.Add(own);
    });
  this->Targets = this->Fragments->Sum(std::move(sums.Targets));
  this->StartVolumes = this->Fragments->Sum(std::move(sums.Cells));
  this->TotalOfMaterial = SumOverRanks(sums.Totals, runtime.Group());
  this->Far = std::move(sums.Far);
  std::sort(this->Far.begin(), this->Far.end(),
    [](const FarMatter& a, const FarMatter& b)
    { return std::tie(a.Cell, a.Material) < std::tie(b.Cell, b.Material); });
  this->DistributeOrphans(leavesFar);
  this->Aims = this->Targets;
  this->Resists.assign(this->Targets.size(), 0);
}

/// Sums valueOf(fragment) over the fragments of each material on all ranks.
template <class ValueOf>
std::vector<double> FragmentVolumes::SumByMaterial(const ValueOf& valueOf) const
{
  std::vector<ExactSum> sums(this->TotalOfMaterial.size());
  for (int f = 1; f < static_cast<int>(this->Targets.size()); ++f)
  {
    if (this->Fragments->IsMine[f])
    {
      sums[this->Fragments->Materials[f]].Add(valueOf(f));
    }
  }
  return SumOverRanks(sums, this->Run.Group());
}

/// Distributes fractions without a cell of their material nearby to all fragments of the material,
/// in proportion to their targets, or takes them from the totals.
void FragmentVolumes::DistributeOrphans(bool leavesFar)
{
  const std::vector<double> found =
    this->SumByMaterial([this](int fragment) { return this->Targets[fragment]; });
  if (leavesFar)
  {
    std::copy(found.begin() + 1, found.end(), this->TotalOfMaterial.begin() + 1);
  }
  for (std::size_t f = 1; f < this->Targets.size(); ++f)
  {
    const int m = this->Fragments->Materials[f];
    this->Targets[f] *= found[m] > 0.0 ? this->TotalOfMaterial[m] / found[m] : 1.0;
  }
}

void FragmentVolumes::Measure(const ActiveMesh& mesh)
{
  this->ForgetRequests();
  this->Facets.Start(mesh, this->Targets.size(), this->Run);
  this->System = IslandSystem(*this->Fragments, this->Facets.Areas());
  this->SumFacets();
}

void FragmentVolumes::Measure(const ActiveMesh& mesh, const std::vector<unsigned char>& moved)
{
  this->Facets.Update(mesh, moved, this->Run);
  this->SumFacets();
}

void FragmentVolumes::SetBulges(std::vector<double> bulges)
{
  this->Bulges = std::move(bulges);
  this->SetAims();
}

/// Sums over the ranks.
void FragmentVolumes::SumFacets()
{
  std::vector<ExactSum> swept = this->Facets.Swept();
  this->Areas = this->System.SumAreas(this->Facets.Areas(), swept);
  this->Swept = ValuesOf(swept);
  this->SetAims();
}

/// Returns the factor by which a fragment is asked for more than it lacks.
double FragmentVolumes::FactorOf(int fragment, double largest, bool insists) const
{
  const Request& last = this->Requests[fragment];
  if (last.Change == 0.0)
  {
    return 1.0;
  }
  const double part = (this->VolumeOf(fragment) - last.Volume) / last.Change;
  if (part * largest <= 1.0)
  {
    return insists ? largest : 1.0;
  }
  return std::max(1.0, 1.0 / part);
}

/// Returns by how much the volume of each fragment is asked to change; [0] is the outside.
std::vector<double> FragmentVolumes::FindRequests(const VolumeRules& rules) const
{
  std::vector<double> requests(this->Targets.size(), 0.0);
  for (int f = 1; f < static_cast<int>(requests.size()); ++f)
  {
    const VolumeRule& rule = this->IsSmall(f) ? rules.Small : rules.Large;
    const bool isPushed = rules.Insists && this->IsPushed(f);
    if (isPushed || !(this->ErrorOf(f) <= rule.Tolerance))
    {
      const double aim = isPushed ? this->Targets[f] : this->Aims[f];
      requests[f] =
        this->FactorOf(f, rule.LargestFactor, rules.Insists) * (aim - this->VolumeOf(f));
    }
  }
  return requests;
}

std::vector<double> FragmentVolumes::FindShifts(const ActiveMesh& mesh, const VolumeRules& rules)
{
  const std::vector<double> requests = this->FindRequests(rules);
  std::vector<double> lack(requests.size(), 0.0);
  for (std::size_t f = 1; f < lack.size(); ++f)
  {
    lack[f] = this->Resists[f] ? 0.0 : requests[f];
    this->Requests[f] = { requests[f], this->VolumeOf(static_cast<int>(f)) };
  }
  std::vector<double> mu = this->System.Solve(this->Areas, lack);
  if (rules.Insists)
  {
    this->AddPushes(requests, mu);
  }
  std::vector<double> shifts(mesh.Attachments.size());
  ForEach(this->Run, shifts.size(),
    [&](Index i)
    {
      const auto& [first, second] = mesh.Attachments[i].Fragments;
      shifts[i] = mu[first] - mu[second];
    });
  return shifts;
}

void FragmentVolumes::AddPushes(const std::vector<double>& requests, std::vector<double>& mu) const
{
  std::vector<ExactSum> sums(mu.size());
  // A rank does not know all pairs of a fragment, so each adds its own parts.
  for (const auto& [pair, area] : this->Facets.Areas())
  {
    sums[pair.first].Add(area);
    sums[pair.second].Add(area);
  }
  const std::vector<double> areas = this->Fragments->Sum(std::move(sums));
  for (std::size_t f = 1; f < mu.size(); ++f)
  {
    mu[f] += this->Resists[f] && areas[f] > 0.0 ? requests[f] / areas[f] : 0.0;
  }
}

double FragmentVolumes::ErrorOf(int fragment) const
{
  return std::fabs(this->VolumeOf(fragment) - this->Aims[fragment]) / this->Aims[fragment];
}

double FragmentVolumes::WorstFragmentError() const
{
  double worst = 0.0;
  for (int f = 1; f < static_cast<int>(this->Targets.size()); ++f)
  {
    worst = std::max(worst, this->ErrorOf(f));
  }
  return this->Run.Group().Max(worst);
}

bool FragmentVolumes::IsPushed(int fragment) const
{
  const double target = this->Targets[fragment];
  return this->Resists[fragment] &&
    std::fabs(this->VolumeOf(fragment) - target) <= LargestPushedError * target;
}

bool FragmentVolumes::HasPushed() const
{
  bool isAny = false;
  for (int f = 1; f < static_cast<int>(this->Targets.size()); ++f)
  {
    isAny = isAny || this->IsPushed(f);
  }
  return this->Run.Group().Any(isAny);
}

std::vector<unsigned char> FragmentVolumes::FindOff(double error) const
{
  std::vector<unsigned char> isOff(this->Targets.size(), 0);
  for (std::size_t f = 1; f < isOff.size(); ++f)
  {
    isOff[f] = std::fabs(this->VolumeOf(f) - this->Targets[f]) > error * this->Targets[f];
  }
  return isOff;
}

double FragmentVolumes::SumErrors(const std::vector<unsigned char>& fragments) const
{
  ExactSum sum;
  for (std::size_t f = 1; f < fragments.size(); ++f)
  {
    const bool counts = fragments[f] && this->Fragments->IsMine[f];
    sum.Add(counts ? std::fabs(this->VolumeOf(f) - this->Targets[f]) : 0.0);
  }
  return SumOverRanks(std::vector<ExactSum>{ sum }, this->Run.Group())[0];
}

void FragmentVolumes::ForgetResisting(const std::vector<unsigned char>& fragments)
{
  for (std::size_t f = 1; f < fragments.size(); ++f)
  {
    this->Resists[f] &= !fragments[f];
  }
  this->SetAims();
}

void FragmentVolumes::MarkResisting(double error)
{
  for (int f = 1; f < static_cast<int>(this->Targets.size()); ++f)
  {
    this->Resists[f] |= !(this->ErrorOf(f) <= error);
  }
  this->Tolerance = error;
  this->SetAims();
}

std::vector<double> FragmentVolumes::FindScales(double error) const
{
  std::vector<double> scales(this->Targets.size(), 1.0);
  for (int f = 1; f < static_cast<int>(scales.size()); ++f)
  {
    const double aim = this->Resists[f] ? this->Targets[f] : this->Aims[f];
    const double volume = this->VolumeOf(f);
    if (this->IsSmall(f) && volume > 0.0 && std::fabs(volume - aim) > error * aim)
    {
      scales[f] = CubeRoot(aim / volume);
    }
  }
  return scales;
}

/// Ends the marks of fragments that have reached their targets, and sets the aims of all fragments.
void FragmentVolumes::SetAims()
{
  for (int f = 1; f < static_cast<int>(this->Targets.size()); ++f)
  {
    const double target = this->Targets[f], missing = target - this->VolumeOf(f);
    this->Resists[f] &= !(std::fabs(missing) <= this->Tolerance * target);
  }
  const std::vector<double> lack = this->SumByMaterial(
    [this](int f) { return this->Resists[f] ? this->Targets[f] - this->VolumeOf(f) : 0.0; });
  const std::vector<double> free =
    this->SumByMaterial([this](int f) { return this->Resists[f] ? 0.0 : this->Targets[f]; });
  for (int f = 1; f < static_cast<int>(this->Targets.size()); ++f)
  {
    const int m = this->Fragments->Materials[f];
    const double takeover =
      free[m] > 0.0 ? std::clamp(lack[m] / free[m], -LargestTakeover, LargestTakeover) : 0.0;
    this->Aims[f] = this->Resists[f] ? this->VolumeOf(f) : (1.0 + takeover) * this->Targets[f];
  }
}

double FragmentVolumes::WorstError() const
{
  double worst = 0.0;
  for (int f = 1; f < static_cast<int>(this->Targets.size()); ++f)
  {
    worst = this->IsSmall(f) ? worst : std::max(worst, this->ErrorOf(f));
  }
  worst = this->Run.Group().Max(worst);
  const std::vector<double> volumes = this->MaterialVolumes();
  const std::vector<double> aims =
    this->SumByMaterial([this](int fragment) { return this->Aims[fragment]; });
  for (std::size_t m = 1; m < volumes.size(); ++m)
  {
    if (volumes[m] > 0.0)
    {
      worst = std::max(worst, std::fabs(volumes[m] - aims[m]) / aims[m]);
    }
  }
  return worst;
}

std::vector<double> FragmentVolumes::MaterialVolumes() const
{
  return this->SumByMaterial([this](int fragment) { return this->VolumeOf(fragment); });
}

std::vector<Index> FragmentVolumes::MaterialFragments() const
{
  std::vector<Index> fragments(this->TotalOfMaterial.size(), 0);
  for (std::size_t f = 1; f < this->Targets.size(); ++f)
  {
    fragments[this->Fragments->Materials[f]] += this->Fragments->IsMine[f];
  }
  this->Run.Group().Sum(fragments);
  return fragments;
}

void ReportVolumes(const CartesianGrid& grid, const FragmentVolumes& volumes, MeshReport& report)
{
  const double cellVolume = Cube(grid.MeanWidth());
  report.TargetVolume = Multiplied(volumes.MaterialTargets(), cellVolume);
  report.MeshVolume = Multiplied(volumes.MaterialVolumes(), cellVolume);
  const FragmentShare& share = volumes.Share();
  for (std::size_t f = 1; f < share.Size(); ++f)
  {
    if (share.IsMine[f])
    {
      report.Fragments.Ids.push_back(share.Ids[f]);
      report.Fragments.Volumes.push_back(cellVolume * volumes.FragmentTargets()[f]);
    }
  }
  for (Index fragments : volumes.MaterialFragments())
  {
    report.Materials.push_back({ 0, fragments });
  }
}

} // namespace vfm
