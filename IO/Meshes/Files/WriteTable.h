/**
 * WriteTable: writes a table as comma-separated values.
 */
#pragma once

#include "Input/FieldArray.h"

#include <string>
#include <vector>

namespace vfm
{

/// Writes a line of column names, then one line per row. Numbers have all their digits. Texts are
/// quoted where RFC 4180 requires it.
/// @param columns  columns of equal length, with one component each
/// @throws InputError  if the file cannot be written; the message holds the reason
void WriteTable(const std::vector<FieldArray>& columns, const std::string& path);

} // namespace vfm
