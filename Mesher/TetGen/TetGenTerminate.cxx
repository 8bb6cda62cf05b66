/**
 * Replaces TetGen's exit on errors, which frees the mesh and throws; unwinding then frees the mesh
 * again and crashes. TetGen's function is a weak symbol, so this one replaces it if the dynamic
 * linker sees it, which requires default visibility. This file must not include tetgen.h, which
 * defines the function inline.
 */
#include "TetGen/TetGenTerminate.h"

class tetgenmesh;

__attribute__((visibility("default"))) void terminatetetgen(tetgenmesh*, int code)
{
  throw code;
}

namespace vfm
{

const int TetGenTerminateIsLinked = 1;

} // namespace vfm
