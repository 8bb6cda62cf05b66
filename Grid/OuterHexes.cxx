#include "OuterHexes.h"

#include "HexTopology.h"
#include "TransitionSmoothing.h"

#include <limits>

namespace vfm
{
namespace
{

constexpr int UnknownLabel = -1;

} // namespace

OuterHexes::OuterHexes(const RefinedGrid& grid, const LabelArray& labels, bool meshVoid,
  Runtime& runtime, bool asCubes) :
  Grid(grid),
  Labels(labels),
  MeshVoid(meshVoid),
  TheRefined(MakeRefinedMesh(grid.Octets(), grid.Base().Extended(1), false)),
  NodeNumber(grid.Base().NumberOfEntries(), Unused)
{
  SmoothTransitions(grid.Lattice(), this->TheRefined, runtime, true, asCubes);
  for (Index key : this->TheRefined.HexKeys)
  {
    this->Wanted.push_back(this->IsWanted(grid.Lattice().HexOfKey(key)));
  }
  this->MarkPoints();
  this->NumberPoints();
}

int OuterHexes::LabelOf(const RefinedLattice::Place& cell) const
{
  const CartesianGrid& finest = this->Grid.Finest();
  const Index3 nearest = this->Grid.NearestCell(cell.Level, cell.At);
  return finest.Local().Contains(nearest) ? this->Labels[finest.Linear(nearest)] : UnknownLabel;
}

/// Points on or in owned cells need all hexes in the cells around the one of the coarser level that they stem from. Where
/// the label of such a cell is too far away to be known, its hexes are wanted if its points are.
bool OuterHexes::IsWanted(const RefinedLattice::Place& cell) const
{
  const bool isNear = cell.Level == 0 ||
    this->Grid.IsNear(cell.Level - 1, { { cell.At[0] >> 1, cell.At[1] >> 1, cell.At[2] >> 1 } });
  return isNear && (this->MeshVoid || this->LabelOf(cell) != 0);
}

/// Calls onCell(base cell) and onHex(hex of Refined) for all wanted hexes, by key.
template <class OnCell, class OnHex>
void OuterHexes::ForHexes(const OnCell& onCell, const OnHex& onHex) const
{
  const RefinedLattice& lattice = this->Grid.Lattice();
  const CartesianGrid& base = this->Grid.Base();
  Index hex = 0;
  const auto visitUpTo = [&](Index key)
  {
    for (; hex < this->TheRefined.NumberOfHexes() && this->TheRefined.HexKeys[hex] < key; ++hex)
    {
      if (this->Wanted[hex])
      {
        onHex(hex);
      }
    }
  };
  ForUntouchedCells(base, base.Extended(1), this->TheRefined,
    [&](const Index3& cell)
    {
      visitUpTo(lattice.HexKey(0, cell, 0));
      if (this->IsWanted({ 0, cell, 0 }))
      {
        onCell(cell);
      }
    });
  visitUpTo(std::numeric_limits<Index>::max());
}

/// Of a point of Refined.
int& OuterHexes::NumberOf(Index point, const RefinedLattice::Place& place)
{
  return place.Level == 0 && place.Slot == 0 ? this->NodeNumber[this->Grid.Base().Linear(place.At)]
                                             : this->PointNumber[point];
}

/// Whether a node of the lattice is a point of the finest cells.
int OuterHexes::Sort(int level, const Index3& node) const
{
  const Index3 finest = this->Grid.FinestNode(level, node);
  return this->Grid.Finest().HexBox().Touches(finest) && this->Grid.TouchesFine(finest) ? Fine
                                                                                        : Used;
}

void OuterHexes::MarkPoints()
{
  const RefinedLattice& lattice = this->Grid.Lattice();
  this->PointNumber.assign(this->TheRefined.PointKeys.size(), Unused);
  const auto markCell = [&](const Index3& cell)
  {
    ++this->HexCount;
    for (int c = 0; c < 8; ++c)
    {
      const Index3 node = CornerOfCell(cell, c);
      int& number = this->NodeNumber[this->Grid.Base().Linear(node)];
      number = number == Unused ? this->Sort(0, node) : number;
    }
  };
  const auto markHex = [&](Index hex)
  {
    ++this->HexCount;
    for (Index at = 8 * hex; at < 8 * hex + 8; ++at)
    {
      const Index point = this->TheRefined.Hexes[at];
      const RefinedLattice::Place place = lattice.NodeOfKey(this->TheRefined.PointKeys[point]);
      int& number = this->NumberOf(point, place);
      number = place.Slot > 0 ? Used
        : number == Unused    ? this->Sort(place.Level, place.At)
                              : number;
    }
  };
  this->ForHexes(markCell, markHex);
}

/// Calls visit(number, key, position) for all points that are used, by key.
template <class Visitor>
void OuterHexes::ForPoints(const Visitor& visit)
{
  const CartesianGrid& base = this->Grid.Base();
  const std::vector<Index>& keys = this->TheRefined.PointKeys;
  Index point = 0;
  const auto visitPoint = [&](int& number)
  {
    const double* x = this->TheRefined.Points.data() + 3 * point;
    if (number != Unused)
    {
      visit(number, keys[point], Vector3{ { x[0], x[1], x[2] } });
    }
  };
  const auto visitUpTo = [&](Index key)
  {
    for (; point < this->TheRefined.NumberOfPoints() && keys[point] < key; ++point)
    {
      visitPoint(this->PointNumber[point]);
    }
  };
  const auto visitNode = [&](const Index3& p)
  {
    const Index key = this->Grid.Lattice().NodeKey(0, p, 0);
    int& number = this->NodeNumber[base.Linear(p)];
    visitUpTo(key);
    if (point < this->TheRefined.NumberOfPoints() && keys[point] == key)
    {
      visitPoint(number);
      ++point;
    }
    else if (number != Unused)
    {
      visit(number, key, base.NodePoint(p));
    }
  };
  IndexBox nodes = base.Extended(1);
  for (Index& upper : nodes.Upper)
  {
    upper += nodes.NumberOfCells() > 0;
  }
  ForCells(nodes, visitNode);
  visitUpTo(std::numeric_limits<Index>::max());
}

void OuterHexes::NumberPoints()
{
  this->ForPoints(
    [this](int& number, Index, const Vector3&)
    {
      if (number != Fine)
      {
        number = static_cast<int>(this->PointCount++);
      }
    });
}

/// Leaves only what Refined tells of.
void OuterHexes::DropParts()
{
  RefinedMesh kept;
  kept.PointKeys.swap(this->TheRefined.PointKeys);
  kept.Places.swap(this->TheRefined.Places);
  kept.TouchedCells.swap(this->TheRefined.TouchedCells);
  this->TheRefined = std::move(kept);
  this->NodeNumber = Buffer<int>();
  std::vector<int>().swap(this->PointNumber);
  std::vector<unsigned char>().swap(this->Wanted);
}

/// Writes the hexes one after another.
class OuterHexes::Writer
{
public:
  Writer(
    OuterHexes& outer, Mesh& mesh, Index firstPoint, Index firstHex, const FinePoint& finePoint) :
    Outer(outer), Result(mesh), FirstPoint(firstPoint), Hex(firstHex), FindFine(finePoint)
  {
  }

  void AddCell(const Index3& cell)
  {
    for (int c = 0; c < 8; ++c)
    {
      const Index3 node = CornerOfCell(cell, c);
      this->SetCorner(
        VtkCorner[c], this->Outer.NodeNumber[this->Outer.Grid.Base().Linear(node)], 0, node);
    }
    this->Finish(this->Outer.Grid.Lattice().HexKey(0, cell, 0), { 0, cell, 0 });
  }

  void AddHex(Index hex)
  {
    const RefinedMesh& refined = this->Outer.TheRefined;
    const RefinedLattice& lattice = this->Outer.Grid.Lattice();
    for (int c = 0; c < 8; ++c)
    {
      const Index point = refined.Hexes[8 * hex + c];
      const RefinedLattice::Place place = lattice.NodeOfKey(refined.PointKeys[point]);
      this->SetCorner(c, this->Outer.NumberOf(point, place), place.Level, place.At);
    }
    this->Finish(refined.HexKeys[hex], lattice.HexOfKey(refined.HexKeys[hex]));
  }

private:
  void SetCorner(int corner, int number, int level, const Index3& node)
  {
    this->Result.Elements[8 * this->Hex + corner] = number == Fine
      ? this->FindFine(this->Outer.Grid.FinestNode(level, node))
      : this->FirstPoint + number;
  }

  void Finish(Index key, const RefinedLattice::Place& cell)
  {
    this->Result.ElementIds[this->Hex] = this->Outer.Grid.ElementId(key, this->Result.ElementSlots);
    this->Result.Material[this->Hex] = this->Outer.LabelOf(cell);
    ++this->Hex;
  }

  OuterHexes& Outer;
  Mesh& Result;
  Index FirstPoint, Hex;
  const FinePoint& FindFine;
};

void OuterHexes::Fill(Mesh& mesh, Index firstPoint, Index firstHex, const FinePoint& finePoint)
{
  this->ForPoints(
    [&](int number, Index key, const Vector3& x)
    {
      if (number != Fine)
      {
        std::copy(x.begin(), x.end(), mesh.Points.data() + 3 * (firstPoint + number));
        mesh.PointIds[firstPoint + number] = this->Grid.PointId(key, mesh.PointSlots);
      }
    });
  Writer writer(*this, mesh, firstPoint, firstHex, finePoint);
  this->ForHexes(
    [&](const Index3& cell) { writer.AddCell(cell); }, [&](Index hex) { writer.AddHex(hex); });
  this->DropParts();
}

} // namespace vfm
