/**
 * WidenCells: the phase that replaces the cells of the input by those of the options CellWidth
 * and MaterialWidths, before all other steps.
 */
#pragma once

#include "Phases/ReadCells.h"

namespace vfm
{

/// Returns the levels on which the input is read before its cells are replaced.
LevelSetup SetUpReading(const InputLevels& levels);

/// Replaces Cells::Fields, Setup and Owners, and sets Requests, State and Wide. Labels are smoothed
/// before. All cells of the new grid count as cells of level 0.
/// @param requests of the cells that this rank reads
/// @param states state arrays of the input
/// @param[in,out] cells read as SetUpReading says
/// @throws InputError if the new cells would be narrower, or if StoreState does; on all ranks
/// @pre Collective.
void WidenCells(const MesherJob& job, const InputRequests& requests, std::vector<StateArray> states,
  Cells& cells);

/// Smooths labels, as the option LabelSmoothing says; does nothing to fractions.
/// @pre Collective.
void SmoothFields(const MesherJob& job, LevelFields& fields);

} // namespace vfm
