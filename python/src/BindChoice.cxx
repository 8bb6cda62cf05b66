#include "BindChoice.h"

#include "Materials/ChooseMaterials.h"
#include "NumpyArrays.h"

#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

namespace vfm
{
namespace
{

namespace nb = nanobind;
using namespace nb::literals;

MaterialChoice Choose(const std::vector<std::pair<std::string, NumpyArray>>& arrays,
  const std::vector<std::string>& others, double tolerance, bool isImage, bool hasThreshold)
{
  const Index cells = arrays.empty() ? 0 : NumpyView(arrays[0].first, arrays[0].second).Rows;
  ChoiceRules rules;
  rules.Tolerance = tolerance;
  rules.IsImage = isImage;
  rules.Others = others;
  rules.HasThreshold = hasThreshold;
  return ChooseMaterials(ListArrays({ MakeBlockArrays(cells, arrays) }), rules);
}

/// Returns pairs of the content and its reason.
std::vector<std::pair<std::string, std::string>> ListContents(const MaterialChoice& choice)
{
  std::vector<std::pair<std::string, std::string>> contents;
  for (const ContentOfArray& found : choice.Contents)
  {
    contents.emplace_back(NameOfContent(found.Content), found.Reason);
  }
  return contents;
}

} // namespace

void BindChoice(nb::module_& module)
{
  nb::class_<MaterialChoice>(module, "MaterialChoice", "Arrays that hold the materials.")
    .def_ro("fractions", &MaterialChoice::Fractions, "list of str: Arrays, one per material.")
    .def_ro("labels", &MaterialChoice::Labels, "str: Array of labels; empty without labels.")
    .def_ro("how", &MaterialChoice::How, "str: Reason of the choice.")
    .def_ro("problem", &MaterialChoice::Problem, "str: Reason if nothing is chosen.")
    .def_ro("is_clear", &MaterialChoice::IsClear, "bool: True if no other choice is possible.")
    .def_prop_ro("contents", ListContents, "list of (str, str): Content of each array, reason.");
  module.def(
    "choose_materials", Choose, "arrays"_a, "others"_a, "tolerance"_a, "image"_a, "threshold"_a);
}

} // namespace vfm
