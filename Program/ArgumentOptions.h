/**
 * ArgumentOptions: the options of the command line, and the help.
 */
#pragma once

#include <string>
#include <vector>

namespace vfm
{

struct ArgumentOption
{
  std::string Name;
  std::string Value; ///< what follows, empty: nothing; [VALUE]: or nothing
  std::string Help;  ///< empty: GetHelp shows the option with that of the mesher
  std::string
    MesherOption = {};    ///< set to the value, or on; empty: the program reads the value itself
  bool MayRepeat = false; ///< may be given several times
};

/// The program's own options, then the mesher's that have a name here (Option::Argument).
const std::vector<ArgumentOption>& GetArgumentOptions();

std::string GetHelp();

} // namespace vfm
