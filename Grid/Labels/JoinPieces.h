/**
 * JoinPieces: joins the local components of all ranks into fragments, without a list of all
 * components on any rank.
 */
#pragma once

#include "Labels/FragmentShare.h"

namespace vfm
{

/// Local component: a connected part of a fragment on one rank. It consists of cells (Fragments)
/// or of elements (TetFragments.h).
struct Piece
{
  Index Lowest; ///< id of the lowest cell or element; components of different fragments differ
  Index Label;
};
/// Pairs of local components. Component i of rank r has the number OffsetOfRank + i.
using PiecePairs = std::vector<std::array<Index, 2>>;

/// Returns the number of the first local component of this rank. Not collective.
inline Index OffsetOfRank(const Ranks& ranks)
{
  return static_cast<Index>(ranks.Rank()) << 32;
}

/// The fragments of a rank and of its components.
struct JoinedPieces
{
  FragmentShare Share;
  std::vector<int> Fragments; ///< of each local component, as numbered on this rank
  int Rounds = 0;             ///< of messages to peers
  int Shortcuts = 0;          ///< rounds that also took labels from far away
};

/// Joins the local components of all ranks into fragments, which are numbered from 1 by their
/// lowest cell or element.
/// @param mine  local components of this rank
/// @param same  pairs of a component of this rank and one of this rank or a peer that belong to
///   one fragment. The peer need not list the pair too.
/// @param peers  ranks that may be in pairs, of both directions: if a is a peer of b, b is one of a
/// @pre Collective. Throws an InputError on all ranks if there are 2^31 fragments or more.
JoinedPieces JoinPieces(const std::vector<Piece>& mine, const PiecePairs& same,
  const std::vector<int>& peers, Ranks& ranks);

} // namespace vfm
