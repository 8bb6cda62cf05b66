#include "Meshes/Decks/DeckParts.h"

namespace vfm
{

void WriteNodeLines(
  DeckCards& cards, const MeshData& mesh, std::size_t numberWidth, std::size_t realWidth)
{
  for (Index point = 0; point < mesh.NumberOfPoints; ++point)
  {
    cards.Integer(point + 1, numberWidth);
    for (int axis = 0; axis < 3; ++axis)
    {
      cards.Real(mesh.Point(point)[axis], realWidth);
    }
    cards.End();
  }
}

void WriteNumbers(
  DeckCards& cards, const std::vector<Index>& points, std::size_t inLine, std::size_t width)
{
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    cards.Integer(points[p] + 1, width);
    if ((p + 1) % inLine == 0 || p + 1 == points.size())
    {
      cards.End();
    }
  }
}

void WriteFace(DeckCards& cards, const MeshData& mesh, const ElementSide& side, std::size_t width)
{
  Index last = -1;
  for (Index point : PointsOfSide(mesh, side))
  {
    last = point < 0 ? last : point;
    cards.Integer(last + 1, width);
  }
  cards.End();
}

} // namespace vfm
