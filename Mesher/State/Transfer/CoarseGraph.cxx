#include "State/Transfer/CoarseGraph.h"

#include "Base/Sorted.h"

#include <cmath>
#include <tuple>

namespace vfm
{
namespace
{

// Smallest width of a block in cells, and largest number of blocks of all ranks.
constexpr Index SmallestBlock = 4, MaximumBlocks = 4000;
// Relative increase of the diagonal. It makes the matrix regular, because potentials are determined
// only up to a constant.
constexpr double Hold = 1e-6;
constexpr int BitsOfWidth = 40;

using BlockName = std::array<Index, 4>; // connected component, position in blocks

BlockName NameOf(const FlowGraph& graph, std::size_t node, Index size)
{
  const Index3& p = graph.Places[node];
  return { { graph.Pieces[node], p[0] / size, p[1] / size, p[2] / size } };
}

/// Returns the sorted names of the blocks of all ranks. Collective.
std::vector<BlockName> GatherNames(const FlowGraph& graph, Index size, Ranks& ranks)
{
  std::vector<BlockName> names;
  for (std::size_t i = 0; i < graph.Nodes.size(); ++i)
  {
    names.push_back(NameOf(graph, i, size));
  }
  SortUnique(names);
  names = GatherItems(ranks, names);
  SortUnique(names);
  return names;
}

struct Link
{
  Index From, To;
  std::int64_t Width;
  bool operator<(const Link& other) const
  {
    return std::tie(this->From, this->To) < std::tie(other.From, other.To);
  }
};

/// Merges links between the same blocks.
void JoinLinks(std::vector<Link>& links)
{
  std::sort(links.begin(), links.end());
  std::size_t count = 0;
  for (const Link& link : links)
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

} // namespace

CoarseGraph::CoarseGraph(const FlowGraph& graph, Ranks& ranks)
{
  this->Number(graph, ranks);
  this->MakeMatrix(graph, ranks);
}

void CoarseGraph::Number(const FlowGraph& graph, Ranks& ranks)
{
  Index size = SmallestBlock;
  std::vector<BlockName> names = GatherNames(graph, size, ranks);
  for (std::size_t before = 0; names.size() > MaximumBlocks && names.size() != before;)
  {
    before = names.size();
    size *= 2;
    names = GatherNames(graph, size, ranks);
  }
  this->Blocks = static_cast<int>(names.size());
  for (std::size_t b = 0; b <= names.size(); ++b)
  {
    if (b == 0 || b == names.size() || names[b][0] != names[b - 1][0])
    {
      this->Pieces.push_back(static_cast<Index>(b));
    }
  }
  std::vector<double> blocks(graph.Nodes.size() + graph.Copies);
  for (std::size_t i = 0; i < graph.Nodes.size(); ++i)
  {
    blocks[i] = static_cast<double>(FindSorted(names, NameOf(graph, i, size)));
  }
  graph.Update(blocks);
  this->BlockOfNode.assign(blocks.begin(), blocks.end());
}

void CoarseGraph::MakeMatrix(const FlowGraph& graph, Ranks& ranks)
{
  double widest = 0.0;
  for (const FlowNode& node : graph.Nodes)
  {
    widest = std::max(widest, *std::max_element(node.Widths.begin(), node.Widths.end()));
  }
  widest = ranks.Max(widest);
  const double unit = widest > 0.0 ? std::ldexp(1.0, std::ilogb(widest) - BitsOfWidth) : 1.0;
  std::vector<Link> links;
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
  links = GatherItems(ranks, links);
  JoinLinks(links);
  std::vector<double> diagonal(this->Blocks, 0.0);
  std::vector<Eigen::Triplet<double>> entries;
  for (const Link& link : links)
  {
    const double width = static_cast<double>(link.Width) * unit;
    diagonal[link.From] += width;
    entries.emplace_back(static_cast<int>(link.From), static_cast<int>(link.To), -width);
  }
  for (int b = 0; b < this->Blocks; ++b)
  {
    entries.emplace_back(b, b, diagonal[b] > 0.0 ? (1.0 + Hold) * diagonal[b] : widest + 1.0);
  }
  Eigen::SparseMatrix<double> matrix(this->Blocks, this->Blocks);
  matrix.setFromTriplets(entries.begin(), entries.end());
  this->Factors.compute(matrix);
}

/// Subtracts the mean of each connected component. A total excess of a component, due to rounding,
/// cannot flow anywhere.
void CoarseGraph::Centre(Eigen::VectorXd& values) const
{
  for (std::size_t p = 0; p + 1 < this->Pieces.size(); ++p)
  {
    const Index begin = this->Pieces[p], count = this->Pieces[p + 1] - begin;
    values.segment(begin, count).array() -= values.segment(begin, count).mean();
  }
}

const Eigen::VectorXd& CoarseGraph::Solve(Eigen::VectorXd excess)
{
  this->Centre(excess);
  this->Potential = this->Factors.solve(excess);
  this->Centre(this->Potential);
  return this->Potential;
}

} // namespace vfm
