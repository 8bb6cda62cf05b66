#include "Smoothing/Hex/ActiveCorners.h"

#include "Base/HexNumbering.h"

namespace vfm
{

ActiveCorners::ActiveCorners(const ActiveMesh& active, Mesh& mesh)
{
  const Index hexes = static_cast<Index>(mesh.ElementIds.size());
  const Index count = static_cast<Index>(active.Elements.size()) / 8;
  if (2 * count < hexes)
  {
    return;
  }
  this->Hexes = hexes;
  this->Runs.push_back({ 0, 0 });
  this->Others.reserve(8 * (hexes - count));
  Index next = 0; // active hex
  const auto isNext = [&](const Index* corners)
  {
    if (next == count)
    {
      return false;
    }
    const int* points = active.Elements.data() + 8 * next;
    for (int c = 0; c < 8; ++c)
    {
      if (active.MeshPoint[points[c]] != corners[VtkCorner[c]])
      {
        return false;
      }
    }
    return true;
  };
  for (Index hex = 0; hex < hexes; ++hex)
  {
    const Index* corners = mesh.Elements.data() + 8 * hex;
    const bool isActive = isNext(corners);
    if (isActive != (this->Runs.size() % 2 == 1))
    {
      this->Runs.push_back({ hex, isActive ? next : hex - next });
    }
    if (isActive)
    {
      ++next;
    }
    else
    {
      this->Others.insert(this->Others.end(), corners, corners + 8);
    }
  }
  mesh.Elements = Buffer<Index>();
}

void ActiveCorners::Restore(const std::vector<int>& elements, const std::vector<int>& meshPoints,
  Runtime& runtime, Mesh& mesh) const
{
  if (this->Hexes == 0)
  {
    return;
  }
  mesh.Elements = Buffer<Index>(8 * this->Hexes);
  runtime.For(0, this->Hexes,
    [&](Index first, Index last)
    {
      auto run = std::upper_bound(this->Runs.begin(), this->Runs.end(), first,
        [](Index hex, const Run& r) { return hex < r.First; });
      for (Index hex = first; hex < last; ++hex)
      {
        while (run != this->Runs.end() && run->First <= hex)
        {
          ++run;
        }
        const Index at = (run - 1)->Start + hex - (run - 1)->First;
        Index* corners = mesh.Elements.data() + 8 * hex;
        if ((run - this->Runs.begin()) % 2 == 1)
        {
          const int* points = elements.data() + 8 * at;
          for (int c = 0; c < 8; ++c)
          {
            corners[VtkCorner[c]] = meshPoints[points[c]];
          }
        }
        else
        {
          std::copy_n(this->Others.data() + 8 * at, 8, corners);
        }
      }
    });
}

} // namespace vfm
