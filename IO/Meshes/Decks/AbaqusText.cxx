#include "Meshes/Decks/AbaqusText.h"

namespace vfm
{
namespace
{

bool IsLetter(char c)
{
  return c >= 'A' && c <= 'Z';
}

std::string CleanName(const std::string& name)
{
  std::string clean;
  for (char c : name)
  {
    c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    if (IsLetter(c) || (c >= '0' && c <= '9'))
    {
      clean += c;
    }
    else if (!clean.empty() && clean.back() != '_')
    {
      clean += '_';
    }
  }
  if (!clean.empty() && clean.back() == '_')
  {
    clean.pop_back();
  }
  if (clean.empty() || !IsLetter(clean.front()))
  {
    clean = "S_" + clean;
  }
  return clean;
}

} // namespace

std::string AbaqusNames::Add(const std::string& name)
{
  return this->Used.Add(CleanName(name));
}

} // namespace vfm
