/// Quadrics fitted to samples of surfaces.
#include "GivenSurfaces/SampleFit.h"
#include "GivenCases.h"

#include <gtest/gtest.h>

using namespace vfm;
using vfm::testing::GivenCase;

namespace
{

constexpr FitRange Range{ 1.5, 0.7 };

/// Samples around a node of the only body of a case.
std::vector<NearSample> SamplesAt(const GivenCase& given, const Vector3& origin)
{
  std::vector<NearSample> samples;
  NearSurface(given.Surfaces, 0, 1.0, given.Surface)
    .ListSamples({ {}, origin, { { 1.0, 1.0, 1.0 } } }, 4.0, samples);
  return samples;
}

TEST(SampleFit, SpheresAreMetClosely)
{
  const Vector3 centre{ { 8.1, 8.2, 8.3 } };
  for (double radius : { 1.5, 3.0, 6.0 })
  {
    const GivenCase sphere(16, { vfm::testing::SphereSurface(centre, radius, 96) });
    const Vector3 normal = Unit({ { 1.0, 0.5, 0.3 } });
    const Vector3 node = centre + radius * normal;
    const auto fit = FitSamples(SamplesAt(sphere, node), { {}, normal, -1, {} }, Range);
    ASSERT_TRUE(fit) << radius;
    EXPECT_LT(fit->Error, 0.02) << radius;
    Vector3 gradient;
    EXPECT_NEAR(DistanceTo(fit->Surface, {}, gradient), 0.0, 0.02) << radius;
    EXPECT_GT(Dot(gradient, normal), 0.999) << radius;
  }
}

TEST(SampleFit, OnlyThePartIsFitted)
{
  const GivenCase box(12, { vfm::testing::BoxSurface({ { 2, 2, 2 } }, { { 9, 9, 9 } }) });
  const std::vector<NearSample> samples = SamplesAt(box, { { 9, 9, 5 } });
  const auto fit = FitSamples(samples, { {}, { { 1, 0, 0 } }, -1, {} }, Range);
  ASSERT_TRUE(fit);
  EXPECT_LT(fit->Error, 1e-6);
  Vector3 gradient;
  EXPECT_NEAR(DistanceTo(fit->Surface, { { 0.5, 1.0, 0.0 } }, gradient), 0.5, 1e-3);
  // between two sides that fade into each other, the nearer normal decides
  const Vector3 between = Unit({ { 1.0, 0.8, 0.0 } });
  const auto first = FitSamples(samples, { {}, between, -1, { { 0, 1, 0 } } }, Range);
  ASSERT_TRUE(first);
  DistanceTo(first->Surface, {}, gradient);
  EXPECT_GT(gradient[0], 0.999);
  EXPECT_FALSE(FitSamples(samples, { {}, { { 0, 0, 1 } }, -1, {} }, Range));
  EXPECT_FALSE(FitSamples({}, { {}, { { 1, 0, 0 } }, -1, {} }, Range));
}

TEST(SampleFit, FewSamplesDefineAPlane)
{
  std::vector<NearSample> samples;
  for (int i = 0; i < 5; ++i)
  {
    samples.push_back({ { { 0.1 * i, 0.2 * (i % 2), 0.0 } }, { { 0, 0, 1 } }, 0.1, 0 });
  }
  const auto fit = FitSamples(samples, { {}, { { 0, 0, 1 } }, 0, {} }, Range);
  ASSERT_TRUE(fit);
  EXPECT_EQ(fit->Surface.C[3], 0.0);
  EXPECT_FALSE(FitSamples(samples, { {}, { { 0, 0, 1 } }, 1, {} }, Range)); // another sheet
}

} // namespace
