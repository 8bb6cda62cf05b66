/// Fits of half-spaces and films to exact fractions.
#include "Fractions/LayerFit.h"
#include "Base/Vector3.h"
#include "RandomDraw.h"

#include <gtest/gtest.h>

using namespace vfm;
using vfm::testing::RandomDraw;

namespace
{

/// Returns the fractions of a layer in the unit cube and the cells around it.
std::vector<FractionSample> SampleLayer(const Layer& layer)
{
  std::vector<FractionSample> samples;
  for (int n : { 13, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 14, 15, 16, 17, 18, 19, 20, 21, 22,
         23, 24, 25, 26 })
  {
    const Index3 step = StepAround(n);
    FractionSample sample{ {}, {}, 0.0, 1.0 };
    for (int a = 0; a < 3; ++a)
    {
      sample.Size[a] = step[a] == 0 ? 1.0 : 0.8 + 0.2 * a;
      sample.Centre[a] = static_cast<double>(step[a]) * 0.5 * (1.0 + sample.Size[a]);
    }
    sample.Value = FractionInLayer(layer, sample.Centre, sample.Size);
    samples.push_back(sample);
  }
  return samples;
}

} // namespace

TEST(LayerFit, FractionsOfLayersAlongAnAxis)
{
  const Vector3 centre{ { 1.0, 2.0, 3.0 } }, size{ { 2.0, 1.0, 4.0 } };
  EXPECT_NEAR(FractionInLayer({ { { 1, 0, 0 } }, -INFINITY, 0.5 }, centre, size), 0.25, 1e-14);
  EXPECT_NEAR(FractionInLayer({ { { 0, 0, 1 } }, 2.0, 3.0 }, centre, size), 0.25, 1e-14);
  EXPECT_NEAR(FractionInLayer({ { { 0, 1, 0 } }, 3.0, 4.0 }, centre, size), 0.0, 1e-14);
}

TEST(LayerFit, FlatInterfacesAreFound)
{
  RandomDraw random(5);
  for (int i = 0; i < 100; ++i)
  {
    const Layer layer{ Unit(random.Vector(-1, 1)), -INFINITY, random.Between(-0.3, 0.3) };
    const LayerFit fit = FitHalfSpace(SampleLayer(layer));
    ASSERT_TRUE(fit.IsFound);
    ASSERT_LT(fit.Error, 1e-9);
    ASSERT_NEAR(fit.Region.Upper, layer.Upper, 1e-7);
    ASSERT_NEAR(Norm(fit.Region.Normal - layer.Normal), 0.0, 1e-7);
  }
}

// The films are oblique: the tilt of a film between two layers of cells would not show.
TEST(LayerFit, FilmsAreFound)
{
  RandomDraw random(6);
  for (int i = 0; i < 50; ++i)
  {
    const double middle = random.Between(-0.2, 0.2);
    const Layer layer{ Unit(random.Vector(0.5, 1.0)), middle - 0.15, middle + 0.15 };
    const LayerFit fit = FitFilm(SampleLayer(layer));
    ASSERT_TRUE(fit.IsFound);
    ASSERT_LT(fit.Error, 1e-6);
    ASSERT_NEAR(std::fabs(Dot(fit.Region.Normal, layer.Normal)), 1.0, 1e-6);
    ASSERT_NEAR(fit.Region.Upper - fit.Region.Lower, 0.3, 1e-5);
  }
}

TEST(LayerFit, ThreadsAreNoFilms)
{
  RandomDraw random(7);
  for (int i = 0; i < 50; ++i)
  {
    const double middle = random.Between(-0.2, 0.2);
    const Layer film{ Unit(random.Vector(0.1, 1.0)), middle - 0.2, middle + 0.2 };
    std::vector<FractionSample> samples = SampleLayer(film);
    EXPECT_FALSE(IsAlongLine(samples));
    const Vector3 direction = Unit(random.Vector(0.1, 1.0));
    for (FractionSample& sample : samples)
    {
      const Vector3 r = sample.Centre - Dot(sample.Centre, direction) * direction;
      sample.Value = std::exp(-4.0 * Dot(r, r)); // a thread with a smeared surface
    }
    EXPECT_TRUE(IsAlongLine(samples));
  }
}
