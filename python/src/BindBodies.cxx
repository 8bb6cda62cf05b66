#include "BindBodies.h"

#include "NumpyFields.h"
#include "Ranks/PrintableText.h"
#include "Shapes/PlaceGrid.h"

#include <nanobind/ndarray.h>
#include <nanobind/stl/array.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <algorithm>
#include <cstdint>
#include <tuple>

namespace vfm
{
namespace
{

namespace nb = nanobind;
using namespace nb::literals;

using Places = nb::ndarray<const double, nb::shape<-1, 3>, nb::c_contig, nb::device::cpu>;
using Corners = nb::ndarray<const std::int64_t, nb::shape<-1, 3>, nb::c_contig, nb::device::cpu>;
using Numbers = nb::ndarray<const std::int32_t, nb::ndim<1>, nb::c_contig, nb::device::cpu>;
/// Name, points, triangles, patches or None, names of the patches.
using GivenBody =
  std::tuple<std::string, Places, Corners, std::optional<Numbers>, std::vector<std::string>>;

template <class Row, class Array>
std::vector<Row> CopyRows(const Array& values)
{
  std::vector<Row> rows(values.shape(0));
  for (std::size_t r = 0; r < rows.size(); ++r)
  {
    std::copy_n(values.data() + 3 * r, 3, rows[r].begin());
  }
  return rows;
}

/// Triangles as they were given.
struct BodyArrays
{
  std::string Name;
  std::vector<Vector3> Points;
  std::vector<PointTriangle> Triangles;
  std::vector<int> Patches;
  std::vector<std::string> PatchNames;
};

/// Makes the bodies without the GIL. The name of a body is in messages if there are several.
Bodies MakeBodies(const std::vector<GivenBody>& given)
{
  std::vector<BodyArrays> arrays;
  for (const auto& [name, points, triangles, patches, names] : given)
  {
    BodyArrays body{ name, CopyRows<Vector3>(points), CopyRows<PointTriangle>(triangles), {},
      names };
    if (patches)
    {
      body.Patches.assign(patches->data(), patches->data() + patches->shape(0));
    }
    arrays.push_back(std::move(body));
  }
  const nb::gil_scoped_release others;
  auto surfaces = std::make_shared<InputSurfaces>();
  std::string notes;
  for (BodyArrays& body : arrays)
  {
    const std::string prefix = arrays.size() > 1 ? body.Name + ": " : "";
    std::string note;
    PrefixErrors(prefix,
      [&]
      {
        surfaces->Bodies.push_back(MakeBody(body.Name, std::move(body.Points),
          std::move(body.Triangles), std::move(body.Patches), std::move(body.PatchNames), &note));
      });
    notes += note.empty() ? "" : (notes.empty() ? "" : " ") + prefix + note;
  }
  return { surfaces, notes };
}

nb::tuple ToTuple(const BodySurface& body)
{
  return nb::make_tuple(body.Name, RowsToNumpy<double>(body.Boundary.Points),
    RowsToNumpy<std::int64_t>(body.Boundary.Triangles), NumbersToNumpy(body.Patches),
    body.PatchNames);
}

nb::list ToList(const Bodies& bodies)
{
  nb::list list;
  for (const BodySurface& body : bodies.Surfaces->Bodies)
  {
    list.append(ToTuple(body));
  }
  return list;
}

const BodySurface& FindBody(const Bodies& bodies, const std::string& name)
{
  const std::vector<BodySurface>& all = bodies.Surfaces->Bodies;
  const auto found = std::find_if(
    all.begin(), all.end(), [&name](const BodySurface& body) { return body.Name == name; });
  if (found == all.end())
  {
    throw nb::key_error(name.c_str());
  }
  return *found;
}

nb::dict DescribeBody(const Bodies& bodies, const std::string& name)
{
  const BodySurface& body = FindBody(bodies, name);
  nb::dict arrays;
  arrays["points"] = RowsToNumpy<double>(body.Boundary.Points);
  arrays["triangles"] = RowsToNumpy<std::int64_t>(body.Boundary.Triangles);
  arrays["patches"] = NumbersToNumpy(body.Patches);
  arrays["patch_names"] = nb::cast(body.PatchNames);
  return arrays;
}

std::vector<std::string> ListNames(const Bodies& bodies)
{
  std::vector<std::string> names;
  for (const BodySurface& body : bodies.Surfaces->Bodies)
  {
    names.push_back(body.Name);
  }
  return names;
}

Bodies Rename(const Bodies& bodies, const std::map<std::string, std::string>& names)
{
  auto renamed = std::make_shared<InputSurfaces>(*bodies.Surfaces);
  for (BodySurface& body : renamed->Bodies)
  {
    const auto found = names.find(body.Name);
    body.Name = found == names.end() ? body.Name : found->second;
  }
  return { renamed, bodies.Note };
}

nb::list ToNodes(const GridPlace& place)
{
  nb::list nodes;
  for (const std::vector<double>& x : ListNodes(place))
  {
    Buffer<double> values(x.size());
    std::copy(x.begin(), x.end(), values.data());
    nodes.append(ToNumpy(values));
  }
  return nodes;
}

/// Returns the nodes of a grid around the bodies.
/// @param cells  number along the longest side, or three; none: widths are given
nb::list Place(const Bodies& bodies, const std::vector<std::int64_t>& cells,
  const std::optional<std::array<double, 3>>& widths)
{
  const PlaceBounds bounds = FindBounds(*bodies.Surfaces);
  return ToNodes(widths   ? PlaceCellsOfWidth(bounds, *widths)
      : cells.size() == 1 ? PlaceCells(bounds, cells[0])
                          : PlaceCells(bounds, { { cells.at(0), cells.at(1), cells.at(2) } }));
}

} // namespace

void BindBodies(nb::module_& module)
{
  nb::class_<Bodies>(module, "Bodies",
    "Closed surfaces of the bodies from which volume fractions were computed: the attribute "
    "surfaces of Fractions. bodies[name] is a dict of points, shape (n, 3), triangles (m, 3), "
    "patches (m,) and patch_names; len() is the number of bodies.")
    .def(
      "__init__",
      [](Bodies* self, const std::vector<GivenBody>& given)
      { new (self) Bodies(MakeBodies(given)); },
      "bodies"_a)
    .def("__getstate__", ToList)
    .def("__setstate__",
      [](Bodies& self, const std::vector<GivenBody>& state)
      { new (&self) Bodies(MakeBodies(state)); })
    .def("__len__", [](const Bodies& self) { return self.Surfaces->Bodies.size(); })
    .def("__getitem__", DescribeBody, "name"_a)
    .def_prop_ro("names", ListNames,
      "list of str: Names of the bodies; where they overlap, the first has priority.")
    .def_prop_ro(
      "note", [](const Bodies& self) { return MakePrintable(self.Note); },
      "str: Repairs of the surfaces, such as merged points; empty if there are none.")
    .def("_renamed", Rename, "names"_a)
    .def("_place", Place, "cells"_a, "widths"_a.none());
}

} // namespace vfm
