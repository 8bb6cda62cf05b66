#include "FindFaces.h"

#include "Elements/ElementFaces.h"
#include "NumpyFields.h"
#include "NumpyMesh.h"
#include "Report/MatchFaces.h"
#include "Report/Sets/NamedSurfaces.h"
#include "Report/Sets/SplitFaces.h"

#include <nanobind/stl/map.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

namespace vfm
{
namespace
{

namespace nb = nanobind;
using namespace nb::literals;

template <class T>
using Column = nb::ndarray<const T, nb::c_contig, nb::device::cpu, nb::ndim<1>>;

nb::object FindNeighbours(const NumpyPoints& points, const NumpyCells& cells)
{
  const MeshData mesh = ViewMesh(points, cells);
  Buffer<Index> neighbours;
  {
    const nb::gil_scoped_release others;
    const std::vector<Index> behind = MatchSides(mesh);
    neighbours = Buffer<Index>(behind.size());
    std::copy(behind.begin(), behind.end(), neighbours.begin());
  }
  return ToNumpy(neighbours, ElementFaces(mesh.Corners).Count);
}

/// Returns the elements of faces and their sides.
std::pair<nb::object, nb::object> ToPython(const std::vector<ElementSide>& faces)
{
  Buffer<Index> elements(faces.size());
  Buffer<int> sides(faces.size());
  for (std::size_t at = 0; at < faces.size(); ++at)
  {
    elements[at] = faces[at].Element;
    sides[at] = faces[at].Side;
  }
  return { ToNumpy(elements), ToNumpy(sides) };
}

nb::list ListSideSets(const NumpyPoints& points, const NumpyCells& cells,
  const NamedArrays& pointArrays, const NamedArrays& cellArrays, const nb::dict& fields)
{
  const StoredMesh mesh = ViewMesh(points, cells, pointArrays, cellArrays, fields);
  MeshSets sets;
  {
    const nb::gil_scoped_release others;
    Ranks alone;
    sets = FindMeshSets(mesh.Data, alone);
  }
  nb::list list;
  for (const SideSet& set : sets.SideSets)
  {
    const auto [elements, sides] = ToPython(set.Sides);
    list.append(nb::make_tuple(set.Id, set.Name, elements, sides));
  }
  return list;
}

nb::tuple ListTaggedFaces(const NumpyPoints& points, const NumpyCells& cells,
  const NamedArrays& pointArrays, const NamedArrays& cellArrays, const nb::dict& fields)
{
  const StoredMesh mesh = ViewMesh(points, cells, pointArrays, cellArrays, fields);
  TaggedFaces tagged;
  {
    const nb::gil_scoped_release others;
    Ranks alone;
    tagged = TagFaces(FindNamedSurfaces(mesh.Data, alone));
  }
  Buffer<int> tags(tagged.Tags.size());
  std::copy(tagged.Tags.begin(), tagged.Tags.end(), tags.begin());
  const auto [elements, sides] = ToPython(tagged.Faces);
  return nb::make_tuple(elements, sides, ToNumpy(tags), tagged.Names);
}

nb::list ListCohesive(const NumpyPoints& points, const NumpyCells& cells,
  const NamedArrays& pointArrays, const NamedArrays& cellArrays, const nb::dict& fields)
{
  const StoredMesh mesh = ViewMesh(points, cells, pointArrays, cellArrays, fields);
  std::vector<CohesiveBlock> blocks;
  {
    const nb::gil_scoped_release others;
    Ranks alone;
    blocks = FindCohesiveBlocks(mesh.Data, alone);
  }
  nb::list list;
  for (const CohesiveBlock& block : blocks)
  {
    Buffer<Index> corners(block.Points.size()), ids(block.Ids.size());
    std::copy(block.Points.begin(), block.Points.end(), corners.begin());
    std::copy(block.Ids.begin(), block.Ids.end(), ids.begin());
    list.append(
      nb::make_tuple(block.Id, block.Name, nb::make_tuple(block.Materials[0], block.Materials[1]),
        ToNumpy(corners, CohesiveCorners(mesh.Data)), ToNumpy(ids)));
  }
  return list;
}

nb::object ListFacePoints(
  const NumpyCells& cells, const Column<std::int64_t>& elements, const Column<int>& sides)
{
  const ElementFaces table(static_cast<int>(cells.shape(1)));
  const Index count = static_cast<Index>(elements.shape(0));
  if (static_cast<Index>(sides.shape(0)) != count)
  {
    throw nb::value_error("elements and sides must have the same length.");
  }
  Buffer<Index> points(count * table.Corners);
  for (Index at = 0; at < count; ++at)
  {
    const Index element = elements.data()[at];
    const int side = sides.data()[at];
    if (element < 0 || element >= static_cast<Index>(cells.shape(0)) || side < 0 ||
      side >= table.Count)
    {
      throw nb::value_error(("There is no side " + std::to_string(side) + " of an element " +
        std::to_string(element) + ".")
                              .c_str());
    }
    const std::array<Index, 4> face =
      table.PointsOf(cells.data() + element * static_cast<Index>(cells.shape(1)), side);
    std::copy_n(face.begin(), table.Corners, points.begin() + at * table.Corners);
  }
  return ToNumpy(points, table.Corners);
}

} // namespace

void BindFaces(nb::module_& module)
{
  module.def("neighbours", FindNeighbours, "points"_a, "cells"_a);
  module.def("side_sets", ListSideSets, "points"_a, "cells"_a, "point_arrays"_a, "cell_arrays"_a,
    "fields"_a);
  module.def("tagged_faces", ListTaggedFaces, "points"_a, "cells"_a, "point_arrays"_a,
    "cell_arrays"_a, "fields"_a);
  module.def("cohesive_blocks", ListCohesive, "points"_a, "cells"_a, "point_arrays"_a,
    "cell_arrays"_a, "fields"_a);
  module.def("face_points", ListFacePoints, "cells"_a, "elements"_a, "sides"_a);
}

} // namespace vfm
