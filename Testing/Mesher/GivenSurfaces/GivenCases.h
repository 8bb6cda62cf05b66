/**
 * Interfaces of closed surfaces for tests of given surfaces.
 */
#pragma once

#include "GivenSurfaces/BodySurfaces.h"
#include "Interface/Interface.h"
#include "Labels/ResolveLabels.h"
#include "SurfaceCases.h"

namespace vfm
{
namespace testing
{

/// Grid of unit cells from 0, with the fractions, labels and interface of bodies.
struct GivenCase
{
  GivenCase(Index cells, const std::vector<ClosedSurface>& surfaces, double edgeAngle = 40.0) :
    Bodies(MakeBodies(surfaces)),
    Grid(Coordinates(cells)),
    Fractions(FractionsOfBodies(Grid, Bodies)),
    Labels(AssignMaterials(Grid, Fractions, 0.5)),
    Surface(Grid, Fractions, Labels, FindMixedNodes(Grid, Labels), 0.5, Run),
    Surfaces(Bodies, Names(surfaces.size()), Grid, edgeAngle)
  {
  }

  static std::array<std::vector<double>, 3> Coordinates(Index cells)
  {
    std::vector<double> x;
    for (Index i = 0; i <= cells; ++i)
    {
      x.push_back(static_cast<double>(i));
    }
    return { x, x, x };
  }
  static std::vector<std::string> Names(std::size_t bodies)
  {
    std::vector<std::string> names;
    for (std::size_t b = 1; b <= bodies; ++b)
    {
      names.push_back(std::to_string(b));
    }
    return names;
  }

  Runtime Run;
  InputSurfaces Bodies;
  CartesianGrid Grid;
  FractionField Fractions;
  LabelArray Labels;
  Interface Surface;
  BodySurfaces Surfaces;
};

} // namespace testing
} // namespace vfm
