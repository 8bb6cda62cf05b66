/**
 * Makes shapes from a text.
 */
#include "Harness.h"

#include "Shapes/ShapesText.h"

namespace vfm
{
namespace testing
{

void ReadBytes(const std::string& bytes)
{
  ParseShapes(bytes, { { -1.0, -1.0, -1.0 } }, { { 1.0, 1.0, 1.0 } });
}

} // namespace testing
} // namespace vfm
