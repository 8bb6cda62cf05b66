#include "NearestTriangle.h"

namespace vfm
{
namespace testing
{
namespace
{

double DistanceToSegment(const Vector3& x, const Vector3& a, const Vector3& b)
{
  const Vector3 along = b - a;
  const double square = Dot(along, along);
  const double t = square > 0.0 ? Dot(x - a, along) / square : 0.0;
  return Norm(x - a - std::min(1.0, std::max(0.0, t)) * along);
}

} // namespace

double DistanceToTriangle(const Vector3& x, const NearestTriangle::Corners& t)
{
  const Vector3 normal = Unit(Cross(t[1] - t[0], t[2] - t[0]));
  bool isOver = Dot(normal, normal) > 0.0;
  double nearest = 1e300;
  for (int c = 0; c < 3; ++c)
  {
    const Vector3 &a = t[c], &b = t[(c + 1) % 3];
    isOver = isOver && Dot(Cross(b - a, x - a), normal) >= 0.0;
    nearest = std::min(nearest, DistanceToSegment(x, a, b));
  }
  return isOver ? std::fabs(Dot(x - t[0], normal)) : nearest;
}

NearestTriangle::Ball NearestTriangle::BallAround(const Corners& triangle)
{
  Ball ball{ 1.0 / 3.0 * (triangle[0] + triangle[1] + triangle[2]), 0.0 };
  for (const Vector3& corner : triangle)
  {
    ball.Radius = std::max(ball.Radius, Norm(corner - ball.Centre));
  }
  return ball;
}

NearestTriangle::NearestTriangle(std::vector<Corners> triangles, double binWidth) :
  Triangles(std::move(triangles)), Lower(this->Triangles[0][0]), Width(binWidth)
{
  Vector3 upper = this->Lower;
  for (const Corners& triangle : this->Triangles)
  {
    this->Balls.push_back(BallAround(triangle));
    for (const Vector3& corner : triangle)
    {
      for (int a = 0; a < 3; ++a)
      {
        this->Lower[a] = std::min(this->Lower[a], corner[a]);
        upper[a] = std::max(upper[a], corner[a]);
      }
    }
  }
  this->Box = { { { 0, 0, 0 } }, this->BinOf(upper) };
  for (Index& end : this->Box.Upper)
  {
    ++end;
  }
  this->Members = MakeGroups<int>(this->Box.NumberOfCells(),
    [this](const auto& visit)
    {
      for (std::size_t t = 0; t < this->Triangles.size(); ++t)
      {
        ForCells(this->BinsOf(this->Triangles[t]),
          [&](const Index3& bin) { visit(IndexInBox(this->Box, bin), static_cast<int>(t)); });
      }
    });
}

Index3 NearestTriangle::BinOf(const Vector3& x) const
{
  Index3 bin;
  for (int a = 0; a < 3; ++a)
  {
    bin[a] = static_cast<Index>(std::floor((x[a] - this->Lower[a]) / this->Width));
  }
  return bin;
}

IndexBox NearestTriangle::BinsOf(const Corners& triangle) const
{
  IndexBox bins{ this->BinOf(triangle[0]), this->BinOf(triangle[0]) };
  for (const Vector3& corner : triangle)
  {
    const Index3 bin = this->BinOf(corner);
    for (int a = 0; a < 3; ++a)
    {
      bins.Lower[a] = std::min(bins.Lower[a], bin[a]);
      bins.Upper[a] = std::max(bins.Upper[a], bin[a] + 1);
    }
  }
  return bins;
}

double NearestTriangle::Distance(const Vector3& x) const
{
  const int nearest = this->Find(x, [](int, double distance) { return distance; });
  return DistanceToTriangle(x, this->Triangles[nearest]);
}

int NearestTriangle::Find(const Vector3& x, const std::function<double(int, double)>& badness) const
{
  double least = 1e300;
  int found = -1;
  const Index3 middle = this->BinOf(x);
  // A triangle in no bin within `reach` bins of x is farther away than reach widths.
  for (Index reach = 0; least > (reach - 1) * this->Width; ++reach)
  {
    IndexBox bins;
    for (int a = 0; a < 3; ++a)
    {
      bins.Lower[a] = middle[a] - reach;
      bins.Upper[a] = middle[a] + reach + 1;
    }
    ForCells(Intersect(bins, this->Box),
      [&](const Index3& bin)
      {
        Index away = 0;
        for (int a = 0; a < 3; ++a)
        {
          away = std::max(away, std::abs(bin[a] - middle[a]));
        }
        const Index group = IndexInBox(this->Box, bin);
        for (Index m = this->Members.Begin[group];
             away == reach && m < this->Members.Begin[group + 1]; ++m)
        {
          const int triangle = this->Members.Items[m];
          if (Norm(x - this->Balls[triangle].Centre) - this->Balls[triangle].Radius >= least)
          {
            continue;
          }
          const double bad = badness(triangle, DistanceToTriangle(x, this->Triangles[triangle]));
          if (bad < least)
          {
            least = bad;
            found = triangle;
          }
        }
      });
  }
  return found;
}

} // namespace testing
} // namespace vfm
