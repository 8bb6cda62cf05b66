#include "State/StateBalance.h"

#include "Base/WideSum.h"

#include <sstream>

namespace vfm
{
namespace
{

constexpr int NumberOfSums = 9;
constexpr double SmallPart = 1e-12; // fraction of a material; less is rounding

using SumTerms = std::array<double, NumberOfSums>;

SumTerms TermsOf(const StateSums& sums)
{
  return { { sums.Volume, sums.Mass, sums.Momentum[0], sums.Momentum[1], sums.Momentum[2],
    sums.Kinetic, sums.Internal, sums.LostToElements, sums.LostToNodes } };
}

StateSums FromTerms(const SumTerms& terms)
{
  return { terms[0], terms[1], { { terms[2], terms[3], terms[4] } }, terms[5], terms[6], terms[7],
    terms[8] };
}

/// Collects arrays with values of each material.
class ColumnMaker
{
public:
  explicit ColumnMaker(std::size_t first) : First(first) {}

  template <class Get>
  void Add(const char* name, const std::vector<StateSums>& sums, const Get& get)
  {
    std::vector<double> values;
    for (std::size_t m = this->First; m < sums.size(); ++m)
    {
      values.push_back(get(sums[m]));
    }
    this->Columns.push_back({ name, std::move(values) });
  }

  /// Adds an array of tuples; get: returns the tuple of a material.
  template <class Values, class Get>
  void AddTuples(const char* name, const std::vector<Values>& of, const Get& get)
  {
    std::vector<double> values;
    int components = 1;
    for (std::size_t m = this->First; m < of.size(); ++m)
    {
      const auto& tuple = get(of[m]);
      components = static_cast<int>(tuple.size());
      values.insert(values.end(), tuple.begin(), tuple.end());
    }
    this->Columns.push_back({ name, std::move(values), components });
  }

  std::vector<FieldArray> Columns;

private:
  std::size_t First; // first material
};

} // namespace

std::vector<StateSums> SumByMaterial(const int* material, std::size_t count, int materials,
  const std::function<StateSums(Index)>& find, Ranks& ranks)
{
  std::vector<WideSum> sums(NumberOfSums * materials);
  for (std::size_t i = 0; i < count; ++i)
  {
    const SumTerms terms = TermsOf(find(static_cast<Index>(i)));
    for (int t = 0; t < NumberOfSums; ++t)
    {
      sums[NumberOfSums * material[i] + t].Add(terms[t]);
    }
  }
  WideSum::SumOverRanks(sums, ranks);
  std::vector<StateSums> result;
  for (int m = 0; m < materials; ++m)
  {
    SumTerms terms{};
    std::transform(sums.begin() + NumberOfSums * m, sums.begin() + NumberOfSums * (m + 1),
      terms.begin(), [](const WideSum& sum) { return sum.Value(); });
    result.push_back(FromTerms(terms));
  }
  return result;
}

namespace
{

void AddParticles(const StateBalance& balance, std::size_t first, ColumnMaker& maker)
{
  const std::vector<StateSums>& of = balance.Particles;
  maker.Columns.push_back({ "Particles",
    std::vector<Index>(balance.ParticleCounts.begin() + first, balance.ParticleCounts.end()) });
  maker.Add("ParticleVolume", of, [](const StateSums& s) { return s.Volume; });
  if (balance.HasDensity)
  {
    maker.Add("ParticleMass", of, [](const StateSums& s) { return s.Mass; });
  }
  if (balance.HasVelocity)
  {
    maker.AddTuples(
      "ParticleMomentum", of, [](const StateSums& s) -> const Vector3& { return s.Momentum; });
    maker.Add("ParticleKineticEnergy", of, [](const StateSums& s) { return s.Kinetic; });
    maker.Add("ParticleLostKineticEnergy", of, [](const StateSums& s) { return s.LostToElements; });
  }
  if (balance.HasEnergy)
  {
    maker.Add("ParticleInternalEnergy", of, [](const StateSums& s) { return s.Internal; });
  }
}

} // namespace

std::vector<FieldArray> ListBalance(const StateBalance& balance, bool meshVoid)
{
  const auto mass = [](const StateSums& s) { return s.Mass; };
  const auto kinetic = [](const StateSums& s) { return s.Kinetic; };
  const auto internal = [](const StateSums& s) { return s.Internal; };
  const auto volume = [](const StateSums& s) { return s.Volume; };
  const auto momentum = [](const StateSums& s) -> const Vector3& { return s.Momentum; };
  const auto factors = [](const std::array<double, 2>& f) -> const auto&
  {
    return f;
  };
  ColumnMaker maker(meshVoid ? 0 : 1);
  maker.Add("InputVolume", balance.Input, volume);
  maker.Add("UnmeshedVolume", balance.Unmeshed, volume);
  maker.AddTuples("VolumeFactors", balance.Factors, factors);
  if (balance.HasDensity)
  {
    maker.Add("InputMass", balance.Input, mass);
    maker.Add("MeshMass", balance.Mesh, mass);
    maker.Add("UnmeshedMass", balance.Unmeshed, mass);
  }
  if (balance.HasVelocity)
  {
    maker.AddTuples("InputMomentum", balance.Input, momentum);
    maker.AddTuples("MeshMomentum", balance.Mesh, momentum);
    maker.AddTuples("UnmeshedMomentum", balance.Unmeshed, momentum);
    maker.Add("InputKineticEnergy", balance.Input, kinetic);
    maker.Add("MeshKineticEnergy", balance.Mesh, kinetic);
    maker.Add("UnmeshedKineticEnergy", balance.Unmeshed, kinetic);
    maker.Add(
      "LostKineticEnergy", balance.Mesh, [](const StateSums& s) { return s.LostToElements; });
  }
  if (balance.HasNodes)
  {
    maker.Add(
      "LostNodalKineticEnergy", balance.Mesh, [](const StateSums& s) { return s.LostToNodes; });
  }
  if (balance.HasEnergy)
  {
    maker.Add("InputInternalEnergy", balance.Input, internal);
    maker.Add("MeshInternalEnergy", balance.Mesh, internal);
    maker.Add("UnmeshedInternalEnergy", balance.Unmeshed, internal);
  }
  if (!balance.Particles.empty())
  {
    AddParticles(balance, meshVoid ? 0 : 1, maker);
  }
  return std::move(maker.Columns);
}

std::string DescribeUnmeshed(const StateBalance& balance, const Materials& table)
{
  constexpr int MaximumNames = 20;
  std::ostringstream list;
  int count = 0;
  for (std::size_t m = 1; m < balance.Input.size(); ++m)
  {
    const StateSums &all = balance.Input[m], &left = balance.Unmeshed[m];
    if (left.Volume > SmallPart * all.Volume && ++count <= MaximumNames)
    {
      list << (count > 1 ? ", " : "") << "'" << table.Names[m] << "' volume " << left.Volume
           << " of " << all.Volume;
      if (balance.HasDensity)
      {
        list << ", mass " << left.Mass << " of " << all.Mass;
      }
    }
  }
  if (count > MaximumNames)
  {
    list << " and " << count - MaximumNames << " materials more";
  }
  return count == 0
    ? ""
    : "Material apart from all elements of its kind is left out of the mesh: " + list.str() + ".";
}

} // namespace vfm
