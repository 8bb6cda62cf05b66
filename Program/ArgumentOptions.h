/**
 * ArgumentOptions: the options of the command line: names, help, what each does with the words that follow.
 */
#pragma once

#include "ArgumentWords.h"
#include "Arguments.h"

#include <functional>

namespace vfm
{

/// Takes the values of an option, whose name is the last argument. Throws ProgramError (WrongArguments).
using ArgumentTaker = std::function<void(Arguments&, ArgumentWords&, const std::string&)>;

struct ArgumentOption
{
  std::string Name, Value, Help;
  ArgumentTaker Take;
};

/// Of the program itself, in the order of the help.
const std::vector<ArgumentOption>& GetOwnArguments();

/// Of the mesher (Option::Argument), which DescribeOptions tells.
const std::vector<ArgumentOption>& GetMesherArguments();

} // namespace vfm
