#include "Input/InputFields.h"

#include "Input/InputRoute.h"
#include "Input/MakePartition.h"
#include "Ranks/Agreement.h"

namespace vfm
{

std::vector<Index3> InputCells::FindInterfaceCells() const
{
  std::vector<Index3> found;
  for (std::size_t block = 0; block < this->Input.Blocks.size(); ++block)
  {
    vfm::FindInterfaceCells(
      this->Input.Blocks[block].Box,
      [&](const Index3& first, Index count, int* materials)
      { this->ReadMaterials(block, first, count, materials); },
      found);
  }
  return found;
}

namespace
{

Bytes PackFor(const IndexBox& requested, const InputBlocks& input, const InputCells& cells)
{
  std::vector<SparseCells> packets;
  for (std::size_t block = 0; block < input.Blocks.size(); ++block)
  {
    const IndexBox box = Intersect(input.Blocks[block].Box, requested);
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
