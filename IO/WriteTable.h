/**
 * WriteTable: a table as comma-separated values.
 */
#pragma once

#include <string>

class vtkTable;

namespace vfm
{

/// A line of column names, then a line a row. Numbers have all their digits, texts stand in quotes where they must (RFC 4180).
/// Throws InputError, which tells why, when the file cannot be written. VTK's own writer keeps six digits and leaves quotes as they are.
void WriteTable(vtkTable* table, const std::string& path);

} // namespace vfm
