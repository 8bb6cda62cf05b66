#include "TetGen/TetGenImprove.h"

#include "TetGen/TetGenFaces.h"

namespace vfm
{
namespace tetfill
{
namespace
{

/// Cosine of 25 degrees. Tets with a smaller dihedral angle are improved.
const double PoorCosine = 0.906;
/// Limit on the number of tets around an edge that is split.
const std::size_t LargestRing = 30;

/// Returns the cosine of the smallest dihedral angle, or 2 for a tet that is flat or inverted.
double WorstCosine(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d)
{
  const Vector3* p[4] = { &a, &b, &c, &d };
  const double det = Determinant(a, b, c, d);
  Vector3 normal[4];
  double longest = 0.0;
  for (int k = 0; k < 4; ++k)
  {
    const int* f = FaceOfTet[k];
    const Vector3 u = *p[f[1]] - *p[f[0]], v = *p[f[2]] - *p[f[0]];
    normal[k] = Unit(Cross(u, v));
    longest = std::max({ longest, Dot(u, u), Dot(v, v) });
  }
  double worst = det > FlatTet * longest * std::sqrt(longest) ? -1.0 : 2.0;
  for (int k = 0; k < 4; ++k)
  {
    for (int m = 0; m < k; ++m)
    {
      worst = std::max(worst, -Dot(normal[k], normal[m]));
    }
  }
  return worst;
}

/// Replaces two tets at a face by three tets around the edge between their opposite corners, top
/// and bottom. TetGen leaves flat caps where three triangles of the surface
/// meet; this flip opens them.
/// @param[out] three  the new tets
/// @return whether the flip increases the smallest angle
bool FlipFace(const SortedTriangle& face, const Tet& upper, const Tet& lower,
  const std::vector<Vector3>& points, Tet (&three)[3])
{
  const auto apex = [&](const Tet& tet)
  {
    return std::accumulate(tet.begin(), tet.end(), 0LL) - face.Corners[0] - face.Corners[1] -
      face.Corners[2];
  };
  const int top = static_cast<int>(apex(upper)), bottom = static_cast<int>(apex(lower));
  const auto cosine = [&](const Tet& t)
  { return WorstCosine(points[t[0]], points[t[1]], points[t[2]], points[t[3]]); };
  const double before = std::max(cosine(upper), cosine(lower));
  double after = -1.0;
  for (int k = 0; k < 3; ++k)
  {
    // Seen from outside `upper`, the corners are counterclockwise unless the face is odd.
    const int p = face.Corners[k], q = face.Corners[(k + 1) % 3];
    three[k] = face.IsOdd ? Tet{ { p, q, bottom, top } } : Tet{ { q, p, bottom, top } };
    after = std::max(after, cosine(three[k]));
  }
  return after < before - 1e-3;
}

double WorstCosine(const Tet& t, const std::vector<Vector3>& points)
{
  return WorstCosine(points[t[0]], points[t[1]], points[t[2]], points[t[3]]);
}

/// Flips faces of poor tets, each tet at most once. Returns whether any tet changed.
bool FlipFaces(const TetGenPart& part, const LocalPart& local, TetGenFill& fill)
{
  const std::vector<Vector3> points = LocalPoints(local, fill);
  const std::size_t before = fill.Tets.size();
  std::vector<bool> isPoor, isDone(before, false);
  for (const Tet& t : fill.Tets)
  {
    isPoor.push_back(WorstCosine(t, points) > PoorCosine);
  }
  ForGroups(SortedFaces(part, fill.Tets),
    [&](const SortedTriangle* first, const SortedTriangle* last)
    {
      const int i = first->Owner, j = last[-1].Owner;
      Tet three[3];
      if (i >= 0 && i != j && (isPoor[i] || isPoor[j]) && !isDone[i] && !isDone[j] &&
        FlipFace(*first, fill.Tets[i], fill.Tets[j], points, three))
      {
        isDone[i] = isDone[j] = true;
        fill.Tets[i] = three[0];
        fill.Tets[j] = three[1];
        fill.Tets.push_back(three[2]);
      }
    });
  return fill.Tets.size() > before;
}

/// Split of the edge AB at Point.
struct Split
{
  int A = 0, B = 0;
  std::vector<int> Ring; ///< tets around the edge
  Vector3 Point{};
  double Cosine = 2.0; ///< largest WorstCosine of the new tets
};

/// Returns the tets around an edge. The ring is empty if there are more than LargestRing, or if the
/// edge is on the surface, where the ring is open.
std::vector<int> Ring(const std::vector<Tet>& tets, const std::vector<int>& ofA, int b)
{
  std::vector<int> ring, corners;
  for (const int i : ofA)
  {
    if (std::count(tets[i].begin(), tets[i].end(), b))
    {
      ring.push_back(i);
      corners.insert(corners.end(), tets[i].begin(), tets[i].end());
    }
  }
  for (const int p : corners)
  {
    if (ring.size() > LargestRing || std::count(corners.begin(), corners.end(), p) == 1)
    {
      ring.clear();
      break;
    }
  }
  return ring;
}

/// Finds the best point for a split, between the middle of the edge and the centre of its ring.
void FindPoint(const std::vector<Tet>& tets, const std::vector<Vector3>& points, Split& split)
{
  const Vector3 middle = 0.5 * (points[split.A] + points[split.B]);
  Vector3 centre{};
  for (const int i : split.Ring)
  {
    for (const int p : tets[i])
    {
      centre = centre + (p == split.A || p == split.B ? 0.0 : 0.5 / split.Ring.size()) * points[p];
    }
  }
  for (const double t : { 0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.65, 0.8 })
  {
    const Vector3 point = middle + t * (centre - middle);
    double worst = -1.0;
    for (const int i : split.Ring)
    {
      for (const int end : { split.A, split.B })
      {
        const auto corner = [&](int k) { return tets[i][k] == end ? point : points[tets[i][k]]; };
        worst = std::max(worst, WorstCosine(corner(0), corner(1), corner(2), corner(3)));
      }
    }
    if (worst < split.Cosine)
    {
      split.Cosine = worst;
      split.Point = point;
    }
  }
}

/// Returns the best split of an edge of a tet. Its ring is empty if no split increases the
/// smallest angle.
Split BestSplit(const std::vector<Tet>& tets, const std::vector<Vector3>& points,
  const std::vector<std::vector<int>>& tetsOf, const std::vector<bool>& isDone, const Tet& tet)
{
  Split best;
  best.Cosine = WorstCosine(tet, points) - 1e-3;
  for (int m = 0; m < 4; ++m)
  {
    for (int k = 0; k < m; ++k)
    {
      Split split;
      const bool isFewer = tetsOf[tet[k]].size() < tetsOf[tet[m]].size();
      split.A = tet[isFewer ? k : m];
      split.B = tet[isFewer ? m : k];
      split.Ring = Ring(tets, tetsOf[split.A], split.B);
      if (std::none_of(split.Ring.begin(), split.Ring.end(), [&](int i) { return isDone[i]; }))
      {
        FindPoint(tets, points, split);
        best = !split.Ring.empty() && split.Cosine < best.Cosine ? split : best;
      }
    }
  }
  return best;
}

/// Splits edges of poor tets, the poorest first. TetGen leaves such slivers below two triangles of
/// the surface. Returns whether any tet changed.
bool SplitEdges(const LocalPart& local, TetGenFill& fill)
{
  std::vector<Vector3> points = LocalPoints(local, fill);
  const std::size_t before = fill.Tets.size();
  std::vector<std::pair<double, int>> poor;
  std::vector<bool> isPoorPoint(points.size(), false), isDone(before, false);
  for (std::size_t i = 0; i < before; ++i)
  {
    const double cosine = WorstCosine(fill.Tets[i], points);
    if (cosine > PoorCosine)
    {
      poor.emplace_back(-cosine, static_cast<int>(i));
      for (const int p : fill.Tets[i])
      {
        isPoorPoint[p] = true;
      }
    }
  }
  std::vector<std::vector<int>> tetsOf(points.size());
  for (std::size_t i = 0; i < (poor.empty() ? 0 : before); ++i)
  {
    for (const int p : fill.Tets[i])
    {
      if (isPoorPoint[p])
      {
        tetsOf[p].push_back(static_cast<int>(i));
      }
    }
  }
  std::sort(poor.begin(), poor.end());
  for (const auto& next : poor)
  {
    const Split split = isDone[next.second]
      ? Split()
      : BestSplit(fill.Tets, points, tetsOf, isDone, fill.Tets[next.second]);
    for (const int i : split.Ring)
    {
      isDone[i] = true;
      Tet half = fill.Tets[i];
      const int added = static_cast<int>(fill.Points.size());
      std::replace(half.begin(), half.end(), split.A, added);
      std::replace(fill.Tets[i].begin(), fill.Tets[i].end(), split.B, added);
      fill.Tets.push_back(half);
    }
    if (!split.Ring.empty())
    {
      fill.Points.push_back(local.ToWorld(split.Point));
      points.push_back(local.ToLocal(fill.Points.back()));
    }
  }
  return fill.Tets.size() > before;
}

} // namespace

std::vector<Vector3> LocalPoints(const LocalPart& local, const TetGenFill& fill)
{
  std::vector<Vector3> points;
  for (const Vector3& p : fill.Points)
  {
    points.push_back(local.ToLocal(p));
  }
  return points;
}

bool Improve(const TetGenPart& part, const LocalPart& local, TetGenFill& fill)
{
  bool hasChanged = false;
  for (int sweep = 0; sweep < 4; ++sweep)
  {
    bool isNew = FlipFaces(part, local, fill);
    isNew = SplitEdges(local, fill) || isNew;
    if (!isNew)
    {
      break;
    }
    hasChanged = true;
  }
  return hasChanged;
}

} // namespace tetfill
} // namespace vfm
