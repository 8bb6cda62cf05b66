#include "State/Transfer/CoarseGraph.h"

#include "Base/Sorted.h"

#include <cmath>
#include <tuple>

namespace vfm
{
namespace
{

// Smallest width of a block in cells, and largest number of blocks of a component.
constexpr Index SmallestBlock = 4, MaximumBlocks = 4000;
// Relative increase of the diagonal. It makes the matrix regular, because potentials are determined
// only up to a constant.
constexpr double Hold = 1e-6;
constexpr int BitsOfWidth = 40;

/// Key of a link on the way to its home: the component, and the positions of both blocks.
using LinkName = std::array<Index, 7>;

void AddTo(std::int64_t& a, std::int64_t b)
{
  a += b;
}

/// Merges links between the same blocks.
void JoinLinks(std::vector<BlockLink>& links)
{
  std::sort(links.begin(), links.end(),
    [](const BlockLink& a, const BlockLink& b)
    { return std::tie(a.From, a.To) < std::tie(b.From, b.To); });
  std::size_t count = 0;
  for (const BlockLink& link : links)
  {
    if (count > 0 && links[count - 1].From == link.From && links[count - 1].To == link.To)
    {
      links[count - 1].Width += link.Width;
    }
    else
    {
      links[count++] = link;
    }
  }
  links.resize(count);
}

/// Calls body(first, last) for the blocks of each component.
template <class Body>
void ForComponents(const std::vector<BlockName>& names, const Body& body)
{
  ForRuns(
    names.begin(), names.end(), [](const BlockName& a, const BlockName& b) { return a[0] == b[0]; },
    [&](auto first, auto last)
    {
      body(static_cast<std::size_t>(first - names.begin()),
        static_cast<std::size_t>(last - names.begin()));
    });
}

/// Returns the names of the components that have too many blocks, ascending.
std::vector<Index> ListLarge(const std::vector<BlockName>& names)
{
  std::vector<Index> large;
  ForComponents(names,
    [&](std::size_t first, std::size_t last)
    {
      if (last - first > MaximumBlocks)
      {
        large.push_back(names[first][0]);
      }
    });
  return large;
}

/// Returns for each component of this rank the smallest width of blocks that may be few enough.
/// Collective.
std::vector<Index> StartSizes(const FlowGraph& graph)
{
  std::vector<std::int64_t> nodes(graph.Components.Size(), 0);
  for (std::size_t i = 0; i < graph.Nodes.size(); ++i)
  {
    ++nodes[graph.Pieces[i]];
  }
  graph.Components.Merge(nodes, 1, AddTo);
  std::vector<Index> sizes(nodes.size(), SmallestBlock);
  for (std::size_t p = 0; p < sizes.size(); ++p)
  {
    while (nodes[p] > MaximumBlocks * sizes[p] * sizes[p] * sizes[p])
    {
      sizes[p] *= 2;
    }
  }
  return sizes;
}

/// Returns the matrix of a component.
/// @param first,count  its blocks
/// @param links  its links, sorted
Eigen::SparseMatrix<double> MakeMatrix(std::size_t first, std::size_t count, const BlockLink* begin,
  const BlockLink* end, double unit, double widest)
{
  std::vector<double> diagonal(count, 0.0);
  std::vector<Eigen::Triplet<double>> entries;
  for (const BlockLink* link = begin; link != end; ++link)
  {
    const double width = static_cast<double>(link->Width) * unit;
    const int from = link->From - static_cast<int>(first);
    diagonal[from] += width;
    entries.emplace_back(from, link->To - static_cast<int>(first), -width);
  }
  for (std::size_t b = 0; b < count; ++b)
  {
    entries.emplace_back(static_cast<int>(b), static_cast<int>(b),
      diagonal[b] > 0.0 ? (1.0 + Hold) * diagonal[b] : widest + 1.0);
  }
  Eigen::SparseMatrix<double> matrix(
    static_cast<Eigen::Index>(count), static_cast<Eigen::Index>(count));
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

void Centre(Eigen::VectorXd& values)
{
  values.array() -= values.mean();
}

} // namespace

void BlockSystems::Make(
  const std::vector<BlockName>& names, std::vector<BlockLink> links, double unit, double widest)
{
  JoinLinks(links);
  const BlockLink* next = links.data();
  const BlockLink* end = next + links.size();
  ForComponents(names,
    [&](std::size_t first, std::size_t last)
    {
      const BlockLink* begin = next;
      next = std::find_if(
        begin, end, [last](const BlockLink& link) { return link.From >= static_cast<int>(last); });
      if (last - first > 1) // a single block has nowhere to flow to
      {
        this->Systems.push_back(std::make_unique<System>());
        System& system = *this->Systems.back();
        system.First = first;
        system.Count = last - first;
        system.Factors.compute(MakeMatrix(first, system.Count, begin, next, unit, widest));
      }
    });
}

void BlockSystems::Solve(std::vector<double>& values) const
{
  std::vector<double> potential(values.size(), 0.0);
  for (const auto& system : this->Systems)
  {
    Eigen::VectorXd excess = Eigen::Map<const Eigen::VectorXd>(
      values.data() + system->First, static_cast<Eigen::Index>(system->Count));
    Centre(excess);
    Eigen::VectorXd solution = system->Factors.solve(excess);
    Centre(solution);
    std::copy(solution.data(), solution.data() + solution.size(),
      potential.begin() + static_cast<std::ptrdiff_t>(system->First));
  }
  values = std::move(potential);
}

CoarseGraph::CoarseGraph(const FlowGraph& graph, Ranks& ranks)
{
  this->Number(graph, ranks);
  this->MakeSystems(graph, ranks);
}

void CoarseGraph::Number(const FlowGraph& graph, Ranks& ranks)
{
  std::vector<Index> sizes = StartSizes(graph);
  while (ranks.Any(this->MakeBlocks(graph, sizes, ranks)))
  {
  }
  this->HasShared = ranks.Any(!this->SharedBlocks.empty());
}

/// Makes the blocks of this rank. Doubles the sizes of components of too many blocks; returns
/// whether there are any. Collective.
/// @param sizes  width of the blocks of each component of this rank
bool CoarseGraph::MakeBlocks(const FlowGraph& graph, std::vector<Index>& sizes, Ranks& ranks)
{
  const FragmentShare& components = graph.Components;
  std::vector<BlockName> names(graph.Places.size());
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    const Index3& p = graph.Places[i];
    const Index size = sizes[graph.Pieces[i]];
    names[i] = { { components.Ids[graph.Pieces[i]], p[0] / size, p[1] / size, p[2] / size } };
  }
  this->Names = names;
  SortUnique(this->Names);
  this->BlockOfNode.clear();
  for (const BlockName& name : names)
  {
    this->BlockOfNode.push_back(static_cast<int>(FindSorted(this->Names, name)));
  }
  this->SharedBlocks.clear();
  this->LocalBlocks.clear();
  std::vector<BlockName> shared, local;
  for (std::size_t b = 0; b < this->Names.size(); ++b)
  {
    const int piece = components.Find(static_cast<int>(this->Names[b][0]));
    const bool isShared = components.IsShared[piece] != 0;
    (isShared ? this->SharedBlocks : this->LocalBlocks).push_back(static_cast<int>(b));
    (isShared ? shared : local).push_back(this->Names[b]);
  }
  this->Ways = KeyMerge<BlockName>(std::move(shared), HomeOfFirst(ranks), ranks);
  std::vector<Index> large = ListLarge(local);
  const std::vector<Index> largeAtHome = ListLarge(this->Ways.HomeKeys());
  std::vector<unsigned char> isLarge;
  for (const BlockName& name : this->Ways.HomeKeys())
  {
    isLarge.push_back(FindSorted(largeAtHome, name[0]) >= 0);
  }
  isLarge = this->Ways.FromHome(std::move(isLarge), 1);
  for (std::size_t s = 0; s < isLarge.size(); ++s)
  {
    if (isLarge[s])
    {
      large.push_back(this->Names[this->SharedBlocks[s]][0]);
    }
  }
  SortUnique(large);
  for (Index component : large)
  {
    sizes[components.Find(static_cast<int>(component))] *= 2;
  }
  return !large.empty();
}

/// Returns the links from blocks of owned nodes.
std::vector<BlockLink> CoarseGraph::FindLinks(const FlowGraph& graph, double unit) const
{
  std::vector<BlockLink> links;
  for (std::size_t i = 0; i < graph.Nodes.size(); ++i)
  {
    for (int f = 0; f < 6; ++f)
    {
      const int from = this->BlockOfNode[i], to = this->BlockOfNode[graph.Nodes[i].Others[f]];
      if (from != to)
      {
        links.push_back({ from, to, static_cast<std::int64_t>(graph.Nodes[i].Widths[f] / unit) });
      }
    }
  }
  JoinLinks(links);
  return links;
}

void CoarseGraph::MakeSystems(const FlowGraph& graph, Ranks& ranks)
{
  double widest = 0.0;
  for (const FlowNode& node : graph.Nodes)
  {
    widest = std::max(widest, *std::max_element(node.Widths.begin(), node.Widths.end()));
  }
  widest = ranks.Max(widest);
  const double unit = widest > 0.0 ? std::ldexp(1.0, std::ilogb(widest) - BitsOfWidth) : 1.0;
  const std::vector<BlockLink> links = this->FindLinks(graph, unit);
  std::vector<BlockName> names;
  for (int block : this->LocalBlocks)
  {
    names.push_back(this->Names[block]);
  }
  std::vector<BlockLink> local, shared;
  for (const BlockLink& link : links)
  {
    const auto from = FindSorted(this->LocalBlocks, link.From);
    if (from < 0)
    {
      shared.push_back(link);
      continue;
    }
    local.push_back({ static_cast<int>(from),
      static_cast<int>(FindSorted(this->LocalBlocks, link.To)), link.Width });
  }
  this->Local.Make(names, std::move(local), unit, widest);
  if (this->HasShared)
  {
    this->MakeSystemsAtHome(shared, unit, widest, ranks);
  }
}

/// Makes the systems of components of several ranks. Collective.
/// @param links  links of their blocks on this rank
void CoarseGraph::MakeSystemsAtHome(
  const std::vector<BlockLink>& links, double unit, double widest, Ranks& ranks)
{
  std::vector<LinkName> keys;
  std::vector<std::int64_t> widths;
  for (const BlockLink& link : links) // ascending, like the names of blocks
  {
    const BlockName &from = this->Names[link.From], &to = this->Names[link.To];
    keys.push_back({ { from[0], from[1], from[2], from[3], to[1], to[2], to[3] } });
    widths.push_back(link.Width);
  }
  const KeyMerge<LinkName> ways(std::move(keys), HomeOfFirst(ranks), ranks);
  widths = ways.ToHome(std::move(widths), 1, AddTo);
  const std::vector<BlockName>& names = this->Ways.HomeKeys();
  std::vector<BlockLink> atHome;
  for (std::size_t k = 0; k < widths.size(); ++k)
  {
    const LinkName& key = ways.HomeKeys()[k];
    atHome.push_back(
      { static_cast<int>(FindSorted(names, BlockName{ { key[0], key[1], key[2], key[3] } })),
        static_cast<int>(FindSorted(names, BlockName{ { key[0], key[4], key[5], key[6] } })),
        widths[k] });
  }
  this->AtHome.Make(names, std::move(atHome), unit, widest);
}

std::vector<double> CoarseGraph::Solve(const std::vector<std::int64_t>& excess, double unit) const
{
  const auto pick = [&excess](const std::vector<int>& blocks)
  {
    std::vector<std::int64_t> picked;
    for (int block : blocks)
    {
      picked.push_back(excess[block]);
    }
    return picked;
  };
  const auto toValues = [unit](const std::vector<std::int64_t>& sums)
  {
    std::vector<double> values;
    for (std::int64_t sum : sums)
    {
      values.push_back(static_cast<double>(sum) * unit);
    }
    return values;
  };
  std::vector<double> potential(excess.size());
  const auto put = [&potential](const std::vector<int>& blocks, const std::vector<double>& values)
  {
    for (std::size_t b = 0; b < blocks.size(); ++b)
    {
      potential[blocks[b]] = values[b];
    }
  };
  std::vector<double> values = toValues(pick(this->LocalBlocks));
  this->Local.Solve(values);
  put(this->LocalBlocks, values);
  if (this->HasShared)
  {
    values = toValues(this->Ways.ToHome(pick(this->SharedBlocks), 1, AddTo));
    this->AtHome.Solve(values);
    put(this->SharedBlocks, this->Ways.FromHome(std::move(values), 1));
  }
  return potential;
}

} // namespace vfm
