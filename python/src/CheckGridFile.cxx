#include "CheckGridFile.h"

#include "GridFiles/VtkFileCheck.h"
#include "InputTrust.h"
#include "Ranks/Errors.h"

#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>

#include <algorithm>

namespace vfm
{
namespace
{

namespace nb = nanobind;
using namespace nb::literals;

/// Converts an element (name, attributes, place, children).
OutlineElement ToElement(const nb::handle& from)
{
  const auto element = nb::cast<nb::tuple>(from);
  OutlineElement result;
  result.Name = nb::cast<std::string>(element[0]);
  result.Attributes = nb::cast<std::map<std::string, std::string>>(element[1]);
  result.Place = nb::cast<std::int64_t>(element[2]);
  for (const nb::handle child : nb::cast<nb::list>(element[3]))
  {
    result.Children.push_back(ToElement(child));
  }
  return result;
}

/// Calls a callable; its ValueError becomes an InputError, to which the path is added.
nb::tuple CallReader(const nb::callable& read, const std::string& path)
{
  try
  {
    return nb::cast<nb::tuple>(read(path));
  }
  catch (const nb::python_error& error)
  {
    if (!error.matches(PyExc_ValueError))
    {
      throw;
    }
    throw InputError(nb::cast<std::string>(nb::str(error.value())));
  }
}

/// Reads a file by a callable that returns (root, place of the appended data or None, encoding).
XmlOutline ReadOutline(const nb::callable& read, const std::string& path)
{
  const nb::tuple found = CallReader(read, path);
  XmlOutline outline;
  outline.Root = ToElement(found[0]);
  FindAppendedData(path, nb::cast<std::optional<std::int64_t>>(found[1]),
    nb::cast<std::string>(found[2]), outline);
  return outline;
}

/// Unpacks a block by a callable that returns bytes.
bool Unpack(const nb::callable& unpack, const std::string& compressor,
  const std::vector<unsigned char>& packed, std::vector<unsigned char>& unpacked)
{
  const auto found = nb::cast<nb::bytes>(
    unpack(compressor, nb::bytes(packed.data(), packed.size()), unpacked.size()));
  if (found.size() != unpacked.size())
  {
    return false;
  }
  std::copy_n(static_cast<const unsigned char*>(found.data()), unpacked.size(), unpacked.begin());
  return true;
}

void Check(
  const std::string& path, const nb::callable& read, const nb::callable& unpack, bool isTrusted)
{
  const InputTrust trust(isTrusted);
  const VtkFileTools tools{ [&read](const std::string& name) { return ReadOutline(read, name); },
    [&unpack](const std::string& compressor, const std::vector<unsigned char>& packed,
      std::vector<unsigned char>& unpacked)
    { return Unpack(unpack, compressor, packed, unpacked); } };
  CheckVtkFile(path, tools);
}

} // namespace

void BindChecks(nb::module_& module)
{
  module.def("check_vtk_file", Check, "path"_a, "read_outline"_a, "unpack"_a, "trust_input"_a);
}

} // namespace vfm
