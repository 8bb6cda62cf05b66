/// Invalid arguments of the C interface give a code and a text, and the host continues.
#include "HostFields.h"
#include "Sculptor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using vfm::testing::HostFields;
using vfm::testing::MeshFromData;
using vfm::testing::MyRank;
using vfm::testing::NumberOfRanks;

namespace
{

constexpr int WrongHandle = 987654;

class SculptorArguments : public ::testing::Test
{
protected:
  void SetUp() override { ASSERT_EQ(sculptor_create(&this->Sculptor), SCULPTOR_OK); }
  void TearDown() override { EXPECT_EQ(sculptor_delete(this->Sculptor), SCULPTOR_OK); }

  /// Calls c_mesh_from_data with this rank's fields, which the test may have changed.
  int Mesh(int refine = 0, int smooth = 1)
  {
    return MeshFromData(this->Sculptor, this->Fields, this->Fields.Ball.data(), refine, 0, smooth);
  }
  /// Expects the words in the error text, and that a mesh can be made afterwards.
  void ExpectText(const std::string& words)
  {
    const std::string text = sculptor_error_text(this->Sculptor);
    EXPECT_NE(text.find(words), std::string::npos) << text;
    const double* points = nullptr;
    EXPECT_EQ(sculptor_get_points(this->Sculptor, &points), SCULPTOR_ERROR_NO_MESH);
    this->Fields = HostFields(MyRank(), NumberOfRanks());
    EXPECT_EQ(this->Mesh(), SCULPTOR_OK) << sculptor_error_text(this->Sculptor);
  }

  int Sculptor = 0;
  HostFields Fields{ MyRank(), NumberOfRanks() };
  // some arguments are invalid only on this rank
  const bool IsLast = MyRank() == NumberOfRanks() - 1;
};

} // namespace

TEST_F(SculptorArguments, WrongHandles)
{
  const double* coordinates = nullptr;
  EXPECT_EQ(sculptor_clear_fields(WrongHandle), SCULPTOR_ERROR_HANDLE);
  EXPECT_NE(std::string(sculptor_error_text(0)).find("987654"), std::string::npos);
  EXPECT_EQ(sculptor_delete(0), SCULPTOR_ERROR_HANDLE);
  EXPECT_EQ(sculptor_get_points(-1, &coordinates), SCULPTOR_ERROR_HANDLE);
  int deleted = 0;
  ASSERT_EQ(sculptor_create(&deleted), SCULPTOR_OK);
  ASSERT_EQ(sculptor_delete(deleted), SCULPTOR_OK);
  EXPECT_EQ(sculptor_delete(deleted), SCULPTOR_ERROR_HANDLE);
  EXPECT_EQ(sculptor_create(nullptr), SCULPTOR_ERROR_ARGUMENT);
}

TEST_F(SculptorArguments, NullFractionsOnOneRank)
{
  HostFields& f = this->Fields;
  EXPECT_EQ(MeshFromData(this->Sculptor, f, this->IsLast ? nullptr : f.Ball.data()),
    SCULPTOR_ERROR_ARGUMENT);
  this->ExpectText("vfrac is a null pointer");
}

TEST_F(SculptorArguments, NullBox)
{
  const HostFields& f = this->Fields;
  EXPECT_EQ(sculptor_set_box(this->Sculptor, nullptr, f.Intervals.data()), SCULPTOR_ERROR_ARGUMENT);
  this->ExpectText("bounding_box is a null pointer");
  EXPECT_EQ(sculptor_set_box(this->Sculptor, f.Bounds.data(), nullptr), SCULPTOR_ERROR_ARGUMENT);
}

TEST_F(SculptorArguments, NoCells)
{
  this->Fields.Intervals[0] = this->IsLast ? 0 : this->Fields.Intervals[0];
  EXPECT_EQ(this->Mesh(), SCULPTOR_ERROR_ARGUMENT);
  this->ExpectText("xint is 0");
}

TEST_F(SculptorArguments, BoxInsideOut)
{
  std::swap(this->Fields.Bounds[1], this->Fields.Bounds[4]);
  EXPECT_EQ(this->Mesh(), SCULPTOR_ERROR_ARGUMENT);
  this->ExpectText("bounding box");
}

TEST_F(SculptorArguments, NumbersOutOfRange)
{
  EXPECT_EQ(this->Mesh(17), SCULPTOR_ERROR_ARGUMENT);
  this->ExpectText("MaximumLevel");
  EXPECT_EQ(this->Mesh(-1), SCULPTOR_ERROR_ARGUMENT);
  this->ExpectText("auto_refine is -1");
  EXPECT_EQ(this->Mesh(0, 3), SCULPTOR_ERROR_ARGUMENT);
  this->ExpectText("Smoothing");
}

TEST_F(SculptorArguments, FractionsThatAreNone)
{
  this->Fields.Ball[7] =
    this->IsLast ? std::numeric_limits<double>::quiet_NaN() : this->Fields.Ball[7];
  EXPECT_EQ(this->Mesh(), SCULPTOR_ERROR_INPUT);
  this->ExpectText("material");
  this->Fields.Ball[0] = 1.5;
  EXPECT_EQ(this->Mesh(), SCULPTOR_ERROR_INPUT);
  this->ExpectText("1.5");
}

TEST_F(SculptorArguments, NeighboursThatDoNotMatch)
{
  if (this->IsLast)
  {
    this->Fields.Neighbours[5] = 99;
  }
  EXPECT_EQ(this->Mesh(), SCULPTOR_ERROR_INPUT);
  this->ExpectText("99");
  if (NumberOfRanks() == 1)
  {
    return;
  }
  if (this->IsLast)
  {
    this->Fields.Neighbours.fill(-1);
  }
  EXPECT_EQ(this->Mesh(), SCULPTOR_ERROR_INPUT);
  this->ExpectText("does not name it");
  this->Fields.Neighbours.fill(-1);
  EXPECT_EQ(this->Mesh(), SCULPTOR_ERROR_INPUT);
  this->ExpectText("do not lead to");
}

TEST_F(SculptorArguments, BoxesThatDoNotMatch)
{
  if (NumberOfRanks() == 1)
  {
    GTEST_SKIP() << "needs two ranks";
  }
  if (this->IsLast)
  {
    this->Fields.Bounds[5] += 0.3 * vfm::testing::HostSpacing[2];
  }
  EXPECT_EQ(this->Mesh(), SCULPTOR_ERROR_INPUT);
  this->ExpectText("along z");
}

TEST_F(SculptorArguments, RanksThatDoNotAgree)
{
  if (NumberOfRanks() == 1)
  {
    GTEST_SKIP() << "needs two ranks";
  }
  EXPECT_EQ(
    sculptor_set_option(this->Sculptor, "IsoValue", this->IsLast ? "0.4" : "0.5"), SCULPTOR_OK);
  EXPECT_EQ(this->Mesh(), SCULPTOR_ERROR_ARGUMENT);
  EXPECT_EQ(sculptor_set_option(this->Sculptor, "IsoValue", "0.5"), SCULPTOR_OK);
  this->ExpectText("do not agree");
}

TEST_F(SculptorArguments, WhatIsMissing)
{
  EXPECT_EQ(sculptor_make_mesh(this->Sculptor, 0), SCULPTOR_ERROR_ARGUMENT);
  this->ExpectText("No box");
  EXPECT_EQ(sculptor_make_mesh(this->Sculptor, 0), SCULPTOR_ERROR_ARGUMENT);
  this->ExpectText("volume fractions"); // fractions of c_mesh_from_data are discarded
}

TEST_F(SculptorArguments, NamesThatAreUnknown)
{
  EXPECT_EQ(sculptor_set_option(this->Sculptor, "Smothing", "Off"), SCULPTOR_ERROR_ARGUMENT);
  EXPECT_NE(std::string(sculptor_error_text(this->Sculptor)).find("Smothing"), std::string::npos);
  EXPECT_EQ(sculptor_set_option(this->Sculptor, "IsoValue", "half"), SCULPTOR_ERROR_ARGUMENT);
  EXPECT_EQ(sculptor_set_option(this->Sculptor, nullptr, "1"), SCULPTOR_ERROR_ARGUMENT);
  EXPECT_EQ(sculptor_set_option(this->Sculptor, "IndexBase", "2"), SCULPTOR_ERROR_ARGUMENT);
  ASSERT_EQ(this->Mesh(), SCULPTOR_OK);
  double value = 0;
  int components = 0;
  const double* values = nullptr;
  EXPECT_EQ(sculptor_get_number(this->Sculptor, "MeshVolumes", 0, &value), SCULPTOR_ERROR_ARGUMENT);
  EXPECT_EQ(sculptor_get_number(this->Sculptor, "MeshVolume", 1, &value), SCULPTOR_ERROR_ARGUMENT);
  EXPECT_EQ(
    sculptor_get_state(this->Sculptor, "velocity", &components, &values), SCULPTOR_ERROR_ARGUMENT);
}

TEST_F(SculptorArguments, NoCommunicator)
{
  EXPECT_EQ(sculptor_set_communicator(this->Sculptor, MPI_Comm_c2f(MPI_COMM_NULL)),
    SCULPTOR_ERROR_ARGUMENT);
  this->ExpectText("not a communicator");
}

TEST_F(SculptorArguments, FilesThatCannotBeWritten)
{
  EXPECT_EQ(sculptor_write(this->Sculptor, "mesh.pvtu"), SCULPTOR_ERROR_NO_MESH);
  ASSERT_EQ(this->Mesh(), SCULPTOR_OK);
  EXPECT_EQ(sculptor_write(this->Sculptor, nullptr), SCULPTOR_ERROR_ARGUMENT);
  EXPECT_EQ(sculptor_write(this->Sculptor, "/no/such/folder/mesh.pvtu"), SCULPTOR_ERROR_FILE);
  EXPECT_EQ(sculptor_write(this->Sculptor, "mesh.xyz"), SCULPTOR_ERROR_ARGUMENT);
}
