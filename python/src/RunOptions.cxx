#include "RunOptions.h"

#include "Base/ParseText.h"
#include "Options/CellWidths.h"
#include "Options/MaterialWidths.h"
#include "Options/SetOptions.h"

#include <nanobind/stl/array.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace vfm
{
namespace
{

namespace nb = nanobind;

using Box = std::array<double, 7>; // lower corner, upper corner, halvings

/// Converts "Quadric Surface" to "quadric_surface".
std::string SnakeWord(std::string word)
{
  for (char& c : word)
  {
    c = c == ' ' ? '_' : ToLower(c);
  }
  return word;
}

/// Returns the words of a choice.
std::vector<std::string> WordsInPython(const Option& option)
{
  std::vector<std::string> words;
  std::transform(option.Words.begin(), option.Words.end(), std::back_inserter(words), SnakeWord);
  return words;
}

/// Returns the allowed values of an option, in Python notation.
std::string AllowedInPython(const Option& option)
{
  return option.Kind == OptionKind::Switch ? "True or False"
    : option.Kind == OptionKind::Choice    ? "'" + JoinTexts(WordsInPython(option), "', '") + "'"
                                           : option.Allowed();
}

const char* KindInPython(const Option& option)
{
  return option.Kind == OptionKind::Switch ? "flag"
    : option.Kind == OptionKind::Choice    ? "word"
    : option.Kind == OptionKind::Integer   ? "whole"
    : option.Kind == OptionKind::Pairs     ? "text"
    : option.Kind == OptionKind::Widths    ? "widths"
    : option.Kind == OptionKind::Sizes     ? "sizes"
                                           : "real";
}

std::string Describe(const Option& option, nb::handle value)
{
  return option.Python + " is " + nb::cast<std::string>(nb::repr(value)) + ": it must be " +
    AllowedInPython(option) + ".";
}

[[noreturn]] void RejectType(const Option& option, nb::handle value)
{
  PyErr_Clear();
  throw nb::type_error(Describe(option, value).c_str());
}

[[noreturn]] void RejectValue(const Option& option, nb::handle value)
{
  PyErr_Clear();
  throw nb::value_error(Describe(option, value).c_str());
}

double ReadSwitch(const Option& option, nb::handle value)
{
  const int isTrue = PyObject_RichCompareBool(value.ptr(), Py_True, Py_EQ);
  const int isFalse = PyObject_RichCompareBool(value.ptr(), Py_False, Py_EQ);
  if (isTrue != 1 && isFalse != 1)
  {
    RejectType(option, value);
  }
  return isTrue == 1 ? 1.0 : 0.0;
}

double ReadChoice(const Option& option, nb::handle value)
{
  if (!nb::isinstance<nb::str>(value))
  {
    RejectType(option, value);
  }
  const auto word = nb::cast<std::string>(value);
  const auto found = std::find_if(option.Words.begin(), option.Words.end(),
    [&word](const std::string& other) { return SnakeWord(other) == word; });
  if (found == option.Words.end())
  {
    RejectValue(option, value);
  }
  return static_cast<double>(found - option.Words.begin());
}

/// Reads an integer or a real; rejects texts.
double ReadNumber(const Option& option, nb::handle value)
{
  const bool isText = nb::isinstance<nb::str>(value) || nb::isinstance<nb::bytes>(value);
  const bool isWhole = option.Kind == OptionKind::Integer;
  const nb::object number = nb::steal(isText ? nullptr
      : isWhole                              ? PyNumber_Index(value.ptr())
                                             : PyNumber_Float(value.ptr()));
  if (!number.is_valid())
  {
    RejectType(option, value);
  }
  const double found = isWhole ? PyLong_AsDouble(number.ptr()) : PyFloat_AsDouble(number.ptr());
  if (PyErr_Occurred() || !RangeOf(option).Holds(found)) // nor NaN
  {
    RejectValue(option, value);
  }
  return found;
}

/// Converts a number in a value to a text.
std::string WriteNumber(const Option& option, nb::handle value, nb::handle item)
{
  const nb::object number = nb::steal(PyNumber_Float(item.ptr()));
  if (!number.is_valid())
  {
    RejectType(option, value);
  }
  return FormatNumber(PyFloat_AsDouble(number.ptr()));
}

/// Converts a number, or a sequence of three, to a text.
std::string WriteWidths(const Option& option, nb::handle value)
{
  std::vector<std::string> texts;
  const auto add = [&](nb::handle item) { texts.push_back(WriteNumber(option, value, item)); };
  if (PyNumber_Check(value.ptr()) && !PySequence_Check(value.ptr()))
  {
    add(value);
  }
  else
  {
    const nb::object items = nb::steal(PySequence_List(value.ptr()));
    if (!items.is_valid())
    {
      RejectType(option, value);
    }
    for (nb::handle item : items)
    {
      add(item);
    }
    if (texts.size() != 3)
    {
      RejectType(option, value);
    }
  }
  return JoinTexts(texts, ",");
}

/// Converts a dict of widths of materials to a text.
std::string WriteSizes(const Option& option, nb::handle value)
{
  if (!nb::isinstance<nb::dict>(value))
  {
    RejectType(option, value);
  }
  std::vector<std::string> entries;
  for (const auto& [name, width] : nb::borrow<nb::dict>(value))
  {
    entries.push_back(
      QuoteName(nb::cast<std::string>(nb::str(name)) + "=" + WriteNumber(option, value, width)));
  }
  return JoinTexts(entries, ",");
}

void Set(MesherOptions& options, const Option& option, nb::handle value)
{
  if (option.Kind == OptionKind::Widths)
  {
    const std::string text =
      nb::isinstance<nb::str>(value) ? nb::cast<std::string>(value) : WriteWidths(option, value);
    if (!ParseWidths(text))
    {
      RejectValue(option, value);
    }
    options.*option.Text = text;
    return;
  }
  if (option.Kind == OptionKind::Sizes && !nb::isinstance<nb::str>(value))
  {
    const std::string text = WriteSizes(option, value);
    if (!ParseMaterialWidths(text))
    {
      RejectValue(option, value);
    }
    options.*option.Text = text;
    return;
  }
  if (option.Text)
  {
    if (!nb::isinstance<nb::str>(value))
    {
      RejectType(option, value);
    }
    SetOption(options, option.Name, nb::cast<std::string>(value));
    return;
  }
  const double number = option.Kind == OptionKind::Switch ? ReadSwitch(option, value)
    : option.Kind == OptionKind::Choice                   ? ReadChoice(option, value)
                                                          : ReadNumber(option, value);
  option.SetNumber(options, number);
}

nb::object Get(const MesherOptions& options, const Option& option)
{
  if (option.Text)
  {
    const std::string& text = options.*option.Text;
    const bool isOne = option.Kind == OptionKind::Widths && text.find_first_of(", ") == text.npos;
    return isOne ? nb::object(nb::float_(ParseNumber(text, 0.0, HUGE_VAL).value_or(0.0)))
                 : nb::object(nb::str(text.c_str()));
  }
  const double number = option.GetNumber(options);
  switch (option.Kind)
  {
    case OptionKind::Switch:
      return nb::bool_(number != 0.0);
    case OptionKind::Choice:
      return nb::str(SnakeWord(option.Words[static_cast<int>(number)]).c_str());
    case OptionKind::Integer:
      return nb::int_(static_cast<int>(number));
    default:
      return nb::float_(number);
  }
}

/// Returns a dict of the options that differ from their defaults. Options without a name in Python
/// have their text as value.
nb::dict ListChanged(const MesherOptions& options)
{
  nb::dict changed;
  for (const Option* option : ListChangedOptions(options))
  {
    const bool isNamed = !option->Python.empty();
    const std::string name = isNamed ? option->Python : SnakeCase(option->Name);
    changed[name.c_str()] =
      isNamed ? Get(options, *option) : nb::str(GetOption(options, *option).c_str());
  }
  return changed;
}

std::vector<Box> GetBoxes(const MesherOptions& options)
{
  std::vector<Box> boxes;
  for (const auto& [l, u, halvings] : options.RefinementBoxes)
  {
    boxes.push_back({ { l[0], l[1], l[2], u[0], u[1], u[2], halvings } });
  }
  return boxes;
}

void SetBoxes(MesherOptions& options, const std::vector<Box>& boxes)
{
  options.RefinementBoxes.clear();
  for (const Box& b : boxes)
  {
    options.RefinementBoxes.push_back({ { b[0], b[1], b[2] }, { b[3], b[4], b[5] }, b[6] });
  }
}

/// Returns the options with a Python name.
std::vector<const Option*> ListOptions()
{
  std::vector<const Option*> options;
  for (const Option& option : GetOptionTable())
  {
    if (!option.Python.empty())
    {
      options.push_back(&option);
    }
  }
  return options;
}

void BindTable(nb::module_& module)
{
  nb::class_<Option>(module, "Option")
    .def_ro("name", &Option::Python)
    .def_prop_ro("kind", KindInPython)
    .def_prop_ro("default", [](const Option& self) { return Get(MesherOptions(), self); })
    .def_prop_ro("allowed", AllowedInPython)
    .def_prop_ro("words", WordsInPython)
    .def_prop_ro("least", [](const Option& self) { return self.Range.Least; })
    .def_prop_ro("most", [](const Option& self) { return self.Range.Most; })
    .def_ro("group", &Option::Group)
    .def_ro("tets", &Option::OnlyTets)
    .def_ro("text", &Option::Meaning);
  module.def("list_options", ListOptions, nb::rv_policy::reference);
}

void Init(MesherOptions* self, bool tets, const nb::kwargs& values)
{
  MesherOptions& options = *new (self) MesherOptions();
  options.Elements = tets ? ElementKind::Tets : ElementKind::Hexes;
  for (const auto& [name, value] : values)
  {
    const auto given = nb::cast<std::string>(name);
    const OptionTable& table = GetOptionTable();
    const auto found = std::find_if(table.begin(), table.end(),
      [&given](const Option& option) { return option.Python == given; });
    if (found == table.end())
    {
      throw nb::type_error(("There is no option '" + given + "'.").c_str());
    }
    Set(options, *found, value);
  }
}

} // namespace

void BindOptions(nb::module_& module)
{
  nb::class_<MesherOptions> type(module, "Options");
  for (const Option* option : ListOptions())
  {
    type.def_prop_rw(
      option->Python.c_str(), [option](const MesherOptions& self) { return Get(self, *option); },
      [option](MesherOptions& self, nb::handle value) { Set(self, *option, value); });
  }
  type.def("__init__", Init, nb::arg("tets"), nb::arg("values"));
  type.def_rw("refinement_array", &MesherOptions::RefinementArray);
  type.def_prop_rw(
    "threshold", [](const MesherOptions& self) { return self.Threshold; },
    [](MesherOptions& self, const std::string& text) { SetOption(self, "Threshold", text); });
  type.def_prop_rw("refinement_boxes", GetBoxes, SetBoxes);
  type.def("changed", ListChanged);
  BindTable(module);
}

} // namespace vfm
