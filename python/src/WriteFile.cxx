#include "WriteFile.h"

#include "Meshes/WriteMesh.h"
#include "NumpyMesh.h"
#include "NumpyParticles.h"
#include "Ranks/WorkTogether.h"
#include "Report/WriteReport.h"

#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

namespace vfm
{
namespace
{

namespace nb = nanobind;
using namespace nb::literals;

/// @param version  name of a version of Gmsh's format; empty: automatic
GmshVersion ReadVersion(const std::string& version)
{
  const std::optional<GmshVersion> known = ParseGmshVersion(version);
  if (!known && !version.empty())
  {
    throw InputError("The version of a .msh file is '" + version + "': it must be 2.2 or 4.1.");
  }
  return known.value_or(GmshVersion::Automatic);
}

/// Returns whether a choice is plane stress.
bool ReadPlane(const std::string& plane)
{
  const std::optional<bool> known = ParsePlaneStress(plane);
  if (!known)
  {
    throw InputError("plane is '" + plane + "': it must be strain or stress.");
  }
  return *known;
}

/// Returns the path of the particles beside the file; "" if it holds them or there are none.
std::string WriteFile(const std::string& path, const NumpyPoints& points, const NumpyCells& cells,
  const NamedArrays& pointArrays, const NamedArrays& cellArrays, const nb::dict& fields,
  const NamedArrays& particles, std::optional<double> time, const std::string& version, bool binary,
  bool interfaces, bool reduced, const std::string& plane, bool polyhedra)
{
  StoredMesh mesh = ViewMesh(points, cells, pointArrays, cellArrays, fields);
  mesh.Data.Time = time;
  const ParticleData cloud = particles.empty() ? ParticleData() : ViewParticles(particles);
  mesh.Data.Particles = particles.empty() ? nullptr : &cloud;
  const OutputForm form{ .Version = ReadVersion(version),
    .IsBinary = binary,
    .HasInterfaces = interfaces,
    .IsReduced = reduced,
    .IsPlaneStress = ReadPlane(plane),
    .IsDual = polyhedra };
  const nb::gil_scoped_release others;
  Ranks alone;
  WorkInStage(alone, ErrorCode::UnwritableOutput, [&] { WriteMesh(mesh.Data, path, alone, form); });
  return cloud.NumberOfParticles > 0 ? FindParticlesBeside(path) : "";
}

/// Returns the options of each suffix of which one process writes files.
std::vector<std::pair<std::string, std::vector<std::string>>> ListFormats()
{
  std::vector<std::pair<std::string, std::vector<std::string>>> formats;
  for (const FormatRow& format : GetFormatTable())
  {
    for (const std::string& suffix : format.Suffixes)
    {
      if (!format.IsPerRank && format.IsInPackage)
      {
        formats.emplace_back(suffix, format.Options);
      }
    }
  }
  return formats;
}

void WriteReportFile(const std::string& path, const NumpyPoints& points, const NumpyCells& cells,
  const NamedArrays& pointArrays, const NamedArrays& cellArrays, const nb::dict& fields,
  const nb::dict& materials, const std::string& title, const TextPairs& facts,
  const TextPairs& options, const std::vector<std::string>& warnings)
{
  const StoredMesh mesh = ViewMesh(points, cells, pointArrays, cellArrays, fields);
  const FieldArrays table = ReadFields(materials);
  const nb::gil_scoped_release others;
  Ranks alone;
  WorkInStage(alone, ErrorCode::UnwritableOutput,
    [&] {
      WriteReport(mesh.Data, table, { title, facts, options, warnings }, path, alone);
    });
}

} // namespace

void BindWriters(nb::module_& module)
{
  module.def("write_mesh", WriteFile, "path"_a, "points"_a, "cells"_a, "point_arrays"_a,
    "cell_arrays"_a, "fields"_a, "particles"_a, "time"_a.none(), "version"_a = "",
    "binary"_a = false, "interfaces"_a = true, "reduced"_a = false, "plane"_a = "strain",
    "polyhedra"_a = false);
  module.def("list_formats", ListFormats);
  module.def("write_report", WriteReportFile, "path"_a, "points"_a, "cells"_a, "point_arrays"_a,
    "cell_arrays"_a, "fields"_a, "materials"_a, "title"_a, "facts"_a, "options"_a, "warnings"_a);
}

} // namespace vfm
