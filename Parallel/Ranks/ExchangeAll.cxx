#include "Ranks/ExchangeAll.h"

#include <numeric>

namespace vfm
{

std::vector<Bytes> ExchangeAll(std::vector<Bytes> messages, Ranks& ranks)
{
  std::vector<int> peers(ranks.Count());
  std::iota(peers.begin(), peers.end(), 0);
  peers.erase(peers.begin() + ranks.Rank());
  Bytes own = std::move(messages[ranks.Rank()]);
  messages.erase(messages.begin() + ranks.Rank());
  std::vector<Bytes> incoming = ranks.Exchange(peers, messages);
  incoming.insert(incoming.begin() + ranks.Rank(), std::move(own));
  return incoming;
}

} // namespace vfm
