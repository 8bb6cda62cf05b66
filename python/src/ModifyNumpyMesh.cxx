#include "ModifyNumpyMesh.h"

#include "MeshResult.h"
#include "ModifyMesh.h"
#include "NumpyFields.h"
#include "NumpyMesh.h"
#include "PythonRuntime.h"
#include "Report/Sets/MaterialBins.h"

#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <algorithm>

namespace vfm
{
namespace
{

namespace nb = nanobind;
using namespace nb::literals;

/// Copies the array of a dict.
template <class T>
Buffer<T> CopyItem(const nb::dict& arrays, const char* name)
{
  using Values = nb::ndarray<const T, nb::c_contig, nb::device::cpu>;
  const Values values = nb::cast<Values>(arrays[name]);
  Buffer<T> copy(values.size());
  std::copy_n(values.data(), values.size(), copy.begin());
  return copy;
}

/// @throws InputError if ids are not ascending: surfaces would have other points
void CheckOrder(const MeshData& mesh)
{
  const Index* ids = mesh.PointIds;
  if (ids && !std::is_sorted(ids, ids + mesh.NumberOfPoints))
  {
    throw InputError("The points of the mesh must be in the order of their ids.");
  }
}

nb::dict Modify(const NumpyPoints& points, const NumpyCells& cells, const NamedArrays& pointArrays,
  const NamedArrays& cellArrays, const nb::dict& fields, const nb::dict& surfaces,
  const nb::dict& curves, const std::vector<std::string>& extensive, const MesherOptions& options,
  nb::handle warn)
{
  const StoredMesh mesh = ViewMesh(points, cells, pointArrays, cellArrays, fields);
  CheckOrder(mesh.Data);
  ModifyInput input;
  input.Data = mesh.Data;
  input.Extensive = extensive;
  input.Surfaces = { CopyItem<Index>(surfaces, "cells"), CopyItem<int>(surfaces, "surface_id"),
    CopyItem<int>(surfaces, "material_pair"), {}, CopyItem<int>(surfaces, "domain_side") };
  input.Curves = { CopyItem<Index>(curves, "cells"), CopyItem<int>(curves, "curve_id") };
  const MesherOptions kept = options; // other threads may change options during the run
  PythonRuntime runtime(kept.NumberOfThreads, nb::none());
  input.Warn = [&](const std::string& text)
  { runtime.CallPython([&] { warn(nb::str(text.c_str(), text.size())); }); };
  ModifiedMesh result;
  runtime.Run([&] { result = ModifyMesh(std::move(input), kept, runtime); });
  nb::dict arrays;
  for (TransferredArray& array : result.PointArrays)
  {
    arrays[array.Name.c_str()] = ToNumpy(array);
  }
  nb::dict all = ToPython(std::move(result));
  all["point_state"] = arrays;
  return all;
}

/// @param law  factor, exponent, Poisson's ratio, offset and slope of ElasticLaw
nb::tuple BinMaterials(const NumpyPoints& points, const NumpyCells& cells,
  const NamedArrays& pointArrays, const NamedArrays& cellArrays, const nb::dict& fields,
  const std::string& array, int count, const std::vector<int>& materials,
  const std::optional<std::array<double, 5>>& law)
{
  const StoredMesh mesh = ViewMesh(points, cells, pointArrays, cellArrays, fields);
  BinRule rule{ array, count, materials, std::nullopt };
  if (law)
  {
    rule.Law = ElasticLaw{ (*law)[0], (*law)[1], (*law)[2], (*law)[3], (*law)[4] };
  }
  BinnedElements bins;
  {
    const nb::gil_scoped_release others;
    Ranks alone;
    bins = BinElements(mesh.Data, rule, alone);
  }
  return nb::make_tuple(NumbersToNumpy(bins.Ids), ToDict(bins.Fields));
}

} // namespace

void BindModify(nb::module_& module)
{
  module.def("modify_mesh", Modify, "points"_a, "cells"_a, "point_arrays"_a, "cell_arrays"_a,
    "fields"_a, "surfaces"_a, "curves"_a, "extensive"_a, "options"_a, "warn"_a);
  module.def("bin_materials", BinMaterials, "points"_a, "cells"_a, "point_arrays"_a,
    "cell_arrays"_a, "fields"_a, "array"_a, "count"_a, "materials"_a, "law"_a.none());
}

} // namespace vfm
