#include "Volumes.h"

#include "Vector3.h"

#include <Eigen/SparseCholesky>

namespace vfm
{
namespace
{

constexpr double LargeFragment = 64.0; // cells; smaller ones do not count in WorstError

/// Volume of the trilinear hex from the quad a to the quad b, by Gauss's rule of 2x2x2 points (exact).
double VolumeBetween(const std::array<Vector3, 4>& a, const std::array<Vector3, 4>& b)
{
  const double low = 0.5 - 0.5 / std::sqrt(3.0);
  double volume = 0.0;
  for (int g = 0; g < 8; ++g)
  {
    const double r = g & 1 ? 1.0 - low : low, s = g & 2 ? 1.0 - low : low,
                 t = g & 4 ? 1.0 - low : low;
    Vector3 dr{}, ds{}, dt{};
    const double shape[4] = { (1 - r) * (1 - s), r * (1 - s), r * s, (1 - r) * s };
    const double byR[4] = { s - 1, 1 - s, s, -s }, byS[4] = { r - 1, -r, r, 1 - r };
    for (int c = 0; c < 4; ++c)
    {
      const Vector3 x = (1.0 - t) * a[c] + t * b[c];
      dr = dr + byR[c] * x;
      ds = ds + byS[c] * x;
      dt = dt + shape[c] * (b[c] - a[c]);
    }
    volume += Dot(dr, Cross(ds, dt)) / 8.0;
  }
  return volume;
}

double AreaOf(const std::array<Vector3, 4>& q)
{
  return 0.5 * Norm(Cross(q[2] - q[0], q[3] - q[1]));
}

} // namespace

FragmentVolumes::FragmentVolumes(const FractionField& fractions, const LabelArray& labels,
  const Interface& interface, const Fragments& fragments, const Partition& partition) :
  TheInterface(interface),
  TheFragments(fragments),
  Parts(partition),
  Swept(fragments.NumberOfFragments() + 1, 0.0)
{
  this->FindSides();
  this->AddTargets(fractions, labels);
  this->ShareOrphans();
}

/// The fragments beside every face near the owned cells, and those of every target.
void FragmentVolumes::FindSides()
{
  const Interface& interface = this->TheInterface;
  const IndexBox box = interface.Grid().HexBox();
  for (const InterfaceFace& face : interface.Faces())
  {
    const Index3 upper = interface.Grid().Position(face.Node);
    Index3 lower = upper;
    --lower[face.Axis];
    const bool near = box.Contains(lower) && box.Contains(upper);
    this->Sides.push_back({ near ? this->TheFragments.FragmentOfCell(lower) : 0,
      near ? this->TheFragments.FragmentOfCell(upper) : 0, this->Parts.OwnsCell(upper) });
  }
  this->PairFragments.resize(interface.Points().size(), { { 0, 0 } });
  for (std::size_t n = 0; n < interface.Nodes().size(); ++n)
  {
    for (Index at = interface.FaceOffset(n); at < interface.FaceOffset(n + 1); ++at)
    {
      const Index f = interface.FaceList()[at];
      const InterfaceFace& face = interface.Faces()[f];
      const Index target =
        interface.FindPoint(n, face.First(), face.Second()) - interface.Points().data();
      const bool ordered = face.LowerLabel < face.UpperLabel;
      const Side& side = this->Sides[f];
      this->PairFragments[target] = { { ordered ? side.Lower : side.Upper,
        ordered ? side.Upper : side.Lower } };
    }
  }
}

/// The fragment of the material nearest to a cell that has another label: among the 26 around it.
int FragmentVolumes::FragmentNear(const LabelArray& labels, const Index3& cell, int material) const
{
  const CartesianGrid& grid = this->TheInterface.Grid();
  int best = 0;
  Index nearest = 4;
  for (Index c = 0; c < 27; ++c)
  {
    const Index3 d{ { c % 3 - 1, c / 3 % 3 - 1, c / 9 - 1 } };
    const Index3 q{ { cell[0] + d[0], cell[1] + d[1], cell[2] + d[2] } };
    const Index distance = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
    if (distance < nearest && grid.HexBox().Contains(q) && labels[grid.Linear(q)] == material)
    {
      best = this->TheFragments.FragmentOfCell(q);
      nearest = distance;
    }
  }
  return best;
}

void FragmentVolumes::AddTargets(const FractionField& fractions, const LabelArray& labels)
{
  const CartesianGrid& grid = this->TheInterface.Grid();
  const IndexBox& box = grid.Owned();
  const double scale = std::pow(this->TheInterface.Scale(), -3.0);
  std::vector<ExactSum> target(this->Swept.size()), cells(this->Swept.size()),
    total(fractions.NumberOfMaterials() + 1);
  Index3 p;
  const auto addPart = [&](Index cell, int fragment, int material, double volume)
  {
    total[material].Add(volume);
    const int home = labels[cell] == material ? fragment : this->FragmentNear(labels, p, material);
    if (home > 0)
    {
      target[home].Add(volume);
    }
  };
  for (p[2] = box.Lower[2]; p[2] < box.Upper[2]; ++p[2])
  {
    for (p[1] = box.Lower[1]; p[1] < box.Upper[1]; ++p[1])
    {
      this->TheFragments.ForRuns(p[1], p[2],
        [&](Index first, Index last, int fragment)
        {
          last = std::min(last, box.Upper[0]);
          for (p[0] = std::max(first, box.Lower[0]); p[0] < last; ++p[0])
          {
            const Index cell = grid.Linear(p);
            const double volume = grid.CellVolume(p) * scale;
            cells[fragment].Add(volume);
            if (!fractions.IsMixed(cell))
            {
              addPart(cell, fragment, fractions.Label(cell), volume);
              continue;
            }
            for (const FractionField::Part& part : fractions.Parts(cell))
            {
              addPart(cell, fragment, part.Material, part.Fraction * volume);
            }
          }
        });
    }
  }
  Ranks& ranks = this->Parts.Group();
  this->Targets = SumOverRanks(target, ranks);
  this->CellVolumes = SumOverRanks(cells, ranks);
  this->TotalOfMaterial = SumOverRanks(total, ranks);
}

/// Fractions with no cell of their material near go to all fragments of the material alike.
void FragmentVolumes::ShareOrphans()
{
  std::vector<double> found(this->TotalOfMaterial.size(), 0.0);
  for (std::size_t f = 1; f < this->Targets.size(); ++f)
  {
    found[this->TheFragments.MaterialOfFragment(static_cast<int>(f))] += this->Targets[f];
  }
  for (std::size_t f = 1; f < this->Targets.size(); ++f)
  {
    const int m = this->TheFragments.MaterialOfFragment(static_cast<int>(f));
    this->Targets[f] *= found[m] > 0.0 ? this->TotalOfMaterial[m] / found[m] : 1.0;
  }
}

double FragmentVolumes::Lack(std::size_t fragment) const
{
  return this->Targets[fragment] - this->CellVolumes[fragment] - this->Swept[fragment];
}

void FragmentVolumes::Measure(const ActiveMesh& mesh)
{
  std::vector<ExactSum> swept(this->Swept.size());
  std::map<std::pair<int, int>, ExactSum> areas;
  for (std::size_t f = 0; f < this->Sides.size(); ++f)
  {
    const Side& side = this->Sides[f];
    if (!side.Counts)
    {
      continue;
    }
    std::array<Vector3, 4> before, after;
    int c = 0;
    for (Index n : this->TheInterface.NodesOfFace(static_cast<Index>(f)))
    {
      before[c] = this->TheInterface.NodePoint(this->TheInterface.Nodes()[n]);
      after[c++] = mesh.X[mesh.SurfacePoint[n]];
    }
    const double volume = VolumeBetween(before, after);
    swept[side.Lower].Add(volume);
    swept[side.Upper].Add(-volume);
    areas[std::minmax(side.Lower, side.Upper)].Add(AreaOf(after));
  }
  this->Swept = SumOverRanks(swept, this->Parts.Group());
  this->GatherAreas(areas);
}

void FragmentVolumes::GatherAreas(const std::map<std::pair<int, int>, ExactSum>& areas)
{
  std::vector<Area> mine;
  for (const auto& area : areas)
  {
    mine.push_back({ area.first.first, area.first.second, area.second });
  }
  std::map<std::pair<int, int>, ExactSum> all;
  for (const Area& area : GatherItems(this->Parts.Group(), mine))
  {
    all[{ area.First, area.Second }].Add(area.Value);
  }
  this->Areas.clear();
  for (const auto& area : all)
  {
    this->Areas.push_back({ area.first.first, area.first.second, area.second });
  }
}

std::vector<double> FragmentVolumes::FindShifts() const
{
  const int count = this->TheFragments.NumberOfFragments();
  std::vector<Eigen::Triplet<double>> entries;
  for (int f = 0; f < count; ++f)
  {
    entries.emplace_back(f, f, 1e-6); // a fragment that touches nothing
  }
  for (const Area& area : this->Areas)
  {
    const int a = area.First - 1, b = area.Second - 1; // -1: not meshed
    const double value = area.Value.Value();
    for (int side : { a, b })
    {
      if (side >= 0)
      {
        entries.emplace_back(side, side, value);
      }
    }
    if (a >= 0 && b >= 0)
    {
      entries.emplace_back(a, b, -value);
      entries.emplace_back(b, a, -value);
    }
  }
  Eigen::SparseMatrix<double> A(count, count);
  A.setFromTriplets(entries.begin(), entries.end());
  Eigen::VectorXd lack(count);
  for (int f = 0; f < count; ++f)
  {
    lack[f] = this->Lack(f + 1);
  }
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(A);
  const Eigen::VectorXd mu = solver.solve(lack);
  std::vector<double> shifts;
  for (const std::array<int, 2>& pair : this->PairFragments)
  {
    shifts.push_back((pair[0] > 0 ? mu[pair[0] - 1] : 0.0) - (pair[1] > 0 ? mu[pair[1] - 1] : 0.0));
  }
  return shifts;
}

double FragmentVolumes::WorstError() const
{
  double worst = 0.0;
  for (std::size_t f = 1; f < this->Targets.size(); ++f)
  {
    if (this->Targets[f] >= LargeFragment)
    {
      worst = std::max(worst,
        std::fabs(this->CellVolumes[f] + this->Swept[f] - this->Targets[f]) / this->Targets[f]);
    }
  }
  const std::vector<double> volumes = this->MaterialVolumes();
  for (std::size_t m = 1; m < volumes.size(); ++m)
  {
    if (volumes[m] > 0.0)
    {
      worst = std::max(
        worst, std::fabs(volumes[m] - this->TotalOfMaterial[m]) / this->TotalOfMaterial[m]);
    }
  }
  return worst;
}

std::vector<double> FragmentVolumes::MaterialTargets() const
{
  return this->TotalOfMaterial;
}

std::vector<double> FragmentVolumes::MaterialVolumes() const
{
  std::vector<double> volumes(this->TotalOfMaterial.size(), 0.0);
  for (std::size_t f = 1; f < this->Targets.size(); ++f)
  {
    volumes[this->TheFragments.MaterialOfFragment(static_cast<int>(f))] +=
      this->CellVolumes[f] + this->Swept[f];
  }
  return volumes;
}

} // namespace vfm
