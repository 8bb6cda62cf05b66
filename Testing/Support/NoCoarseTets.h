/**
 * Input of a tetrahedral mesh of a grid without refinements.
 */
#pragma once

#include "Elements/Tet/CoarseTets.h"

namespace vfm
{
namespace testing
{

struct NoCoarseTets
{
  NoCoarseTets(const CartesianGrid& grid, Runtime& runtime) :
    Levels(std::make_shared<const RefinedGrid>(grid, runtime.Group())),
    Tets(*this->Levels, this->Labels, false, NarrowVoid(), runtime.Group())
  {
  }

  std::shared_ptr<const RefinedGrid> Levels;
  LabelArray Labels;
  CoarseTets Tets;
};

} // namespace testing
} // namespace vfm
