/// Shifts of the interfaces of a film by what its cells lack.
#include "Volumes/LocalVolumes.h"
#include "Base/Vector3.h"
#include "MeshChecks.h"
#include "Phases/HexMethod.h"
#include "Smoothing/Attach.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

namespace
{

constexpr Index Layer = 5; // of the film, across z

/// Returns a film of 0.45 cells in one layer of unit cells.
FractionField MakeLayer(const CartesianGrid& grid)
{
  FractionField fractions(grid, 1);
  ForCells(grid.Global(),
    [&](const Index3& p)
    {
      if (p[2] == Layer)
      {
        fractions.SetParts(grid.Linear(p), { { 1, 0.45 } });
      }
    });
  return fractions;
}

MeshOptions KeepThinParts()
{
  MeshOptions options;
  options.ThinParts = true;
  return options;
}

/// Hexahedra of the film in 12^3 cells, before they move.
struct FilmHexes
{
  FilmHexes()
  {
    this->Method.Attach(*this->Interfaces, this->TheDraft, this->Run);
    SetFacets(this->TheDraft.Facets, this->TheRuntime, this->Active);
  }

  CartesianGrid Grid = MakeUnitGrid(12);
  FractionField Fractions = MakeLayer(this->Grid);
  MeshOptions Options = KeepThinParts();
  MeshCells Cells{ this->Grid, this->Fractions, this->Options };
  HexMethod Method{ this->Cells };
  Runtime TheRuntime;
  MeshReport Report;
  MeshRun Run{ this->Grid, this->TheRuntime, this->Report };
  Draft TheDraft = this->Method.Make(this->Cells, this->Run);
  ActiveMesh& Active = this->Method.MakeActive(this->Cells, this->Run, this->TheDraft);
  std::unique_ptr<LevelInterfaces> Interfaces =
    this->Method.FindInterfaces(this->Cells, this->TheDraft, this->Run);
};

/// Expects a shift towards the film at all points that are at least 3 cells from the sides.
void ExpectShift(const FilmHexes& film, double shift)
{
  const LocalVolumes local(film.Cells, film.TheDraft.Thin, film.TheDraft.Elements, film.Active,
    film.TheDraft.Volumes, film.Run);
  std::vector<double> shifts(film.Active.Attachments.size(), 7.0);
  local.ReplaceShifts(local.Measure(film.Active), film.Active, shifts);
  int points = 0;
  for (std::size_t p = 0; p + 1 < film.Active.AttachmentOffset.size(); ++p)
  {
    const Vector3& x = film.Active.X[p];
    if (x[0] > 2.5 && x[0] < 9.5 && x[1] > 2.5 && x[1] < 9.5)
    {
      for (Index i = film.Active.AttachmentOffset[p]; i < film.Active.AttachmentOffset[p + 1]; ++i)
      {
        EXPECT_NEAR(shifts[i], shift, 1e-9) << x[0] << " " << x[1] << " " << x[2];
        ++points;
      }
    }
  }
  EXPECT_EQ(points, 2 * 7 * 7);
}

} // namespace

TEST(LocalVolumes, ShiftsAreLimited)
{
  // Each cell has 0.55 too much between two surfaces.
  ExpectShift(FilmHexes(), 0.2);
}

TEST(LocalVolumes, ShiftsMakeUpForWhatCellsLack)
{
  for (double thickness : { 0.8, 0.45, 0.3 })
  {
    FilmHexes film;
    for (Vector3& x : film.Active.X)
    {
      x[2] = x[2] > Layer + 0.5 ? Layer + thickness : x[2];
    }
    ExpectShift(film, 0.5 * (thickness - 0.45));
  }
}
