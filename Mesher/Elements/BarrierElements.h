/**
 * BarrierElements: elements of void that keep bodies apart while points move (NarrowVoid.h). They
 * have no fragment, and KeepOwned removes them.
 */
#pragma once

#include "Elements/Mesh.h"

namespace vfm
{

struct BarrierElements
{
  bool Exist = false; ///< void has no other elements then

  bool Contain(const Mesh& mesh, Index element) const
  {
    return this->Exist && mesh.Material[element] == 0;
  }
};

} // namespace vfm
