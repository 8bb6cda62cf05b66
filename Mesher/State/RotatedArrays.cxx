#include "State/RotatedArrays.h"

#include "Base/ParseText.h"
#include "Input/ImageFrame.h"
#include "Input/ValueType.h"
#include "Ranks/Errors.h"

namespace vfm
{
namespace
{

[[noreturn]] void Reject(const std::string& name, const std::string& reason)
{
  throw InputError("The rotated array '" + name + "' " + reason);
}

void CheckComponents(const std::string& name, int components)
{
  if (!CanRotate(components))
  {
    Reject(name,
      "has " + std::to_string(components) + " component" + (components == 1 ? "" : "s") +
        ": a vector has 3, a symmetric tensor 6 (xx, yy, zz, xy, yz, xz), a tensor 9.");
  }
}

bool IsNamed(
  const ConservedArray& array, const std::vector<StateArray>& states, const std::string& name)
{
  return TrimText(array.Name) == name ||
    std::any_of(array.States.begin(), array.States.end(),
      [&](std::size_t s) { return TrimText(states[s].Name) == name; });
}

} // namespace

void MarkRotated(
  const std::vector<std::string>& names, StatePlan& plan, std::vector<StateArray>& states)
{
  for (const std::string& name : names)
  {
    bool isFound = false;
    for (ConservedArray& array : plan.Conserved)
    {
      if (IsNamed(array, states, TrimText(name)))
      {
        CheckComponents(name, array.Components);
        array.IsRotated = isFound = true;
      }
    }
    for (std::size_t s : plan.Copied)
    {
      StateArray& state = states[s];
      if (TrimText(state.Name) == TrimText(name))
      {
        CheckComponents(name, state.Components);
        if (!IsRealType(state.Type))
        {
          Reject(name, "holds integers, which are copied: only real numbers can be rotated.");
        }
        state.IsRotated = isFound = true;
      }
    }
    if (!isFound)
    {
      Reject(name, "is not a selected state array.");
    }
  }
}

} // namespace vfm
