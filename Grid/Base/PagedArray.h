/**
 * PagedArray: one value per linear index of a CartesianGrid, compressed where neighbours are equal.
 */
#pragma once

#include "Base/CartesianGrid.h"
#include "Base/Memory.h"
#include "Base/SlotArena.h"

#include <memory>
#include <mutex>
#include <unordered_map>

namespace vfm
{

/// Compressed array of the shape of a CartesianGrid. Each row along x consists of
/// pages of 32 values:
///   row -> table of its pages -> page -> value
/// Uniform pages (of one value) with equal values are one shared page. Uniform rows with equal
/// values share one table. A uniform row takes 8 bytes; other rows and pages need their own memory.
/// The lowest bit of a pointer marks a shared target.
///
/// Fill and Write share every page and row that becomes uniform. Set does so only if indices are
/// set in ascending order. Threads may write to different rows at the same time.
template <class T>
class PagedArray
{
  using Link = std::uintptr_t; // pointer; its lowest bit is set if the target is shared
  static bool IsShared(Link link) { return link & 1; }
  static const Link* TableAt(Link link) { return reinterpret_cast<const Link*>(link & ~Link(1)); }
  static const T* PageAt(Link link) { return reinterpret_cast<const T*>(link & ~Link(1)); }

public:
  using value_type = T;
  static constexpr Index PageSize = 32;

  /// Read access to a row. The index i counts from the first index of the row.
  class RowView
  {
  public:
    T operator[](Index i) const
    {
      const auto n = static_cast<std::uint64_t>(i); // unsigned numbers divide faster
      return this->Page(n / PageSize)[n % PageSize];
    }
    /// Returns the values of page p.
    const T* Page(Index p) const { return PageAt(TableAt(this->Row)[p]); }
    /// Returns whether the page or the row is known to be uniform.
    bool IsUniform(Index p) const { return IsShared(TableAt(this->Row)[p]); }
    bool IsUniform() const { return IsShared(this->Row); }

  private:
    friend class PagedArray;
    explicit RowView(Link row) : Row(row) {}
    Link Row;
  };

  PagedArray() = default;
  /// Makes an array of the grid's shape with equal values.
  PagedArray(const CartesianGrid& grid, T value);
  PagedArray(const PagedArray& other);
  PagedArray(PagedArray&& other) noexcept = default;
  PagedArray& operator=(PagedArray other) noexcept
  {
    std::swap(this->Length, other.Length);
    std::swap(this->Inverse, other.Inverse);
    this->Rows.swap(other.Rows);
    this->Shared.swap(other.Shared);
    return *this;
  }

  T operator[](Index n) const
  {
    const Index row = this->RowOf(n);
    return RowView(this->Rows[row])[n - row * this->Length];
  }
  /// Returns the row of an index.
  RowView Row(Index n) const { return RowView(this->Rows[this->RowOf(n)]); }
  Index RowLength() const { return this->Length; }
  /// Returns the position of an index in its row.
  Index InRow(Index n) const { return n - this->RowOf(n) * this->Length; }

  void Set(Index n, T value);
  /// Sets [first, last), which is in one row.
  void Fill(Index first, Index last, T value);
  /// Sets [first, last), which is in one row, to values[0], values[1] ...
  void Write(Index first, Index last, const T* values);
  /// Copies the row of index `from` to the row of index `to`.
  void CopyRow(Index from, Index to);

  /// Visits [first, last), which is in one row, in ascending order. Calls
  /// same(begin, end, value) for ranges known to be uniform and each(begin, end, values) for
  /// others, with values[0] at begin.
  template <class Same, class Each>
  void Visit(Index first, Index last, const Same& same, const Each& each) const;

  std::size_t MemoryInBytes() const;

private:
  struct Constant
  {
    alignas(Link) T Values[PageSize];
    std::vector<Link> Table;
  };
  struct Store
  {
    explicit Store(std::size_t pages) :
      Pages(PageSize * sizeof(T)), Tables(pages * sizeof(Link)), NumberOfPages(pages)
    {
    }
    std::mutex Mutex;
    SlotArena Pages, Tables;
    std::unordered_map<T, Constant> Constants;
    std::size_t NumberOfPages; // pages per row
  };

  __extension__ typedef unsigned __int128 Wide;
  /// Returns n / Length; exact if n * Length < 2^64.
  Index RowOf(Index n) const
  {
    return static_cast<Index>(
      static_cast<Wide>(static_cast<std::uint64_t>(n)) * this->Inverse >> 64);
  }
  Index NumberOfPages() const { return static_cast<Index>(this->Shared->NumberOfPages); }
  /// Returns the number of values used in page p. The last page may have fewer than PageSize.
  Index SizeOfPage(Index p) const { return std::min(PageSize, this->Length - p * PageSize); }
  static bool AreEqual(const T* values, Index count)
  {
    return std::all_of(values + 1, values + count, [&](T value) { return value == values[0]; });
  }

  Constant& FindConstant(T value);
  Link SharedPage(T value) { return reinterpret_cast<Link>(this->FindConstant(value).Values) | 1; }
  Link SharedTable(T value)
  {
    return reinterpret_cast<Link>(this->FindConstant(value).Table.data()) | 1;
  }
  Link* OwnTable(Index row);
  T* OwnPage(Index row, Index p);
  void Take(SlotArena& arena, Link& link);
  void Give(SlotArena& arena, Link link);
  void SharePage(Index row, Index p, T value);
  void ShareRow(Index row);
  void FillRow(Index row, T value);
  void FillPage(Index row, Index p, Index begin, Index end, T value);
  template <class Body>
  void ForPages(Index first, Index last, const Body& body);

  Index Length = 1;
  std::uint64_t Inverse = 0; // 2^64 / Length, rounded up
  std::vector<Link, LargeAllocator<Link>> Rows;
  std::unique_ptr<Store> Shared;
};

template <class T>
PagedArray<T>::PagedArray(const CartesianGrid& grid, T value) :
  Length(grid.Stride(1)),
  Inverse(~std::uint64_t(0) / static_cast<std::uint64_t>(grid.Stride(1)) + 1),
  Shared(std::make_unique<Store>((grid.Stride(1) + PageSize - 1) / PageSize))
{
  this->Rows.assign(grid.NumberOfEntries() / this->Length, this->SharedTable(value));
}

template <class T>
PagedArray<T>::PagedArray(const PagedArray& other) : Length(other.Length), Inverse(other.Inverse)
{
  if (!other.Shared)
  {
    return;
  }
  this->Shared = std::make_unique<Store>(other.Shared->NumberOfPages);
  this->Rows.assign(other.Rows.size(), 0);
  for (std::size_t row = 0; row < this->Rows.size(); ++row)
  {
    const RowView from(other.Rows[row]);
    this->Rows[row] = this->SharedTable(from[0]);
    for (Index p = 0; !from.IsUniform() && p < this->NumberOfPages(); ++p)
    {
      if (from.IsUniform(p))
      {
        this->FillPage(row, p, 0, this->SizeOfPage(p), from.Page(p)[0]);
        continue;
      }
      std::copy_n(from.Page(p), PageSize, this->OwnPage(row, p));
    }
  }
}

template <class T>
typename PagedArray<T>::Constant& PagedArray<T>::FindConstant(T value)
{
  const std::lock_guard<std::mutex> lock(this->Shared->Mutex);
  const auto at = this->Shared->Constants.try_emplace(value);
  Constant& constant = at.first->second; // its address does not change
  if (at.second)
  {
    std::fill_n(constant.Values, PageSize, value);
    constant.Table.assign(this->Shared->NumberOfPages, reinterpret_cast<Link>(constant.Values) | 1);
  }
  return constant;
}

template <class T>
void PagedArray<T>::Take(SlotArena& arena, Link& link)
{
  const std::lock_guard<std::mutex> lock(this->Shared->Mutex);
  link = reinterpret_cast<Link>(arena.Take());
}

template <class T>
void PagedArray<T>::Give(SlotArena& arena, Link link)
{
  const std::lock_guard<std::mutex> lock(this->Shared->Mutex);
  arena.Give(reinterpret_cast<void*>(link));
}

/// Returns the table of a row for writing; copies a shared table first.
template <class T>
typename PagedArray<T>::Link* PagedArray<T>::OwnTable(Index row)
{
  Link& link = this->Rows[row];
  if (IsShared(link))
  {
    const Link* from = TableAt(link);
    this->Take(this->Shared->Tables, link);
    std::copy_n(from, this->Shared->NumberOfPages, reinterpret_cast<Link*>(link));
  }
  return reinterpret_cast<Link*>(link);
}

/// Returns the values of a page for writing; copies a shared page first.
template <class T>
T* PagedArray<T>::OwnPage(Index row, Index p)
{
  Link& link = this->OwnTable(row)[p];
  if (IsShared(link))
  {
    const T* from = PageAt(link);
    this->Take(this->Shared->Pages, link);
    std::copy_n(from, PageSize, reinterpret_cast<T*>(link));
  }
  return reinterpret_cast<T*>(link);
}

/// Replaces a page by the shared page of a value.
template <class T>
void PagedArray<T>::SharePage(Index row, Index p, T value)
{
  Link& link = this->OwnTable(row)[p];
  if (!IsShared(link))
  {
    this->Give(this->Shared->Pages, link);
  }
  link = this->SharedPage(value);
}

/// Replaces the table of a row by a shared table if all its pages are the same shared page.
template <class T>
void PagedArray<T>::ShareRow(Index row)
{
  const Link link = this->Rows[row];
  if (IsShared(link))
  {
    return;
  }
  const Link* table = TableAt(link);
  const bool isUniform = IsShared(table[0]) &&
    std::all_of(
      table + 1, table + this->NumberOfPages(), [&](Link page) { return page == table[0]; });
  if (isUniform)
  {
    this->Rows[row] = this->SharedTable(PageAt(table[0])[0]);
    this->Give(this->Shared->Tables, link);
  }
}

/// Sets [begin, end) of a page; shares the page if it becomes uniform.
template <class T>
void PagedArray<T>::FillPage(Index row, Index p, Index begin, Index end, T value)
{
  const RowView view(this->Rows[row]);
  if (view.IsUniform(p) && view.Page(p)[0] == value)
  {
    return;
  }
  if (end - begin == this->SizeOfPage(p))
  {
    this->SharePage(row, p, value);
    return;
  }
  T* page = this->OwnPage(row, p);
  std::fill(page + begin, page + end, value);
  if (AreEqual(page, this->SizeOfPage(p)))
  {
    this->SharePage(row, p, value);
  }
}

/// Calls body(row, page, begin, end, index of begin) for the parts of pages in [first, last).
template <class T>
template <class Body>
void PagedArray<T>::ForPages(Index first, Index last, const Body& body)
{
  const Index row = this->RowOf(first), start = row * this->Length;
  for (Index n = first; n < last;)
  {
    const Index p = (n - start) / PageSize, page = start + p * PageSize;
    const Index end = std::min(last, page + PageSize);
    body(row, p, n - page, end - page, n);
    n = end;
  }
  this->ShareRow(row);
}

template <class T>
void PagedArray<T>::Set(Index n, T value)
{
  const Index row = this->RowOf(n), i = n - row * this->Length;
  if (RowView(this->Rows[row])[i] == value)
  {
    return;
  }
  const Index p = i / PageSize, last = this->SizeOfPage(p) - 1;
  T* page = this->OwnPage(row, p);
  page[i % PageSize] = value;
  // After the last index of a page, the page is complete if indices are set in ascending order.
  if (i % PageSize == last && AreEqual(page, last + 1))
  {
    this->SharePage(row, p, value);
    this->ShareRow(row);
  }
}

template <class T>
void PagedArray<T>::FillRow(Index row, T value)
{
  const Link link = this->Rows[row];
  if (!IsShared(link))
  {
    for (Index p = 0; p < this->NumberOfPages(); ++p)
    {
      if (!IsShared(TableAt(link)[p]))
      {
        this->Give(this->Shared->Pages, TableAt(link)[p]);
      }
    }
    this->Give(this->Shared->Tables, link);
  }
  this->Rows[row] = this->SharedTable(value);
}

template <class T>
void PagedArray<T>::Fill(Index first, Index last, T value)
{
  if (last - first == this->Length)
  {
    this->FillRow(this->RowOf(first), value);
    return;
  }
  this->ForPages(first, last,
    [&](Index row, Index p, Index begin, Index end, Index)
    { this->FillPage(row, p, begin, end, value); });
}

template <class T>
void PagedArray<T>::Write(Index first, Index last, const T* values)
{
  this->ForPages(first, last,
    [&](Index row, Index p, Index begin, Index end, Index n)
    {
      const T* from = values + (n - first);
      if (AreEqual(from, end - begin))
      {
        this->FillPage(row, p, begin, end, from[0]);
        return;
      }
      std::copy_n(from, end - begin, this->OwnPage(row, p) + begin);
    });
}

template <class T>
void PagedArray<T>::CopyRow(Index from, Index to)
{
  const Index start = this->RowOf(to) * this->Length;
  const Index shift = start - this->RowOf(from) * this->Length;
  this->Visit(
    start - shift, start - shift + this->Length,
    [&](Index begin, Index end, T value) { this->Fill(begin + shift, end + shift, value); },
    [&](Index begin, Index end, const T* values)
    { this->Write(begin + shift, end + shift, values); });
}

template <class T>
template <class Same, class Each>
void PagedArray<T>::Visit(Index first, Index last, const Same& same, const Each& each) const
{
  const Index row = this->RowOf(first), start = row * this->Length;
  const RowView view(this->Rows[row]);
  if (view.IsUniform())
  {
    same(first, last, view.Page(0)[0]);
    return;
  }
  for (Index n = first; n < last;)
  {
    Index p = (n - start) / PageSize;
    const T* page = view.Page(p);
    const Index begin = n;
    n = std::min(last, start + (p + 1) * PageSize);
    if (!view.IsUniform(p))
    {
      each(begin, n, page + (begin - start - p * PageSize));
      continue;
    }
    while (n < last && view.Page(p + 1) == page)
    {
      ++p;
      n = std::min(last, n + PageSize);
    }
    same(begin, n, page[0]);
  }
}

template <class T>
std::size_t PagedArray<T>::MemoryInBytes() const
{
  if (!this->Shared)
  {
    return 0;
  }
  const std::size_t constants = this->Shared->Constants.size() *
    (sizeof(Constant) + this->Shared->NumberOfPages * sizeof(Link));
  return this->Rows.capacity() * sizeof(Link) + this->Shared->Pages.MemoryInBytes() +
    this->Shared->Tables.MemoryInBytes() + constants;
}

} // namespace vfm
