#include "State/InputContents.h"

#include "Ranks/Errors.h"

#include <cmath>
#include <cstring>
#include <sstream>

namespace vfm
{
namespace
{

template <class Stored>
double ReadAs(const char* bytes)
{
  Stored value;
  std::memcpy(&value, bytes, sizeof(value));
  return static_cast<double>(value);
}

/// Returns the reader of a type (CarrierType).
double (*FindReader(int type))(const char*)
{
  return VisitType(
    type, [](auto tag) -> double (*)(const char*) { return ReadAs<typename decltype(tag)::Type>; });
}

/// Fraction of a material in a cell, and of all materials except void.
struct Filling
{
  double Own = 0.0, All = 0.0;
};

Filling FindFilling(const FractionField& fractions, Index cell, int material)
{
  Filling filling;
  fractions.ForParts(cell,
    [&](int other, double fraction)
    {
      filling.Own += other == material ? fraction : 0.0;
      filling.All += other > 0 ? fraction : 0.0;
    });
  return filling;
}

} // namespace

InputContents::InputContents(
  std::vector<StateArray> states, StatePlan plan, const ImageFrame& frame) :
  States(std::move(states)), Plan(std::move(plan)), Frame(frame)
{
  for (const StateArray& state : this->States)
  {
    this->Readers.push_back(FindReader(CarrierType(state.Type)));
  }
  for (const ConservedArray& array : this->Plan.Conserved)
  {
    this->First.push_back(this->Columns);
    this->Columns += array.Components;
  }
  this->Columns += this->Plan.Velocity >= 0;
}

TransferredArray InputContents::MakeArray(std::size_t array, Buffer<double>& values) const
{
  const ConservedArray& made = this->Plan.Conserved[array];
  const std::vector<std::string> names = made.IsVector
    ? std::vector<std::string>{ "X", "Y", "Z" }
    : this->States[made.States[0]].ComponentNames;
  return { made.Name, ValueType::Double, made.Components, names,
    made.Meaning == StateMeaning::Extensive, TakeBytes(values) };
}

void InputContents::Read(const InputCell& cell, int material, double* values) const
{
  const Index place = cell.Source->Place(cell.Cell);
  double* to = values;
  for (const ConservedArray& array : this->Plan.Conserved)
  {
    if (array.IsOfMaterials() && material == 0)
    {
      to = std::fill_n(to, array.Components, 0.0);
      continue;
    }
    const double factor = array.IsShared() ? this->FindFactor(cell, array, material) : 1.0;
    for (int c = 0; c < array.Components; ++c)
    {
      *to++ = factor *
        this->ReadComponent(
          *cell.Source, place, this->StateOf(array, material, c), array.IsVector ? 0 : c);
    }
    if (array.IsRotated)
    {
      RotateTuple(this->Frame, array.Components, to - array.Components);
    }
  }
  if (this->Plan.Velocity >= 0)
  {
    const double* u = values + this->First[this->Plan.Velocity];
    *to = 0.5 * (u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
  }
}

std::size_t InputContents::StateOf(const ConservedArray& array, int material, int component)
{
  return array.States[array.IsVector ? component
      : array.IsOfMaterials()        ? std::max(material, 1) - 1
                                     : 0];
}

double InputContents::ReadComponent(
  const StateBlock& source, Index place, std::size_t state, int component) const
{
  const StateArray& array = this->States[state];
  const std::size_t size = TupleSize(array) / array.Components;
  return this->Readers[state](source.Values[state] + (place * array.Components + component) * size);
}

/// Returns the factor from the value of a whole cell to a value per volume of a material in it.
double InputContents::FindFactor(
  const InputCell& cell, const ConservedArray& array, int material) const
{
  const Filling filling = FindFilling(*cell.Fractions, cell.At, material);
  const double shared = array.IsOfMaterials() ? filling.Own
    : material > 0                            ? filling.All
                                              : 1.0 - filling.All;
  if (shared <= 0.0 || (material == 0 && filling.All > 0.0))
  {
    return 0.0;
  }
  return 1.0 / (array.Meaning == StateMeaning::Extensive ? shared * cell.Volume : shared);
}

void InputContents::Check(const double* values, int material, const Index3& cell, int level,
  const std::vector<std::string>& names) const
{
  const double* value = values;
  for (std::size_t a = 0; a < this->Plan.Conserved.size(); ++a)
  {
    const ConservedArray& array = this->Plan.Conserved[a];
    const bool isDensity = static_cast<int>(a) == this->Plan.Density;
    for (int c = 0; c < array.Components; ++c, ++value)
    {
      if (std::isfinite(*value) && !(isDensity && *value < 0.0))
      {
        continue;
      }
      std::ostringstream text;
      text << "The " << (isDensity ? "density" : "state") << " array '"
           << this->States[StateOf(array, material, c)].Name << "' is " << *value << " in "
           << TextOf(cell);
      if (level >= 0)
      {
        text << " of level " << level;
      }
      text << ", which holds '" << names[material] << "': it must be a number"
           << (isDensity ? ", 0 or more," : "") << " wherever there is material.";
      throw InputError(text.str());
    }
  }
}

} // namespace vfm
