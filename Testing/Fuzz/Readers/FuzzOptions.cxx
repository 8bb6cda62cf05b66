/**
 * Sets options from lines NAME=VALUE, for hexahedra and for tetrahedra.
 */
#include "Harness.h"

#include "Options/SetOptions.h"
#include "Ranks/Errors.h"

namespace vfm
{
namespace testing
{

void ReadBytes(const std::string& bytes)
{
  for (const ElementKind elements : { ElementKind::Hexes, ElementKind::Tets })
  {
    MesherOptions options;
    options.Elements = elements;
    for (std::string left = bytes; !left.empty();)
    {
      std::string value = TakeUntil(left, "\n");
      const std::string name = TakeUntil(value, "=");
      try
      {
        SetOption(options, name, value);
      }
      catch (const InputError&) // the next line may be valid
      {
      }
    }
    for (const Option* option : ListChangedOptions(options))
    {
      GetOption(options, *option);
    }
    CheckOptions(options);
  }
}

} // namespace testing
} // namespace vfm
