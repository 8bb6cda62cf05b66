/**
 * WriteTable: writes a table as comma-separated values.
 */
#pragma once

#include "Input/FieldArray.h"
#include "Ranks/Ranks.h"

#include <string>
#include <vector>

namespace vfm
{

/// Writes a line of column names, then one line per row: the rows of rank 0, then of rank 1, ...
/// Numbers have all their digits. Texts are quoted where RFC 4180 requires it.
/// @param columns  columns of this rank, of equal length, with one component each; the names on
///   rank 0 are used
/// @throws InputError  if the file cannot be written; the message holds the reason; on all ranks
/// @pre Collective
/// @note Rank 0 receives the lines of one rank after the other, so it never holds the whole table.
void WriteTable(const std::vector<FieldArray>& columns, const std::string& path, Ranks& ranks);

} // namespace vfm
