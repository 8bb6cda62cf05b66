/**
 * PeriodicFields: copies of the cells of a domain that repeats, around the domain.
 */
#pragma once

#include "Levels/LevelFields.h"
#include "Options/MesherOptions.h"

namespace vfm
{

/// Returns how often the cells of a periodic domain can be joined in pairs, so that the coarsest
/// level has an even number of at least 4 cells along each periodic axis.
/// @param coordinates nodes of the coarsest level of the input
int CountPeriodicLevels(
  const MesherOptions& options, const std::array<std::vector<double>, 3>& coordinates);

/// Checks whether other options allow a periodic mesh.
/// @throws InputError if they do not
void CheckPeriods(const MesherOptions& options);

/// Adds the copies of cells that meshing needs (CartesianGrid::Covering). Does nothing without
/// periodic axes.
/// @throws InputError if there are fewer than 3 cells along a periodic axis, or an odd number in a
/// refined mesh
/// @pre Collective
void AddCopies(
  const MesherOptions& options, const LevelSetup& setup, Ranks& ranks, LevelFields& fields);

/// Returns a sentence if materials do not seem to continue across sides where the domain repeats:
/// if they change at more than three times as many faces there as between layers inside; ""
/// otherwise.
/// @pre Collective
std::string DescribeSeams(const LevelFields& fields, double isoValue, Ranks& ranks);

/// Removes the copies of cells. Does nothing without periodic axes.
/// @pre Collective
void RemoveCopies(Ranks& ranks, LevelFields& fields);

} // namespace vfm
