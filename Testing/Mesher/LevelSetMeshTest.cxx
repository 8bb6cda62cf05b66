/// Meshes of level sets.
#include "Levels/LevelSetBalls.h"
#include "Mesher.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

namespace
{

constexpr double FilmRadius = 0.64; // 0.4 cells around the ball

MesherInput MakeBalls(Ranks& ranks)
{
  MesherInput input;
  input.Levels = MakeInput({ All }, ranks, 1.0, FilmRadius);
  input.Arrays.Fractions = { "ball", "film" };
  return input;
}

double VolumeOfBall(double radius)
{
  return 4.0 / 3.0 * 3.14159265358979 * radius * radius * radius;
}

} // namespace

TEST(LevelSetMesh, BallInAFilmThinnerThanACell)
{
  Ranks alone;
  RankRuntime runtime(alone);
  MesherOptions options;
  options.LevelSets = LevelSetRule::Priority;
  const MeshReport report = RunMesher(MakeBalls(alone), options, runtime).Report;
  const double ball = VolumeOfBall(0.6), film = VolumeOfBall(FilmRadius) - ball;
  ASSERT_EQ(report.TargetVolume.size(), 3u);
  EXPECT_NEAR(report.TargetVolume[1], ball, 1e-4 * ball);
  EXPECT_NEAR(report.TargetVolume[2], film, 1e-3 * film);
  EXPECT_NEAR(report.MeshVolume[1], ball, 1e-4 * ball);
  EXPECT_NEAR(report.MeshVolume[2], film, 1e-3 * film);
  EXPECT_GT(report.MinimumScaledJacobian, 0.25);
}

TEST(LevelSetMesh, MessagesNameTheOption)
{
  Ranks alone;
  RankRuntime runtime(alone);
  MesherInput input = MakeBalls(alone);
  MesherOptions options;
  const std::string told = ErrorOf([&] { RunMesher(input, options, runtime); });
  EXPECT_NE(told.find("volume fractions lie in [0, 1]"), std::string::npos) << told;
  EXPECT_NE(told.find("LevelSets Priority (--level-set "), std::string::npos) << told;
  options.LevelSets = LevelSetRule::Priority;
  input.Arrays.Labels = "ball";
  input.Arrays.Fractions.clear();
  EXPECT_NE(ErrorOf([&] { RunMesher(input, options, runtime); }).find("LevelSets applies to"),
    std::string::npos);
}
