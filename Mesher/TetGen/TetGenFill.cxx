#include "TetGen/TetGenFill.h"

#include "Base/Runtime.h"
#include "TetGen/CallTetGen.h"
#include "TetGen/TetGenFaces.h"
#include "TetGen/TetGenImprove.h"
#include "TetGen/TetGenTerminate.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <new>

namespace vfm
{

using namespace tetfill;

namespace
{

constexpr int OutOfMemory = 1; // error code of TetGen

/// Ratio of longest edge to target length above which a tet is split. With this value, the mean
/// edge has the target length.
const double LongestOverTarget = 1.55;
/// Dihedral angle, in degrees, above which flips, smoothing and splits of slivers improve a tet.
const double LargestDihedral = 140.0;
/// Limit on new points: number per point of the surface, and constant that is added.
const int NewPointsPerPoint = 50, NewPointsAtLeast = 10000;

/// Input of TetGen. This object, not TetGen, owns the arrays.
class Input
{
public:
  Input(const LocalPart& local, const std::vector<Vector3>& holes) :
    Points(local.Points),
    Holes(holes),
    Triangles(local.Triangles),
    Polygons(local.Triangles.size()),
    Facets(local.Triangles.size())
  {
    for (std::size_t i = 0; i < this->Facets.size(); ++i)
    {
      this->Polygons[i] = { this->Triangles[i].data(), 3 };
      this->Facets[i] = { &this->Polygons[i], 1, nullptr, 0 };
    }
    this->Io.pointlist = this->Points[0].data();
    this->Io.numberofpoints = static_cast<int>(this->Points.size());
    this->Io.facetlist = this->Facets.data();
    this->Io.numberoffacets = static_cast<int>(this->Facets.size());
    this->Io.holelist = this->Holes.empty() ? nullptr : this->Holes[0].data();
    this->Io.numberofholes = static_cast<int>(this->Holes.size());
  }
  Input(const Input&) = delete;
  Input& operator=(const Input&) = delete;
  ~Input() { this->Io.initialize(); }

  tetgenio Io;

private:
  std::vector<Vector3> Points, Holes;
  std::vector<Triangle> Triangles;
  std::vector<tetgenio::polygon> Polygons;
  std::vector<tetgenio::facet> Facets;
};

/// Progress of filling a part. TetGen calls back only while it inserts points, so the shares of its
/// stages are measured times.
class FillClock
{
public:
  FillClock(const FillProgress& progress, const TetGenPart& part) :
    Progress(progress), ExpectedCalls(CallsPerTriangle * static_cast<double>(part.Triangles.size()))
  {
  }

  void Reach(double done)
  {
    this->Done = std::max(this->Done, done);
    this->Progress(this->Done);
  }

  /// Counts a call of the size function.
  void Count()
  {
    if (++this->Calls % CallsPerProgress == 0)
    {
      const double share = 1.0 - std::exp(-static_cast<double>(this->Calls) / this->ExpectedCalls);
      this->Reach(BeforePoints + (AfterPoints - BeforePoints) * share);
    }
  }

  static constexpr double AfterCheck = 0.2, BeforePoints = 0.45, AfterPoints = 0.6,
                          AfterTetGen = 0.8;

private:
  static constexpr int CallsPerProgress = 5000;
  static constexpr double CallsPerTriangle = 7.0; // measured for balls; thin films have fewer
  const FillProgress& Progress;
  const double ExpectedCalls;
  std::int64_t Calls = 0;
  double Done = 0.0;
};

/// Data of the callback, which is a plain function. Set while the mutex is held.
struct SizeRequest
{
  const SizeFunction* Size;
  const LocalPart* Local;
  FillClock* Clock;
};
thread_local const SizeRequest* CurrentRequest = nullptr;

/// Callback of TetGen: returns whether a tet must be split because of its size.
bool IsTooLarge(REAL* a, REAL* b, REAL* c, REAL* d, REAL*, REAL)
{
  const REAL* corner[4] = { a, b, c, d };
  Vector3 centre{};
  double longest = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    for (int x = 0; x < 3; ++x)
    {
      centre[x] += 0.25 * corner[i][x];
    }
    for (int j = 0; j < i; ++j)
    {
      const Vector3 edge{ { corner[i][0] - corner[j][0], corner[i][1] - corner[j][1],
        corner[i][2] - corner[j][2] } };
      longest = std::max(longest, Dot(edge, edge));
    }
  }
  CurrentRequest->Clock->Count();
  const LocalPart& local = *CurrentRequest->Local;
  const double target = (*CurrentRequest->Size)(local.ToWorld(centre));
  return target > 0.0 &&
    std::ldexp(std::sqrt(longest), local.Exponent) > LongestOverTarget * target;
}

tetgenbehavior Switches(const TetGenOptions& options, int limit)
{
  tetgenbehavior b;
  b.plc = 1;
  b.quiet = 1;
  b.nobisect = 1;   // -Y: adds no points on the surface
  b.nojettison = 1; // keeps the numbers of points
  b.nomergefacet = b.nomergevertex = 1;
  b.nofacewritten = 1;
  b.regionattrib = 1;
  b.quality = 1;
  b.minratio = options.RadiusEdgeRatio;
  b.mindihedral = options.MinimumDihedralAngle;
  b.optlevel = options.OptimizationLevel;
  b.optmaxdihedral = LargestDihedral;
  b.optminsmtdihed = LargestDihedral;
  b.optminslidihed = LargestDihedral;
  b.steinerleft = limit;
  return b;
}

/// Lets TetGen check with exact arithmetic that no triangles intersect. This is required first,
/// because intersections make its asserts fail.
std::string CheckCrossings(const LocalPart& local)
{
  Input input(local, {});
  tetgenio output;
  tetgenbehavior b;
  b.plc = 1;
  b.quiet = 1;
  b.diagnose = 1;
  b.nojettison = 1;
  b.nomergefacet = b.nomergevertex = 1;
  CallTetGen(b, input.Io, output);
  if (output.numberoftrifaces == 0)
  {
    return "";
  }
  const Vector3 p = local.ToWorld(local.Points[output.trifacelist[0]]);
  return Text("the surface crosses itself near (%g, %g, %g)", p[0], p[1], p[2]);
}

/// Copies TetGen's output. New points follow the partPoints points of the part. Returns an error,
/// or an empty text.
std::string TakeOutput(
  const tetgenio& output, const LocalPart& local, std::size_t partPoints, TetGenFill& fill)
{
  const int old = static_cast<int>(local.Points.size());
  if (output.numberoftetrahedra == 0 || output.numberofpoints < old || output.numberofcorners != 4)
  {
    return "TetGen made no tetrahedra";
  }
  fill.Points.resize(partPoints);
  fill.Tets.clear();
  std::vector<int> index(local.PartPoint);
  for (int i = 0; i < output.numberofpoints; ++i)
  {
    const double* x = output.pointlist + 3 * i;
    const Vector3 p{ { x[0], x[1], x[2] } };
    if (i < old && p != local.Points[i])
    {
      return "TetGen moved a point of the surface";
    }
    if (i >= old)
    {
      index.push_back(static_cast<int>(fill.Points.size()));
      fill.Points.push_back(local.ToWorld(p));
    }
  }
  for (int i = 0; i < output.numberoftetrahedra; ++i)
  {
    Tet tet;
    for (int k = 0; k < 4; ++k)
    {
      const int p = output.tetrahedronlist[4 * i + k];
      if (p < 0 || p >= output.numberofpoints)
      {
        return "TetGen made a tetrahedron with a point that does not exist";
      }
      tet[k] = index[p];
    }
    fill.Tets.push_back(tet);
  }
  return "";
}

/// Connects tets across faces that are not on the surface. Returns false if a face has more than
/// two tets, or both on one side, or is on the surface and has no tet.
bool Connect(const std::vector<SortedTriangle>& faces, Sets& sets)
{
  bool isGood = true;
  ForGroups(faces,
    [&](const SortedTriangle* first, const SortedTriangle* last)
    {
      const bool isSurface = first->Owner < 0;
      const long tetCount = (last - first) - isSurface;
      isGood = isGood && (tetCount == 1 || (tetCount == 2 && last[-1].IsOdd != last[-2].IsOdd));
      if (!isSurface && tetCount == 2)
      {
        sets.Join(first[0].Owner, first[1].Owner);
      }
    });
  return isGood;
}

/// Removes the tets in holes of a non-manifold surface. Checks that the boundary of the other tets
/// is exactly the surface, and that they are on its inner side. Returns an error, or an empty text.
std::string KeepInside(const TetGenPart& part, std::vector<Tet>& tets)
{
  const std::vector<SortedTriangle> faces = SortedFaces(part, tets);
  Sets sets(tets.size());
  if (!Connect(faces, sets))
  {
    return "TetGen did not keep the surface";
  }
  enum : unsigned char
  {
    Inside = 1,
    Outside = 2,
    Open = 4
  };
  std::vector<unsigned char> side(tets.size(), 0);
  std::size_t innerSides = 0;
  ForGroups(faces,
    [&](const SortedTriangle* first, const SortedTriangle* last)
    {
      const bool isSurface = first->Owner < 0;
      for (const SortedTriangle* face = first + isSurface; face < last; ++face)
      {
        const bool isInside = isSurface && face->IsOdd == first->IsOdd;
        const bool isOpen = !isSurface && last - first == 1;
        side[sets.Root(face->Owner)] |= isOpen ? Open : isInside ? Inside : isSurface ? Outside : 0;
        innerSides += isInside;
      }
    });
  if (innerSides != part.Triangles.size())
  {
    return "TetGen left a part of the region empty";
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < tets.size(); ++i)
  {
    const unsigned char found = side[sets.Root(static_cast<int>(i))];
    if ((found & Inside) && found != Inside)
    {
      return "TetGen left the region";
    }
    if (found == Inside)
    {
      tets[kept++] = tets[i];
    }
  }
  tets.resize(kept);
  return "";
}

/// Checks that all tets are positive by a margin and that their total volume is the volume of the
/// region. Returns an error, or an empty text.
std::string CheckVolumes(const LocalPart& local, const TetGenFill& fill)
{
  const std::vector<Vector3> points = LocalPoints(local, fill);
  double volume = 0.0;
  for (const Tet& t : fill.Tets)
  {
    const double det = Determinant(points[t[0]], points[t[1]], points[t[2]], points[t[3]]);
    double longest = 0.0;
    for (int k = 0; k < 4; ++k)
    {
      for (int m = 0; m < k; ++m)
      {
        longest = std::max(longest, Norm(points[t[k]] - points[t[m]]));
      }
    }
    if (!(det > FlatTet * longest * longest * longest)) // also true for NaN
    {
      const Vector3& p = fill.Points[t[0]];
      return Text("TetGen left a flat tetrahedron at (%g, %g, %g)", p[0], p[1], p[2]);
    }
    volume += det / 6.0;
  }
  return std::abs(volume - local.Volume) <= 1e-9 * local.Volume + 1e-14 * local.Area
    ? ""
    : Text("TetGen filled %.9g of the volume", volume / local.Volume);
}

/// Removes new points that have no tets.
void DropUnused(std::size_t old, TetGenFill& fill)
{
  std::vector<int> index(fill.Points.size(), -1);
  for (const Tet& tet : fill.Tets)
  {
    for (const int p : tet)
    {
      index[p] = 0;
    }
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < fill.Points.size(); ++i)
  {
    if (i < old || index[i] == 0)
    {
      fill.Points[kept] = fill.Points[i];
      index[i] = static_cast<int>(kept++);
    }
  }
  fill.Points.resize(kept);
  for (Tet& tet : fill.Tets)
  {
    for (int& p : tet)
    {
      p = index[p];
    }
  }
}

/// Returns the message for an error code of TetGen.
const char* Reason(int code)
{
  switch (code)
  {
    case 2:
      return "TetGen found an internal error";
    case 3:
      return "TetGen found that the surface crosses itself";
    case 4:
    case 5:
      return "TetGen found points or triangles of the surface too close to each other";
    default:
      return "TetGen found an error in the surface";
  }
}

std::string RunOnce(const LocalPart& local, std::size_t partPoints, const TetGenOptions& options,
  const SizeFunction& size, FillClock& clock, TetGenFill& fill)
{
  const int old = static_cast<int>(local.Points.size());
  const int limit = NewPointsAtLeast + NewPointsPerPoint * old;
  Input input(local, HoleSeeds(local));
  const SizeRequest request{ &size, &local, &clock };
  if (size)
  {
    CurrentRequest = &request;
    input.Io.tetunsuitable = &IsTooLarge;
  }
  tetgenbehavior b = Switches(options, limit);
  tetgenio output;
  CallTetGen(b, input.Io, output);
  fill.Complete = output.numberofpoints - old < limit;
  return TakeOutput(output, local, partPoints, fill);
}

/// Runs TetGen, one thread at a time. Returns an error, or an empty text.
std::string Run(const LocalPart& local, std::size_t partPoints, const TetGenOptions& options,
  const SizeFunction& size, FillClock& clock, TetGenFill& fill)
{
  static std::mutex mutex;
  const std::lock_guard<std::mutex> lock(mutex);
  const std::string crossing = CheckCrossings(local);
  if (!crossing.empty())
  {
    return crossing;
  }
  clock.Reach(FillClock::AfterCheck);
  std::string refusal = RunOnce(local, partPoints, options, size, clock, fill);
  if (refusal.empty() && !fill.Complete)
  {
    // Usually the surface does not permit the bound on angles. Runs again without it.
    TetGenOptions modest = options;
    modest.MinimumDihedralAngle = 0.0;
    modest.RadiusEdgeRatio = std::max(2.0, options.RadiusEdgeRatio);
    refusal = RunOnce(local, partPoints, modest, size, clock, fill);
    fill.Complete = false;
  }
  return refusal;
}

std::string Fill(const TetGenPart& part, const TetGenOptions& options, const SizeFunction& size,
  const FillProgress& progress, TetGenFill& fill)
{
  FillClock clock(progress, part);
  LocalPart local;
  std::string refusal = MakeLocalPart(part, local);
  fill.Points = part.Points;
  refusal = refusal.empty() ? Run(local, part.Points.size(), options, size, clock, fill) : refusal;
  clock.Reach(FillClock::AfterTetGen);
  refusal = refusal.empty() ? KeepInside(part, fill.Tets) : refusal;
  if (refusal.empty() && Improve(part, local, fill))
  {
    refusal = KeepInside(part, fill.Tets);
  }
  refusal = refusal.empty() ? CheckVolumes(local, fill) : refusal;
  if (refusal.empty())
  {
    DropUnused(part.Points.size(), fill);
  }
  return refusal;
}

} // namespace

TetGenFill FillWithTetGen(const TetGenPart& part, const TetGenOptions& options,
  const SizeFunction& size, const FillProgress& progress)
{
  TetGenFill fill;
  try
  {
    fill.Refusal = TetGenTerminateIsLinked ? Fill(part, options, size, progress, fill) : "";
  }
  catch (const int code)
  {
    if (code == OutOfMemory)
    {
      throw std::bad_alloc(); // not an error of the part
    }
    fill.Refusal = Reason(code);
  }
  catch (const Aborted&)
  {
    throw;
  }
  catch (const std::bad_alloc&)
  {
    throw;
  }
  catch (const std::exception& error)
  {
    fill.Refusal = std::string("TetGen failed: ") + error.what();
  }
  if (!fill.Refusal.empty())
  {
    fill.Points.clear();
    fill.Tets.clear();
  }
  return fill;
}

} // namespace vfm
