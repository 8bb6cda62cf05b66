/**
 * WriteTable: a table as comma-separated values.
 */
#pragma once

#include "Input/FieldArray.h"

#include <string>
#include <vector>

namespace vfm
{

/// A line of column names, then one line per row. Numbers have all their digits, texts have quotes where they need them (RFC 4180).
/// columns: of one length, with one component. Throws InputError, with the reason, when the file cannot be written.
void WriteTable(const std::vector<FieldArray>& columns, const std::string& path);

} // namespace vfm
