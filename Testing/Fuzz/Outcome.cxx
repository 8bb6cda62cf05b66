#include "Outcome.h"

#include "CheckCase.h"

#include <chrono>
#include <cstdio>

namespace vfm
{
namespace testing
{
namespace
{

template <std::size_t Size>
void CopyText(const std::string& from, char (&to)[Size])
{
  std::snprintf(to, Size, "%s", from.c_str());
}

std::string MethodOf(const FuzzCase& c)
{
  const std::string elements = c.Make == MakeTetMesh ? NameOf(c.Options.Method) : "hexes";
  return elements + (InterfacesCrossLevels(c.Options) ? " crossing" : "");
}

Outcome DescribeCase(unsigned seed, const FuzzCase& c)
{
  Outcome outcome;
  outcome.Seed = seed;
  outcome.HasCubes = c.HasCubes;
  outcome.IsUsual = !c.Options.StairStep &&
    c.Options.Smoothing == SmoothingMethod::QuadricSurface && c.Options.TargetScaledJacobian == 0.0;
  outcome.IsRefined = c.Options.Levels.Refinements > 0;
  outcome.Ranks = static_cast<int>(std::max<std::size_t>(c.Boxes.size(), 1));
  CopyText(MethodOf(c), outcome.Method);
  CopyText(c.Field, outcome.Field);
  CopyText(c.Words, outcome.Words);
  return outcome;
}

} // namespace

Outcome RunSeed(unsigned seed, bool isPeriodic, const std::function<void(const Outcome&)>& started)
{
  Outcome outcome;
  outcome.Seed = seed;
  const auto begin = std::chrono::steady_clock::now();
  try
  {
    const FuzzCase c = MakeFuzzCase(seed, isPeriodic);
    outcome = DescribeCase(seed, c);
    started(outcome);
    const FuzzResult result = CheckCase(c);
    outcome.Elements = result.Elements;
    outcome.Coefficient = result.Coefficient;
    outcome.ScaledJacobian = result.ScaledJacobian;
    outcome.Overlap = result.Overlap;
    CopyText(result.Problem, outcome.Problem);
  }
  catch (const std::exception& error)
  {
    CopyText(std::string("throws: ") + error.what(), outcome.Problem);
  }
  outcome.HasEnded = true;
  outcome.Seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return outcome;
}

void Summary::Smallest::Add(double value, unsigned seed)
{
  if (!(value >= this->Value))
  {
    this->Value = value;
    this->Seed = seed;
  }
}

std::string Summary::Smallest::Text() const
{
  char text[64];
  std::snprintf(text, sizeof text, "%.3g (%u)", this->Value, this->Seed);
  return this->Value == 1e300 ? "" : text;
}

void Summary::Add(const Outcome& outcome)
{
  Row& row =
    this->Rows[std::string(outcome.Method) + (outcome.HasCubes ? ", cubes" : ", stretched")];
  const bool hasFailed = outcome.Problem[0] != '\0';
  ++row.Cases;
  row.Refined += outcome.IsRefined;
  row.OnRanks += outcome.Ranks > 1;
  row.Failed += hasFailed;
  row.Elements += outcome.Elements;
  row.Overlaps += outcome.Overlap > 0.0;
  row.Coefficient.Add(outcome.Coefficient, outcome.Seed);
  if (outcome.IsUsual)
  {
    row.ScaledJacobian.Add(outcome.ScaledJacobian, outcome.Seed);
  }
  ++this->Fields[outcome.Field];
  this->Failed += hasFailed;
  this->Seconds += outcome.Seconds;
  if (outcome.Seconds > this->Longest)
  {
    this->Longest = outcome.Seconds;
    this->LongestSeed = outcome.Seed;
  }
  if (hasFailed)
  {
    std::printf("seed %u: %s | %s\n", outcome.Seed, outcome.Problem, outcome.Words);
    std::fflush(stdout);
  }
}

void Summary::Print() const
{
  std::printf(
    "\n| method, cells | cases | refined | on ranks | elements | smallest coefficient, cell "
    "volumes (seed) | smallest scaled Jacobian, usual options (seed) | overlaps | failures |\n"
    "|---|---|---|---|---|---|---|---|---|\n");
  Index cases = 0, elements = 0;
  for (const auto& entry : this->Rows)
  {
    const Row& row = entry.second;
    std::printf("| %s | %lld | %lld | %lld | %lld | %s | %s | %lld | %lld |\n", entry.first.c_str(),
      static_cast<long long>(row.Cases), static_cast<long long>(row.Refined),
      static_cast<long long>(row.OnRanks), static_cast<long long>(row.Elements),
      row.Coefficient.Text().c_str(), row.ScaledJacobian.Text().c_str(),
      static_cast<long long>(row.Overlaps), static_cast<long long>(row.Failed));
    cases += row.Cases;
    elements += row.Elements;
  }
  std::printf("\nfields:");
  for (const auto& field : this->Fields)
  {
    std::printf(" %s %lld", field.first.c_str(), static_cast<long long>(field.second));
  }
  std::printf("\n%lld cases, %lld elements, %.1f s, longest %.1f s (seed %u), %lld failures\n",
    static_cast<long long>(cases), static_cast<long long>(elements), this->Seconds, this->Longest,
    this->LongestSeed, static_cast<long long>(this->Failed));
}

} // namespace testing
} // namespace vfm
