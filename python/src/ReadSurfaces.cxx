#include "ReadSurfaces.h"

#include "NumpyFields.h"
#include "Ranks/Errors.h"
#include "Ranks/PrintableText.h"
#include "Surfaces/ReadSurface.h"

#include <nanobind/stl/string.h>

namespace vfm
{
namespace
{

namespace nb = nanobind;
using namespace nb::literals;

/// Unpacks bytes by a callable that returns bytes; its ValueError becomes an InputError.
std::string Inflate(
  const nb::callable& inflate, std::string_view packed, int windowBits, std::size_t most)
{
  try
  {
    const auto found =
      nb::cast<nb::bytes>(inflate(nb::bytes(packed.data(), packed.size()), windowBits, most));
    return { static_cast<const char*>(found.data()), found.size() };
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

nb::tuple ToTuple(const SurfaceFile& body)
{
  nb::list names;
  for (const std::string& name : body.PatchNames)
  {
    names.append(MakePrintable(name));
  }
  return nb::make_tuple(MakePrintable(body.Name), RowsToNumpy<double>(body.Points),
    RowsToNumpy<std::int64_t>(body.Triangles), NumbersToNumpy(body.Patches), names, body.Note);
}

nb::list ReadFile(const std::string& path, const nb::callable& inflate)
{
  const SurfaceTools tools{ [&inflate](std::string_view packed, int windowBits, std::size_t most)
    { return Inflate(inflate, packed, windowBits, most); } };
  nb::list bodies;
  PrefixErrors("Cannot read " + path + ": ",
    [&]
    {
      for (const SurfaceFile& body : ReadBodies(path, tools))
      {
        bodies.append(ToTuple(body));
      }
    });
  return bodies;
}

} // namespace

void BindSurfaceFiles(nb::module_& module)
{
  module.def("read_surface", ReadFile, "path"_a, "inflate"_a);
  module.def("is_surface_file", IsSurfaceFile, "path"_a);
}

} // namespace vfm
