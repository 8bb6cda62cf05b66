/**
 * WriteReport: writes a quality report of a mesh as one HTML page.
 *
 * The page contains counts, warnings, a table of materials with volumes and errors, histograms of
 * the scaled Jacobian and of the dihedral angles of tetrahedra, the worst elements with their
 * places, side sets, and the input and options of the run. It needs no script, no other file and no
 * network, and holds no date: equal runs write equal bytes.
 */
#pragma once

#include "Options/MesherOptions.h"
#include "Ranks/Ranks.h"
#include "Report/ReportPage.h"

namespace vfm
{

/// Returns the reason why no report can have this name; "" if one can. Checks only the suffix.
std::string FindReportProblem(const std::string& path);

/// Lists the options that differ from their defaults, with their values as `sculptor --set`
/// accepts them.
TextPairs ListReportOptions(const MesherOptions& options);

/// Writes the page on rank 0. It does not depend on the number of ranks.
/// @param mesh part of this rank, with the fields of RunMesher
/// @param materials MesherResult::MaterialFields, equal on all ranks
/// @param head texts of rank 0; other ranks may pass an empty head
/// @throws InputError if the suffix is wrong, an array is missing, or the file cannot be written;
/// on all ranks, with path and reason. The earlier file then remains
/// @pre Collective
void WriteReport(const MeshData& mesh, const FieldArrays& materials, const ReportHead& head,
  const std::string& path, Ranks& ranks);

} // namespace vfm
