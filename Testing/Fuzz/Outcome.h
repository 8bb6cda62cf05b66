/**
 * The outcome of one case, and the table of many.
 */
#pragma once

#include "FuzzCase.h"

#include <map>

namespace vfm
{
namespace testing
{

/// Outcome of one case; plain memory, because it is sent through a pipe.
struct Outcome
{
  unsigned Seed = 0;
  bool HasEnded = false;
  bool HasCubes = false;
  bool IsUsual = false; ///< smoothed with the defaults, so that the scaled Jacobian counts
  bool IsRefined = false;
  int Ranks = 1;
  Index Elements = 0;
  double Coefficient = 1e300, ScaledJacobian = 1e300, Overlap = 0.0; ///< see FuzzResult
  double Seconds = 0.0;
  char Method[24] = "", Field[24] = "", Words[480] = "", Problem[240] = "";
};

/// Makes and checks the case of a seed (MakeFuzzCase); started: called before meshing.
Outcome RunSeed(unsigned seed, bool isPeriodic, const std::function<void(const Outcome&)>& started);

class Summary
{
public:
  void Add(const Outcome& outcome);
  void Print() const;
  Index Failures() const { return this->Failed; }

private:
  struct Smallest
  {
    double Value = 1e300;
    unsigned Seed = 0;
    void Add(double value, unsigned seed);
    std::string Text() const;
  };
  struct Row
  {
    Index Cases = 0, Refined = 0, OnRanks = 0, Failed = 0, Elements = 0, Overlaps = 0;
    Smallest Coefficient, ScaledJacobian;
  };

  std::map<std::string, Row> Rows; // by method and widths
  std::map<std::string, Index> Fields;
  Index Failed = 0;
  double Seconds = 0.0, Longest = 0.0;
  unsigned LongestSeed = 0;
};

} // namespace testing
} // namespace vfm
