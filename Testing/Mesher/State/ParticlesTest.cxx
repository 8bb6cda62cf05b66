/// Material without elements as particles: elements and particles hold the contents of all cells.
#include "State/Particles.h"
#include "Input/PlainArrays.h"
#include "LabelInput.h"
#include "RankFields.h"
#include "State/MakeParticles.h"
#include "ThreadRanks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <mutex>
#include <random>

using namespace vfm;
using namespace vfm::testing;

namespace
{

constexpr Index3 Cells{ { 16, 12, 14 } };
constexpr double Width = 0.3;
constexpr Vector3 Origin{ { 0.1, -0.4, 2.0 } };

/// Values of a cell.
struct CellValues
{
  double A, B;                      ///< fractions
  double Density[2];                ///< of each material
  double Velocity[3], Energy, Dose; ///< Dose is a sum over the cell
  int Number;
};

/// A ball of A, far from it drops of A and B in random cells, some of them tiny, and a cloud of A.
CellValues ValuesAt(const Index3& cell)
{
  std::mt19937 random(static_cast<unsigned>(cell[0] + 1000 * cell[1] + 100000 * cell[2]));
  const auto draw = [&] { return std::uniform_real_distribution<double>(0.0, 1.0)(random); };
  CellValues values{};
  double squares = 0.0;
  for (int a = 0; a < 3; ++a)
  {
    const double d = static_cast<double>(cell[a]) - 4.2 - 0.1 * a;
    squares += d * d;
  }
  values.A = std::clamp(4.0 - std::sqrt(squares), 0.0, 1.0);
  if (squares > 40.0 && cell[0] > 7)
  {
    const bool isCloud = cell[0] > 10 && cell[1] > 7;
    values.A = isCloud || draw() < 0.1 ? 0.4 * draw() : draw() < 0.05 ? 5e-4 : 0.0;
    values.B = draw() < 0.1 ? 0.5 * draw() : 0.0;
  }
  values.Density[0] = 7.0 + draw();
  values.Density[1] = 2.0 + draw();
  for (double& u : values.Velocity)
  {
    u = 2.0 * draw() - 0.8;
  }
  values.Energy = 3.0 + draw();
  values.Dose = 0.01 * draw();
  values.Number = static_cast<int>(cell[0] + Cells[0] * (cell[1] + Cells[1] * cell[2]));
  return values;
}

/// Stores the values of the cells of a box.
void StoreValues(const IndexBox& box, PlainArrays& arrays)
{
  std::vector<double> a, b, densityA, densityB, velocity, energy, dose;
  std::vector<int> numbers;
  ForCells(box,
    [&](const Index3& cell)
    {
      const CellValues values = ValuesAt(cell);
      a.push_back(values.A);
      b.push_back(values.B);
      densityA.push_back(values.Density[0]);
      densityB.push_back(values.Density[1]);
      velocity.insert(velocity.end(), values.Velocity, values.Velocity + 3);
      energy.push_back(values.Energy);
      dose.push_back(values.Dose);
      numbers.push_back(values.Number);
    });
  arrays.Store("A", ValueType::Double, std::move(a));
  arrays.Store("B", ValueType::Double, std::move(b));
  arrays.Store("density A", ValueType::Double, std::move(densityA));
  arrays.Store("density B", ValueType::Double, std::move(densityB));
  const auto tuples = std::make_shared<std::vector<double>>(std::move(velocity));
  arrays.Add("velocity", ValueType::Double, box.NumberOfCells(), 3,
    std::shared_ptr<const void>(tuples, tuples->data()));
  arrays.Store("energy", ValueType::Double, std::move(energy));
  arrays.Store("dose", ValueType::Double, std::move(dose));
  arrays.Store("number", ValueType::Int, std::move(numbers));
}

/// What of the state is transferred.
enum class Given
{
  Nothing,
  Copies,
  NoDensity,
  All
};

InputBlock MakePart(const IndexBox& box, double width)
{
  auto arrays = std::make_shared<PlainArrays>(box.NumberOfCells());
  StoreValues(box, *arrays);
  return MakeBlock(box, Origin, width, arrays);
}

/// Returns the part of a rank, cut across z.
/// @param hasLevels  whether cells among the drops are halved, on the last rank
MesherInput MakeParts(Given given, Ranks& ranks, bool hasLevels = false)
{
  const Index first = ranks.Rank() * Cells[2] / ranks.Count(),
              last = (ranks.Rank() + 1) * Cells[2] / ranks.Count();
  std::vector<InputBlock> blocks{ MakePart(
    { { { 0, 0, first } }, { { Cells[0], Cells[1], last } } }, Width) };
  if (hasLevels && ranks.Rank() == ranks.Count() - 1)
  {
    blocks.push_back(MakePart({ { { 18, 12, 8 } }, { { 30, 20, 24 } } }, 0.5 * Width));
  }
  MesherInput input = MakeInput(std::move(blocks), ranks);
  input.Arrays.Fractions = { "A", "B" };
  StateChoice& state = input.Arrays.State;
  if (given == Given::Copies)
  {
    state.Arrays = { "number", "velocity" };
  }
  if (given == Given::All || given == Given::NoDensity)
  {
    state.IsConserved = true;
    state.Arrays = { "velocity", "number", "energy", "dose" };
    state.Velocity = "velocity";
    state.Energy = "energy";
    state.Kinds = { "dose=extensive" };
  }
  if (given == Given::All)
  {
    state.Densities = { "density A", "density B" };
    state.Arrays.insert(state.Arrays.begin(), { "density A", "density B" });
  }
  return input;
}

/// Returns options by which drops and the cloud are particles, or else elements of thin parts.
MesherOptions ParticleOptions(ElementKind elements = ElementKind::Hexes, bool thinParts = false)
{
  MesherOptions options;
  options.Elements = elements;
  options.ThinParts = thinParts;
  options.UnmeshedMaterial = Unmeshed::Particles;
  options.LeastParticle = 0.0;
  return options;
}

MesherResult Make(Given given, const MesherOptions& options)
{
  Runtime serial;
  return RunMesher(MakeParts(given, serial.Group()), options, serial);
}

const double* ValuesOf(const Particles& particles, const std::string& name)
{
  const auto found = std::find_if(particles.Arrays.begin(), particles.Arrays.end(),
    [&](const TransferredArray& array) { return array.Name == name; });
  return found == particles.Arrays.end() ? nullptr
                                         : reinterpret_cast<const double*>(found->Values.data());
}

Index3 CellAt(const Particles& particles, Index p)
{
  Index3 cell;
  for (int a = 0; a < 3; ++a)
  {
    cell[a] = std::lround((particles.Positions[3 * p + a] - Origin[a]) / Width - 0.5);
  }
  return cell;
}

/// Checks mass, momentum and energy of input and output, for each material.
/// @param isInternal  whether lost kinetic energy of particles is internal energy
void ExpectSums(const StateBalance& balance, bool isInternal = false)
{
  ASSERT_EQ(balance.Particles.size(), balance.Input.size());
  for (std::size_t m = 1; m < balance.Input.size(); ++m)
  {
    const StateSums &in = balance.Input[m], &mesh = balance.Mesh[m], &rest = balance.Particles[m];
    EXPECT_NEAR(mesh.Mass + rest.Mass, in.Mass, 1e-13 * in.Mass);
    EXPECT_LT(Norm(mesh.Momentum + rest.Momentum - in.Momentum), 1e-13 * in.Mass);
    const double total = in.Kinetic + in.Internal;
    EXPECT_NEAR(mesh.Kinetic + mesh.Internal + rest.Kinetic + rest.Internal +
        (isInternal ? 0.0 : mesh.LostToElements + rest.LostToElements),
      total, 1e-13 * total);
    EXPECT_EQ(balance.Unmeshed[m].Volume, 0.0);
  }
}

double SumOf(const std::vector<StateSums>& sums, double StateSums::*member)
{
  return std::accumulate(sums.begin() + 1, sums.end(), 0.0,
    [member](double sum, const StateSums& s) { return sum + s.*member; });
}

void ExpectContentsOfCells(const MesherResult& result)
{
  const Particles& particles = *result.State.TheParticles;
  EXPECT_EQ(particles.Size(),
    std::accumulate(result.State.Balance.ParticleCounts.begin(),
      result.State.Balance.ParticleCounts.end(), Index(0)));
  const double cell = Width * Width * Width;
  const auto* numbers = reinterpret_cast<const int*>(ValuesOf(particles, "number"));
  for (Index p = 0; p < particles.Size(); ++p)
  {
    const CellValues values = ValuesAt(CellAt(particles, p));
    const int m = particles.Material[p] - 1;
    const double fraction = m == 0 ? values.A : values.B, volume = fraction * cell;
    EXPECT_EQ(particles.Ids[p], 2 * values.Number + m);
    EXPECT_EQ(numbers[p], values.Number);
    EXPECT_NEAR(particles.Volume[p], volume, 1e-15);
    EXPECT_NEAR(4.0 / 3.0 * std::acos(-1.0) * std::pow(particles.Radius[p], 3), volume, 1e-14);
    EXPECT_NEAR(particles.Mass[p], volume * values.Density[m], 1e-13);
    EXPECT_EQ(ValuesOf(particles, "energy")[p], values.Energy);
    EXPECT_NEAR(
      ValuesOf(particles, "dose")[p], values.Dose * fraction / (values.A + values.B), 1e-15);
    for (int a = 0; a < 3; ++a)
    {
      EXPECT_EQ(ValuesOf(particles, "velocity")[3 * p + a], values.Velocity[a]);
    }
  }
}

} // namespace

// The particles are those of the cells: fractions of cells with none of the material's label
// around, with the state of the cell. With thin parts they are few.
TEST(Particles, AreTheContentsOfTheirCells)
{
  const MesherResult all = Make(Given::All, ParticleOptions());
  EXPECT_GT(all.State.TheParticles->Size(), 100);
  ExpectContentsOfCells(all);
  const MesherResult few = Make(Given::All, ParticleOptions(ElementKind::Hexes, true));
  EXPECT_GT(few.State.TheParticles->Size(), 20);
  EXPECT_LT(SumOf(few.State.Balance.Particles, &StateSums::Volume),
    0.05 * SumOf(all.State.Balance.Particles, &StateSums::Volume));
  ExpectContentsOfCells(few);
}

TEST(Particles, SumsMatchTheInput)
{
  for (ElementKind elements : { ElementKind::Hexes, ElementKind::Tets })
  {
    ExpectSums(Make(Given::All, ParticleOptions(elements, true)).State.Balance);
    for (Given given : { Given::All, Given::NoDensity })
    {
      const MesherResult result = Make(given, ParticleOptions(elements));
      ExpectSums(result.State.Balance);
      EXPECT_EQ(SumOf(result.State.Balance.Particles, &StateSums::LostToElements), 0.0);
      EXPECT_EQ(result.State.TheParticles->Mass.empty(), given == Given::NoDensity);
    }
  }
}

// The volumes of elements do not count particles.
TEST(Particles, VolumesMatchTheInput)
{
  for (Given given : { Given::Nothing, Given::Copies, Given::All })
  {
    MesherOptions options = ParticleOptions();
    const MesherResult result = Make(given, options);
    const StateBalance& balance = result.State.Balance;
    for (std::size_t m = 1; m < balance.Input.size(); ++m)
    {
      const double input = balance.Input[m].Volume;
      EXPECT_NEAR(
        result.Report.TargetVolume[m] + balance.Particles[m].Volume, input, 1e-13 * input);
      EXPECT_NEAR(result.Report.MeshVolume[m] + balance.Particles[m].Volume, input, 1e-4 * input);
      EXPECT_GT(balance.Particles[m].Volume, 0.05 * input);
    }
    options.UnmeshedMaterial = Unmeshed::Give;
    const MesherResult before = Make(given, options);
    EXPECT_FALSE(before.State.TheParticles);
    EXPECT_NEAR(before.Report.TargetVolume[1], balance.Input[1].Volume, 1e-12);
  }
}

TEST(Particles, NeedNoState)
{
  const MesherResult all = Make(Given::All, ParticleOptions());
  for (Given given : { Given::Nothing, Given::Copies })
  {
    const MesherResult result = Make(given, ParticleOptions());
    const Particles& particles = *result.State.TheParticles;
    EXPECT_EQ(particles.Positions, all.State.TheParticles->Positions);
    EXPECT_EQ(particles.Volume, all.State.TheParticles->Volume);
    EXPECT_EQ(particles.Ids, all.State.TheParticles->Ids);
    EXPECT_TRUE(particles.Mass.empty());
    ASSERT_EQ(particles.Arrays.size(), given == Given::Copies ? 2u : 0u);
    EXPECT_EQ(result.State.Arrays.size(), particles.Arrays.size());
    if (given == Given::Copies)
    {
      EXPECT_EQ(particles.Arrays[0].Name, "number");
      EXPECT_EQ(ValuesOf(particles, "velocity")[5], ValuesAt(CellAt(particles, 1)).Velocity[2]);
    }
  }
}

TEST(Particles, ViewHasTheArraysOfFiles)
{
  MesherResult result = Make(Given::All, ParticleOptions());
  Particles particles = std::move(*result.State.TheParticles);
  const auto namesOf = [](const ParticleData& data)
  {
    std::vector<std::string> names;
    for (const MeshArray& array : data.Arrays)
    {
      names.push_back(array.Name);
    }
    return names;
  };
  const ParticleData data = ViewParticles(particles);
  EXPECT_EQ(data.NumberOfParticles, particles.Size());
  EXPECT_EQ(namesOf(data),
    (std::vector<std::string>{ "Id", "Material", "Radius", "Volume", "Mass", "density", "velocity",
      "number", "energy", "dose" }));
  EXPECT_EQ(data.PositionAt(1)[2], particles.Positions[5]);
  EXPECT_EQ(data.Arrays[5].Values, particles.Arrays[0].Values.data());
  particles.Arrays[4].Name = "Volume"; // the state array stays
  EXPECT_EQ(namesOf(ViewParticles(particles)),
    (std::vector<std::string>{
      "Id", "Material", "Radius", "Mass", "density", "velocity", "number", "energy", "Volume" }));
}

TEST(Particles, ClustersKeepAllSumsButKineticEnergy)
{
  const MesherResult single = Make(Given::All, ParticleOptions());
  for (LostEnergy lost : { LostEnergy::Report, LostEnergy::InternalEnergy })
  {
    MesherOptions options = ParticleOptions();
    options.ParticleClusters = true;
    options.LostKineticEnergy = lost;
    const MesherResult result = Make(Given::All, options);
    const Particles& particles = *result.State.TheParticles;
    const StateBalance& balance = result.State.Balance;
    ExpectSums(balance, lost == LostEnergy::InternalEnergy);
    EXPECT_GT(SumOf(balance.Particles, &StateSums::LostToElements),
      0.05 * SumOf(balance.Particles, &StateSums::Kinetic));
    EXPECT_LT(particles.Size(), single.State.TheParticles->Size() / 3);
    EXPECT_NEAR(SumOf(balance.Particles, &StateSums::Volume),
      SumOf(single.State.Balance.Particles, &StateSums::Volume), 1e-14);
    // First moments stay.
    double moments[2]{};
    int n = 0;
    for (const Particles* some : { &particles, &*single.State.TheParticles })
    {
      for (Index p = 0; p < some->Size(); ++p)
      {
        moments[n] += some->Volume[p] * some->Positions[3 * p];
      }
      ++n;
    }
    EXPECT_NEAR(moments[0], moments[1], 1e-13 * moments[1]);
  }
}

// A small particle joins one that is not, or the best of small ones around it.
TEST(Particles, SmallOnesJoin)
{
  MesherOptions options = ParticleOptions();
  const MesherResult all = Make(Given::All, options);
  options.LeastParticle = 0.05;
  const MesherResult result = Make(Given::All, options);
  ExpectSums(result.State.Balance);
  const Particles &joined = *result.State.TheParticles, &single = *all.State.TheParticles;
  EXPECT_LT(joined.Size(), single.Size());
  const double least = options.LeastParticle * Width * Width * Width;
  std::map<Index, Index> byId;
  for (Index p = 0; p < single.Size(); ++p)
  {
    byId[single.Ids[p]] = p;
    if (single.Volume[p] >= least)
    {
      EXPECT_TRUE(
        std::find(joined.Ids.begin(), joined.Ids.end(), single.Ids[p]) != joined.Ids.end());
    }
  }
  int left = 0;
  for (Index p = 0; p < joined.Size(); ++p)
  {
    EXPECT_GE(joined.Volume[p], single.Volume[byId.at(joined.Ids[p])]);
    const Index3 own = CellAt(single, byId.at(joined.Ids[p]));
    for (Index q = 0; single.Volume[byId[joined.Ids[p]]] < least && q < joined.Size(); ++q)
    {
      const Index3 other = CellAt(single, byId[joined.Ids[q]]);
      const bool isNear = std::abs(own[0] - other[0]) <= 1 && std::abs(own[1] - other[1]) <= 1 &&
        std::abs(own[2] - other[2]) <= 1;
      EXPECT_FALSE(p != q && isNear && joined.Material[p] == joined.Material[q]);
      left += p == q;
    }
  }
  EXPECT_GT(left, 0);
}

namespace
{

/// Particles of all ranks by id, as numbers.
using ById = std::map<Index, std::vector<double>>;

void AddTo(const Particles& particles, ById& all)
{
  for (Index p = 0; p < particles.Size(); ++p)
  {
    std::vector<double>& values = all[particles.Ids[p]];
    EXPECT_TRUE(values.empty()); // each is on one rank
    values = { particles.Positions[3 * p], particles.Positions[3 * p + 1],
      particles.Positions[3 * p + 2], double(particles.Material[p]), particles.Radius[p],
      particles.Volume[p], particles.Mass.empty() ? 0.0 : particles.Mass[p] };
    for (const TransferredArray& array : particles.Arrays)
    {
      const std::size_t size = array.Values.size() / particles.Size();
      for (std::size_t c = 0; c < size; ++c)
      {
        values.push_back(array.Values[size * p + c]);
      }
    }
  }
}

} // namespace

TEST(Particles, RanksGiveTheSame)
{
  for (int kind = 0; kind < 5; ++kind)
  {
    MesherOptions options =
      ParticleOptions(kind == 3 ? ElementKind::Tets : ElementKind::Hexes, kind == 4);
    options.ParticleClusters = kind == 1;
    options.LeastParticle = kind == 0 ? 0.0 : 0.1;
    options.Periodic = kind == 2 ? 7 : 0;
    ById alone;
    for (int count : { 1, 2, 3, 5 })
    {
      ById joined;
      std::mutex mutex;
      RunOnRanks(count,
        [&](ThreadRanks& ranks)
        {
          RankRuntime runtime(ranks);
          const MesherResult result = RunMesher(MakeParts(Given::All, ranks), options, runtime);
          const std::lock_guard<std::mutex> lock(mutex);
          AddTo(*result.State.TheParticles, joined);
        });
      alone = count == 1 ? joined : alone;
      EXPECT_GT(joined.size(), kind == 4 ? 10u : 20u);
      EXPECT_TRUE(joined == alone) << kind << " on " << count << " ranks";
    }
  }
}

// Each matter counts once; particles that were joined across sides are in the domain.
TEST(Particles, PeriodicDomains)
{
  for (Sides sides : { Sides::Flat, Sides::Free, Sides::Joined })
  {
    MesherOptions options = ParticleOptions();
    options.Periodic = 7;
    options.PeriodicSides = sides;
    options.ParticleClusters = true;
    const MesherResult result = Make(Given::All, options);
    ExpectSums(result.State.Balance);
    const Particles& particles = *result.State.TheParticles;
    for (Index p = 0; p < particles.Size(); ++p)
    {
      for (int a = 0; a < 3; ++a)
      {
        EXPECT_GE(particles.Positions[3 * p + a], Origin[a]);
        EXPECT_LT(particles.Positions[3 * p + a], Origin[a] + Width * double(Cells[a]));
      }
    }
  }
}

// Refined meshes have the particles of the cells of the input.
TEST(Particles, OfRefinedMeshes)
{
  const MesherResult single = Make(Given::All, ParticleOptions());
  for (RefinementMode mode :
    { RefinementMode::Uniform, RefinementMode::Automatic, RefinementMode::Coarsen })
  {
    MesherOptions options = ParticleOptions();
    options.Refinement = mode;
    options.MaximumLevel = 1;
    const MesherResult result = Make(Given::All, options);
    ExpectSums(result.State.Balance);
    const Particles& particles = *result.State.TheParticles;
    EXPECT_GT(particles.Size(), 100);
    double volume = 0.0;
    for (Index p = 0; p < particles.Size(); ++p)
    {
      volume += particles.Volume[p];
      EXPECT_TRUE(
        std::find(single.State.TheParticles->Ids.begin(), single.State.TheParticles->Ids.end(),
          particles.Ids[p]) != single.State.TheParticles->Ids.end() ||
        mode != RefinementMode::Coarsen);
    }
    const StateBalance& balance = result.State.Balance;
    const double input = SumOf(balance.Input, &StateSums::Volume);
    EXPECT_NEAR(SumOf(balance.Particles, &StateSums::Volume), volume, 1e-13);
    EXPECT_NEAR(
      result.Report.TargetVolume[1] + result.Report.TargetVolume[2] + volume, input, 1e-9 * input);
  }
}

// Refined input has the particles of its finest cells, or of larger ones if the mesh is coarser.
TEST(Particles, OfRefinedInput)
{
  for (RefinementMode mode : { RefinementMode::InputLevels, RefinementMode::Off })
  {
    MesherOptions options = ParticleOptions();
    options.Refinement = mode;
    ById alone;
    for (int count : { 1, 3 })
    {
      ById joined;
      std::mutex mutex;
      RunOnRanks(count,
        [&](ThreadRanks& ranks)
        {
          RankRuntime runtime(ranks);
          const MesherResult result =
            RunMesher(MakeParts(Given::All, ranks, true), options, runtime);
          const std::lock_guard<std::mutex> lock(mutex);
          AddTo(*result.State.TheParticles, joined);
          const StateBalance& balance = result.State.Balance;
          ExpectSums(balance);
          const double input = SumOf(balance.Input, &StateSums::Volume);
          EXPECT_NEAR(result.Report.TargetVolume[1] + result.Report.TargetVolume[2] +
              SumOf(balance.Particles, &StateSums::Volume),
            input, 1e-13 * input);
        });
      alone = count == 1 ? joined : alone;
      EXPECT_GT(joined.size(), 100u);
      EXPECT_TRUE(joined == alone);
    }
  }
}

// Positions and rotated arrays are in world coordinates.
TEST(Particles, OfImagesWithAxes)
{
  Runtime serial;
  const MesherResult own = Make(Given::All, ParticleOptions());
  MesherInput input = MakeParts(Given::All, serial.Group());
  input.Arrays.State.Rotated = { "velocity" };
  const ImageFrame frame = MakeImageFrame(
    { 0.48, -0.6, -0.64, 0.8, 0.0, 0.6, 0.36, 0.8, -0.48 }, { { 1.0, 2.0, 3.0 } }, "A");
  input.Levels.Reading.Frame = frame;
  const MesherResult turned = RunMesher(input, ParticleOptions(), serial);
  const Particles &before = *own.State.TheParticles, &after = *turned.State.TheParticles;
  ASSERT_EQ(before.Ids, after.Ids);
  ExpectSums(turned.State.Balance);
  for (Index p = 0; p < after.Size(); ++p)
  {
    const double* x = before.Positions.data() + 3 * p;
    const Vector3 expected = frame.ToSpace({ { x[0], x[1], x[2] } });
    Vector3 u;
    std::copy_n(ValuesOf(before, "velocity") + 3 * p, 3, u.begin());
    RotateTuple(frame, 3, u.data());
    for (int a = 0; a < 3; ++a)
    {
      EXPECT_NEAR(after.Positions[3 * p + a], expected[a], 1e-14);
      EXPECT_NEAR(ValuesOf(after, "velocity")[3 * p + a], u[a], 1e-14);
    }
  }
  MesherOptions options = ParticleOptions();
  options.ImageAxes = true;
  EXPECT_EQ(RunMesher(input, options, serial).State.TheParticles->Positions, before.Positions);
}

// Materials of particles have the ids of the user; void is no particle.
TEST(Particles, HaveTheIdsOfLabels)
{
  Runtime serial;
  std::vector<int> labels(12 * 10 * 8, 0);
  ForCells({ { { 2, 2, 2 } }, { { 6, 6, 6 } } },
    [&](const Index3& cell) { labels[cell[0] + 12 * (cell[1] + 10 * cell[2])] = 40; });
  labels[10 + 12 * (8 + 10 * 6)] = 7; // becomes void
  MesherInput input = MakeLabelInput({ { { 12, 10, 8 } }, 0.0, 1.0 }, labels, serial.Group());
  MesherOptions options = ParticleOptions();
  options.MeshVoid = true;
  options.MinimumRegionCells = 2;
  const MesherResult result = RunMesher(input, options, serial);
  const Particles& particles = *result.State.TheParticles;
  ASSERT_EQ(particles.Size(), 1);
  EXPECT_EQ(particles.Material[0], 7);
  EXPECT_EQ(particles.Volume[0], 1.0);
  EXPECT_EQ(particles.Positions, (std::vector<double>{ 10.5, 8.5, 6.5 }));
}

namespace
{

const FieldArray* Find(const FieldArrays& fields, const std::string& name)
{
  const auto found = std::find_if(
    fields.begin(), fields.end(), [&name](const FieldArray& field) { return field.Name == name; });
  return found == fields.end() ? nullptr : &*found;
}

} // namespace

TEST(Particles, AreInTheTableOfMaterials)
{
  const std::vector<std::string> columns{ "Particles", "ParticleVolume", "ParticleMass",
    "ParticleMomentum", "ParticleKineticEnergy", "ParticleLostKineticEnergy",
    "ParticleInternalEnergy" };
  MesherOptions options = ParticleOptions();
  std::vector<std::string> warnings;
  Runtime serial;
  MesherInput input = MakeParts(Given::All, serial.Group());
  input.Warn = [&](const std::string& text) { warnings.push_back(text); };
  const MesherResult result = RunMesher(input, options, serial);
  EXPECT_TRUE(warnings.empty()) << warnings.front();
  for (const std::string& name : columns)
  {
    EXPECT_TRUE(Find(result.MaterialFields, name)) << name;
  }
  const double mass = std::accumulate(
    result.State.TheParticles->Mass.begin(), result.State.TheParticles->Mass.end(), 0.0);
  const auto& masses =
    std::get<std::vector<double>>(Find(result.MaterialFields, "ParticleMass")->Values);
  EXPECT_NEAR(masses[0] + masses[1], mass, 1e-13 * mass);
  const auto& counts =
    std::get<std::vector<Index>>(Find(result.MaterialFields, "Particles")->Values);
  EXPECT_EQ(counts[0] + counts[1], result.State.TheParticles->Size());
  const MesherResult bare = Make(Given::Nothing, options);
  EXPECT_TRUE(Find(bare.MaterialFields, "ParticleVolume"));
  EXPECT_FALSE(Find(bare.MaterialFields, "ParticleMass"));
  options.UnmeshedMaterial = Unmeshed::Drop;
  const MesherResult dropped = RunMesher(input, options, serial);
  EXPECT_FALSE(warnings.empty());
  for (const std::string& name : columns)
  {
    EXPECT_FALSE(Find(dropped.MaterialFields, name)) << name;
  }
}
