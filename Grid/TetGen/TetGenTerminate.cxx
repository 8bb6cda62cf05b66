/**
 * TetGen's exit on errors, replaced. Its own version frees the mesh and throws; unwinding then frees the
 * mesh again and crashes. It is a weak symbol, so this one takes its place, if the dynamic linker sees it:
 * hence default visibility. This file must not include tetgen.h, where the other one is defined inline.
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
