/// Conserved state by the C interface: options, elements, nodes, sums.
#include "HostFields.h"
#include "MeshView.h"
#include "Sculptor.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolumeFractionToHex.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

using namespace vfm;
using namespace vfm::testing;

namespace
{

using Words = std::vector<std::pair<const char*, const char*>>;

class SculptorState : public ::testing::Test
{
protected:
  void SetUp() override { ASSERT_EQ(sculptor_create(&this->Sculptor), SCULPTOR_OK); }
  void TearDown() override { EXPECT_EQ(sculptor_delete(this->Sculptor), SCULPTOR_OK); }

  int Set(const char* name, const char* value)
  {
    return sculptor_set_option(this->Sculptor, name, value);
  }

  void HandOver()
  {
    const HostFields& f = this->Fields;
    sculptor_set_box(this->Sculptor, f.Bounds.data(), f.Intervals.data());
    sculptor_set_neighbours(this->Sculptor, f.Neighbours.data());
    sculptor_add_material(this->Sculptor, "ball", f.Ball.data());
    sculptor_add_material(this->Sculptor, "plate", f.Plate.data());
    sculptor_add_state(this->Sculptor, "velocity", 3, f.Velocity.data());
    sculptor_add_state(this->Sculptor, "density", 1, f.Density.data());
  }

  /// Compares the mesh, and the velocity of its nodes, with those of the filter on one rank.
  void ExpectThatOfTheFilter(const char* width, const char* ofMaterials = "None");

  double Number(const char* name, int index)
  {
    double value = 0.0;
    EXPECT_EQ(sculptor_get_number(this->Sculptor, name, index, &value), SCULPTOR_OK) << name;
    return value;
  }

  int Sculptor = 0;
  const HostFields Fields{ MyRank(), NumberOfRanks() };
};

/// Meshes the whole field by the filter on one rank.
void MeshWholeWithState(vtkVolumeFractionToHex& mesher)
{
  mesher.AddDensityArray("density");
  mesher.SetVelocityArray("velocity");
  mesher.SetNodalVelocity(true);
  MeshWhole(HostFields(0, 1), mesher);
}

using Vectors = std::map<std::int64_t, std::array<double, 3>>;

Vectors VelocitiesOfNodes(vtkUnstructuredGrid* mesh)
{
  Vectors velocities;
  vtkDataArray* values = mesh->GetPointData()->GetArray("velocity");
  vtkDataArray* ids = mesh->GetPointData()->GetGlobalIds();
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    values->GetTuple(p, velocities[static_cast<std::int64_t>(ids->GetComponent(p, 0))].data());
  }
  return velocities;
}

} // namespace

TEST_F(SculptorState, OptionsByText)
{
  for (const auto& [name, value] : Words{ { "StateTransfer", "conserve" },
         { "DensityArrays", "rho - 1, rho - 2" }, { "StateKinds", "p=volume,T=mass*cv" },
         { "StateOrder", "1" }, { "VelocityArray", "velocity" }, { "EnergyArray", "None" },
         { "NodalVelocity", "on" }, { "LostKineticEnergy", "internal energy" },
         { "UnmeshedMaterial", "Drop" }, { "RotatedArrays", "velocity, stress" } })
  {
    EXPECT_EQ(this->Set(name, value), SCULPTOR_OK) << sculptor_error_text(this->Sculptor);
  }
  for (const auto& [name, value] : Words{ { "StateTransfer", "some" }, { "StateKinds", "p" },
         { "StateOrder", "3" }, { "NodalVelocity", "perhaps" }, { "LostKineticEnergy", "heat" },
         { "UnmeshedMaterial", "keep" } })
  {
    EXPECT_EQ(this->Set(name, value), SCULPTOR_ERROR_ARGUMENT) << name;
    const std::string text = sculptor_error_text(this->Sculptor);
    EXPECT_NE(text.find(name), std::string::npos) << text;
    EXPECT_NE(text.find(value), std::string::npos) << text;
  }
}

void SculptorState::ExpectThatOfTheFilter(const char* width, const char* ofMaterials)
{
  ASSERT_EQ(this->Set("CellWidth", width), SCULPTOR_OK);
  ASSERT_EQ(this->Set("MaterialWidths", ofMaterials), SCULPTOR_OK);
  ASSERT_EQ(this->Set("DensityArrays", "density"), SCULPTOR_OK);
  ASSERT_EQ(this->Set("VelocityArray", "velocity"), SCULPTOR_OK);
  ASSERT_EQ(this->Set("NodalVelocity", "on"), SCULPTOR_OK);
  this->HandOver();
  ASSERT_EQ(sculptor_make_mesh(this->Sculptor, 0), SCULPTOR_OK)
    << sculptor_error_text(this->Sculptor);
  vtkNew<vtkVolumeFractionToHex> mesher;
  mesher->SetCellWidth(width);
  mesher->SetMaterialWidths(ofMaterials);
  MeshWholeWithState(*mesher);
  const MeshView mesh = ViewOf(this->Sculptor);
  EXPECT_EQ(SumOverRanks(Digest(mesh)), Digest(ViewOf(mesher->GetOutput())));

  const Vectors expected = VelocitiesOfNodes(mesher->GetOutput());
  const double* velocities = nullptr;
  std::int64_t points = 0, elements = 0;
  int components = 0, corners = 0;
  ASSERT_EQ(
    sculptor_get_point_state(this->Sculptor, "velocity", &components, &velocities), SCULPTOR_OK);
  ASSERT_EQ(components, 3);
  sculptor_get_counts(this->Sculptor, &points, &elements, &corners);
  for (std::int64_t p = 0; p < points; ++p)
  {
    for (int a = 0; a < 3; ++a)
    {
      ASSERT_EQ(velocities[3 * p + a], expected.at(mesh.PointIds[p])[a]);
    }
  }
}

TEST_F(SculptorState, IsThatOfTheFilter)
{
  this->ExpectThatOfTheFilter("0");
}

/// New cells get the state of cells that neither this rank nor its neighbours have.
TEST_F(SculptorState, OfWiderCellsIsThatOfTheFilter)
{
  this->ExpectThatOfTheFilter("0.17,0.2,0.2");
}

TEST_F(SculptorState, OfMaterialsWithWidthsIsThatOfTheFilter)
{
  this->ExpectThatOfTheFilter("0.4", "ball=0.2");
}

TEST_F(SculptorState, OfAutomaticWidthsIsThatOfTheFilter)
{
  this->ExpectThatOfTheFilter("0", "auto");
}

TEST_F(SculptorState, SumsAreThoseOfTheCells)
{
  ASSERT_EQ(this->Set("DensityArrays", "density"), SCULPTOR_OK);
  ASSERT_EQ(this->Set("VelocityArray", "velocity"), SCULPTOR_OK);
  this->HandOver();
  ASSERT_EQ(sculptor_make_mesh(this->Sculptor, 0), SCULPTOR_OK)
    << sculptor_error_text(this->Sculptor);
  const HostFields whole(0, 1);
  for (int material = 0; material < 2; ++material)
  {
    const std::vector<double>& fractions = material == 0 ? whole.Ball : whole.Plate;
    double mass = 0.0, momentum[3] = {};
    for (std::size_t cell = 0; cell < fractions.size(); ++cell)
    {
      const double part =
        fractions[cell] * whole.Density[cell] * HostSpacing[0] * HostSpacing[1] * HostSpacing[2];
      mass += part;
      for (int a = 0; a < 3; ++a)
      {
        momentum[a] += part * whole.Velocity[3 * cell + a];
      }
    }
    const double gone = this->Number("UnmeshedMass", material);
    EXPECT_NEAR((this->Number("MeshMass", material) + gone) / mass, 1.0, 1e-13);
    for (int a = 0; a < 3; ++a)
    {
      const double sum = this->Number("MeshMomentum", 3 * material + a) +
        this->Number("UnmeshedMomentum", 3 * material + a);
      EXPECT_NEAR(sum / momentum[a], 1.0, 1e-13);
    }
  }
  double beyond = 0.0;
  EXPECT_EQ(
    sculptor_get_number(this->Sculptor, "MeshMomentum", 6, &beyond), SCULPTOR_ERROR_ARGUMENT);
  const double* velocities = nullptr;
  int components = 0;
  EXPECT_EQ(sculptor_get_point_state(this->Sculptor, "velocity", &components, &velocities),
    SCULPTOR_ERROR_ARGUMENT); // velocities at nodes were not requested
  EXPECT_EQ(std::string(sculptor_error_text(this->Sculptor)),
    "The mesh has no state of nodes named 'velocity'.");
}

TEST_F(SculptorState, WrongNamesAreReportedOnAllRanks)
{
  ASSERT_EQ(this->Set("DensityArrays", "weight"), SCULPTOR_OK);
  this->HandOver();
  EXPECT_EQ(sculptor_make_mesh(this->Sculptor, 0), SCULPTOR_ERROR_INPUT);
  const std::string text = sculptor_error_text(this->Sculptor);
  EXPECT_NE(text.find("'weight'"), std::string::npos) << text;
  ASSERT_EQ(this->Set("DensityArrays", "None"), SCULPTOR_OK);
  EXPECT_EQ(sculptor_make_mesh(this->Sculptor, 0), SCULPTOR_OK);
}
