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
    bool isUnknown = false; // a name that is no option; the message lists all of them, slowly
    for (std::string left = bytes; !left.empty();)
    {
      std::string value = TakeUntil(left, "\n");
      const std::string name = TakeUntil(value, "=");
      if (isUnknown && !FindOption(name))
      {
        continue;
      }
      isUnknown = isUnknown || !FindOption(name);
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
