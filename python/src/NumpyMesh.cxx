#include "NumpyMesh.h"

#include "Report/FlatData.h"
#include "Report/MeshArrays.h"

#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <algorithm>

namespace vfm
{
namespace
{

namespace nb = nanobind;

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
    const std::optional<KnownArray> known = FindKnownArray(name);
    const bool isId = known && known->Type == ValueType::Id;
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

[[noreturn]] void RejectCells()
{
  throw nb::value_error(
    "cells must be points of hexahedra (n, 8), tetrahedra or quads (n, 4) or triangles (n, 3).");
}

void CheckPoints(const NumpyCells& cells, Index points)
{
  const auto isPoint = [points](Index point) { return point >= 0 && point < points; };
  if (!std::all_of(cells.data(), cells.data() + cells.size(), isPoint))
  {
    RejectCells();
  }
}

} // namespace

MeshData ViewMesh(const NumpyPoints& points, const NumpyCells& cells)
{
  MeshData mesh;
  mesh.NumberOfPoints = static_cast<Index>(points.shape(0));
  mesh.NumberOfElements = static_cast<Index>(cells.shape(0));
  mesh.Corners = static_cast<int>(cells.shape(1));
  mesh.Points = points.data();
  mesh.Elements = cells.data();
  if (mesh.Corners != 8 && mesh.Corners != 4 && mesh.Corners != 3)
  {
    RejectCells();
  }
  CheckPoints(cells, mesh.NumberOfPoints);
  return mesh;
}

namespace
{

/// Views cells of 8 or 4 points, or copies the corners and mid nodes of cells of 20, 27 or 10.
StoredMesh ViewNodes(const NumpyPoints& points, const NumpyCells& cells)
{
  const auto nodes = static_cast<int>(cells.shape(1));
  if (nodes != 20 && nodes != 27 && nodes != 10)
  {
    return { ViewMesh(points, cells), {} };
  }
  StoredMesh mesh;
  MeshData& data = mesh.Data;
  data.NumberOfPoints = static_cast<Index>(points.shape(0));
  data.NumberOfElements = static_cast<Index>(cells.shape(0));
  data.Corners = nodes == 10 ? 4 : 8;
  data.MidsPerElement = nodes - data.Corners;
  data.Points = points.data();
  CheckPoints(cells, data.NumberOfPoints);
  std::vector<Index> corners, mids;
  for (Index e = 0; e < data.NumberOfElements; ++e)
  {
    const Index* cell = cells.data() + nodes * e;
    corners.insert(corners.end(), cell, cell + data.Corners);
    mids.insert(mids.end(), cell + data.Corners, cell + nodes);
  }
  data.Elements = mesh.Store(std::move(corners));
  data.MidPoints = mesh.Store(std::move(mids));
  return mesh;
}

} // namespace

FieldArrays ReadFields(const nb::dict& fields)
{
  FieldArrays read;
  for (const auto& [name, value] : fields)
  {
    read.push_back(ReadField(nb::cast<std::string>(name), value));
  }
  return read;
}

StoredMesh ViewMesh(const NumpyPoints& points, const NumpyCells& cells,
  const NamedArrays& pointArrays, const NamedArrays& cellArrays, const nb::dict& fields)
{
  StoredMesh mesh = ViewNodes(points, cells);
  mesh.Data.PointArrays = ListArrays(pointArrays, mesh.Data.NumberOfPoints);
  mesh.Data.ElementArrays = ListArrays(cellArrays, mesh.Data.NumberOfElements);
  mesh.Data.Fields = ReadFields(fields);
  PutFlatAxisFirst(mesh.Data.Fields);
  FindKnownArrays(mesh);
  return mesh;
}

} // namespace vfm
