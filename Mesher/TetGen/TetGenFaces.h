/**
 * TetGenFaces: sorted lists of the faces of tets and of the surface around them, in which equal
 * faces are consecutive; disjoint sets.
 */
#pragma once

#include "Base/Sorted.h"
#include "Elements/TetQuality.h"
#include "TetGen/TetGenSurface.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace vfm
{
namespace tetfill
{

/// A tet is flat if its determinant is at most this factor times its longest edge cubed.
constexpr double FlatTet = 1e-9;

/// Returns six times the volume of a tet.
inline double Determinant(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d)
{
  return Dot(Cross(b - a, c - a), d - a);
}

/// Face of a tet, or triangle of the surface.
struct SortedTriangle
{
  Triangle Corners; ///< corners, ascending
  int Owner;        ///< tet, or -1 for a triangle of the surface
  bool IsOdd;       ///< whether sorting the outward order was an odd permutation

  SortedTriangle(int a, int b, int c, int owner) :
    Corners{ { a, b, c } }, Owner(owner), IsOdd(false)
  {
    for (const int k : { 0, 1, 0 })
    {
      if (this->Corners[k] > this->Corners[k + 1])
      {
        std::swap(this->Corners[k], this->Corners[k + 1]);
        this->IsOdd = !this->IsOdd;
      }
    }
  }
  bool operator<(const SortedTriangle& other) const
  {
    return this->Corners != other.Corners ? this->Corners < other.Corners
                                          : this->Owner < other.Owner;
  }
};

/// Returns the triangles of a surface and all faces of tets, sorted by corners. Triangles precede
/// equal faces.
inline std::vector<SortedTriangle> SortedFaces(const TetGenPart& part, const std::vector<Tet>& tets)
{
  std::vector<SortedTriangle> faces;
  faces.reserve(4 * tets.size() + part.Triangles.size());
  for (const Triangle& t : part.Triangles)
  {
    faces.emplace_back(t[0], t[1], t[2], -1);
  }
  for (std::size_t i = 0; i < tets.size(); ++i)
  {
    for (const int(&k)[3] : FaceOfTet)
    {
      faces.emplace_back(tets[i][k[0]], tets[i][k[1]], tets[i][k[2]], static_cast<int>(i));
    }
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

/// Calls body(first, last) for each group of faces with the same corners.
template <typename Body>
void ForGroups(const std::vector<SortedTriangle>& faces, const Body& body)
{
  ForRuns(
    faces.data(), faces.data() + faces.size(),
    [](const SortedTriangle& a, const SortedTriangle& b) { return a.Corners == b.Corners; }, body);
}

/// Disjoint sets of the numbers 0 to n - 1.
class Sets
{
public:
  explicit Sets(std::size_t n) : Parent(n) { std::iota(Parent.begin(), Parent.end(), 0); }
  int Root(int i)
  {
    while (this->Parent[i] != i)
    {
      i = this->Parent[i] = this->Parent[this->Parent[i]];
    }
    return i;
  }
  void Join(int i, int j) { this->Parent[this->Root(i)] = this->Root(j); }

private:
  std::vector<int> Parent;
};

} // namespace tetfill
} // namespace vfm
