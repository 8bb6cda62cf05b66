#include "FragmentParts.h"

#include <numeric>

namespace vfm
{

FragmentParts::FragmentParts(const Mesh& mesh) : TheMesh(mesh), Order(mesh.Fragment.size())
{
  const Buffer<int>& fragments = mesh.Fragment;
  const int largest = fragments.empty() ? 0 : *std::max_element(fragments.begin(), fragments.end());
  this->First.assign(largest + 2, 0);
  for (int fragment : fragments)
  {
    ++this->First[fragment + 1];
  }
  std::partial_sum(this->First.begin(), this->First.end(), this->First.begin());
  std::vector<Index> next = this->First;
  for (std::size_t e = 0; e < fragments.size(); ++e)
  {
    this->Order[next[fragments[e]]++] = static_cast<Index>(e);
  }
}

FragmentParts::Part FragmentParts::Get(int fragment) const
{
  Part part;
  if (fragment + 1 >= static_cast<int>(this->First.size()))
  {
    return part;
  }
  part.Elements.assign(
    this->Order.begin() + this->First[fragment], this->Order.begin() + this->First[fragment + 1]);
  const int corners = this->TheMesh.Corners;
  for (Index element : part.Elements)
  {
    const Index* points = this->TheMesh.Elements.data() + corners * element;
    part.Points.insert(part.Points.end(), points, points + corners);
  }
  std::sort(part.Points.begin(), part.Points.end());
  part.Points.erase(std::unique(part.Points.begin(), part.Points.end()), part.Points.end());
  return part;
}

} // namespace vfm
