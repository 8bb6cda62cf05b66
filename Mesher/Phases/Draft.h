/**
 * Draft: a mesh while it is made.
 */
#pragma once

#include "Elements/BarrierElements.h"
#include "Elements/Facet.h"
#include "Elements/FeatureKind.h"
#include "Volumes/FragmentVolumes.h"

namespace vfm
{

/// A mesh of the elements in CartesianGrid::HexBox with what stages pass on. What only one stage
/// needs, such as HexTopology::RowOffset, stays in the stage.
///
/// | part | made by | freed by |
/// |---|---|---|
/// | Elements | ElementMethod::Make | FinishMesh returns it, with the owned elements |
/// | Elements except corners | ElementMethod::Make | packed in HexMethod until RestoreDraft |
/// | Elements.Pulls | FitElements | AddMidNodes |
/// | Facets | ElementMethod::Make; EndMoves again | ElementMethod::StartMoves; FinishMesh |
/// | Volumes, Thin, IsThin, RequestedFamilies, WholeCells | ElementMethod::Make | FinishMesh |
/// | Barrier | ElementMethod::Make | KeepOwned removes its elements |
/// | Kinds | FitElements | FinishMesh |
struct Draft
{
  Mesh Elements;
  std::vector<Facet> Facets; ///< all facets of the mesh
  FragmentVolumes Volumes;
  std::vector<Index> RequestedFamilies{}; ///< LevelHexes::RequestedFamilies
  BarrierElements Barrier{};
  std::vector<Index> Thin{};           ///< cells of thin parts, ascending
  std::vector<unsigned char> IsThin{}; ///< FindThinFragments
  Index WholeCells = 0; ///< number of elements, from the first one, that are unchanged cells
  std::vector<FeatureKind> Kinds{}; ///< of each point; empty: there are no carriers
};

} // namespace vfm
