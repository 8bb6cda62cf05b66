/**
 * WriteTable: a table as comma-separated values.
 */
#pragma once

#include "Input/FieldArray.h"

namespace vfm
{

/// A line of column names, then a line per row. Numbers have all their digits, texts stand in quotes where they must (RFC 4180).
/// columns: of one component and one length. Throws InputError, which tells why, when the file cannot be written.
void WriteTable(const std::vector<FieldArray>& columns, const std::string& path);

} // namespace vfm
