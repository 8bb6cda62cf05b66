#include "MeasureMesh.h"

#include "NumpyFields.h"
#include "NumpyMesh.h"
#include "Report/ElementMoments.h"
#include "Report/Fragments/FragmentTable.h"

#include <nanobind/stl/optional.h>

#include <algorithm>

namespace vfm
{
namespace
{

namespace nb = nanobind;
using namespace nb::literals;

template <class T>
using Column = nb::ndarray<const T, nb::c_contig, nb::device::cpu, nb::ndim<1>>;

template <class T>
const T* OfEach(const Column<T>& values, Index count, const char* name)
{
  if (static_cast<Index>(values.shape(0)) != count)
  {
    throw nb::value_error((std::string(name) + " has another length than the mesh.").c_str());
  }
  return values.data();
}

nb::object MeasureVolumes(
  const NumpyPoints& points, const NumpyCells& cells, const nb::dict& fields)
{
  MeshData mesh = ViewMesh(points, cells);
  mesh.Fields = ReadFields(fields);
  const std::vector<ElementMoments> moments = FindElementMoments(mesh);
  Buffer<double> volumes(moments.size());
  std::transform(moments.begin(), moments.end(), volumes.begin(),
    [](const ElementMoments& element) { return element.Volume; });
  return ToNumpy(volumes);
}

/// Makes a column of values; get(row, a): component a of a row.
template <class T, class Get>
nb::object MakeColumn(const std::vector<FragmentSummary>& rows, const Get& get, int components = 0)
{
  const int width = std::max(components, 1);
  Buffer<T> values(rows.size() * width);
  for (std::size_t at = 0; at < values.size(); ++at)
  {
    values[at] = get(rows[at / width], at % width);
  }
  return ToNumpy(values, components);
}

nb::dict ToColumns(const std::vector<FragmentSummary>& rows, bool hasMass, bool hasMomentum)
{
  using Row = const FragmentSummary&;
  nb::dict columns;
  columns["id"] = MakeColumn<int>(rows, [](Row row, int) { return row.Id; });
  columns["material"] = MakeColumn<int>(rows, [](Row row, int) { return row.Material; });
  columns["elements"] = MakeColumn<Index>(rows, [](Row row, int) { return row.Elements; });
  columns["volume"] = MakeColumn<double>(rows, [](Row row, int) { return row.Volume; });
  columns["centroid"] = MakeColumn<double>(
    rows, [](Row row, int a) { return row.Centroid[a]; }, 3);
  columns["bounds"] = MakeColumn<double>(
    rows, [](Row row, int a) { return row.Bounds[a]; }, 6);
  if (hasMass)
  {
    columns["mass"] = MakeColumn<double>(rows, [](Row row, int) { return row.Mass; });
  }
  if (hasMomentum)
  {
    columns["momentum"] = MakeColumn<double>(
      rows, [](Row row, int a) { return row.Momentum[a]; }, 3);
  }
  nb::list neighbours;
  for (const FragmentSummary& row : rows)
  {
    Buffer<int> ids(row.Neighbours.size());
    std::copy(row.Neighbours.begin(), row.Neighbours.end(), ids.begin());
    neighbours.append(ToNumpy(ids));
  }
  columns["neighbours"] = neighbours;
  return columns;
}

nb::dict MeasureFragments(const NumpyPoints& points, const NumpyCells& cells,
  const Column<std::int64_t>& pointIds, const Column<int>& dimension, const Column<int>& material,
  const Column<int>& fragment, const std::optional<Column<double>>& density,
  const std::optional<NumpyPoints>& velocity)
{
  MeshData mesh = ViewMesh(points, cells);
  mesh.PointIds = OfEach(pointIds, mesh.NumberOfPoints, "point_ids");
  mesh.GeometryDimension = OfEach(dimension, mesh.NumberOfPoints, "dimension");
  mesh.Material = OfEach(material, mesh.NumberOfElements, "material");
  mesh.Fragment = OfEach(fragment, mesh.NumberOfElements, "fragment");
  FragmentArrays arrays;
  if (density)
  {
    const double* values = OfEach(*density, mesh.NumberOfElements, "density");
    mesh.ElementArrays.push_back({ "density", ValueType::Double, 1, {}, values });
    arrays.Densities = { "density" };
  }
  if (density && velocity)
  {
    if (static_cast<Index>(velocity->shape(0)) != mesh.NumberOfElements)
    {
      throw nb::value_error("velocity has another length than the mesh.");
    }
    mesh.ElementArrays.push_back({ "velocity", ValueType::Double, 3, {}, velocity->data() });
    arrays.Velocity = "velocity";
  }
  Ranks alone;
  return ToColumns(
    FindFragments(mesh, arrays, alone), density.has_value(), !arrays.Velocity.empty());
}

} // namespace

void BindMeasures(nb::module_& module)
{
  module.def("element_volumes", MeasureVolumes, "points"_a, "cells"_a, "fields"_a);
  module.def("fragments", MeasureFragments, "points"_a, "cells"_a, "point_ids"_a, "dimension"_a,
    "material"_a, "fragment"_a, "density"_a.none(), "velocity"_a.none());
}

} // namespace vfm
