/**
 * Module: the Python module _core; _core.pyi describes its functions.
 */
#include "BindBodies.h"
#include "BindChoice.h"
#include "Blocks/BlockFile.h"
#include "CheckGridFile.h"
#include "FileBlocks.h"
#include "FindFaces.h"
#include "Labels/ReadLabelNames.h"
#include "MeasureMesh.h"
#include "MeshResult.h"
#include "MesherCall.h"
#include "ModifyNumpyMesh.h"
#include "Phases/MeshOfCells.h"
#include "PythonRuntime.h"
#include "Ranks/PrintableText.h"
#include "ReadSurfaces.h"
#include "RunOptions.h"
#include "ShapeFractions.h"
#include "WriteFile.h"

#include <nanobind/stl/array.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <algorithm>

namespace
{

namespace nb = nanobind;
using namespace nb::literals;

using Numbers = nb::ndarray<const double, nb::ndim<1>, nb::c_contig, nb::device::cpu>;
using NodeArrays = std::array<Numbers, 3>;

vfm::NodeCoordinates Copy(const NodeArrays& nodes)
{
  vfm::NodeCoordinates coordinates;
  for (int a = 0; a < 3; ++a)
  {
    coordinates[a].assign(nodes[a].data(), nodes[a].data() + nodes[a].size());
  }
  return coordinates;
}

nb::dict MakeMesh(const vfm::FileBlocks* blocks,
  const std::vector<std::pair<std::string, vfm::NumpyArray>>& arrays, const NodeArrays& coordinates,
  const std::array<double, 9>& axes, const std::array<double, 3>& origin, bool arePoints,
  const std::vector<std::string>& fractions, const std::string& labels,
  const vfm::LabelNames& names, nb::handle state, const vfm::MesherOptions& options,
  nb::handle progress, nb::handle warn, bool areGuessed, const std::string& labelsOption,
  const vfm::Bodies* bodies)
{
  const vfm::MesherCall call{ blocks ? blocks->Blocks : std::vector<vfm::InputBlock>(), arrays,
    Copy(coordinates), axes, origin, arePoints, fractions, labels, names,
    vfm::ReadStateChoice(state, options.StateTransfer), areGuessed, labelsOption,
    bodies ? bodies->Surfaces : nullptr };
  const vfm::MesherOptions kept = options; // other threads may change options during the run
  vfm::PythonRuntime runtime(kept.NumberOfThreads, progress);
  vfm::MesherResult result;
  runtime.Run(
    [&]
    {
      runtime.Progress(0.0, "Reading input");
      vfm::MesherInput input = vfm::MakeInput(call, runtime);
      input.Warn = [&](const std::string& text)
      { runtime.CallPython([&] { warn(nb::str(text.c_str(), text.size())); }); };
      result = vfm::RunMesher(input, kept, runtime);
      runtime.Progress(1.0, "Done");
    });
  return vfm::ToPython(std::move(result));
}

nb::list FillShapes(const std::string& text, const NodeArrays& coordinates, double tolerance,
  int threads, nb::handle progress)
{
  vfm::PythonRuntime runtime(threads, progress);
  return vfm::FractionsOfText(text, Copy(coordinates), tolerance, runtime);
}

nb::list FillSurfaces(
  const vfm::Bodies& bodies, const NodeArrays& coordinates, int threads, nb::handle progress)
{
  vfm::PythonRuntime runtime(threads, progress);
  return vfm::FractionsInside(*bodies.Surfaces, Copy(coordinates), runtime);
}

nb::list FillLevelSets(const std::vector<std::pair<std::string, vfm::NumpyArray>>& arrays,
  const NodeArrays& coordinates, const std::string& rule, const std::string& inside, int threads,
  nb::handle progress)
{
  vfm::PythonRuntime runtime(threads, progress);
  return vfm::FractionsOfArrays(arrays, Copy(coordinates), rule, inside, runtime);
}

vfm::FileBlocks ReadBlocks(const std::string& path, int step,
  const std::optional<std::vector<std::string>>& names, bool isTrusted)
{
  const nb::gil_scoped_release others;
  vfm::FileBlocks blocks;
  vfm::PrefixErrors("Cannot read " + path + ": ",
    [&] { blocks = vfm::ReadFileBlocks(path, step, names, isTrusted); });
  return blocks;
}

void BindBlocks(nb::module_& module)
{
  nb::class_<vfm::FileBlocks>(module, "Blocks",
    "Blocks of cells of a file, on all levels, with arrays. Made by read(); len() is the number of "
    "blocks.")
    .def_ro("path", &vfm::FileBlocks::Path, "str: Path of the file.")
    .def_ro("times", &vfm::FileBlocks::Times, "list of float: Times of all steps of the file.")
    .def_ro("time", &vfm::FileBlocks::Time, "float or None: Time of the blocks.")
    .def_ro("names", &vfm::FileBlocks::Names, "list of str: Names of the arrays.")
    .def_ro("fractions", &vfm::FileBlocks::Fractions,
      "list of str: Names of the arrays that hold volume fractions.")
    .def_ro("labels", &vfm::FileBlocks::Labels,
      "str: Name of the array that holds labels; empty without labels.")
    .def("__len__", [](const vfm::FileBlocks& self) { return self.Blocks.size(); });
  module.def("read_blocks", ReadBlocks, "path"_a, "step"_a, "names"_a.none(), "trust_input"_a);
  module.def("is_block_file", vfm::IsBlockFile, "path"_a);
}

/// Converts an InputError to a Python exception.
void TranslateError(const std::exception_ptr& raised, void*)
{
  try
  {
    std::rethrow_exception(raised);
  }
  catch (const vfm::InputError& error)
  {
    const vfm::ErrorCode code = error.Code();
    PyErr_SetString(code == vfm::ErrorCode::OutOfMemory ? PyExc_MemoryError
        : code == vfm::ErrorCode::UnwritableOutput      ? PyExc_OSError
                                                        : PyExc_ValueError,
      vfm::MakePrintable(error.what()).c_str()); // Python requires UTF-8
  }
}

/// Reads names of labels. A note about them is a warning of the package.
vfm::LabelNames ReadNames(const std::string& path)
{
  std::string note;
  vfm::LabelNames names = vfm::ReadLabelNames(path, &note);
  if (!note.empty())
  {
    const nb::object category =
      nb::module_::import_("volume_fraction_mesh").attr("VolumeFractionMeshWarning");
    nb::module_::import_("warnings").attr("warn")(note, category, "stacklevel"_a = 2);
  }
  return names;
}

} // namespace

NB_MODULE(_core, module)
{
  nb::register_exception_translator(TranslateError);
  module.attr("version") = VFM_VERSION;
  module.attr("has_tetgen") = vfm::HasTetGen();
  vfm::BindOptions(module);
  BindBlocks(module);
  vfm::BindBodies(module);
  vfm::BindChecks(module);
  vfm::BindChoice(module);
  vfm::BindFaces(module);
  vfm::BindMeasures(module);
  vfm::BindModify(module);
  vfm::BindSurfaceFiles(module);
  vfm::BindWriters(module);
  module.def("mesh", MakeMesh, "blocks"_a.none(), "arrays"_a, "coordinates"_a, "axes"_a, "origin"_a,
    "are_points"_a, "fractions"_a, "labels"_a, "label_names"_a, "state"_a.none(), "options"_a,
    "progress"_a.none(), "warn"_a, "guessed"_a = false, "labels_option"_a = "--labels",
    "bodies"_a.none() = nb::none());
  module.def("read_label_names", ReadNames, "path"_a);
  module.def("shape_fractions", FillShapes, "text"_a, "coordinates"_a, "tolerance"_a, "threads"_a,
    "progress"_a.none());
  module.def("level_set_fractions", FillLevelSets, "arrays"_a, "coordinates"_a, "rule"_a,
    "inside"_a, "threads"_a, "progress"_a.none());
  module.def("surface_fractions", FillSurfaces, "surfaces"_a, "coordinates"_a, "threads"_a,
    "progress"_a.none());
}
