#include "WriteFile.h"

#include "Meshes/WriteMesh.h"
#include "NumpyArrays.h"
#include "NumpyMesh.h"
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

using NamedArrays = std::vector<std::pair<std::string, NumpyArray>>;

std::vector<MeshArray> ListArrays(const NamedArrays& arrays, Index rows)
{
  std::vector<MeshArray> list;
  for (const auto& [name, values] : arrays)
  {
    const NumpyView view(name, values);
    if (view.Rows != rows)
    {
      throw InputError("The array '" + name + "' has another length than the mesh.");
    }
    const bool isId = name == "GlobalPointIds" || name == "GlobalCellIds";
    list.push_back({ name, isId ? ValueType::Id : view.Type, view.Components, {}, view.Values });
  }
  return list;
}

template <class T>
FieldArray CopyField(const std::string& name, const NumpyView& view)
{
  const T* values = static_cast<const T*>(view.Values);
  return { name, std::vector<T>(values, values + view.Rows * view.Components), view.Components };
}

FieldArray ReadField(const std::string& name, nb::handle value)
{
  if (nb::isinstance<nb::list>(value))
  {
    return { name, nb::cast<std::vector<std::string>>(value) };
  }
  const NumpyArray array = nb::cast<NumpyArray>(value);
  const NumpyView view(name, array);
  switch (view.Type)
  {
    case ValueType::Int:
      return CopyField<int>(name, view);
    case ValueType::LongLong:
      return CopyField<Index>(name, view);
    case ValueType::Double:
      return CopyField<double>(name, view);
    default:
      throw InputError("The field '" + name + "' is neither int32 nor int64 nor float64.");
  }
}

FieldArrays ReadFields(const nb::dict& fields)
{
  FieldArrays read;
  for (const auto& [name, value] : fields)
  {
    read.push_back(ReadField(nb::cast<std::string>(name), value));
  }
  return read;
}

StoredMesh ReadMesh(const NumpyPoints& points, const NumpyCells& cells,
  const NamedArrays& pointArrays, const NamedArrays& cellArrays, const nb::dict& fields)
{
  StoredMesh mesh{ ViewMesh(points, cells), {} };
  mesh.Data.PointArrays = ListArrays(pointArrays, mesh.Data.NumberOfPoints);
  mesh.Data.ElementArrays = ListArrays(cellArrays, mesh.Data.NumberOfElements);
  mesh.Data.Fields = ReadFields(fields);
  FindKnownArrays(mesh);
  return mesh;
}

void WriteFile(const std::string& path, const NumpyPoints& points, const NumpyCells& cells,
  const NamedArrays& pointArrays, const NamedArrays& cellArrays, const nb::dict& fields,
  std::optional<double> time)
{
  StoredMesh mesh = ReadMesh(points, cells, pointArrays, cellArrays, fields);
  mesh.Data.Time = time;
  const nb::gil_scoped_release others;
  Ranks alone;
  WorkInStage(alone, ErrorCode::UnwritableOutput, [&] { WriteMesh(mesh.Data, path, alone); });
}

void WriteReportFile(const std::string& path, const NumpyPoints& points, const NumpyCells& cells,
  const NamedArrays& pointArrays, const NamedArrays& cellArrays, const nb::dict& fields,
  const nb::dict& materials, const std::string& title, const TextPairs& facts,
  const TextPairs& options, const std::vector<std::string>& warnings)
{
  const StoredMesh mesh = ReadMesh(points, cells, pointArrays, cellArrays, fields);
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
    "cell_arrays"_a, "fields"_a, "time"_a.none());
  module.def("write_report", WriteReportFile, "path"_a, "points"_a, "cells"_a, "point_arrays"_a,
    "cell_arrays"_a, "fields"_a, "materials"_a, "title"_a, "facts"_a, "options"_a, "warnings"_a);
}

} // namespace vfm
