/**
 * WriteConnections: contact pairs and ties between both sides of split interfaces, for Abaqus and
 * CalculiX.
 */
#pragma once

#include "Meshes/Decks/AbaqusText.h"
#include "Meshes/Decks/DeckModel.h"
#include "Meshes/Files/OutputFile.h"

namespace vfm
{

/// A surface of the file: a side set with its name there.
struct DeckSurface
{
  std::string Name;
  const SideSet* Set;
};

/// A node that takes the displacement of the other side.
struct TiedNode
{
  std::array<int, 2> Materials; ///< of the node and of the other side, the lower one first
  Index Node;                   ///< point of the mesh
};

/// Ties that connect all copies of each node.
struct NodeTies
{
  std::vector<TiedNode> Nodes; ///< each node once, ascending by materials and node
  /// Pairs of nodes with equal displacements, for copies that Nodes does not connect, as where four
  /// fragments meet at a line. The first node of a pair is the first of no other pair and not in
  /// Nodes.
  std::vector<std::array<Index, 2>> Equal;
};

/// Finds the ties; none unless the connection of the model is Tied. The node of the lower material
/// depends on the other side. A node of several interfaces depends on the first of them, because a
/// solver allows one constraint per node.
NodeTies FindNodeTies(const DeckModel& model);

/// Returns the set without nodes that follow other nodes, on which solvers reject conditions.
NodeSet RemoveTiedNodes(NodeSet set, const NodeTies& ties);

/// Writes the connection of the model: Contact or Tied.
/// - Contact: *CONTACT PAIR of the two surfaces of each pair, the lower material as slave, with a
///   *SURFACE INTERACTION of the same name, hard and without friction
/// - Tied: *TIE of the nodes of the lower material to the surface of the other, and *EQUATION for
///   NodeTies::Equal
/// @param surfaces  surfaces of the file
void WriteConnections(const DeckModel& model, const NodeTies& ties,
  const std::vector<DeckSurface>& surfaces, AbaqusNames& names, OutputFile& file);

} // namespace vfm
