/// Results of the calls of the Sculptor report, with and without a mesh, and
/// of the C++ class based on them.
#include "CMLPSculptor.hpp"
#include "HostFields.h"

#include <gtest/gtest.h>

#include <utility>

using vfm::testing::HostFields;
using vfm::testing::MeshFromData;
using vfm::testing::MyRank;
using vfm::testing::NumberOfRanks;

namespace
{

constexpr int WrongHandle = 987654;

class CMLPSculptor : public ::testing::Test
{
protected:
  void SetUp() override
  {
    this->Handle = c_create_cml_psculptor();
    ASSERT_GT(this->Handle, 0);
  }
  void TearDown() override
  {
    c_delete_cml_psculptor(this->Handle);
    EXPECT_EQ(sculptor_error_code(0), SCULPTOR_OK);
  }
  int Mesh() { return MeshFromData(this->Handle, this->Fields, this->Fields.Ball.data()); }
  /// Expects the handle's code of the last call and a text that contains the words.
  void ExpectError(int code, const std::string& words) const
  {
    EXPECT_EQ(sculptor_error_code(this->Handle), code);
    const std::string text = sculptor_error_text(this->Handle);
    EXPECT_NE(text.find(words), std::string::npos) << text;
  }

  int Handle = 0;
  int Nodes = -1, Hexes = -1, Tets = -1;
  HostFields Fields{ MyRank(), NumberOfRanks() };
};

/// Makes the same mesh as Mesh.
void MakeMesh(cml::PSculptor& sculptor, const HostFields& f)
{
  sculptor.mesh_from_data(f.Bounds[0], f.Bounds[1], f.Bounds[2], f.Bounds[3], f.Bounds[4],
    f.Bounds[5], f.Intervals[0], f.Intervals[1], f.Intervals[2], f.Ball.data(), f.Neighbours[1],
    f.Neighbours[0], f.Neighbours[3], f.Neighbours[2], f.Neighbours[5], f.Neighbours[4], 0, 0, 1,
    0);
}

/// Returns the code of the error that the work throws; 0 if it throws none.
template <class Work>
int CodeOf(const Work& work)
{
  try
  {
    work();
  }
  catch (const cml::Error& error)
  {
    EXPECT_STRNE(error.what(), "");
    return error.code();
  }
  return SCULPTOR_OK;
}

} // namespace

TEST_F(CMLPSculptor, WithoutMesh)
{
  c_get_free_totals(this->Handle, &this->Nodes, &this->Hexes, &this->Tets);
  this->ExpectError(SCULPTOR_ERROR_NO_MESH, "no mesh");
  EXPECT_EQ(this->Nodes, 0);
  EXPECT_EQ(this->Hexes, 0);
  EXPECT_EQ(this->Tets, 0);
  EXPECT_EQ(c_get_num_fragments(this->Handle), -1);
  this->ExpectError(SCULPTOR_ERROR_NO_MESH, "no mesh");
  EXPECT_EQ(c_get_free_hexes(this->Handle, nullptr, nullptr), SCULPTOR_ERROR_NO_MESH);
  EXPECT_EQ(c_get_free_tets(this->Handle, nullptr, nullptr), SCULPTOR_ERROR_NO_MESH);
  EXPECT_EQ(c_get_fragment_totals(this->Handle, 1, &this->Nodes, &this->Hexes, &this->Tets),
    SCULPTOR_ERROR_NO_MESH);
  EXPECT_EQ(c_get_fragment_hexes(this->Handle, 1, nullptr, nullptr), SCULPTOR_ERROR_NO_MESH);
  EXPECT_EQ(c_get_fragment_tets(this->Handle, 1, nullptr, nullptr), SCULPTOR_ERROR_NO_MESH);
}

TEST_F(CMLPSculptor, WrongArguments)
{
  ASSERT_EQ(this->Mesh(), SCULPTOR_OK);
  c_get_free_totals(this->Handle, &this->Nodes, nullptr, &this->Tets);
  this->ExpectError(SCULPTOR_ERROR_ARGUMENT, "num_hexes is a null pointer");
  EXPECT_EQ(this->Nodes, 0);
  c_get_free_totals(this->Handle, &this->Nodes, &this->Hexes, &this->Tets);
  EXPECT_EQ(sculptor_error_code(this->Handle), SCULPTOR_OK);
  ASSERT_GT(this->Hexes, 0);
  EXPECT_EQ(c_get_free_hexes(this->Handle, nullptr, nullptr), SCULPTOR_ERROR_ARGUMENT);
  this->ExpectError(SCULPTOR_ERROR_ARGUMENT, "coords is a null pointer");
  std::vector<double> coords(3 * this->Nodes);
  EXPECT_EQ(c_get_free_hexes(this->Handle, coords.data(), nullptr), SCULPTOR_ERROR_ARGUMENT);
  this->ExpectError(SCULPTOR_ERROR_ARGUMENT, "hexes is a null pointer");
  // the mesh has no tetrahedra
  EXPECT_EQ(c_get_free_tets(this->Handle, coords.data(), nullptr), SCULPTOR_OK);
  for (int fragment : { -1, 0, 2 })
  {
    EXPECT_EQ(
      c_get_fragment_totals(this->Handle, fragment, &this->Nodes, &this->Hexes, &this->Tets),
      SCULPTOR_ERROR_ARGUMENT);
    this->ExpectError(SCULPTOR_ERROR_ARGUMENT, "There is no fragment " + std::to_string(fragment));
  }
}

TEST_F(CMLPSculptor, WrongHandles)
{
  c_get_free_totals(WrongHandle, &this->Nodes, &this->Hexes, &this->Tets);
  EXPECT_EQ(this->Nodes, 0);
  EXPECT_EQ(sculptor_error_code(0), SCULPTOR_ERROR_HANDLE);
  EXPECT_EQ(sculptor_error_code(WrongHandle), SCULPTOR_ERROR_HANDLE);
  EXPECT_NE(std::string(sculptor_error_text(0)).find("987654"), std::string::npos);
  EXPECT_EQ(c_get_num_fragments(WrongHandle), -1);
  EXPECT_EQ(
    MeshFromData(WrongHandle, this->Fields, this->Fields.Ball.data()), SCULPTOR_ERROR_HANDLE);
  EXPECT_EQ(sculptor_error_code(this->Handle), SCULPTOR_OK); // an error of another call
  const int deleted = c_create_cml_psculptor();
  EXPECT_NE(deleted, this->Handle);
  EXPECT_EQ(sculptor_error_code(0), SCULPTOR_OK);
  c_delete_cml_psculptor(deleted);
  EXPECT_EQ(sculptor_error_code(0), SCULPTOR_OK);
  c_delete_cml_psculptor(deleted);
  EXPECT_EQ(sculptor_error_code(0), SCULPTOR_ERROR_HANDLE);
}

TEST_F(CMLPSculptor, HandlesAreThoseOfSculptor)
{
  ASSERT_EQ(this->Mesh(), SCULPTOR_OK);
  c_get_free_totals(this->Handle, &this->Nodes, &this->Hexes, &this->Tets);
  std::int64_t points = 0, elements = 0;
  int corners = 0, handle = 0;
  EXPECT_EQ(sculptor_get_counts(this->Handle, &points, &elements, &corners), SCULPTOR_OK);
  EXPECT_EQ(points, this->Nodes);
  EXPECT_EQ(elements, this->Hexes);
  EXPECT_EQ(corners, 8);
  ASSERT_EQ(sculptor_create(&handle), SCULPTOR_OK);
  EXPECT_EQ(MeshFromData(handle, this->Fields, this->Fields.Ball.data()), SCULPTOR_OK);
  EXPECT_EQ(c_get_num_fragments(handle), 1);
  c_delete_cml_psculptor(handle);
  EXPECT_EQ(sculptor_delete(handle), SCULPTOR_ERROR_HANDLE);
}

TEST_F(CMLPSculptor, ClassGivesTheSame)
{
  ASSERT_EQ(this->Mesh(), SCULPTOR_OK);
  c_get_free_totals(this->Handle, &this->Nodes, &this->Hexes, &this->Tets);
  std::vector<double> coords(3 * this->Nodes);
  std::vector<int> hexes(8 * this->Hexes);
  ASSERT_EQ(c_get_free_hexes(this->Handle, coords.data(), hexes.data()), SCULPTOR_OK);

  cml::PSculptor sculptor;
  MakeMesh(sculptor, this->Fields);
  const cml::Mesh mesh = sculptor.get_free_mesh(), fragment = sculptor.get_fragment_mesh(1);
  EXPECT_EQ(mesh.coords, coords);
  EXPECT_EQ(mesh.hexes, hexes);
  EXPECT_TRUE(mesh.tets.empty());
  EXPECT_EQ(sculptor.get_num_fragments(), 1);
  EXPECT_EQ(fragment.coords, coords);
  EXPECT_EQ(fragment.hexes, hexes);
}

TEST_F(CMLPSculptor, ClassThrows)
{
  cml::PSculptor sculptor;
  EXPECT_EQ(CodeOf([&] { sculptor.get_free_totals(); }), SCULPTOR_ERROR_NO_MESH);
  EXPECT_EQ(CodeOf([&] { sculptor.get_free_mesh(); }), SCULPTOR_ERROR_NO_MESH);
  EXPECT_EQ(CodeOf([&] { sculptor.get_num_fragments(); }), SCULPTOR_ERROR_NO_MESH);
  EXPECT_EQ(CodeOf([&] { sculptor.get_fragment_mesh(1); }), SCULPTOR_ERROR_NO_MESH);
  this->Fields.Ball[0] = -1.0;
  EXPECT_EQ(CodeOf([&] { MakeMesh(sculptor, this->Fields); }), SCULPTOR_ERROR_INPUT);
  EXPECT_EQ(CodeOf([&] { sculptor.check(sculptor_set_option(sculptor.handle(), "Iso", "1")); }),
    SCULPTOR_ERROR_ARGUMENT);
}

TEST_F(CMLPSculptor, ClassOwnsItsSculptor)
{
  int first = 0, second = 0;
  const double* points = nullptr;
  {
    cml::PSculptor sculptor, other;
    first = sculptor.handle();
    second = other.handle();
    MakeMesh(sculptor, this->Fields);
    cml::PSculptor moved(std::move(sculptor));
    EXPECT_EQ(moved.handle(), first);
    EXPECT_GE(moved.get_free_totals().nodes, 0);
    other = std::move(moved); // the second is deleted
    EXPECT_EQ(other.handle(), first);
    EXPECT_EQ(sculptor_get_points(second, &points), SCULPTOR_ERROR_HANDLE);
    EXPECT_EQ(sculptor_get_points(first, &points), SCULPTOR_OK);
    EXPECT_EQ(CodeOf([&] { moved.get_num_fragments(); }), SCULPTOR_ERROR_HANDLE);
  }
  EXPECT_EQ(sculptor_get_points(first, &points), SCULPTOR_ERROR_HANDLE);
}
