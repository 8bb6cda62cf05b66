/**
 * TetGenTerminate: replaces TetGen's exit on errors. Code must refer to TetGenTerminateIsLinked,
 * so that a linker takes the replacement from a static library.
 */
#pragma once

namespace vfm
{

extern const int TetGenTerminateIsLinked;

} // namespace vfm
