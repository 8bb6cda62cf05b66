/**
 * TetGen behind an interface without its header: fills a closed surface with tetrahedra and leaves the
 * surface as it is, so that neighbouring regions match. Only in builds with VFM_HAS_TETGEN.
 *
 * TetGen reads some wrong inputs as an endless loop, an assert() or a crash; so the surface is checked
 * first, and every result is checked face by face. What fails is refused with a reason.
 */
#pragma once

#include "Base/Options.h"
#include "Mesh/Mesh.h"

#include <functional>

namespace vfm
{

/// A closed region.
struct TetGenPart
{
  std::vector<Vector3> Points; ///< all different where triangles use them
  /// The whole boundary, normals outward. It may touch itself at shared edges and vertices, and have
  /// several components; the inside of holes is outside the region.
  std::vector<std::array<int, 3>> Triangles;
};

/// Wished edge length at a place; anything not > 0 means no wish. Called by one thread at a time.
using SizeFunction = std::function<double(const Vector3&)>;

struct TetGenFill
{
  std::vector<Vector3>
    Points; ///< those of the part, bit by bit, then new ones, none on the boundary
  std::vector<std::array<int, 4>> Tets; ///< det(b - a, c - a, d - a) > 0
  std::string Refusal;                  ///< why there is no result; empty: done
  bool Complete =
    true; ///< false: the limit on new points ended refinement early; the mesh is valid
};

/// What part of the work is done, 0 to 1, now and then, never less than before.
using FillProgress = std::function<void(double)>;

/// One run at a time in the process, others wait: TetGen has global state. The result depends on the
/// arguments only. Never throws but Aborted, when size or progress do (the way to stop a long run).
TetGenFill FillWithTetGen(
  const TetGenPart& part, const TetGenOptions& options, const SizeFunction& size,
  const FillProgress& progress = [](double) {});

} // namespace vfm
