#include "Smoothing/EaseTargets.h"

#include "Elements/TetQuality.h"
#include "Geometry/Quality.h"

namespace vfm
{
namespace
{

/// Limits of poor elements.
struct Limits
{
  double Jacobian, LeastAngle, LargestAngle; // degrees
};
constexpr Limits AtFadingEdges{ 0.61, 20.0, 150.0 }, Elsewhere{ 0.5, 20.0, 150.0 };
constexpr int MostRounds = 5;
constexpr float Easing = 0.25f; // factor of the weights in a round
constexpr float LeastWeight = 0.1f;
// Corners of hexes numbered by bits, in VTK's order.
constexpr std::array<int, 8> VtkCorners{ 0, 1, 3, 2, 4, 5, 7, 6 };

bool IsPoorHex(const ActiveMesh& mesh, const int* corners, const Limits& limits)
{
  constexpr std::array<Index, 8> hex{ 0, 1, 2, 3, 4, 5, 6, 7 };
  std::array<Vector3, 8> points;
  for (int c = 0; c < 8; ++c)
  {
    points[c] = mesh.X[corners[VtkCorners[c]]];
  }
  return HexScaledJacobian(points[0].data(), hex.data()) < limits.Jacobian;
}

bool IsPoorTet(const ActiveMesh& mesh, const int* corners, const Limits& limits)
{
  constexpr std::array<Index, 4> tet{ 0, 1, 2, 3 };
  std::array<Vector3, 4> points;
  for (int c = 0; c < 4; ++c)
  {
    points[c] = mesh.X[corners[c]];
  }
  std::array<double, 6> angles;
  DihedralAngles(points[0].data(), tet.data(), angles.data());
  const auto [least, largest] = std::minmax_element(angles.begin(), angles.end());
  return *least < limits.LeastAngle || *largest > limits.LargestAngle;
}

/// Returns whether an element at an owned point is poor.
bool HasPoorElement(const ActiveMesh& mesh, int point)
{
  const bool fades = !mesh.AtFadingEdge.empty() && mesh.AtFadingEdge[point];
  const Limits& limits = fades ? AtFadingEdges : Elsewhere;
  return std::any_of(mesh.CornerList.begin() + mesh.CornerOffset[point],
    mesh.CornerList.begin() + mesh.CornerOffset[point + 1],
    [&](CornerPosition at)
    {
      const int* corners = mesh.Elements.data() + at / mesh.Corners * mesh.Corners;
      return !mesh.IsBarrierAt(at) &&
        (mesh.HasHexes() ? IsPoorHex(mesh, corners, limits) : IsPoorTet(mesh, corners, limits));
    });
}

/// Lowers the weights at a point. Returns false if they are the least ones.
bool Ease(ActiveMesh& mesh, int point)
{
  bool isEased = false;
  for (CornerPosition i = mesh.AttachmentOffset[point]; i < mesh.AttachmentOffset[point + 1]; ++i)
  {
    float& weight = mesh.Attachments[i].Weight;
    isEased = isEased || weight > LeastWeight;
    weight = weight > LeastWeight ? std::max(LeastWeight, Easing * weight) : weight;
  }
  return isEased;
}

} // namespace

bool EaseTargets(const SmoothingStage& stage, Smoother& smoother)
{
  ActiveMesh& mesh = smoother.TheMesh();
  for (int round = 0; round < MostRounds; ++round)
  {
    std::vector<unsigned char> isEased(mesh.X.size(), 0);
    mesh.ForOwned(smoother.TheRuntime(),
      [&](int point) { isEased[point] = HasPoorElement(mesh, point) && Ease(mesh, point); });
    if (!smoother.TheRuntime().Group().Any(
          std::find(isEased.begin(), isEased.end(), 1) != isEased.end()))
    {
      return round > 0;
    }
    smoother.RunStage(stage, [](double) {});
  }
  return true;
}

} // namespace vfm
