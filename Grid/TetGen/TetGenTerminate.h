/**
 * TetGen's exit on errors is replaced where this is referred to: then a linker takes its file out of a static library.
 */
#pragma once

namespace vfm
{

extern const int TetGenTerminateIsLinked;

} // namespace vfm
