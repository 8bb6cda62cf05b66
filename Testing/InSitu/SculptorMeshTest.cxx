/// Meshes made by the calls of the Sculptor report.
#include "CMLPSculptor.c.h"
#include "HostFields.h"

#include <gtest/gtest.h>

#include <set>

using vfm::testing::HostFields;
using vfm::testing::MeshFromData;
using vfm::testing::MyRank;
using vfm::testing::NumberOfRanks;

namespace
{

/// Returns the volume of a tetrahedron.
double VolumeOfTet(const double* a, const double* b, const double* c, const double* d)
{
  double u[3], v[3], w[3];
  for (int i = 0; i < 3; ++i)
  {
    u[i] = b[i] - a[i];
    v[i] = c[i] - a[i];
    w[i] = d[i] - a[i];
  }
  return (u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) +
           u[2] * (v[0] * w[1] - v[1] * w[0])) /
    6.0;
}

/// Returns the sum of five tetrahedra per hexahedron. Positive volume requires
/// nodes in the right order and base.
double SumOfVolumes(const std::vector<double>& coordinates, const std::vector<int>& connectivity,
  int corners, int base)
{
  const int tets[5][4] = { { 0, 1, 3, 4 }, { 1, 2, 3, 6 }, { 1, 4, 5, 6 }, { 3, 4, 6, 7 },
    { 1, 3, 4, 6 } };
  double sum = 0.0;
  for (std::size_t first = 0; first < connectivity.size(); first += corners)
  {
    const auto at = [&](int c)
    { return coordinates.data() + 3 * (connectivity[first + c] - base); };
    for (int t = 0; t < (corners == 8 ? 5 : 1); ++t)
    {
      const int* tet = tets[t];
      const double volume = corners == 8
        ? VolumeOfTet(at(tet[0]), at(tet[1]), at(tet[2]), at(tet[3]))
        : VolumeOfTet(at(0), at(1), at(2), at(3));
      EXPECT_GT(volume, 0.0);
      sum += volume;
    }
  }
  return sum;
}

double SumOverRanks(double mine)
{
  double sum = 0.0;
  MPI_Allreduce(&mine, &sum, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
  return sum;
}

class SculptorMesh : public ::testing::TestWithParam<int> // parameter: whether tetrahedra
{
protected:
  void SetUp() override
  {
    this->Sculptor = c_create_cml_psculptor();
    ASSERT_GT(this->Sculptor, 0);
    sculptor_set_option(this->Sculptor, "IndexBase", "1");
    sculptor_set_option(this->Sculptor, "Method", "Lattice");
  }
  void TearDown() override { c_delete_cml_psculptor(this->Sculptor); }

  HostFields Fields{ MyRank(), NumberOfRanks() };
  int Sculptor = 0;
};

} // namespace

TEST_P(SculptorMesh, FreeMeshAndFragments)
{
  const bool tet = GetParam() != 0;
  HostFields& f = this->Fields;
  // The plate with a ball-shaped hole, without the ball, is one fragment.
  const auto method = tet ? c_get_free_tets : c_get_free_hexes;
  const auto fragmentMethod = tet ? c_get_fragment_tets : c_get_fragment_hexes;
  const int corners = tet ? 4 : 8;
  ASSERT_EQ(MeshFromData(this->Sculptor, f, f.Plate.data(), 0, 0, 1, GetParam()), SCULPTOR_OK)
    << sculptor_error_text(this->Sculptor);
  int nodes = 0, hexes = 0, tets = 0;
  c_get_free_totals(this->Sculptor, &nodes, &hexes, &tets);
  EXPECT_EQ(tet ? hexes : tets, 0);
  std::vector<double> coordinates(3 * nodes);
  std::vector<int> connectivity(corners * (tet ? tets : hexes));
  ASSERT_EQ(method(this->Sculptor, coordinates.data(), connectivity.data()), SCULPTOR_OK);
  double volume = 0;
  ASSERT_EQ(sculptor_get_number(this->Sculptor, "MeshVolume", 0, &volume), SCULPTOR_OK);
  // Hexahedra have curved faces; five tetrahedra neglect the curvature.
  EXPECT_NEAR(
    SumOverRanks(SumOfVolumes(coordinates, connectivity, corners, 1)), volume, 0.01 * volume);

  ASSERT_EQ(c_get_num_fragments(this->Sculptor), 1);
  int ownNodes = 0, ownHexes = 0, ownTets = 0;
  ASSERT_EQ(c_get_fragment_totals(this->Sculptor, 1, &ownNodes, &ownHexes, &ownTets), SCULPTOR_OK);
  EXPECT_EQ(ownNodes, nodes);
  EXPECT_EQ(ownHexes, hexes);
  EXPECT_EQ(ownTets, tets);
  std::vector<double> ownCoordinates(coordinates.size());
  std::vector<int> ownConnectivity(connectivity.size());
  ASSERT_EQ(
    fragmentMethod(this->Sculptor, 1, ownCoordinates.data(), ownConnectivity.data()), SCULPTOR_OK);
  EXPECT_EQ(ownCoordinates, coordinates);
  EXPECT_EQ(ownConnectivity, connectivity);
}

INSTANTIATE_TEST_SUITE_P(Kinds, SculptorMesh, ::testing::Values(0, 1));

TEST(SculptorFragments, SeveralFragmentsSplitTheMesh)
{
  const HostFields f(MyRank(), NumberOfRanks());
  std::vector<double> layers(f.Ball.size()); // two slabs with a gap
  for (std::size_t cell = 0; cell < layers.size(); ++cell)
  {
    const double x = f.Velocity[3 * cell];
    layers[cell] = x < 6 || x >= 11 ? 1.0 : 0.0;
  }
  const int sculptor = c_create_cml_psculptor();
  int nodes = 0, hexes = 0, tets = 0;
  ASSERT_EQ(MeshFromData(sculptor, f, layers.data(), 0, 1), SCULPTOR_OK)
    << sculptor_error_text(sculptor);
  ASSERT_EQ(c_get_num_fragments(sculptor), 2);
  c_get_free_totals(sculptor, &nodes, &hexes, &tets);
  int sum = 0;
  const double slabs[2] = { 6, 7 }; // thickness in cells
  for (int fragment = 1; fragment <= 2; ++fragment)
  {
    int partNodes = 0, partHexes = 0;
    ASSERT_EQ(
      c_get_fragment_totals(sculptor, fragment, &partNodes, &partHexes, &tets), SCULPTOR_OK);
    std::vector<double> coordinates(3 * partNodes);
    std::vector<int> connectivity(8 * partHexes);
    ASSERT_EQ(c_get_fragment_hexes(sculptor, fragment, coordinates.data(), connectivity.data()),
      SCULPTOR_OK);
    std::set<int> used(connectivity.begin(), connectivity.end());
    EXPECT_EQ(static_cast<int>(used.size()), partNodes); // no node of another fragment
    const double cell =
      vfm::testing::HostSpacing[0] * vfm::testing::HostSpacing[1] * vfm::testing::HostSpacing[2];
    const double volume = SumOverRanks(SumOfVolumes(coordinates, connectivity, 8, 0));
    EXPECT_NEAR(volume, slabs[fragment - 1] * 12 * 15 * cell, 1e-9);
    sum += partHexes;
  }
  EXPECT_EQ(sum, hexes);
  c_delete_cml_psculptor(sculptor);
  EXPECT_EQ(sculptor_error_code(0), SCULPTOR_OK);
}

/// auto_refine halves only cells that are too thin.
TEST(SculptorRefinement, HalvesThinLayersOnly)
{
  const HostFields f(MyRank(), NumberOfRanks());
  for (double height : { 1.0, 5.0 })
  {
    std::vector<double> layer(f.Ball.size());
    int cells = 0;
    for (std::size_t cell = 0; cell < layer.size(); ++cell)
    {
      const double z = f.Velocity[3 * cell + 2];
      layer[cell] = z >= 5 && z < 5 + height ? 1.0 : 0.0;
      cells += layer[cell] > 0.0 ? 1 : 0;
    }
    const int sculptor = c_create_cml_psculptor();
    int nodes = 0, hexes = 0, tets = 0;
    ASSERT_EQ(MeshFromData(sculptor, f, layer.data(), 1, 1), SCULPTOR_OK)
      << sculptor_error_text(sculptor);
    c_get_free_totals(sculptor, &nodes, &hexes, &tets);
    EXPECT_EQ(hexes, height > 2.0 ? cells : 8 * cells) << height;
    c_delete_cml_psculptor(sculptor);
    EXPECT_EQ(sculptor_error_code(0), SCULPTOR_OK);
  }
}
