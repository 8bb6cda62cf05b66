/**
 * Compositions: ways to combine the surfaces of a sharp-feature model, with as few products of
 * indicator functions as possible.
 */
#pragma once

#include <array>

namespace vfm
{

/// Sign times the indicator of the region inside all surfaces of Mask; for flipped surfaces, the
/// outside counts as the inside. Mask 0: the constant 1. Sign 0: no term.
struct CompositionTerm
{
  int Sign, Mask, Flipped;
};

/// Sum of two terms, of which at most one has several surfaces: A or B = 1 - (not A and not B).
using Composition = std::array<CompositionTerm, 2>;

constexpr std::array<Composition, 1> CompositionsOfOne{ {
  { { { 1, 1, 0 }, { 0, 0, 0 } } },
} };
constexpr std::array<Composition, 2> CompositionsOfTwo{ {
  { { { 1, 3, 0 }, { 0, 0, 0 } } },  // X and Y
  { { { 1, 0, 0 }, { -1, 3, 3 } } }, // X or Y
} };
constexpr std::array<Composition, 8> CompositionsOfThree{ {
  { { { 1, 7, 0 }, { 0, 0, 0 } } },  // X and Y and Z
  { { { 1, 0, 0 }, { -1, 7, 7 } } }, // X or Y or Z
  { { { 1, 1, 0 }, { -1, 7, 6 } } }, // (X or Y) and Z
  { { { 1, 2, 0 }, { -1, 7, 5 } } },
  { { { 1, 4, 0 }, { -1, 7, 3 } } },
  { { { 1, 1, 0 }, { 1, 7, 1 } } }, // (X and Y) or Z
  { { { 1, 2, 0 }, { 1, 7, 2 } } },
  { { { 1, 4, 0 }, { 1, 7, 4 } } },
} };

/// Returns a composition by the number of surfaces, 1 to 3, and its index (FeatureModel.h).
inline const Composition& CompositionOf(int surfaces, int composition)
{
  if (surfaces == 1)
  {
    return CompositionsOfOne[0];
  }
  return surfaces == 2 ? CompositionsOfTwo[composition] : CompositionsOfThree[composition];
}

} // namespace vfm
