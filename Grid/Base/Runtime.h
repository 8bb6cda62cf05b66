/**
 * Runtime: the interface of the stages to threads, ranks, progress display and abort.
 */
#pragma once

#include "Base/IndexBox.h"
#include "Ranks/Errors.h"
#include "Ranks/Ranks.h"

#include <cstdint>
#include <functional>

namespace vfm
{

/// Environment of a run. The base class runs loops serially on a single rank; derived classes add
/// threads, ranks and progress.
class Runtime
{
public:
  virtual ~Runtime() = default;

  /// Calls body(begin, end) on disjoint ranges that cover [first, last), possibly at the same time.
  /// @pre Results do not depend on the division into ranges.
  virtual void For(std::int64_t first, std::int64_t last,
    const std::function<void(std::int64_t, std::int64_t)>& body)
  {
    if (first < last)
    {
      body(first, last);
    }
  }

  /// Returns the ranks that share the grid.
  virtual Ranks& Group()
  {
    static Ranks alone;
    return alone;
  }

  /// Reports progress. Only one thread may call it.
  /// @param fraction  completed part of the whole run, 0 to 1
  /// @param stage  name of the current stage
  /// @throws Aborted  if the user stops a run on a single rank
  virtual void Progress(double fraction, const char* stage)
  {
    (void)fraction;
    (void)stage;
  }
};

/// Calls body(i) for 0 <= i < count, possibly several at the same time.
template <class Count, class Body>
void ForEach(Runtime& runtime, Count count, const Body& body)
{
  runtime.For(0, static_cast<Index>(count),
    [&body](Index begin, Index end)
    {
      for (Index i = begin; i < end; ++i)
      {
        body(i);
      }
    });
}

/// Calls body(j, k, number) for the rows along x of a box, possibly several at the same time. Rows
/// are numbered from 0, y fastest.
template <class Body>
void ForRows(Runtime& runtime, const IndexBox& box, const Body& body)
{
  const Index ny = box.Size(1);
  ForEach(runtime, box.NumberOfCells() > 0 ? ny * box.Size(2) : 0,
    [&](Index row) { body(box.Lower[1] + row % ny, box.Lower[2] + row / ny, row); });
}

} // namespace vfm
