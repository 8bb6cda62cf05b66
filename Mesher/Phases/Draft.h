/**
 * Draft: a mesh while it is made.
 */
#pragma once

#include "Elements/Facet.h"
#include "Elements/FeatureKind.h"
#include "Elements/Mesh.h"
#include "Volumes/FragmentVolumes.h"

namespace vfm
{

/// A mesh of the elements in CartesianGrid::HexBox with what stages pass on.
///
/// | part | made by | freed by |
/// |---|---|---|
/// | Elements | ElementMethod::Make | FinishMesh returns it |
/// | Facets | ElementMethod::Make; EndMoves again | ElementMethod::StartMoves; FinishMesh |
/// | Volumes | ElementMethod::Make | FinishMesh |
/// | Kinds | FitElements | FinishMesh |
/// | RequestedFamilies | ElementMethod::Make | FinishMesh |
struct Draft
{
  Mesh Elements;
  std::vector<Facet> Facets; ///< all facets of the mesh
  FragmentVolumes Volumes;
  /// LevelHexes::RequestedFamilies.
  std::vector<Index> RequestedFamilies;
  std::vector<FeatureKind> Kinds{}; ///< of each point; empty: there are no carriers
};

} // namespace vfm
