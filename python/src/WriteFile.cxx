#include "WriteFile.h"

#include "Meshes/WriteMesh.h"
#include "NumpyMesh.h"
#include "Ranks/WorkTogether.h"

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

void WriteFile(const std::string& path, const NumpyPoints& points, const NumpyCells& cells,
  const NamedArrays& pointArrays, const NamedArrays& cellArrays, const nb::dict& fields,
  std::optional<double> time)
{
  StoredMesh mesh = ViewMesh(points, cells, pointArrays, cellArrays, fields);
  mesh.Data.Time = time;
  const nb::gil_scoped_release others;
  Ranks alone;
  WorkInStage(alone, ErrorCode::UnwritableOutput, [&] { WriteMesh(mesh.Data, path, alone); });
}

} // namespace

void BindWriters(nb::module_& module)
{
  module.def("write_mesh", WriteFile, "path"_a, "points"_a, "cells"_a, "point_arrays"_a,
    "cell_arrays"_a, "fields"_a, "time"_a.none());
}

} // namespace vfm
