#include "FragmentTable.h"

#include "Base/ExactSum.h"
#include "Base/Runtime.h"
#include "ElementMoments.h"
#include "MaterialNames.h"
#include "MeshArrays.h"
#include "MeshFaces.h"
#include "Ranks/Agreement.h"
#include "Ranks/MaxOfEach.h"
#include "ShareHead.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <limits>
#include <memory>

namespace vfm
{
namespace
{

struct Fragment
{
  int Material = 0;
  Index Elements = 0;
  double Volume = 0.0, Mass = 0.0;
  Vector3 Centroid{};
  std::array<double, 6> Bounds{}; ///< x from, to, y from, to, z from, to
  std::string Neighbours;
};

/// Lengths and sums are taken in units of the mesh: sums of small and of large meshes are as exact.
struct Units
{
  Vector3 Origin;
  double Length, Volume, Density;
};

/// The cell arrays of one mesh; throws when one is missing.
struct MeshArrays
{
  MeshArrays(vtkUnstructuredGrid* mesh, const std::vector<std::string>& names) :
    Fragments(Find(mesh, "FragmentId")), Materials(Find(mesh, "MaterialId"))
  {
    vtkDataArray* ids = mesh->GetFieldData()->GetArray("MaterialIds");
    for (vtkIdType m = 0; ids && m < ids->GetNumberOfTuples(); ++m)
    {
      this->MaterialIds.push_back(static_cast<int>(ids->GetComponent(m, 0)));
    }
    for (const std::string& name : names)
    {
      this->Densities.push_back(Find(mesh, name));
    }
    if (names.size() > 1 && names.size() != this->MaterialIds.size())
    {
      throw InputError("There are " + std::to_string(names.size()) + " density arrays and " +
        std::to_string(this->MaterialIds.size()) +
        " materials. Choose one array for all materials, or one a material in their order.");
    }
  }

  int FragmentOf(vtkIdType element) const
  {
    return static_cast<int>(this->Fragments->GetComponent(element, 0));
  }
  int MaterialOf(vtkIdType element) const
  {
    return static_cast<int>(this->Materials->GetComponent(element, 0));
  }
  double DensityOf(vtkIdType element) const
  {
    std::size_t place = 0;
    if (this->Densities.size() > 1)
    {
      const auto& ids = this->MaterialIds;
      place = std::find(ids.begin(), ids.end(), this->MaterialOf(element)) - ids.begin();
    }
    return place < this->Densities.size() ? this->Densities[place]->GetComponent(element, 0) : 0.0;
  }

  vtkDataArray *Fragments, *Materials;
  std::vector<vtkDataArray*> Densities;
  std::vector<int> MaterialIds;

private:
  static vtkDataArray* Find(vtkUnstructuredGrid* mesh, const std::string& name)
  {
    vtkDataArray* array = FindMeshArray(mesh->GetCellData(), name);
    if (array->GetNumberOfComponents() != 1)
    {
      throw InputError("The array " + name + " has " +
        std::to_string(array->GetNumberOfComponents()) + " components, not one.");
    }
    return array;
  }
};

/// What the elements of this rank add to a fragment.
struct Sums
{
  Index Elements = 0;
  ExactSum Volume, Mass;
  std::array<ExactSum, 3> Moment;
};

constexpr double Nowhere = -std::numeric_limits<double>::infinity();
constexpr int Extremes = 7; // of a fragment: its material, then its bounds, minima negated

/// Collective.
Units FindUnits(vtkUnstructuredGrid* mesh, const std::vector<ElementMoments>& moments,
  const MeshArrays* arrays, Ranks& ranks)
{
  std::vector<double> extremes(8, Nowhere); // bounds, largest element, largest density
  if (mesh->GetNumberOfPoints() > 0)
  {
    const double* bounds = mesh->GetBounds();
    for (int side = 0; side < 6; ++side)
    {
      extremes[side] = side % 2 ? bounds[side] : -bounds[side];
    }
  }
  for (std::size_t e = 0; e < moments.size(); ++e)
  {
    extremes[6] = std::max(extremes[6], moments[e].Volume);
    extremes[7] = std::max(extremes[7], std::abs(arrays->DensityOf(static_cast<vtkIdType>(e))));
  }
  MaxOfEach(extremes, ranks);
  Units units{ { { -extremes[0], -extremes[2], -extremes[4] } }, 0.0, extremes[6], extremes[7] };
  for (int a = 0; a < 3; ++a)
  {
    units.Length = std::max(units.Length, extremes[2 * a + 1] + extremes[2 * a]);
  }
  units.Density = units.Density > 0.0 ? units.Density : 1.0;
  return units;
}

/// Over the elements of this rank; extremes: Extremes a fragment.
void SumElements(vtkUnstructuredGrid* mesh, const std::vector<ElementMoments>& moments,
  const MeshArrays& arrays, const Units& units, std::vector<Sums>& sums,
  std::vector<double>& extremes)
{
  for (vtkIdType e = 0; e < mesh->GetNumberOfCells(); ++e)
  {
    const int fragment = arrays.FragmentOf(e) - 1;
    Sums& sum = sums[fragment];
    const double volume = moments[e].Volume / units.Volume;
    ++sum.Elements;
    sum.Volume.Add(volume);
    sum.Mass.Add(volume * (arrays.DensityOf(e) / units.Density));
    double* extreme = &extremes[Extremes * fragment];
    extreme[0] = arrays.MaterialOf(e);
    for (int a = 0; a < 3; ++a)
    {
      const double moment = moments[e].Moment[a] / units.Volume - volume * units.Origin[a];
      sum.Moment[a].Add(moment / units.Length);
    }
    vtkIdType size = 0;
    const vtkIdType* points = nullptr;
    mesh->GetCells()->GetCellAtId(e, size, points);
    for (vtkIdType c = 0; c < size; ++c)
    {
      const double* x = mesh->GetPoint(points[c]);
      for (int a = 0; a < 3; ++a)
      {
        extreme[2 * a + 1] = std::max(extreme[2 * a + 1], -x[a]);
        extreme[2 * a + 2] = std::max(extreme[2 * a + 2], x[a]);
      }
    }
  }
}

/// Collective: the sums and extremes of all ranks as fragments.
std::vector<Fragment> UniteFragments(
  const std::vector<Sums>& sums, std::vector<double>& extremes, const Units& units, Ranks& ranks)
{
  std::vector<std::int64_t> elements;
  std::vector<ExactSum> parts;
  for (const Sums& sum : sums)
  {
    elements.push_back(sum.Elements);
    parts.insert(parts.end(), { sum.Volume, sum.Mass });
    parts.insert(parts.end(), sum.Moment.begin(), sum.Moment.end());
  }
  ranks.Sum(elements);
  const std::vector<double> totals = SumOverRanks(parts, ranks);
  MaxOfEach(extremes, ranks);
  std::vector<Fragment> fragments(sums.size());
  for (std::size_t f = 0; f < fragments.size(); ++f)
  {
    const double* total = &totals[5 * f];
    const double* extreme = &extremes[Extremes * f];
    Fragment& fragment = fragments[f];
    fragment.Material = static_cast<int>(extreme[0]);
    fragment.Elements = elements[f];
    fragment.Volume = total[0] * units.Volume;
    fragment.Mass = total[1] * units.Volume * units.Density;
    for (int a = 0; a < 3; ++a)
    {
      fragment.Centroid[a] = units.Origin[a] + units.Length * total[2 + a] / total[0];
      fragment.Bounds[2 * a] = -extreme[2 * a + 1];
      fragment.Bounds[2 * a + 1] = extreme[2 * a + 2];
    }
  }
  return fragments;
}

/// Collective.
void FindNeighbours(vtkUnstructuredGrid* mesh, const MeshArrays* arrays, Ranks& ranks,
  std::vector<Fragment>& fragments)
{
  using Pair = std::array<int, 2>;
  std::vector<Pair> pairs;
  for (const MeshFace& face : FindMeshFaces(mesh, "FragmentId", ranks))
  {
    if (face.Behind != NothingBehind)
    {
      pairs.push_back({ { arrays->FragmentOf(face.Cell), face.Behind } });
    }
  }
  for (const Pair& pair : Unite(ranks, std::move(pairs)))
  {
    std::string& text = fragments[pair[0] - 1].Neighbours;
    text += (text.empty() ? "" : " ") + std::to_string(pair[1]);
  }
}

/// Collective.
std::vector<Fragment> FindFragments(
  vtkUnstructuredGrid* mesh, const std::vector<std::string>& densities, Ranks& ranks)
{
  std::unique_ptr<MeshArrays> arrays; // none where this rank has no elements
  std::vector<ElementMoments> moments;
  double last = 0.0;
  WorkTogether(ranks,
    [&]
    {
      if (mesh->GetNumberOfCells() > 0)
      {
        arrays = std::make_unique<MeshArrays>(mesh, densities);
        moments = FindElementMoments(mesh);
        last = arrays->Fragments->GetRange()[1];
      }
    });
  const auto count = static_cast<std::size_t>(ranks.Max(last));
  const Units units = FindUnits(mesh, moments, arrays.get(), ranks);
  std::vector<Sums> sums(count);
  std::vector<double> extremes(Extremes * count, Nowhere);
  if (arrays)
  {
    SumElements(mesh, moments, *arrays, units, sums, extremes);
  }
  std::vector<Fragment> fragments = UniteFragments(sums, extremes, units, ranks);
  FindNeighbours(mesh, arrays.get(), ranks, fragments);
  return fragments;
}

/// get: the value of a fragment.
template <class Array, class Get>
void AddColumn(
  const std::vector<Fragment>& fragments, const char* name, vtkTable* table, const Get& get)
{
  vtkNew<Array> column;
  column->SetName(name);
  column->SetNumberOfValues(static_cast<vtkIdType>(fragments.size()));
  for (std::size_t f = 0; f < fragments.size(); ++f)
  {
    column->SetValue(static_cast<vtkIdType>(f), get(fragments[f]));
  }
  table->AddColumn(column);
}

void FillTable(
  const std::vector<Fragment>& fragments, vtkUnstructuredGrid* mesh, bool hasMass, vtkTable* table)
{
  const MaterialNames names(mesh);
  const auto place = [&fragments](const Fragment& fragment)
  { return static_cast<vtkIdType>(&fragment - fragments.data()); };
  AddColumn<vtkIntArray>(fragments, "FragmentId", table,
    [&](const Fragment& fragment) { return static_cast<int>(place(fragment)) + 1; });
  AddColumn<vtkIntArray>(
    fragments, "MaterialId", table, [](const Fragment& fragment) { return fragment.Material; });
  AddColumn<vtkStringArray>(fragments, "Material", table,
    [&](const Fragment& fragment) { return names.Name(fragment.Material); });
  AddColumn<vtkIdTypeArray>(
    fragments, "Elements", table, [](const Fragment& fragment) { return fragment.Elements; });
  vtkDataArray* targets = mesh->GetFieldData()->GetArray("FragmentTargetVolume");
  if (targets && targets->GetNumberOfTuples() >= static_cast<vtkIdType>(fragments.size()))
  {
    AddColumn<vtkDoubleArray>(fragments, "FractionVolume", table,
      [&](const Fragment& fragment) { return targets->GetComponent(place(fragment), 0); });
  }
  AddColumn<vtkDoubleArray>(
    fragments, "MeshVolume", table, [](const Fragment& fragment) { return fragment.Volume; });
  for (int a = 0; a < 3; ++a)
  {
    AddColumn<vtkDoubleArray>(fragments, (std::string("Centroid") + "XYZ"[a]).c_str(), table,
      [a](const Fragment& fragment) { return fragment.Centroid[a]; });
  }
  for (int side = 0; side < 6; ++side)
  {
    AddColumn<vtkDoubleArray>(fragments,
      (std::string(side % 2 ? "Max" : "Min") + "XYZ"[side / 2]).c_str(), table,
      [side](const Fragment& fragment) { return fragment.Bounds[side]; });
  }
  if (hasMass)
  {
    AddColumn<vtkDoubleArray>(
      fragments, "Mass", table, [](const Fragment& fragment) { return fragment.Mass; });
  }
  AddColumn<vtkStringArray>(
    fragments, "Neighbours", table, [](const Fragment& fragment) { return fragment.Neighbours; });
}

} // namespace

void MakeFragmentTable(vtkUnstructuredGrid* mesh, const std::vector<std::string>& densities,
  Ranks& ranks, vtkTable* table)
{
  const std::vector<Fragment> fragments = FindFragments(mesh, densities, ranks);
  const vtkSmartPointer<vtkUnstructuredGrid> head =
    fragments.empty() ? vtkSmartPointer<vtkUnstructuredGrid>(mesh) : ShareHead(mesh, ranks);
  if (ranks.Rank() == 0)
  {
    FillTable(fragments, head, !densities.empty(), table);
  }
}

} // namespace vfm
