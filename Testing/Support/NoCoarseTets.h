/**
 * Input of a tetrahedral mesh of a grid without refinements.
 */
#pragma once

#include "Tet/CoarseTets.h"
#include "Tet/TetImprove.h"

namespace vfm
{
namespace testing
{

struct NoCoarseTets
{
  NoCoarseTets(const CartesianGrid& grid, Runtime& runtime) :
    Levels(std::make_shared<const RefinedGrid>(grid, runtime.Group())),
    Hexes(*this->Levels, this->Labels, CoarseHexes::Options(), runtime),
    Energy(FloorsOf(MeshOptions())),
    Tets(this->Hexes, this->Energy, runtime)
  {
  }

  std::shared_ptr<const RefinedGrid> Levels;
  LabelArray Labels;
  CoarseHexes Hexes;
  TetEnergy Energy;
  CoarseTets Tets;
};

} // namespace testing
} // namespace vfm
