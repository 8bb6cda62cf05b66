/**
 * MesherCall: the arguments of a call from Python as the input of a run.
 */
#pragma once

#include "Mesher.h"
#include "NumpyArrays.h"

#include <nanobind/nanobind.h>

namespace vfm
{

class PythonRuntime;

/// As _core.pyi tells them.
struct MesherCall
{
  std::vector<InputBlock> Blocks; ///< of a file; none: one block of the arrays and coordinates
  std::vector<std::pair<std::string, NumpyArray>> Arrays;
  std::array<std::vector<double>, 3> Coordinates;
  std::array<double, 9> Axes;
  std::array<double, 3> Origin;
  bool ArePoints;
  std::vector<std::string> Fractions;
  std::string Labels;
  LabelNames Names;
  StateChoice State;
};

/// Of a dict, or None.
StateChoice ReadStateChoice(nanobind::handle state, StateTransfer transfer);

/// Throws InputError as the functions of InputBlocks and InputLevels do. call must outlive what is returned.
MesherInput MakeInput(const MesherCall& call, Runtime& runtime);

} // namespace vfm
