/// Cracks between elements that `sculptor test` reports.
#include "CheckSurface.h"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <numeric>

using vfm::CheckSurface;
using vfm::SurfaceCheck;

namespace
{

/// Hexahedra of boxes whose corners are points of a lattice; corners at equal places are one point.
class Hexes
{
public:
  void Add(const std::array<int, 3>& lower, int width)
  {
    const int corners[8][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
      { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } };
    for (int c = 0; c < 8; ++c)
    {
      std::array<int, 3> at = lower;
      for (int a = 0; a < 3; ++a)
      {
        at[a] += width * corners[c][a];
      }
      const auto point = this->Points.emplace(at, this->Count);
      this->Count += point.second;
      this->Elements.push_back(point.first->second);
    }
  }
  /// Later elements share no point with earlier ones.
  void Forget() { this->Points.clear(); }

  SurfaceCheck Check() const
  {
    std::vector<vfm::Index> ids(this->Count);
    std::iota(ids.begin(), ids.end(), 1);
    vfm::MeshData mesh;
    mesh.PointIds = ids.data();
    mesh.NumberOfPoints = this->Count;
    mesh.NumberOfElements = static_cast<vfm::Index>(this->Elements.size() / 8);
    mesh.Elements = this->Elements.data();
    return CheckSurface(mesh);
  }

private:
  std::map<std::array<int, 3>, vfm::Index> Points;
  vfm::Index Count = 0;
  std::vector<vfm::Index> Elements;
};

void Expect(const SurfaceCheck& check, bool isConforming, int pieces, int spheres)
{
  EXPECT_EQ(check.IsConforming, isConforming);
  EXPECT_EQ(check.Pieces, pieces);
  EXPECT_EQ(check.Spheres, spheres);
}

} // namespace

TEST(CheckSurface, OfElementsThatShareAFace)
{
  Hexes hexes;
  hexes.Add({ 0, 0, 0 }, 2);
  hexes.Add({ 2, 0, 0 }, 2);
  Expect(hexes.Check(), true, 1, 1);
  hexes.Add({ 8, 0, 0 }, 2);
  Expect(hexes.Check(), true, 2, 2);
}

TEST(CheckSurface, ACrackIsAPieceMore)
{
  Hexes hexes;
  hexes.Add({ 0, 0, 0 }, 2);
  hexes.Forget();
  hexes.Add({ 2, 0, 0 }, 2);
  Expect(hexes.Check(), true, 2, 2);
}

TEST(CheckSurface, HangingNodesAreAPieceMore)
{
  Hexes hexes;
  hexes.Add({ 0, 0, 0 }, 2);
  for (int y : { 0, 1 })
  {
    for (int z : { 0, 1 })
    {
      hexes.Add({ 2, y, z }, 1);
    }
  }
  Expect(hexes.Check(), true, 2, 2);
}

TEST(CheckSurface, SharedEdgesAndFacesOfThreeDoNotConform)
{
  Hexes edge;
  edge.Add({ 0, 0, 0 }, 2);
  edge.Add({ 2, 2, 0 }, 2);
  EXPECT_FALSE(edge.Check().IsConforming);
  Hexes face;
  face.Add({ 0, 0, 0 }, 2);
  face.Add({ 2, 0, 0 }, 2);
  face.Add({ 2, 0, 0 }, 2);
  EXPECT_FALSE(face.Check().IsConforming);
}

TEST(CheckSurface, ARingIsNoSphere)
{
  Hexes hexes;
  for (int x : { 0, 2, 4 })
  {
    for (int y : { 0, 2, 4 })
    {
      if (x != 2 || y != 2)
      {
        hexes.Add({ x, y, 0 }, 2);
      }
    }
  }
  Expect(hexes.Check(), true, 1, 0);
}
