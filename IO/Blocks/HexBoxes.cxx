#include "Blocks/HexBoxes.h"

#include "Input/NodeCoordinates.h"

#include <cmath>
#include <limits>
#include <map>
#include <sstream>
#include <tuple>

namespace vfm
{
namespace
{

constexpr int Corners = 8;
constexpr const char* Advice =
  " Hexahedra must be the cells of a Cartesian grid: rotate a rotated grid "
  "back (ParaView's filter Transform), resample other meshes onto a grid (filter "
  "Resample To Image).";

/// A cell and its position in the grid of its data set.
struct PlacedCell
{
  std::array<int, 3> Place;
  Index Id;

  bool operator<(const PlacedCell& other) const
  {
    return std::tie(this->Place[2], this->Place[1], this->Place[0]) <
      std::tie(other.Place[2], other.Place[1], other.Place[0]);
  }
};

/// The hexahedra of a data set and the nodes of their grid.
class Hexahedra
{
public:
  Hexahedra(HexCells& data, const std::vector<Index>& cells, const std::string& name) :
    Data(data), Name(name), Cells(cells)
  {
    this->FindWidths();
    this->FindNodes();
  }

  std::array<std::vector<double>, 3> TakeCoordinates() { return std::move(this->X); }

  /// Returns the cells in the order of the grid.
  std::vector<PlacedCell> Place();

private:
  using Box = std::array<std::array<double, 2>, 3>;

  void FindWidths();
  void FindNodes();
  Box FindBox(Index cell);
  bool IsPlaced(PlacedCell& cell);
  [[noreturn]] void Reject(Index cell, const std::string& what) const
  {
    RejectCell(this->Name, cell, what);
  }
  void CheckSides(Index cell);
  [[noreturn]] void RejectPlace(Index cell);

  HexCells& Data;
  const std::string& Name;
  const std::vector<Index>& Cells;
  std::array<double, 3> Width{}; // widths of the smallest cells
  std::array<std::vector<double>, 3> X;
  std::array<std::vector<int>, 3> Nodes; // index in X of each point
};

Hexahedra::Box Hexahedra::FindBox(Index cell)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Box box;
  box.fill({ { infinity, -infinity } });
  const std::span<const Index> points = this->Data.GetCorners(cell);
  const Index count = this->Data.NumberOfPoints();
  if (points.size() != Corners ||
    std::any_of(points.begin(), points.end(), [count](Index p) { return p < 0 || p >= count; }))
  {
    this->Reject(cell, "does not have eight points of the mesh.");
  }
  for (int c = 0; c < Corners; ++c)
  {
    const Vector3 point = this->Data.GetPoint(points[c]);
    for (int a = 0; a < 3; ++a)
    {
      if (!std::isfinite(point[a]))
      {
        this->Reject(
          cell, "has a corner that is not finite, its point " + std::to_string(points[c]) + ".");
      }
      box[a] = { { std::min(box[a][0], point[a]), std::max(box[a][1], point[a]) } };
    }
  }
  return box;
}

void Hexahedra::FindWidths()
{
  this->Width.fill(std::numeric_limits<double>::infinity());
  for (Index cell : this->Cells)
  {
    const Box box = this->FindBox(cell);
    for (int a = 0; a < 3; ++a)
    {
      const double width = box[a][1] - box[a][0];
      if (!(width > 0.0))
      {
        this->Reject(cell, std::string("is flat along ") + AxisNames[a] + "." + Advice);
      }
      this->Width[a] = std::min(this->Width[a], width);
    }
  }
}

void Hexahedra::FindNodes()
{
  std::vector<char> isUsed(this->Data.NumberOfPoints(), 0);
  for (Index cell : this->Cells)
  {
    const std::span<const Index> points = this->Data.GetCorners(cell);
    std::for_each(points.begin(), points.end(), [&isUsed](Index point) { isUsed[point] = 1; });
  }
  for (int a = 0; a < 3; ++a)
  {
    std::vector<double> all(isUsed.size(), 0.0), used;
    for (std::size_t p = 0; p < isUsed.size(); ++p)
    {
      if (isUsed[p])
      {
        all[p] = this->Data.GetPoint(static_cast<Index>(p))[a];
        used.push_back(all[p]);
      }
    }
    std::sort(used.begin(), used.end());
    this->X[a] = MergeClose(used, this->Width[a]);
    this->Nodes[a].resize(all.size());
    std::transform(all.begin(), all.end(), this->Nodes[a].begin(),
      [&](double x) { return static_cast<int>(FindNode(this->X[a], x)); });
  }
}

/// Sets the position of a cell. Returns whether its corners are the corners of a box between
/// adjacent nodes.
bool Hexahedra::IsPlaced(PlacedCell& cell)
{
  const std::span<const Index> points = this->Data.GetCorners(cell.Id);
  for (int a = 0; a < 3; ++a)
  {
    cell.Place[a] = this->Nodes[a][points[0]];
    for (int c = 1; c < Corners; ++c)
    {
      cell.Place[a] = std::min(cell.Place[a], this->Nodes[a][points[c]]);
    }
  }
  unsigned int found = 0; // one bit per corner
  for (int c = 0; c < Corners; ++c)
  {
    int corner = 0;
    for (int a = 0; a < 3; ++a)
    {
      const int step = this->Nodes[a][points[c]] - cell.Place[a];
      if (step > 1)
      {
        return false;
      }
      corner |= step << a;
    }
    found |= 1u << corner;
  }
  return found == 255u;
}

/// Checks that all corners lie on the sides of the bounding box of the cell.
void Hexahedra::CheckSides(Index cell)
{
  const Box box = this->FindBox(cell);
  const std::span<const Index> points = this->Data.GetCorners(cell);
  std::ostringstream text;
  for (int c = 0; c < Corners; ++c)
  {
    const Vector3 point = this->Data.GetPoint(points[c]);
    for (int a = 0; a < 3; ++a)
    {
      if (std::min(point[a] - box[a][0], box[a][1] - point[a]) > MatchTolerance * this->Width[a])
      {
        text << "is not a box with sides along the axes: its point " << points[c] << " at ("
             << point[0] << ", " << point[1] << ", " << point[2] << ") lies between its "
             << AxisNames[a] << " sides at " << box[a][0] << " and " << box[a][1] << "." << Advice;
        this->Reject(cell, text.str());
      }
    }
  }
}

/// Throws InputError with the reason why a cell has no position; CheckSides must have passed.
void Hexahedra::RejectPlace(Index cell)
{
  const Box box = this->FindBox(cell);
  std::ostringstream text;
  for (int a = 0; a < 3; ++a)
  {
    const std::vector<double>& x = this->X[a];
    const Index node = FindNode(x, box[a][0]);
    if (FindNode(x, box[a][1]) > node + 1)
    {
      text << "does not fit the other cells along " << AxisNames[a]
           << ": another cell has a node at " << x[node + 1] << ", between its sides at "
           << box[a][0] << " and " << box[a][1]
           << ". All cells of a block must lie on one Cartesian grid; of a refined one (AMR) give "
              "every level its own blocks.";
      this->Reject(cell, text.str());
    }
  }
  this->Reject(cell, std::string("has two corners in the same place.") + Advice);
}

std::vector<PlacedCell> Hexahedra::Place()
{
  std::vector<PlacedCell> placed;
  placed.reserve(this->Cells.size());
  for (Index id : this->Cells)
  {
    placed.push_back({ {}, id });
    if (!this->IsPlaced(placed.back()))
    {
      for (Index cell : this->Cells) // a distorted cell may be the reason
      {
        this->CheckSides(cell);
      }
      this->RejectPlace(id);
    }
  }
  std::stable_sort(placed.begin(), placed.end());
  for (std::size_t p = 1; p < placed.size(); ++p)
  {
    if (placed[p].Place == placed[p - 1].Place)
    {
      this->Reject(placed[p - 1].Id,
        "and cell " + std::to_string(placed[p].Id) +
          " lie in the same place. Cells must not overlap, except ghost cells that the array "
          "vtkGhostType marks.");
    }
  }
  return placed;
}

/// A box of cells; each row along x is a run in the list of placed cells.
struct CutBox
{
  IndexBox Box;
  std::vector<std::size_t> Rows; // first entry of each row in the list, y before z
};

/// Joins boxes that are consecutive along an axis and equal along the axes before it.
/// @param boxes ordered by their first cells, z before y before x
std::vector<CutBox> Join(std::vector<CutBox> boxes, int axis)
{
  std::vector<CutBox> joined;
  std::map<std::vector<Index>, std::size_t> open; // key of the box that would follow -> number
  for (CutBox& box : boxes)
  {
    std::vector<Index> key;
    for (int a = 0; a < 3; ++a)
    {
      key.push_back(box.Box.Lower[a]);
      key.push_back(a < axis ? box.Box.Upper[a] : 0);
    }
    std::size_t number = joined.size();
    const auto found = open.find(key);
    if (found == open.end())
    {
      joined.push_back(std::move(box));
    }
    else
    {
      number = found->second;
      joined[number].Box.Upper[axis] = box.Box.Upper[axis];
      joined[number].Rows.insert(joined[number].Rows.end(), box.Rows.begin(), box.Rows.end());
      open.erase(found);
    }
    key[2 * axis] = joined[number].Box.Upper[axis];
    open[key] = number;
  }
  return joined;
}

std::vector<CutBox> CutIntoBoxes(const std::vector<PlacedCell>& cells)
{
  std::vector<CutBox> rows;
  for (std::size_t c = 0; c < cells.size(); ++c)
  {
    const std::array<int, 3>& place = cells[c].Place;
    const bool follows = !rows.empty() && rows.back().Box.Upper[0] == place[0] &&
      rows.back().Box.Lower[1] == place[1] && rows.back().Box.Lower[2] == place[2];
    if (!follows)
    {
      const Index3 lower{ { place[0], place[1], place[2] } };
      rows.push_back({ { lower, { { lower[0], lower[1] + 1, lower[2] + 1 } } }, { c } });
    }
    ++rows.back().Box.Upper[0];
  }
  return Join(Join(std::move(rows), 1), 2);
}

/// Returns the cells box by box.
std::vector<Index> OrderOf(const std::vector<PlacedCell>& cells, const std::vector<CutBox>& boxes)
{
  std::vector<Index> order;
  order.reserve(cells.size());
  for (const CutBox& box : boxes)
  {
    for (std::size_t row : box.Rows)
    {
      for (Index i = 0; i < box.Box.Size(0); ++i)
      {
        order.push_back(cells[row + i].Id);
      }
    }
  }
  return order;
}

} // namespace

void RejectCell(const std::string& name, Index cell, const std::string& what)
{
  throw InputError(name + ": cell " + std::to_string(cell) + " " + what);
}

HexBoxes FindHexBoxes(
  HexCells& hexahedra, const std::vector<Index>& cells, int number, const std::string& name)
{
  Hexahedra found(hexahedra, cells, name);
  const std::vector<PlacedCell> placed = found.Place();
  const std::vector<CutBox> boxes = CutIntoBoxes(placed);
  const auto coordinates = found.TakeCoordinates();
  HexBoxes result{ {}, OrderOf(placed, boxes) };
  Index first = 0;
  for (const CutBox& box : boxes)
  {
    InputBlock block;
    block.Number = number;
    block.Name = name;
    block.FirstCell = first;
    for (int a = 0; a < 3; ++a)
    {
      const auto x = coordinates[a].begin() + box.Box.Lower[a];
      block.Coordinates[a] = std::vector<double>(x, x + box.Box.Size(a) + 1);
    }
    KeepAllCells(block);
    result.Blocks.push_back(std::move(block));
    first += box.Box.NumberOfCells();
  }
  return result;
}

bool HexBoxes::HaveOrderOf(Index cells) const
{
  Index next = 0;
  return static_cast<Index>(this->Cells.size()) == cells &&
    std::all_of(this->Cells.begin(), this->Cells.end(), [&next](Index c) { return c == next++; });
}

} // namespace vfm
