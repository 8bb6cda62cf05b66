/**
 * NumpyMesh: views points, cells and named arrays in numpy arrays as a mesh.
 */
#pragma once

#include "NumpyArrays.h"
#include "Report/MeshData.h"
#include "Report/MeshFields.h"

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>

namespace vfm
{

using NumpyPoints = nanobind::ndarray<const double, nanobind::shape<-1, 3>, nanobind::c_contig,
  nanobind::device::cpu>;
using NumpyCells = nanobind::ndarray<const std::int64_t, nanobind::ndim<2>, nanobind::c_contig,
  nanobind::device::cpu>;
/// Names and values, shape (items,) or (items, components).
using NamedArrays = std::vector<std::pair<std::string, NumpyArray>>;

/// Views points and elements, which must outlive the view.
/// @throws ValueError if cells are not points of hexahedra (n, 8) or tetrahedra (n, 4)
MeshData ViewMesh(const NumpyPoints& points, const NumpyCells& cells);

/// Copies fields: numpy arrays of int32, int64 or float64, or lists of texts, by name.
/// @throws InputError if an array has another type
FieldArrays ReadFields(const nanobind::dict& fields);

/// Views points, elements and arrays, which must outlive the view, and copies fields.
/// @param fields as for ReadFields
/// @throws ValueError as above; InputError if an array has another length than the mesh, or
/// another type
StoredMesh ViewMesh(const NumpyPoints& points, const NumpyCells& cells,
  const NamedArrays& pointArrays, const NamedArrays& cellArrays, const nanobind::dict& fields);

} // namespace vfm
