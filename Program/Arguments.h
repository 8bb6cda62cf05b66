/**
 * Arguments: parses the command line of sculptor.
 */
#pragma once

#include "Meshes/FormatTable.h"
#include "Options/MesherOptions.h"
#include "Report/Sets/MaterialBins.h"

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

/// Values of the command line.
struct Arguments
{
  Command Task = Command::Mesh;
  std::string Input, Output; ///< files; Input has the names of all if there are several surfaces
  std::vector<std::string> SurfaceFiles; ///< surfaces to mesh; empty: Input has cells
  std::optional<int> Cells; ///< number along the longest side of a grid around surfaces
  std::optional<std::array<double, 3>> GridWidths; ///< of the cells of such a grid, instead
  std::optional<std::array<int, 3>> Dimensions;    ///< number of voxels along x, y and z
  /// Lower corner of the voxels, and widths of voxels or of the cells of an image.
  std::optional<std::array<double, 3>> Origin, Spacing;
  std::optional<int> Volume;          ///< number of an image, from 0, in a file of several
  std::optional<int> AxisOrder;       ///< order of the axes of voxels, vfm::AxisOrder
  std::string Fragments;              ///< file of the table of fragments; empty: none
  std::string Geometry;               ///< file of surfaces, curves and vertices; empty: none
  std::string Surfaces;               ///< file of the surfaces of materials; empty: none
  std::string SurfaceFolder;          ///< folder to make for Surfaces; empty: none
  std::string Report;                 ///< file of the quality report; empty: none
  std::vector<std::string> Fractions; ///< cell arrays; empty: found in the input
  std::string Labels;                 ///< cell array; empty: fractions
  std::vector<std::string> Materials; ///< numbers or names of materials to mesh; empty: all
  std::vector<std::string> State;     ///< cell arrays to transfer to the elements
  std::optional<BinRule> Bins;        ///< groups of elements; its array is in State, too
  bool RefinesCells = false;          ///< `sculptor test` refines only chosen cells
  MesherOptions Mesher;
  bool SetsFlat = false;      ///< whether an option says what Flat is; otherwise the input does
  std::optional<int> Step;    ///< index of a time of the input, from 0
  std::optional<double> Time; ///< time of the input, the nearest one is used
  OutputForm Form;            ///< form of the output
  bool TrustsInput = false;   ///< InputTrust
  bool Quiet = false;
};

/// Lists the cell arrays that are needed in addition to the arrays of materials.
/// @param there  arrays of the input, among which components of the velocity are searched
std::vector<std::string> ListOtherArrays(
  const Arguments& arguments, const std::vector<std::string>& there);

/// Parses and checks the command line.
/// @param words  words without the name of the program
/// @throws InputError  (WrongArguments) if the words are wrong
Arguments ParseArguments(const std::vector<std::string>& words);

} // namespace vfm
