/// Particles by the C interface: those of the filter, their sums, files, and errors.
#include "HostFields.h"
#include "Sculptor.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkVolumeFractionToHex.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <map>
#include <string>
#include <vector>

using namespace vfm;
using namespace vfm::testing;

namespace
{

/// Cells far from the ball and the plate, and their fractions of the ball. These drops are thinner
/// than the option LeastThickness, so they get no elements.
const std::map<Index3, double> Drops{ { { { 0, 0, 14 } }, 0.0625 }, { { { 17, 0, 14 } }, 0.09375 },
  { { { 17, 11, 14 } }, 0.08 }, { { { 0, 11, 13 } }, 0.11 } };

HostFields WithDrops(int rank, int ranks)
{
  HostFields fields(rank, ranks);
  const IndexBox& box = fields.Cells;
  for (const auto& [cell, fraction] : Drops)
  {
    Index place = 0, stride = 1;
    bool isOwn = true;
    for (int a = 0; a < 3; ++a)
    {
      isOwn = isOwn && cell[a] >= box.Lower[a] && cell[a] < box.Upper[a];
      place += stride * (cell[a] - box.Lower[a]);
      stride *= box.Size(a);
    }
    if (isOwn)
    {
      fields.Ball[place] = fraction;
    }
  }
  return fields;
}

struct ParticleView
{
  std::int64_t Count = -1;
  const double *Positions = nullptr, *Radii = nullptr, *Volumes = nullptr, *Masses = nullptr;
  const std::int64_t* Ids = nullptr;
  const int* Materials = nullptr;
};

class SculptorParticles : public ::testing::Test
{
protected:
  void SetUp() override { ASSERT_EQ(sculptor_create(&this->Sculptor), SCULPTOR_OK); }
  void TearDown() override { EXPECT_EQ(sculptor_delete(this->Sculptor), SCULPTOR_OK); }

  void Mesh(const char* unmeshed, bool conserves)
  {
    const HostFields& f = this->Fields;
    sculptor_set_option(this->Sculptor, "UnmeshedMaterial", unmeshed);
    sculptor_set_option(this->Sculptor, "DensityArrays", conserves ? "density" : "None");
    sculptor_set_option(this->Sculptor, "VelocityArray", conserves ? "velocity" : "None");
    sculptor_set_box(this->Sculptor, f.Bounds.data(), f.Intervals.data());
    sculptor_set_neighbours(this->Sculptor, f.Neighbours.data());
    sculptor_clear_fields(this->Sculptor);
    sculptor_add_material(this->Sculptor, "ball", f.Ball.data());
    sculptor_add_material(this->Sculptor, "plate", f.Plate.data());
    sculptor_add_state(this->Sculptor, "velocity", 3, f.Velocity.data());
    sculptor_add_state(this->Sculptor, "density", 1, f.Density.data());
    ASSERT_EQ(sculptor_make_mesh(this->Sculptor, 0), SCULPTOR_OK)
      << sculptor_error_text(this->Sculptor);
  }

  ParticleView View()
  {
    ParticleView v;
    EXPECT_EQ(sculptor_get_particles(this->Sculptor, &v.Count, &v.Positions, &v.Ids, &v.Materials,
                &v.Radii, &v.Volumes, &v.Masses),
      SCULPTOR_OK);
    return v;
  }

  const double* State(const char* name, int components)
  {
    int found = 0;
    const double* values = nullptr;
    EXPECT_EQ(sculptor_get_particle_state(this->Sculptor, name, &found, &values), SCULPTOR_OK);
    EXPECT_EQ(found, components);
    return values;
  }

  double Number(const char* name, int index)
  {
    double value = 0.0;
    EXPECT_EQ(sculptor_get_number(this->Sculptor, name, index, &value), SCULPTOR_OK) << name;
    return value;
  }

  int Sculptor = 0;
  const HostFields Fields = WithDrops(MyRank(), NumberOfRanks());
};

std::int64_t Sum(std::int64_t mine)
{
  std::int64_t sum = 0;
  MPI_Allreduce(&mine, &sum, 1, MPI_INT64_T, MPI_SUM, MPI_COMM_WORLD);
  return sum;
}

double Sum(double mine)
{
  double sum = 0;
  MPI_Allreduce(&mine, &sum, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
  return sum;
}

/// Returns all values of a particle of the filter: id, material, position, radius, volume, mass,
/// velocity, density.
std::map<std::int64_t, std::vector<double>> ParticlesOf(vtkPolyData* output)
{
  std::map<std::int64_t, std::vector<double>> all;
  vtkPointData* data = output->GetPointData();
  for (vtkIdType p = 0; p < output->GetNumberOfPoints(); ++p)
  {
    std::vector<double> values{ data->GetArray("Material")->GetComponent(p, 0) };
    values.insert(values.end(), output->GetPoint(p), output->GetPoint(p) + 3);
    for (const char* name : { "Radius", "Volume", "Mass", "velocity", "density" })
    {
      vtkDataArray* array = data->GetArray(name);
      for (int c = 0; c < array->GetNumberOfComponents(); ++c)
      {
        values.push_back(array->GetComponent(p, c));
      }
    }
    all[static_cast<std::int64_t>(data->GetArray("Id")->GetComponent(p, 0))] = values;
  }
  return all;
}

} // namespace

TEST_F(SculptorParticles, AreThoseOfTheFilter)
{
  this->Mesh("Particles", true);
  vtkNew<vtkVolumeFractionToHex> mesher;
  mesher->AddDensityArray("density");
  mesher->SetVelocityArray("velocity");
  mesher->SetUnmeshedMaterial(vtkVolumeFractionMeshAlgorithm::UNMESHED_PARTICLES);
  MeshWhole(WithDrops(0, 1), *mesher);
  const auto expected = ParticlesOf(vtkPolyData::SafeDownCast(mesher->GetOutputDataObject(6)));
  const ParticleView found = this->View();
  ASSERT_EQ(expected.size(), Drops.size());
  ASSERT_EQ(Sum(found.Count), static_cast<std::int64_t>(Drops.size()));
  const double *velocity = this->State("velocity", 3), *density = this->State("density", 1);
  for (std::int64_t p = 0; p < found.Count; ++p)
  {
    const double* x = found.Positions + 3 * p;
    const double* v = velocity + 3 * p;
    const std::vector<double> values{ static_cast<double>(found.Materials[p]), x[0], x[1], x[2],
      found.Radii[p], found.Volumes[p], found.Masses[p], v[0], v[1], v[2], density[p] };
    EXPECT_EQ(values, expected.at(found.Ids[p])); // bit for bit
    EXPECT_TRUE(p == 0 || found.Ids[p] > found.Ids[p - 1]);
  }
}

TEST_F(SculptorParticles, SumsAreThoseOfTheCells)
{
  this->Mesh("Particles", true);
  const ParticleView found = this->View();
  const double* velocity = this->State("velocity", 3);
  double mass = 0.0, momentum[3] = {};
  for (std::int64_t p = 0; p < found.Count; ++p)
  {
    mass += found.Masses[p];
    for (int a = 0; a < 3; ++a)
    {
      momentum[a] += found.Masses[p] * velocity[3 * p + a];
    }
  }
  EXPECT_GT(Sum(mass), 0.0);
  EXPECT_NEAR((this->Number("MeshMass", 0) + Sum(mass)) / this->Number("InputMass", 0), 1.0, 1e-13);
  for (int a = 0; a < 3; ++a)
  {
    EXPECT_NEAR(
      (this->Number("MeshMomentum", a) + Sum(momentum[a])) / this->Number("InputMomentum", a), 1.0,
      1e-13);
  }
  EXPECT_EQ(this->Number("UnmeshedMass", 0), 0.0);
}

TEST_F(SculptorParticles, WithoutDensityThereAreNoMasses)
{
  this->Mesh("Particles", false);
  const ParticleView found = this->View();
  EXPECT_EQ(Sum(found.Count), static_cast<std::int64_t>(Drops.size()));
  EXPECT_EQ(found.Masses, nullptr);
  EXPECT_EQ(found.Volumes != nullptr, found.Count > 0);
  this->State("velocity", 3);
}

TEST_F(SculptorParticles, AreWritten)
{
  this->Mesh("Particles", true);
  const std::string path = "sculptor_particles" + std::to_string(NumberOfRanks()) + ".data";
  ASSERT_EQ(sculptor_write(this->Sculptor, path.c_str()), SCULPTOR_OK)
    << sculptor_error_text(this->Sculptor);
  if (MyRank() == 0)
  {
    std::ifstream file(path);
    std::string line;
    while (std::getline(file, line) && line.find(" atoms") == std::string::npos)
    {
    }
    EXPECT_EQ(line, "4 atoms");
    std::remove(path.c_str());
  }
}

/// A format without particles: the warnings of the mesh name the file beside it, on all ranks.
TEST_F(SculptorParticles, AreWrittenBeside)
{
  const std::string name = "sculptor_beside" + std::to_string(NumberOfRanks()),
                    mesh = name + ".vtu", beside = name + "_particles.vtp";
  for (const char* unmeshed : { "Particles", "Give" })
  {
    this->Mesh(unmeshed, true);
    const std::string before = sculptor_warning_text(this->Sculptor);
    EXPECT_EQ(before.find("particles"), std::string::npos) << before;
    ASSERT_EQ(sculptor_write(this->Sculptor, mesh.c_str()), SCULPTOR_OK)
      << sculptor_error_text(this->Sculptor);
    const bool hasParticles = std::string(unmeshed) == "Particles";
    EXPECT_EQ(std::string(sculptor_warning_text(this->Sculptor)),
      before +
        (hasParticles ? "Files as " + mesh + " hold no particles: they are in " + beside + ".\n"
                      : ""));
    MPI_Barrier(MPI_COMM_WORLD);
    if (MyRank() == 0)
    {
      EXPECT_EQ(std::remove(beside.c_str()) == 0, hasParticles);
      std::remove(mesh.c_str());
    }
    MPI_Barrier(MPI_COMM_WORLD);
  }
}

TEST_F(SculptorParticles, NoneWithoutTheOption)
{
  this->Mesh("Give", true);
  const ParticleView found = this->View();
  EXPECT_EQ(found.Count, 0);
  EXPECT_EQ(found.Positions, nullptr);
  EXPECT_EQ(found.Ids, nullptr);
  const double* values = nullptr;
  int components = 0;
  EXPECT_EQ(sculptor_get_particle_state(this->Sculptor, "velocity", &components, &values),
    SCULPTOR_ERROR_ARGUMENT);
  EXPECT_EQ(std::string(sculptor_error_text(this->Sculptor)),
    "The mesh has no state of particles named 'velocity'.");
  EXPECT_EQ(sculptor_write(this->Sculptor, "none.data"), SCULPTOR_ERROR_FILE);
}

TEST_F(SculptorParticles, ErrorsOfArguments)
{
  std::int64_t count = 0;
  EXPECT_EQ(sculptor_get_particles(
              this->Sculptor, &count, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr),
    SCULPTOR_ERROR_NO_MESH);
  this->Mesh("Particles", true);
  EXPECT_EQ(sculptor_get_particles(
              this->Sculptor, &count, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr),
    SCULPTOR_ERROR_ARGUMENT);
  EXPECT_EQ(std::string(sculptor_error_text(this->Sculptor)), "positions is a null pointer.");
  const double* values = nullptr;
  int components = 0;
  EXPECT_EQ(sculptor_get_particle_state(this->Sculptor, "none", &components, &values),
    SCULPTOR_ERROR_ARGUMENT);
}
