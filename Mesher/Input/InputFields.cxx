#include "Input/InputFields.h"

#include "Input/InputRoute.h"
#include "Ranks/Agreement.h"

namespace vfm
{

std::vector<Index3> InputCells::FindInterfaceCells() const
{
  std::vector<Index3> found;
  for (std::size_t block = 0; block < this->Input.Blocks.size(); ++block)
  {
    this->FindInterfaceCells(block, found);
  }
  return found;
}

void InputCells::FindInterfaceCells(std::size_t block, std::vector<Index3>& found) const
{
  const IndexBox& box = this->Input.Blocks[block].Box;
  const Index n = box.Size(0), plane = n * box.Size(1);
  std::vector<int> last(plane),
    row(n); // last: previous rows of this plane, then the remaining rows of the previous plane
  ForRows(box,
    [&](Index j, Index k)
    {
      int* below = last.data() + (j - box.Lower[1]) * n;
      this->ReadMaterials(block, { { box.Lower[0], j, k } }, n, row.data());
      for (Index i = 0; i < n; ++i)
      {
        const int material = row[i];
        if (material == Mixed || (i > 0 && row[i - 1] != material) ||
          (j > box.Lower[1] && below[i - n] != material) ||
          (k > box.Lower[2] && below[i] != material))
        {
          found.push_back({ { box.Lower[0] + i, j, k } });
        }
      }
      std::copy(row.begin(), row.end(), below);
    });
}

namespace
{

Bytes PackFor(const IndexBox& requested, const InputBlocks& input, const InputCells& cells)
{
  std::vector<SparseCells> packets;
  for (const InputBlock& block : input.Blocks)
  {
    const IndexBox box = Intersect(block.Box, requested);
    if (box.NumberOfCells() > 0)
    {
      packets.push_back(cells.Extract(block, box));
    }
  }
  return PackCells(packets);
}

} // namespace

std::vector<SparseCells> ReceiveCells(const std::vector<BlockPlace>& owners,
  const InputBlocks& input, const InputCells& cells, Index ghostLayers, Ranks& ranks)
{
  const InputRoute route = FindInputRoute(owners, input, ranks.Rank(), ghostLayers);
  std::vector<Bytes> outgoing;
  WorkTogether(ranks,
    [&]
    {
      for (const IndexBox& requested : route.Requested)
      {
        outgoing.push_back(PackFor(requested, input, cells));
      }
    });
  std::vector<SparseCells> received;
  for (const Bytes& message : ranks.Exchange(route.Peers, outgoing))
  {
    for (SparseCells& packet : UnpackCells(message))
    {
      received.push_back(std::move(packet));
    }
  }
  return received;
}

} // namespace vfm
