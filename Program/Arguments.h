/**
 * Arguments: the command line of sculptor.
 */
#pragma once

#include "Options/MesherOptions.h"

#include <array>
#include <optional>

namespace vfm
{

enum class Command
{
  Mesh,
  List,
  Test,
  Help,
  Version
};

struct Arguments
{
  Command Task = Command::Mesh;
  std::string Input, Output;
  std::optional<std::array<int, 3>> Dimensions;         ///< of voxels: cells along x, y and z
  std::optional<std::array<double, 3>> Origin, Spacing; ///< of voxels
  std::optional<int> AxisOrder;                         ///< of voxels, vfm::AxisOrder
  std::string Fragments;                                ///< file of their table; empty: none
  std::string Geometry;               ///< file of surfaces, curves and vertices; empty: none
  std::vector<std::string> Fractions; ///< cell arrays; empty: found in the input
  std::string Labels;                 ///< cell array; empty: fractions
  std::vector<std::string> Materials; ///< numbers or names of those to mesh; empty: all
  std::vector<std::string> State;     ///< cell arrays that the elements get
  bool RefinesCells = false;          ///< of the test: chosen cells alone
  MesherOptions Mesher;
  std::optional<int> Step; ///< of the input's times, from 0
  std::optional<double> Time;
  bool SingleFile = false; ///< also from several ranks
  bool Quiet = false;
};

/// The cell arrays that are needed besides the materials, which are taken for none. there: what the input has, of which components may make
/// up the velocity.
std::vector<std::string> ListOtherArrays(
  const Arguments& arguments, const std::vector<std::string>& there);

/// words: without the program's name. Throws InputError (WrongArguments).
Arguments ParseArguments(const std::vector<std::string>& words);

} // namespace vfm
