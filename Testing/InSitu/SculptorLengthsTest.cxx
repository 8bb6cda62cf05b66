/// Lengths far from 1 in the C interface: the same mesh in another unit of length, or one message
/// on all ranks.
#include "HostFields.h"
#include "Sculptor.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace vfm::testing;

namespace
{

/// Ranks' fields in another unit of length.
class SculptorLengths : public ::testing::TestWithParam<int> // parameter: whether tetrahedra
{
protected:
  /// Makes a mesh; returns the code. The mesh is that of Sculptor.
  int Make(double unit)
  {
    HostFields fields(MyRank(), NumberOfRanks());
    for (double& bound : fields.Bounds)
    {
      bound *= unit;
    }
    this->Release();
    this->Sculptor = CreateSculptor(fields);
    return sculptor_make_mesh(this->Sculptor, this->GetParam());
  }
  /// Returns the coordinates of this rank's points, in units of length.
  std::vector<double> Points(double unit) const
  {
    std::int64_t points = 0, elements = 0;
    int corners = 0;
    EXPECT_EQ(sculptor_get_counts(this->Sculptor, &points, &elements, &corners), SCULPTOR_OK);
    EXPECT_GT(elements, 0);
    const double* coordinates = nullptr;
    EXPECT_EQ(sculptor_get_points(this->Sculptor, &coordinates), SCULPTOR_OK);
    std::vector<double> x(coordinates, coordinates + 3 * points);
    for (double& at : x)
    {
      at /= unit;
    }
    return x;
  }
  double Number(const char* name) const
  {
    double number = 0.0;
    EXPECT_EQ(sculptor_get_number(this->Sculptor, name, 0, &number), SCULPTOR_OK);
    return number;
  }
  void Release() const
  {
    if (this->Sculptor > 0)
    {
      EXPECT_EQ(sculptor_delete(this->Sculptor), SCULPTOR_OK);
    }
  }
  void TearDown() override { this->Release(); }

  int Sculptor = 0;
};

} // namespace

TEST_P(SculptorLengths, AreOfAnyUnit)
{
  ASSERT_EQ(this->Make(1.0), SCULPTOR_OK);
  const std::vector<double> points = this->Points(1.0);
  const double quality = this->Number("MinimumScaledJacobian"), volume = this->Number("MeshVolume");
  for (const double unit : { 0x1p-160, 0x1p-40, 0x1p133, 0x1p160 })
  {
    ASSERT_EQ(this->Make(unit), SCULPTOR_OK) << sculptor_error_text(this->Sculptor);
    EXPECT_EQ(this->Points(unit), points) << unit;
    EXPECT_EQ(this->Number("MinimumScaledJacobian"), quality);
    EXPECT_EQ(this->Number("MeshVolume") / unit / unit / unit, volume);
  }
}

TEST_P(SculptorLengths, OutOfRangeAreReportedOnAllRanks)
{
  for (const double unit : { 1e-300, 1e-60, 1e60, 1e300 })
  {
    EXPECT_EQ(this->Make(unit), SCULPTOR_ERROR_INPUT) << unit;
    const std::string text = sculptor_error_text(this->Sculptor);
    EXPECT_EQ(text.find("The grid has cells of width "), 0u) << text;
    EXPECT_NE(
      text.find("Widths, also of refined cells, must be from 1e-50 to 1e+50"), std::string::npos)
      << text;
  }
}

INSTANTIATE_TEST_SUITE_P(Elements, SculptorLengths, ::testing::Values(0, 1));
