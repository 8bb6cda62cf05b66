/**
 * NumpyMesh: views points and cells in numpy arrays as a mesh.
 */
#pragma once

#include "Summary/MeshData.h"

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>

#include <algorithm>

namespace vfm
{

using NumpyPoints = nanobind::ndarray<const double, nanobind::shape<-1, 3>, nanobind::c_contig,
  nanobind::device::cpu>;
using NumpyCells = nanobind::ndarray<const std::int64_t, nanobind::ndim<2>, nanobind::c_contig,
  nanobind::device::cpu>;

/// Views points and elements, which must outlive the view.
/// @throws ValueError if cells are not points of hexahedra (n, 8) or tetrahedra (n, 4)
inline MeshData ViewMesh(const NumpyPoints& points, const NumpyCells& cells)
{
  MeshData mesh;
  mesh.NumberOfPoints = static_cast<Index>(points.shape(0));
  mesh.NumberOfElements = static_cast<Index>(cells.shape(0));
  mesh.Corners = static_cast<int>(cells.shape(1));
  mesh.Points = points.data();
  mesh.Elements = cells.data();
  const auto isPoint = [&](Index point) { return point >= 0 && point < mesh.NumberOfPoints; };
  if ((mesh.Corners != 8 && mesh.Corners != 4) ||
    !std::all_of(cells.data(), cells.data() + cells.size(), isPoint))
  {
    throw nanobind::value_error("cells must be points of hexahedra (n, 8) or tetrahedra (n, 4).");
  }
  return mesh;
}

} // namespace vfm
