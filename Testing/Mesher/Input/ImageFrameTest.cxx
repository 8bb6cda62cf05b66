/// Frames of images with a direction matrix.
#include "Input/ImageFrame.h"
#include "Base/Runtime.h"

#include <gtest/gtest.h>

using namespace vfm;

namespace
{

/// Returns a rotation about z by 30 degrees, also mirrored along the third axis.
ImageFrame MakeTilted(bool isMirrored)
{
  const double c = std::cos(M_PI / 6), s = std::sin(M_PI / 6);
  return MakeImageFrame(
    { { c, -s, 0, s, c, 0, 0, 0, isMirrored ? -1.0 : 1.0 } }, { { 1, 2, 3 } }, "a");
}

} // namespace

TEST(ImageFrame, PointsComeBack)
{
  for (bool isMirrored : { false, true })
  {
    const ImageFrame frame = MakeTilted(isMirrored);
    EXPECT_EQ(frame.IsMirrored(), isMirrored);
    EXPECT_FALSE(frame.IsAligned());
    const Vector3 point{ { 4, -5, 6 } };
    EXPECT_NEAR(Norm(frame.ToOwn(frame.ToSpace(point)) - point), 0.0, 1e-14);
    EXPECT_NEAR(Norm(frame.ToSpace(frame.Origin) - frame.Origin), 0.0, 1e-15);
  }
  EXPECT_TRUE(ImageFrame().IsIdentity());
  EXPECT_TRUE(MakeImageFrame({ { 0, 1, 0, 1, 0, 0, 0, 0, 1 } }, {}, "a").IsAligned());
}

TEST(ImageFrame, OtherMatricesAreErrors)
{
  EXPECT_THROW(MakeImageFrame({ { 1, 0, 0, 0, 2, 0, 0, 0, 1 } }, {}, "a"), InputError);
  EXPECT_THROW(MakeImageFrame({ { 1, 0.1, 0, 0, 1, 0, 0, 0, 1 } }, {}, "a"), InputError);
}

TEST(ImageFrame, TuplesTurnWithTheAxes)
{
  const ImageFrame frame = MakeTilted(true);
  Vector3 vector{ { 1, 2, 3 } };
  const Vector3 right = frame.ToSpace(frame.Origin + vector) - frame.Origin;
  RotateTuple(frame, 3, vector.data());
  EXPECT_NEAR(Norm(vector - right), 0.0, 1e-14);
  // A tensor of two vectors turns as these do, in both orders of components.
  std::array<double, 6> six{ { 1, 4, 9, 2, 6, 3 } };
  std::array<double, 9> nine{ { 1, 2, 3, 2, 4, 6, 3, 6, 9 } };
  RotateTuple(frame, 6, six.data());
  RotateTuple(frame, 9, nine.data());
  for (int i = 0; i < 9; ++i)
  {
    EXPECT_NEAR(nine[i], right[i / 3] * right[i % 3], 1e-13);
  }
  const int places[6] = { 0, 4, 8, 1, 5, 2 };
  for (int i = 0; i < 6; ++i)
  {
    EXPECT_NEAR(six[i], nine[places[i]], 1e-13);
  }
  EXPECT_TRUE(CanRotate(3) && CanRotate(6) && CanRotate(9));
  EXPECT_FALSE(CanRotate(4));
}
