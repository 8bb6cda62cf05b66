/// Crossings of films whose exact fractions are known.
#include "Interface/FilmCrossings.h"
#include "Base/Vector3.h"
#include "Labels/ThinParts.h"
#include "MeshChecks.h"
#include "RandomDraw.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

namespace
{

/// Fills a layer with material 1, in grid coordinates.
FractionField FillLayer(const CartesianGrid& grid, const Layer& layer)
{
  FractionField fractions(grid, 1);
  ForCells(grid.Global(),
    [&](const Index3& p)
    {
      const Vector3 low = grid.NodePoint(p), high = grid.NodePoint(CornerOfCell(p, 7));
      const double f = FractionInLayer(layer, 0.5 * (low + high), high - low);
      if (f > 0.0)
      {
        fractions.SetParts(grid.Linear(p), { { 1, f } });
      }
    });
  return fractions;
}

/// Crossings of a film across the middle of 12^3 unit cells.
struct FilmCase
{
  FilmCase(const Vector3& normal, double thickness, double shift) :
    Grid(MakeUnitGrid(12)), Region{ Unit(normal), 0.0, 0.0 }
  {
    const double middle = Dot(this->Region.Normal, { { 6.0, 6.0, 6.0 } }) + shift;
    this->Region.Lower = middle - 0.5 * thickness;
    this->Region.Upper = middle + 0.5 * thickness;
    const FractionField fractions = FillLayer(this->Grid, this->Region);
    this->Labels = AssignMaterials(this->Grid, fractions, 0.5);
    const std::vector<ThinCell> thin = LabelThinParts(this->Grid, fractions, 0.25,
      Partition(this->Grid, this->Run.Group()), this->Run, this->Labels);
    this->Films.emplace(this->Grid, fractions, this->Labels, CellsOf(thin), this->Run);
  }

  /// Calls visit for the faces of the film in the inner cells.
  template <class Visit>
  void ForFaces(const Visit& visit) const
  {
    ForCells(Grow(BoxOfCell({ { 6, 6, 6 } }), 3, this->Grid.Global()),
      [&](const Index3& p)
      {
        const Index node = this->Grid.Linear(p);
        for (int axis = 0; axis < 3; ++axis)
        {
          const int lower = this->Labels[node - this->Grid.Stride(axis)];
          if (lower != this->Labels[node])
          {
            visit(InterfaceFace{ node, axis, lower, this->Labels[node] });
          }
        }
      });
  }

  CartesianGrid Grid;
  Layer Region;
  Runtime Run;
  LabelArray Labels;
  std::optional<FilmCrossings> Films;
};

} // namespace

TEST(FilmCrossings, AreOnTheSurfacesOfFlatFilms)
{
  RandomDraw random(3);
  for (int i = 0; i < 30; ++i)
  {
    const FilmCase film(
      random.Vector(0.2, 1.0), random.Between(0.4, 0.7), random.Between(-0.4, 0.4));
    int found = 0, faces = 0;
    film.ForFaces(
      [&](const InterfaceFace& face)
      {
        ++faces;
        const std::optional<Crossing> crossing = film.Films->Find(face);
        if (!crossing)
        {
          return;
        }
        ++found;
        // Normals point to the film, from void, which is the first label.
        const double along = Dot(crossing->Normal, film.Region.Normal);
        EXPECT_NEAR(std::fabs(along), 1.0, 1e-6);
        EXPECT_NEAR(Dot(crossing->Point, film.Region.Normal),
          along > 0.0 ? film.Region.Lower : film.Region.Upper, 1e-5);
      });
    EXPECT_GT(faces, 50);
    EXPECT_GT(found, 0.9 * faces);
  }
}

TEST(FilmCrossings, ThereAreNoneWithoutThinCells)
{
  const FilmCase plate({ { 1.0, 2.0, 3.0 } }, 3.0, 0.1);
  plate.ForFaces([&](const InterfaceFace& face) { EXPECT_FALSE(plate.Films->Find(face)); });
}
