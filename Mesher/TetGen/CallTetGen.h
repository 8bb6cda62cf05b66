/**
 * CallTetGen: calls TetGen so that its failed assertions do not end the process.
 */
#pragma once

#define TETLIBRARY
#include <tetgen.h>

namespace vfm
{

/// Calls TetGen. Not thread safe, like TetGen itself.
/// @throws int  TetGen's error code
/// @throws std::runtime_error  if an assertion of TetGen fails; the memory of its mesh is then lost
void CallTetGen(tetgenbehavior& switches, tetgenio& input, tetgenio& output);

} // namespace vfm
