/**
 * What the stages ask of the program around them: loops over threads, other ranks, progress, abort.
 * The base class is the serial program; ThreadRuntime has threads.
 */
#pragma once

#include "Base/IndexBox.h"
#include "Ranks/Errors.h"
#include "Ranks/Ranks.h"

#include <cstdint>
#include <functional>

namespace vfm
{

class Runtime
{
public:
  virtual ~Runtime() = default;

  /// Calls body(begin, end) on disjoint ranges that cover [first, last), possibly at the same time.
  /// No result may depend on how the range is cut.
  virtual void For(std::int64_t first, std::int64_t last,
    const std::function<void(std::int64_t, std::int64_t)>& body)
  {
    if (first < last)
    {
      body(first, last);
    }
  }

  /// The processes that share the grid.
  virtual Ranks& Group()
  {
    static Ranks alone;
    return alone;
  }

  /// Tells that the named stage is at fraction (0..1) of the whole run.
  /// Throws Aborted when the user wants to stop; on one rank only when it is alone. Called by one thread.
  virtual void Progress(double fraction, const char* stage)
  {
    (void)fraction;
    (void)stage;
  }
};

/// Calls body(i) for 0 .. count - 1, possibly several at the same time.
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

/// Calls body(j, k, number) for the rows along x of a box, numbered with y fastest, possibly several at the same time.
template <class Body>
void ForRows(Runtime& runtime, const IndexBox& box, const Body& body)
{
  const Index ny = box.Size(1);
  ForEach(runtime, box.NumberOfCells() > 0 ? ny * box.Size(2) : 0,
    [&](Index row) { body(box.Lower[1] + row % ny, box.Lower[2] + row / ny, row); });
}

} // namespace vfm
