#include "State/Transfer/WholeElements.h"

#include "Base/HexNumbering.h"

namespace vfm
{

WholeElements::WholeElements(
  const Mesh& mesh, const CartesianGrid& grid, const FractionField& fractions, Runtime& runtime) :
  TheMesh(mesh),
  Grid(grid),
  Fractions(fractions),
  Lowest(mesh.HasHexes() ? mesh.Material.size() : 0, -1),
  Covered(grid, 0)
{
  ForEach(runtime, this->Lowest.size(),
    [this](Index e)
    {
      IndexBox box;
      if (this->FindBox(e, box) && this->IsPure(box, this->TheMesh.Material[e]))
      {
        this->Lowest[e] = this->Grid.Linear(box.Lower);
      }
    });
  for (std::size_t e = 0; e < this->Lowest.size(); ++e)
  {
    if (this->IsWhole(static_cast<Index>(e)))
    {
      ForCells(this->CellsOf(static_cast<Index>(e)),
        [this](const Index3& cell) { this->Covered.Set(this->Grid.Linear(cell), 1); });
    }
  }
}

IndexBox WholeElements::CellsOf(Index element) const
{
  IndexBox box{ this->Grid.Position(this->Lowest[element]), {} };
  const Index opposite = this->TheMesh.Elements[8 * element + 6];
  for (int a = 0; a < 3; ++a)
  {
    const double end = this->TheMesh.Points[3 * opposite + a];
    box.Upper[a] = box.Lower[a] + 1;
    while (this->Grid.Coordinates(a)[box.Upper[a]] < end)
    {
      ++box.Upper[a];
    }
  }
  return box;
}

/// Returns whether the corners of an element are the corners of a box of owned cells, and sets box.
bool WholeElements::FindBox(Index element, IndexBox& box) const
{
  const Index* corners = this->TheMesh.Elements.data() + 8 * element;
  const double* low = this->TheMesh.Points.data() + 3 * corners[0];
  const double* high = this->TheMesh.Points.data() + 3 * corners[6];
  for (int c = 1; c < 7; ++c)
  {
    const double* x = this->TheMesh.Points.data() + 3 * corners[VtkCorner[c]];
    for (int a = 0; a < 3; ++a)
    {
      if (x[a] != (c >> a & 1 ? high[a] : low[a]))
      {
        return false;
      }
    }
  }
  for (int a = 0; a < 3; ++a)
  {
    const std::vector<double>& x = this->Grid.Coordinates(a);
    box.Lower[a] = std::lower_bound(x.begin(), x.end(), low[a]) - x.begin();
    box.Upper[a] = std::lower_bound(x.begin() + box.Lower[a], x.end(), high[a]) - x.begin();
    if (box.Upper[a] == static_cast<Index>(x.size()) || x[box.Lower[a]] != low[a] ||
      x[box.Upper[a]] != high[a])
    {
      return false;
    }
  }
  return Intersect(box, this->Grid.Owned()) == box;
}

bool WholeElements::IsPure(const IndexBox& box, int material) const
{
  bool isPure = true;
  ForCells(box,
    [&](const Index3& p)
    {
      const Index cell = this->Grid.Linear(p);
      isPure = isPure && !this->Fractions.IsMixed(cell) && this->Fractions.Label(cell) == material;
    });
  return isPure;
}

} // namespace vfm
