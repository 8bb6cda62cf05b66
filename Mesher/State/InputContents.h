/**
 * InputContents: what one cell of the input holds of a material, in the terms of what is conserved: each value per volume of the
 * material, or per mass.
 */
#pragma once

#include "Fractions/FractionField.h"
#include "State/StatePlan.h"
#include "State/StateValues.h"

namespace vfm
{

/// A cell of some level of the input.
struct InputCell
{
  const StateBlock* Source;
  Index3 Cell;
  double Volume;                  ///< length units cubed
  const FractionField* Fractions; ///< as read
  Index At;                       ///< the cell in these
};

class InputContents
{
public:
  InputContents(std::vector<StateArray> states, StatePlan plan);

  /// Values lie one after another: those of the arrays of the plan, then |u|^2 / 2 where there is a velocity.
  int NumberOfColumns() const { return this->Columns; }
  int FirstColumn(std::size_t array) const { return this->First[array]; }
  const std::vector<StateArray>& GetStates() const { return this->States; }
  const StatePlan& GetPlan() const { return this->Plan; }

  /// material: 0 void, which has nothing of arrays a material, and a part of what materials share only where there are none.
  void Read(const InputCell& cell, int material, double* values) const;

  /// Throws InputError when values are no numbers or densities below 0. names: of the materials from 0; level: -1 where there is one.
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
  std::vector<ReadValue> Readers; // of each state
  std::vector<int> First;         // column of each array
  int Columns = 0;
};

} // namespace vfm
