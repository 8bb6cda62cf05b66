/**
 * OptionRow: how rows of the table of options are written.
 */
#pragma once

#include "Base/ParseText.h"
#include "Options/OptionTable.h"

#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace vfm
{

/// A row of the table; chained calls set further properties of the option.
struct Row : Option
{
  Row(const char* name, Option value, const char* meaning) : Option(std::move(value))
  {
    this->Name = name;
    this->Meaning = meaning;
    this->Python = this->GetNumber ? SnakeCase(name) : "";
  }

  Row& Above(double least)
  {
    this->Range.IsMinimumOpen = true;
    return this->Set(this->Range.Least, least);
  }
  Row& Below(double most)
  {
    this->Range.IsMaximumOpen = true;
    return this->Set(this->Range.Most, most);
  }
  Row& Special(double number, const char* meaning)
  {
    this->Range.Special = number;
    this->Range.Meaning = meaning;
    return *this;
  }
  Row& ShownIf(std::string condition) { return this->Set(this->Shown, std::move(condition)); }
  Row& EnabledIf(std::string condition) { return this->Set(this->Enabled, std::move(condition)); }
  Row& Advanced() { return this->Set(this->IsAdvanced, true); }
  Row& Listed() { return this->Set(this->IsListed, true); }
  Row& WithVectors() { return this->Set(this->TakesVectors, true); }
  Row& NotOfTets() { return this->Set(this->IsHiddenOfTets, true); }
  Row& OfTets(const char* text) { return this->Set(this->MeaningOfTets, text); }
  Row& Sculptor(const char* argument) { return this->Set(this->Argument, argument); }
  Row& InPython(const char* name) { return this->Set(this->Python, name); }

private:
  template <class Member, class Given>
  Row& Set(Member& member, Given value)
  {
    member = std::move(value);
    return *this;
  }
};

constexpr double NoEnd = std::numeric_limits<double>::infinity();

template <auto Member>
Option MakeNumber(OptionKind kind)
{
  Option option;
  option.Kind = kind;
  option.GetNumber = [](const MesherOptions& options)
  { return static_cast<double>(options.*Member); };
  option.SetNumber = [](MesherOptions& options, double number)
  {
    auto& place = options.*Member;
    place = static_cast<std::decay_t<decltype(place)>>(number);
  };
  return option;
}

template <auto Member>
Option Switch()
{
  return MakeNumber<Member>(OptionKind::Switch);
}

template <auto Member>
Option Number(double least, double most = NoEnd)
{
  const bool isWhole = std::is_same_v<std::decay_t<decltype(MesherOptions().*Member)>, int>;
  Option option = MakeNumber<Member>(isWhole ? OptionKind::Integer : OptionKind::Real);
  option.Range = { least, most };
  return option;
}

template <auto Member>
Option Number(const NumberRange& range = { -NoEnd, NoEnd })
{
  return Number<Member>(range.Least, range.Most);
}

/// words: names of the enumerators, in order.
template <auto Member>
Option Choice(std::vector<std::string> words)
{
  Option option = MakeNumber<Member>(OptionKind::Choice);
  option.Words = std::move(words);
  return option;
}

inline Option Text(OptionKind kind, std::string MesherOptions::*member)
{
  Option option;
  option.Kind = kind;
  option.Text = member;
  return option;
}

inline Option Texts(OptionKind kind, std::vector<std::string> MesherOptions::*member)
{
  Option option;
  option.Kind = kind;
  option.Texts = member;
  return option;
}

} // namespace vfm
