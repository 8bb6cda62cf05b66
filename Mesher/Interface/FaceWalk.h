/**
 * FaceWalk: finds the interface faces of a pair of labels around nodes, one node after another.
 */
#pragma once

#include "Interface/Interface.h"

namespace vfm
{

/// Search on one interface; each thread needs its own. Keeps a reference to the interface.
class FaceWalk
{
public:
  explicit FaceWalk(const Interface& interface) :
    Source(interface),
    NodeWalks(interface.Nodes().size(), 0),
    FaceWalks(interface.Faces().size(), 0)
  {
  }

  /// Returns the faces of a pair at all nodes that are connected to a node by such faces and
  /// allowed nodes. Each face is listed once, in an order that depends only on the faces.
  /// @param node  position in Interface::Nodes()
  /// @param rings  largest number of faces on the way to a node
  /// @param allowed  allowed(position in Interface::Nodes())
  /// @return valid until the next call
  template <class Allowed>
  const std::vector<int>& Find(Index node, int first, int second, int rings, const Allowed& allowed)
  {
    ++this->Walk;
    this->NodeWalks[node] = this->Walk;
    this->Nodes.assign(1, static_cast<int>(node));
    this->Faces.clear();
    std::size_t next = 0;
    for (int ring = 0; ring <= rings; ++ring)
    {
      for (const std::size_t end = this->Nodes.size(); next < end; ++next)
      {
        this->AddFacesAt(this->Nodes[next], first, second, ring < rings, allowed);
      }
    }
    return this->Faces;
  }

private:
  template <class Allowed>
  void AddFacesAt(Index node, int first, int second, bool addCorners, const Allowed& allowed)
  {
    const int* faces = this->Source.FaceList().data();
    for (Index at = this->Source.FaceOffset(node); at < this->Source.FaceOffset(node + 1); ++at)
    {
      const int face = faces[at];
      const InterfaceFace& f = this->Source.Faces()[face];
      if (this->FaceWalks[face] == this->Walk || f.First() != first || f.Second() != second)
      {
        continue;
      }
      this->FaceWalks[face] = this->Walk;
      this->Faces.push_back(face);
      for (std::size_t c = 0; addCorners && c < 4; ++c)
      {
        const int corner = this->Source.CornersOfFace(face)[c];
        if (this->NodeWalks[corner] != this->Walk && allowed(corner))
        {
          this->NodeWalks[corner] = this->Walk;
          this->Nodes.push_back(corner);
        }
      }
    }
  }

  const Interface& Source;
  int Walk = 0;
  std::vector<int> NodeWalks, FaceWalks; // number of the last walk that visited each
  std::vector<int> Nodes, Faces;
};

} // namespace vfm
