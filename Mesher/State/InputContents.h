/**
 * InputContents: reads the state of a material in one cell of the input, converted to values per
 * volume of the material, or per mass.
 */
#pragma once

#include "Fractions/FractionField.h"
#include "State/StatePlan.h"
#include "State/StateValues.h"
#include "State/TransferredArray.h"

namespace vfm
{

/// A cell of any level of the input.
struct InputCell
{
  const StateBlock* Source;
  Index3 Cell;
  double Volume;                  ///< length units cubed
  const FractionField* Fractions; ///< fractions as read
  Index At;                       ///< index of the cell in Fractions
};

/// Reads cells by a plan. Read() may be called by several threads.
class InputContents
{
public:
  /// @param frame  axes of the arrays of the plan that are rotated
  InputContents(std::vector<StateArray> states, StatePlan plan, const ImageFrame& frame);

  /// Returns the number of values of a cell: the components of all arrays of the plan, followed by
  /// |u|^2 / 2 if there is a velocity.
  int NumberOfColumns() const { return this->Columns; }
  int FirstColumn(std::size_t array) const { return this->First[array]; }
  const std::vector<StateArray>& GetStates() const { return this->States; }
  const StatePlan& GetPlan() const { return this->Plan; }
  /// Returns a conserved array of the plan as an array of the output, and takes its values.
  TransferredArray MakeArray(std::size_t array, Buffer<double>& values) const;

  /// Reads the values of a material in a cell. Void (0) has 0 in arrays per material, and in values
  /// that materials share unless the cell contains nothing else.
  void Read(const InputCell& cell, int material, double* values) const;

  /// Checks values of a cell.
  /// @param level level for messages; -1 if there is only one
  /// @param names names of the materials from 0
  /// @throws InputError if values are not finite, or a density is below 0
  void Check(const double* values, int material, const Index3& cell, int level,
    const std::vector<std::string>& names) const;

private:
  using ReadValue = double (*)(const char*);

  static std::size_t StateOf(const ConservedArray& array, int material, int component);
  double ReadComponent(
    const StateBlock& source, Index place, std::size_t state, int component) const;
  double FindFactor(const InputCell& cell, const ConservedArray& array, int material) const;

  const std::vector<StateArray> States;
  const StatePlan Plan;
  const ImageFrame Frame;
  std::vector<ReadValue> Readers; // reader of each state
  std::vector<int> First;         // first column of each array
  int Columns = 0;
};

} // namespace vfm
