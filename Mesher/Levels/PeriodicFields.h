/**
 * PeriodicFields: copies of the cells of a domain that repeats, around the domain.
 */
#pragma once

#include "Levels/LevelFields.h"
#include "Options/MesherOptions.h"

namespace vfm
{

/// Checks whether a domain can repeat as the options request.
/// @param setup  levels of the mesh
/// @throws InputError if there are fewer than 3 cells along a periodic axis, or other options or
/// the levels of the input do not allow it
void CheckPeriods(
  const MesherOptions& options, const InputLevels& input, const LevelSetup& setup);

/// Adds the copies of cells that meshing needs (CartesianGrid::Covering). Does nothing without
/// periodic axes.
/// @pre Collective
void AddCopies(const MesherOptions& options, Ranks& ranks, LevelFields& fields);

/// Returns a sentence if materials do not seem to continue across sides where the domain repeats:
/// if they change at more than three times as many faces there as between layers inside; ""
/// otherwise.
/// @pre Collective
std::string DescribeSeams(const LevelFields& fields, double isoValue, Ranks& ranks);

/// Removes the copies of cells. Does nothing without periodic axes.
/// @pre Collective
void RemoveCopies(Ranks& ranks, LevelFields& fields);

} // namespace vfm
