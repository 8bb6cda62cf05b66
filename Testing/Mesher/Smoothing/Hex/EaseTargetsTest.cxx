/// Targets give way where elements are poor.
#include "Smoothing/EaseTargets.h"

#include "../../GivenSurfaces/GivenCases.h"
#include "Smoothing/ActiveMeshBuilder.h"
#include "Smoothing/Hex/HexEnergy.h"

#include <gtest/gtest.h>

using namespace vfm;

namespace
{

constexpr SmoothingStage Stage{ 8, 60.0, 0.01, 40, 2e-3 };

/// The 2^3 hexes around a point, which a plane attracts.
class EightHexes
{
public:
  /// @param height  of the plane over the point along the diagonal (1, 1, 1)
  EightHexes(double height, float weight) :
    Box(8, { vfm::testing::BoxSurface({ { 2, 2, 2 } }, { { 6, 6, 6 } }) }),
    Targets(this->Box.Surface, SurfaceTargets::Kind::Quadrics, this->Box.Run)
  {
    ActiveMeshBuilder builder(8, 27, { { 13, 13, 0, {}, 0 } });
    for (Index hex = 0; hex < 8; ++hex)
    {
      const Index first = (hex & 1) + 3 * (hex >> 1 & 1) + 9 * (hex >> 2);
      const Index corners[8] = { first, first + 1, first + 4, first + 3, first + 9, first + 10,
        first + 13, first + 12 };
      builder.Add(corners);
    }
    this->Hexes = builder.FinishAlone();
    this->Hexes.Widths.assign(1, { { 1.0, 1.0, 1.0 } });
    for (std::size_t p = 0; p < this->Hexes.X.size(); ++p)
    {
      const Index n = this->Hexes.MeshPoint[p];
      this->Hexes.X[p] = { { 3.0 + n % 3, 3.0 + n / 3 % 3, 3.0 + n / 9 } };
    }
    const Vector3 diagonal = Unit({ { 1, 1, 1 } });
    const Vector3 on = Vector3{ { 4, 4, 4 } } + height * diagonal;
    const Index plane = this->Targets.Add(MakeLocalPlane(on, diagonal), {}, { { 1.0, 1.0, 1.0 } });
    this->Hexes.Attachments = { { static_cast<int>(plane), {}, weight, 0.0 } };
    this->Hexes.AttachmentOffset.assign(this->Hexes.X.size() + 1, 1);
    this->Hexes.AttachmentOffset[0] = 0;
  }

  /// Smooths, then eases. Returns whether points moved, and sets the height of the point.
  bool Ease(double& height)
  {
    const HexEnergy energy(0.55);
    Smoother smoother(this->Hexes, &this->Targets, energy, this->Box.Run);
    smoother.RunStage(Stage, [](double) {});
    this->Pulled = this->Height();
    const bool isEased = EaseTargets(Stage, smoother);
    height = this->Height();
    return isEased;
  }

  void Fade() { this->Hexes.AtFadingEdge.assign(this->Hexes.X.size(), 1); }

  double Pulled = 0.0; ///< height of the point after smoothing
  float Weight() const { return this->Hexes.Attachments[0].Weight; }

private:
  double Height() const
  {
    return Dot(this->Hexes.X[0] - Vector3{ { 4, 4, 4 } }, Unit({ { 1, 1, 1 } }));
  }

  vfm::testing::GivenCase Box;
  SurfaceTargets Targets;
  ActiveMesh Hexes;
};

TEST(EaseTargets, PointsOfPoorHexesGoBack)
{
  EightHexes hexes(1.2, 300.0f);
  double height;
  EXPECT_TRUE(hexes.Ease(height));
  EXPECT_LT(hexes.Weight(), 300.0f);
  EXPECT_GT(hexes.Pulled, height + 0.02);
  EXPECT_GT(height, 0.2);
}

TEST(EaseTargets, GoodHexesStay)
{
  double height;
  EightHexes good(0.1, 300.0f);
  EXPECT_FALSE(good.Ease(height));
  EXPECT_EQ(good.Weight(), 300.0f);
  EXPECT_EQ(height, good.Pulled);
}

TEST(EaseTargets, FadingEdgesGiveWayEarlier)
{
  double stays, eased;
  EightHexes edge(0.42, 300.0f), fading(0.42, 300.0f);
  fading.Fade();
  EXPECT_FALSE(edge.Ease(stays));
  EXPECT_TRUE(fading.Ease(eased));
  EXPECT_LT(eased, stays);
}

} // namespace
