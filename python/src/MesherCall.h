/**
 * MesherCall: converts the arguments of a call from Python to the input of a run.
 */
#pragma once

#include "Mesher.h"
#include "NumpyArrays.h"

#include <nanobind/nanobind.h>

namespace vfm
{

class PythonRuntime;

/// Arguments of the function mesh, described in _core.pyi.
struct MesherCall
{
  std::vector<InputBlock> Blocks; ///< blocks of a file; empty: one block of Arrays, Coordinates
  std::vector<std::pair<std::string, NumpyArray>> Arrays;
  std::array<std::vector<double>, 3> Coordinates;
  std::array<double, 9> Axes;
  std::array<double, 3> Origin;
  bool ArePoints;
  std::vector<std::string> Fractions;
  std::string Labels;
  LabelNames Names;
  StateChoice State;
  bool AreGuessed;
  std::string LabelsOption;
  std::shared_ptr<const InputSurfaces> Surfaces; ///< may be null
};

/// Reads a dict, or None.
StateChoice ReadStateChoice(nanobind::handle state, TransferMode transfer);

/// Makes the input of a run.
/// @param call must outlive the result
/// @throws InputError if FindInputLevels or MakeImageFrame do
MesherInput MakeInput(const MesherCall& call, Runtime& runtime);

} // namespace vfm
