/**
 * TetGenFill: an interface to TetGen that does not include its header. It fills a closed surface
 * with tetrahedra and keeps the surface, so that neighbouring regions match.
 * Only in builds with VFM_HAS_TETGEN.
 *
 * Some invalid inputs make TetGen loop forever, fail an assert() or crash. Therefore the surface is
 * checked first, and every result is checked face by face. Failures are returned with a reason.
 */
#pragma once

#include "Base/Options.h"
#include "Elements/Mesh.h"

#include <functional>

namespace vfm
{

/// Closed region.
struct TetGenPart
{
  std::vector<Vector3> Points; ///< points; all points that triangles use must differ
  /// Whole boundary, with outward normals. It may touch itself at shared edges and vertices, and
  /// have several components; the inside of holes is outside the region.
  std::vector<std::array<int, 3>> Triangles;
};

/// Returns the target edge length at a point. No target applies if the value is not positive.
/// Called by one thread at a time.
using SizeFunction = std::function<double(const Vector3&)>;

/// Result of FillWithTetGen.
struct TetGenFill
{
  /// Points of the part, bitwise unchanged, followed by new points, none of them on the boundary.
  std::vector<Vector3> Points;
  std::vector<std::array<int, 4>> Tets; ///< tets with det(b - a, c - a, d - a) > 0
  std::string Refusal;                  ///< reason of failure; empty on success
  /// False if the limit on new points ended refinement early; the mesh is valid.
  bool Complete = true;
};

/// Receives the fraction of the work that is done, 0 to 1. It is called at irregular times and
/// never decreases.
using FillProgress = std::function<void(double)>;

/// Fills a region with tets. The result depends only on the arguments. Threads may call this at the
/// same time, but only one runs TetGen, which has global state, while the others wait.
/// H. Si, TetGen, a Delaunay-based quality tetrahedral mesh generator, ACM Transactions on
/// Mathematical Software 41 (2015).
/// @return points and tets, which are empty on failure
/// @throws Aborted  if size or progress throws it, which is the way to stop a long run
/// @throws std::bad_alloc  if memory is exhausted
TetGenFill FillWithTetGen(
  const TetGenPart& part, const TetGenOptions& options, const SizeFunction& size,
  const FillProgress& progress = [](double) {});

} // namespace vfm
