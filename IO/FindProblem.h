/**
 * FindProblem: steps of readers that keep why they failed until the data are asked for.
 */
#pragma once

#include "Ranks/Errors.h"

#include <new>
#include <string>

namespace vfm
{

/// Does a step, and returns why it failed, or "".
template <class Step>
std::string FindProblem(const Step& step)
{
  try
  {
    step();
    return "";
  }
  catch (const InputError& error)
  {
    return error.what();
  }
  catch (const std::bad_alloc&)
  {
    return "not enough memory.";
  }
}

} // namespace vfm
