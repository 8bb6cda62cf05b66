#include "Labels/Thinning.h"

namespace vfm
{
namespace
{

/// An action in a box of cells that two ranks have.
struct SentAction
{
  Index Place; // IndexInBox
  int Material;
  int Leaves;
};

/// What a candidate would do if it acted now.
enum class Turn : unsigned char
{
  None,
  Leaves,
  Stays,
  Over // it has acted
};

Turn FindTurn(const ThinCandidates& candidates, std::size_t n)
{
  // A body that ends at a side does not continue beyond it.
  const CellsAround set = candidates.SetAround(candidates[n], !candidates[n].EndsAtSide);
  const int rest = CountPartsOfRest(set);
  const CellsAround inside = candidates.SetAround(candidates[n], false);
  const bool isNeeded = CountPartsOfRest(inside) > 1 || CountPartsOfSet(inside) != 1;
  // An edge that fades at a side is no thread through the side.
  if (rest > 1 || (CountPartsOfSet(set) != 1 && (isNeeded || !candidates[n].FadesAtSide)))
  {
    return Turn::Stays; // a film; a thread or a drop
  }
  if (inside != set && isNeeded)
  {
    return Turn::Stays; // a film along a side of the domain
  }
  if (rest == 0)
  {
    return Turn::None;
  }
  return candidates[n].IsRidge ? Turn::Stays : Turn::Leaves;
}

/// The rounds of ThinSets.
class Rounds
{
public:
  Rounds(const CartesianGrid& grid, Runtime& runtime, ThinCandidates& candidates);
  /// Returns the owned candidates that act in this round.
  std::vector<ThinAction> FindActions();
  /// Lets candidates act, and finds the turns of those around.
  void Act(const std::vector<ThinAction>& actions);
  /// Returns the owned candidates that never got a turn.
  std::vector<ThinAction> FindInside() const;

private:
  void FindTurns(const std::vector<std::size_t>& which);
  bool IsFirst(std::size_t n) const;

  const CartesianGrid& Grid;
  Runtime& Run;
  ThinCandidates& Candidates;
  std::vector<Turn> Turns;           // known in the owned cells and one layer around them
  std::vector<unsigned char> IsNear; // whether the turn of a candidate is known
  std::vector<std::size_t> Waiting;  // owned candidates that have not acted
};

Rounds::Rounds(const CartesianGrid& grid, Runtime& runtime, ThinCandidates& candidates) :
  Grid(grid),
  Run(runtime),
  Candidates(candidates),
  Turns(candidates.Size(), Turn::None),
  IsNear(candidates.Size(), 0)
{
  const IndexBox near = grid.Extended(1);
  std::vector<std::size_t> which;
  for (std::size_t n = 0; n < candidates.Size(); ++n)
  {
    const Index3 cell = grid.Position(candidates[n].Cell);
    if (near.Contains(cell))
    {
      this->IsNear[n] = 1;
      which.push_back(n);
    }
    if (grid.Owned().Contains(cell))
    {
      this->Waiting.push_back(n);
    }
  }
  this->FindTurns(which);
}

void Rounds::FindTurns(const std::vector<std::size_t>& which)
{
  ForEach(this->Run, which.size(),
    [&](Index w) { this->Turns[which[w]] = FindTurn(this->Candidates, which[w]); });
}

/// Returns whether no candidate around with a turn comes before a candidate.
bool Rounds::IsFirst(std::size_t n) const
{
  const auto cellKey = [&](const ThinCandidate& candidate)
  { return this->Grid.CellKey(this->Grid.Canonical(this->Grid.Position(candidate.Cell))); };
  const ThinCandidate& mine = this->Candidates[n];
  bool isFirst = true;
  this->Candidates.ForAround(mine,
    [&](std::size_t other)
    {
      const Turn turn = this->Turns[other];
      const ThinCandidate& theirs = this->Candidates[other];
      if (turn != Turn::None && turn != Turn::Over &&
        (theirs.Key < mine.Key || (theirs.Key == mine.Key && cellKey(theirs) > cellKey(mine))))
      {
        isFirst = false;
      }
    });
  return isFirst;
}

std::vector<ThinAction> Rounds::FindActions()
{
  std::vector<unsigned char> acts(this->Waiting.size());
  ForEach(this->Run, this->Waiting.size(),
    [&](Index w)
    {
      const std::size_t n = this->Waiting[w];
      acts[w] = this->Turns[n] != Turn::None && this->IsFirst(n);
    });
  std::vector<ThinAction> actions;
  std::size_t kept = 0;
  for (std::size_t w = 0; w < acts.size(); ++w)
  {
    const std::size_t n = this->Waiting[w];
    if (acts[w])
    {
      actions.push_back({ n, this->Turns[n] == Turn::Leaves });
      continue;
    }
    this->Waiting[kept++] = n;
  }
  this->Waiting.resize(kept);
  return actions;
}

void Rounds::Act(const std::vector<ThinAction>& actions)
{
  for (const ThinAction& action : actions)
  {
    this->Turns[action.Candidate] = Turn::Over;
    if (action.Leaves)
    {
      this->Candidates.Remove(action.Candidate);
    }
  }
  std::vector<std::size_t> which;
  for (const ThinAction& action : actions)
  {
    if (action.Leaves)
    {
      this->Candidates.ForAround(this->Candidates[action.Candidate],
        [&](std::size_t other)
        {
          if (this->IsNear[other] && this->Turns[other] != Turn::Over)
          {
            which.push_back(other);
          }
        });
    }
  }
  std::sort(which.begin(), which.end());
  which.erase(std::unique(which.begin(), which.end()), which.end());
  this->FindTurns(which);
}

std::vector<ThinAction> Rounds::FindInside() const
{
  std::vector<ThinAction> actions;
  for (std::size_t n : this->Waiting)
  {
    actions.push_back({ n, true });
  }
  return actions;
}

} // namespace

std::vector<ThinAction> ShareActions(const CartesianGrid& grid, const ThinCandidates& candidates,
  const Partition& partition, const std::vector<ThinAction>& own)
{
  std::vector<ThinAction> all = own;
  partition.ExchangeBoxes(
    [&](const IndexBox& box)
    {
      std::vector<SentAction> sent;
      for (const ThinAction& action : own)
      {
        const ThinCandidate& candidate = candidates[action.Candidate];
        const Index3 cell = grid.Position(candidate.Cell);
        if (box.Contains(cell))
        {
          sent.push_back({ IndexInBox(box, cell), candidate.Material, action.Leaves });
        }
      }
      return ToBytes(sent);
    },
    [&](const IndexBox& box, const Bytes& bytes)
    {
      for (const SentAction& sent : FromBytes<SentAction>(bytes))
      {
        const int found = candidates.Find(grid.Linear(CellInBox(box, sent.Place)), sent.Material);
        if (found >= 0) // else it is far from the owned cells
        {
          all.push_back({ static_cast<std::size_t>(found), sent.Leaves != 0 });
        }
      }
    });
  return all;
}

void ThinSets(const CartesianGrid& grid, const Partition& partition, Runtime& runtime,
  ThinCandidates& candidates)
{
  Rounds rounds(grid, runtime, candidates);
  for (;;)
  {
    const std::vector<ThinAction> own = rounds.FindActions();
    if (!partition.Group().Any(!own.empty()))
    {
      break;
    }
    rounds.Act(ShareActions(grid, candidates, partition, own));
  }
  rounds.Act(ShareActions(grid, candidates, partition, rounds.FindInside()));
}

} // namespace vfm
