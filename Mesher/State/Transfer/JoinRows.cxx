#include "State/Transfer/JoinRows.h"

#include "State/Transfer/FarContents.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace vfm
{
namespace
{

constexpr double ShareOfAround = 0.1; // weight of the fractions around in the score
constexpr int Middle = 13;            // the cell itself among the 27

/// The contents of a cell in a message; its values follow in another list.
struct SentRow
{
  Index Place; // IndexInBox
  int Material;
  double Volume;
};

/// A new seed in a message.
struct SentSeed
{
  Index Place; // IndexInBox
  int Material;
};

/// What a row is in the search for seeds.
enum class RowState : unsigned char
{
  Free,
  Covered, // a seed is around
  Seed
};

/// Rows of owned cells and of ghost cells.
class NearRows
{
public:
  NearRows(const CartesianGrid& grid, const Partition& partition, int columns, UnmeshedRows own) :
    Grid(grid), Parts(partition), Columns(columns), All(std::move(own))
  {
    this->Receive();
    this->Sort();
  }

  int Size() const { return static_cast<int>(this->All.Rows.size()); }
  const UnmeshedRow& operator[](int n) const { return this->All.Rows[n]; }
  const double* ValuesOf(int n) const
  {
    return this->All.Values.data() + static_cast<std::size_t>(n) * this->Columns;
  }
  bool IsOwned(int n) const
  {
    return this->Grid.Owned().Contains(this->Grid.Position(this->All.Rows[n].Cell));
  }
  double FractionOf(int n) const
  {
    const UnmeshedRow& row = this->All.Rows[n];
    return row.Volume / this->Grid.CellVolume(this->Grid.Position(row.Cell));
  }
  /// Returns the key that all copies of a cell have.
  Index KeyOf(int n) const
  {
    return this->Grid.CellKey(this->Grid.Canonical(this->Grid.Position(this->All.Rows[n].Cell)));
  }

  /// Returns the number of the row of a cell, -1 if there is none.
  int Find(Index cell, int material) const
  {
    const auto found =
      std::lower_bound(this->All.Rows.begin(), this->All.Rows.end(), std::tie(cell, material),
        [](const UnmeshedRow& row, const std::tuple<const Index&, const int&>& key)
        { return std::tie(row.Cell, row.Material) < key; });
    const bool isFound =
      found != this->All.Rows.end() && found->Cell == cell && found->Material == material;
    return isFound ? static_cast<int>(found - this->All.Rows.begin()) : -1;
  }
  /// Calls body(row) for the rows of the same material in the 26 cells around, in a fixed order.
  template <class Body>
  void ForAround(int n, const Body& body) const
  {
    const Index3 p = this->Grid.Position(this->All.Rows[n].Cell);
    for (int step = 0; step < 27; ++step)
    {
      const Index3 q = CellAround(p, step);
      const int found = step != Middle && this->Grid.Local().Contains(q)
        ? this->Find(this->Grid.Linear(q), this->All.Rows[n].Material)
        : -1;
      if (found >= 0)
      {
        body(found);
      }
    }
  }

  /// Sends rows of owned cells to the ranks that have the cells as ghosts, and returns the rows
  /// received. Collective among peers.
  std::vector<int> Share(const std::vector<int>& own) const
  {
    std::vector<int> received;
    this->Parts.ExchangeBoxes(
      [&](const IndexBox& box)
      {
        std::vector<SentSeed> sent;
        for (int n : own)
        {
          const Index3 cell = this->Grid.Position(this->All.Rows[n].Cell);
          if (box.Contains(cell))
          {
            sent.push_back({ IndexInBox(box, cell), this->All.Rows[n].Material });
          }
        }
        return ToBytes(sent);
      },
      [&](const IndexBox& box, const Bytes& bytes)
      {
        for (const SentSeed& seed : FromBytes<SentSeed>(bytes))
        {
          received.push_back(
            this->Find(this->Grid.Linear(CellInBox(box, seed.Place)), seed.Material));
        }
      });
    return received;
  }

private:
  /// Receives the rows of ghost cells.
  void Receive()
  {
    const std::size_t own = this->All.Rows.size();
    const auto forRowsIn = [&](const IndexBox& box, const auto& body)
    {
      for (std::size_t n = 0; n < own; ++n)
      {
        const Index3 cell = this->Grid.Position(this->All.Rows[n].Cell);
        if (box.Contains(cell))
        {
          body(n, IndexInBox(box, cell));
        }
      }
    };
    std::vector<Index> added; // of each box
    this->Parts.ExchangeBoxes(
      [&](const IndexBox& box)
      {
        std::vector<SentRow> sent;
        forRowsIn(box,
          [&](std::size_t n, Index place) {
            sent.push_back({ place, this->All.Rows[n].Material, this->All.Rows[n].Volume });
          });
        return ToBytes(sent);
      },
      [&](const IndexBox& box, const Bytes& bytes)
      {
        for (const SentRow& sent : FromBytes<SentRow>(bytes))
        {
          const Index3 cell = CellInBox(box, sent.Place);
          this->All.Rows.push_back({ this->Grid.Linear(cell), sent.Material, sent.Volume, {} });
        }
      });
    this->Parts.ExchangeBoxes(
      [&](const IndexBox& box)
      {
        std::vector<double> sent;
        forRowsIn(box,
          [&](std::size_t n, Index)
          {
            const double* values = this->ValuesOf(static_cast<int>(n));
            sent.insert(sent.end(), values, values + this->Columns);
          });
        return ToBytes(sent);
      },
      [&](const IndexBox&, const Bytes& bytes)
      {
        const std::vector<double> values = FromBytes<double>(bytes);
        this->All.Values.insert(this->All.Values.end(), values.begin(), values.end());
      });
  }

  void Sort()
  {
    std::vector<int> order(this->All.Rows.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(),
      [this](int a, int b)
      {
        const UnmeshedRow &one = this->All.Rows[a], &other = this->All.Rows[b];
        return std::tie(one.Cell, one.Material) < std::tie(other.Cell, other.Material);
      });
    UnmeshedRows sorted;
    sorted.Rows.reserve(order.size());
    sorted.Values.reserve(this->All.Values.size());
    for (int n : order)
    {
      sorted.Add(this->All.Rows[n], this->ValuesOf(n), this->Columns);
    }
    this->All = std::move(sorted);
  }

  const CartesianGrid& Grid;
  const Partition& Parts;
  const int Columns;
  UnmeshedRows All;
};

/// Finds seeds, and the seed of each row.
class RowSeeds
{
public:
  RowSeeds(const NearRows& rows, const JoinRule& rule) :
    Rows(rows), States(rows.Size(), RowState::Free)
  {
    for (int n = 0; n < rows.Size(); ++n)
    {
      this->Scores.push_back(rows.FractionOf(n));
      rows.ForAround(n, [&](int other) { this->Scores[n] += rows.FractionOf(other); });
      this->Scores[n] = rows.FractionOf(n) + ShareOfAround * this->Scores[n];
      if (!rule.All && rows.FractionOf(n) >= rule.Least)
      {
        this->States[n] = RowState::Seed;
      }
    }
    this->Cover();
  }

  /// Collective.
  void Run(Ranks& ranks)
  {
    for (;;)
    {
      const std::vector<int> own = this->FindNew();
      if (!ranks.Any(!own.empty()))
      {
        return;
      }
      for (const std::vector<int>& seeds : { own, this->Rows.Share(own) })
      {
        for (int n : seeds)
        {
          this->States[n] = RowState::Seed;
        }
      }
      this->Cover();
    }
  }

  bool IsSeed(int n) const { return this->States[n] == RowState::Seed; }
  /// Returns the seed that a row joins.
  /// @pre All its seeds are known: it is in an owned cell, or in one beside it.
  int SeedOf(int n) const
  {
    int best = this->IsSeed(n) ? n : -1;
    this->Rows.ForAround(n,
      [&](int other)
      {
        if (!this->IsSeed(n) && this->IsSeed(other) && (best < 0 || this->IsBetter(other, best)))
        {
          best = other;
        }
      });
    return best;
  }

private:
  bool IsBetter(int one, int other) const
  {
    return this->Scores[one] != this->Scores[other]
      ? this->Scores[one] > this->Scores[other]
      : this->Rows.KeyOf(one) < this->Rows.KeyOf(other);
  }

  /// Returns free rows of owned cells that are better than all free rows around.
  std::vector<int> FindNew() const
  {
    std::vector<int> found;
    for (int n = 0; n < this->Rows.Size(); ++n)
    {
      bool isBest = this->States[n] == RowState::Free && this->Rows.IsOwned(n);
      if (isBest)
      {
        this->Rows.ForAround(n,
          [&](int other) {
            isBest = isBest && (this->States[other] != RowState::Free || this->IsBetter(n, other));
          });
      }
      if (isBest)
      {
        found.push_back(n);
      }
    }
    return found;
  }

  /// Marks the free rows with a seed around.
  void Cover()
  {
    for (int n = 0; n < this->Rows.Size(); ++n)
    {
      if (this->States[n] == RowState::Free)
      {
        this->Rows.ForAround(n,
          [&](int other)
          { this->States[n] = this->IsSeed(other) ? RowState::Covered : this->States[n]; });
      }
    }
  }

  const NearRows& Rows;
  std::vector<double> Scores;
  std::vector<RowState> States;
};

/// Returns a position in the domain, by whole periods.
Vector3 MoveInside(const CartesianGrid& grid, Vector3 x)
{
  for (int a = 0; a < 3; ++a)
  {
    const double period = grid.PeriodLength(a);
    const double lower = grid.Coordinates(a)[grid.Domain().Lower[a]],
                 upper = grid.Coordinates(a)[grid.Domain().Upper[a]];
    x[a] += period > 0.0 && x[a] < lower ? period : 0.0;
    x[a] -= period > 0.0 && x[a] >= upper ? period : 0.0;
  }
  return x;
}

/// Adds the contents of a seed and of the rows that join it.
void AddJoined(const NearRows& rows, const RowSeeds& seeds, int seed, const StateColumns& columns,
  const CartesianGrid& grid, UnmeshedRows& joined)
{
  UnmeshedRow sum = rows[seed];
  std::vector<double> values(rows.ValuesOf(seed), rows.ValuesOf(seed) + columns.Count());
  Vector3 moment{}; // about the centre of the seed's cell
  rows.ForAround(seed,
    [&](int n)
    {
      if (seeds.SeedOf(n) == seed)
      {
        const Vector3 centre = CentreOfCell(grid, grid.Position(rows[n].Cell));
        moment = moment + rows[n].Volume * (centre - rows[seed].Position);
        columns.Mix(sum.Volume, values.data(), rows[n].Volume, rows.ValuesOf(n));
      }
    });
  sum.Position = MoveInside(grid, sum.Position + (1.0 / sum.Volume) * moment);
  joined.Add(sum, values.data(), columns.Count());
}

} // namespace

UnmeshedRows JoinRows(UnmeshedRows rows, const JoinRule& rule, const StateColumns& columns,
  const Partition& partition, const CartesianGrid& grid)
{
  const auto isSmall = [&](const UnmeshedRow& row)
  { return row.Volume < rule.Least * grid.CellVolume(grid.Position(row.Cell)); };
  const bool joins = rule.All || std::any_of(rows.Rows.begin(), rows.Rows.end(), isSmall);
  if (!partition.Group().Any(joins))
  {
    return rows;
  }
  const NearRows near(grid, partition, columns.Count(), std::move(rows));
  RowSeeds seeds(near, rule);
  seeds.Run(partition.Group());
  UnmeshedRows joined;
  for (int n = 0; n < near.Size(); ++n)
  {
    if (near.IsOwned(n) && seeds.IsSeed(n))
    {
      AddJoined(near, seeds, n, columns, grid, joined);
    }
  }
  return joined;
}

} // namespace vfm
