/**
 * Reads a file of a surface with the suffix VFM_FUZZ_SUFFIX.
 */
#include "Harness.h"

#include "Surfaces/ReadSurface.h"

#include <stdexcept>

namespace vfm
{
namespace testing
{

void ReadBytes(const std::string& bytes)
{
  for (const SurfaceFile& body : ReadBodies(WriteInput(std::string("a") + VFM_FUZZ_SUFFIX, bytes)))
  {
    const Index points = static_cast<Index>(body.Points.size());
    const int names = static_cast<int>(body.PatchNames.size());
    if (body.Patches.size() != body.Triangles.size())
    {
      throw std::logic_error("triangles without a patch");
    }
    for (std::size_t t = 0; t < body.Triangles.size(); ++t)
    {
      for (Index p : body.Triangles[t])
      {
        if (p < 0 || p >= points || body.Patches[t] < 0 || body.Patches[t] >= names)
        {
          throw std::logic_error("a triangle of a point or patch that does not exist");
        }
      }
    }
  }
}

} // namespace testing
} // namespace vfm
