/**
 * ArgumentOptions: lists the options of the command line and prints the help.
 */
#pragma once

#include <string>
#include <vector>

namespace vfm
{

/// Option of the command line.
struct ArgumentOption
{
  std::string Name;  ///< name with its dashes
  std::string Value; ///< name of the value in the help; empty: takes none; [VALUE]: may be omitted
  std::string Help;  ///< help text; empty for options that GetHelp lists with the mesher's
  std::string MesherOption = {}; ///< option of the mesher that it sets to the value, or to on
  bool MayRepeat = false;        ///< may be given several times
};

/// Returns the options of sculptor itself, then the mesher's options that have a name on the
/// command line (Option::Argument).
const std::vector<ArgumentOption>& GetArgumentOptions();

/// Returns the text of --help.
std::string GetHelp();

} // namespace vfm
