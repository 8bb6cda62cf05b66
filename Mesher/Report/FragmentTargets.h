/**
 * FragmentTargets: field data with the volumes of the fractions of fragments, for the whole mesh or
 * for the fragments that a rank counts.
 */
#pragma once

#include "Elements/MeshReport.h"
#include "Input/FieldArray.h"
#include "Options/MesherOptions.h"
#include "Ranks/Ranks.h"

namespace vfm
{

/// Lists the volumes of the fractions of fragments.
/// - FragmentTargetVolume: one value per fragment of the whole mesh, in the order of their ids; on
///   a single rank, or if every rank gets tables of this length (HasWholeTable)
/// - otherwise RankFragments, ids of the fragments that this rank counts, ascending, and
///   RankTargetVolume, one value for each of them
/// @param own  fragments that this rank counts
/// @param count  number of fragments of the whole mesh
/// @pre Collective
std::vector<FieldArray> ListFragmentTargets(
  const MeshReport::FragmentTargets& own, TableMode mode, Index count, Ranks& ranks);

/// Returns whether fields list volumes of fragments in either way, even if of no fragment.
bool HasFragmentTargets(const std::vector<FieldArray>& fields);

/// Returns the fragments of RankFragments; none if there is no such field.
std::vector<int> ListRankFragments(const std::vector<FieldArray>& fields);

/// Returns the volumes that fields list for fragments (ListFragmentTargets), below 0 for a fragment
/// that they do not list.
std::vector<double> FindFragmentTargets(
  const std::vector<FieldArray>& fields, const std::vector<int>& fragments);

/// Returns the volumes of the fractions of all fragments, on all ranks; entry f - 1 is that of
/// fragment f.
/// @pre Collective
std::vector<double> GatherFragmentTargets(
  const MeshReport::FragmentTargets& own, Index count, Ranks& ranks);

/// Returns whether a field belongs to a rank, not to the whole mesh: RankFragments and
/// RankTargetVolume.
bool IsFieldOfRank(const std::string& name);

/// Returns the fields of a whole mesh from those of its parts: FragmentTargetVolume instead of
/// RankFragments and RankTargetVolume, if the parts list all fragments; otherwise neither of them.
/// @param parts  fields of each part, at least one
std::vector<FieldArray> JoinFields(const std::vector<const std::vector<FieldArray>*>& parts);

} // namespace vfm
