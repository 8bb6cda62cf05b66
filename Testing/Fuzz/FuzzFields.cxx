#include "FuzzFields.h"

#include "MeshChecks.h"
#include "RankFields.h"
#include "RankMeshes.h"
#include "Shapes/ShapesFractions.h"
#include "Shapes/ShapesScenes.h"

namespace vfm
{
namespace testing
{
namespace
{

constexpr double ShapeTolerance = 1e-2; // shapes need not be exact here

using Parts = std::vector<FractionField::Part>;

/// Returns a field with partsOf(cell) of each cell.
FractionField FillCells(
  const CartesianGrid& grid, int materials, const std::function<Parts(const Index3&)>& partsOf)
{
  FractionField field(grid, materials);
  ForCells(grid.Local(),
    [&](const Index3& p)
    {
      const Parts parts = partsOf(p);
      if (!parts.empty())
      {
        field.SetParts(grid.Linear(p), parts);
      }
    });
  return field;
}

/// Returns the parts of a cell of one label and a share of another. Either may
/// be void, and both may be equal.
Parts MixTwo(int label, int other, double share)
{
  Parts parts;
  for (int m : { std::min(label, other), std::max(label, other) })
  {
    const double fraction = label == other ? 1.0 : (m == other ? share : 1.0 - share);
    if (m > 0 && fraction > 0.0 && (parts.empty() || parts[0].Material != m))
    {
      parts.push_back({ m, fraction });
    }
  }
  return parts;
}

Vector3 DrawPoint(const CartesianGrid& grid, double margin, RandomDraw& draw)
{
  Vector3 x;
  for (int a = 0; a < 3; ++a)
  {
    const double size = static_cast<double>(grid.Global().Upper[a]);
    x[a] = draw.Between(-margin * size, (1.0 + margin) * size);
  }
  return x;
}

Vector3 DrawAngles(RandomDraw& draw)
{
  Vector3 angles{ { 0, 0, 0 } };
  const bool isTurned = draw.Chance(0.7);
  for (double& angle : angles)
  {
    angle = isTurned ? draw.Between(-180.0, 180.0) : 0.0;
  }
  return angles;
}

/// Returns a random direction, sometimes along an axis.
Vector3 DrawNormal(RandomDraw& draw)
{
  Vector3 normal{ { 0, 0, 0 } };
  if (draw.Chance(0.3))
  {
    normal[draw.Whole(0, 2)] = draw.Pick({ 1.0, -1.0 });
    return normal;
  }
  for (double& n : normal)
  {
    n = draw.Between(-1.0, 1.0);
  }
  return normal;
}

/// Returns a shape of a size given in cells. The grid of shapes has unit cells; the widths of
/// the actual cells stretch them.
Shape DrawShape(const CartesianGrid& grid, int material, RandomDraw& draw)
{
  const Index3& n = grid.Global().Upper;
  const double most = 0.7 * static_cast<double>(std::max({ n[0], n[1], n[2] }));
  const auto size = [&] { return draw.Scale(0.3, std::max(most, 0.6)); };
  const Vector3 at = DrawPoint(grid, 0.1, draw);
  switch (draw.Whole(0, 7))
  {
    case 0:
      return MakeSphere(material, at, size());
    case 1:
      return MakeEllipsoid(material, at, { { size(), size(), size() } }, DrawAngles(draw));
    case 2:
      return MakeBox(material, at, { { size(), size(), size() } }, DrawAngles(draw));
    case 3:
      return MakeCylinder(material, at, 0.5 * size(), 2.0 * size(), DrawAngles(draw));
    case 4:
      return MakeCone(material, at, size(), 0.0, 2.0 * size(), DrawAngles(draw));
    case 5:
    {
      const double ring = size();
      return MakeTorus(material, at, ring, ring * draw.Between(0.2, 0.9), DrawAngles(draw));
    }
    case 6:
      return MakeHalfSpace(material, at, DrawNormal(draw));
    default:
      return MakeGyroid(
        material, at, draw.Scale(3.0, 12.0), draw.Between(-0.5, 0.5), DrawAngles(draw));
  }
}

/// Returns unit cells: the fields of two grids of one size have the same places.
CartesianGrid UnitCells(const CartesianGrid& grid)
{
  const Index3& n = grid.Global().Upper;
  return MakeUnitGrid(n[0], n[1], n[2]);
}

FractionField DrawShapes(const CartesianGrid& grid, int materials, RandomDraw& draw)
{
  const CartesianGrid unit = UnitCells(grid);
  std::vector<Shape> shapes;
  for (int m = 1; m <= materials; ++m)
  {
    for (int count = draw.Whole(1, 2); count > 0; --count)
    {
      shapes.push_back(DrawShape(unit, m, draw));
    }
  }
  return FractionsOfShapes(unit, shapes, materials, ShapeTolerance);
}

FractionField DrawPlates(const CartesianGrid& grid, int materials, RandomDraw& draw)
{
  const CartesianGrid unit = UnitCells(grid);
  std::vector<Shape> shapes;
  for (int m = 1; m <= materials; ++m)
  {
    shapes.push_back(
      MakePlate(m, DrawPoint(unit, -0.1, draw), DrawNormal(draw), draw.Scale(0.05, 2.5)));
  }
  return FractionsOfShapes(unit, shapes, materials, ShapeTolerance);
}

FractionField DrawGrains(const CartesianGrid& grid, int materials, RandomDraw& draw)
{
  const CartesianGrid unit = UnitCells(grid);
  const Index3& n = grid.Global().Upper;
  const Vector3 upper{ { 1.0 * n[0], 1.0 * n[1], 1.0 * n[2] } };
  return FractionsOfShapes(unit, MakePolycrystal(1, { { 0, 0, 0 } }, upper, materials, draw.Seed()),
    materials, ShapeTolerance);
}

/// Returns random fractions, many of them small.
FractionField DrawNoise(const CartesianGrid& grid, int materials, RandomDraw& draw)
{
  const double power = draw.Pick({ 0.5, 1.0, 3.0 }), ofVoid = draw.Pick({ 0.0, 0.5, 1.0 });
  return FillCells(grid, materials,
    [&](const Index3&)
    {
      Parts parts;
      double sum = ofVoid * draw.Between(0.0, 1.0);
      for (int m = 1; m <= materials; ++m)
      {
        parts.push_back({ m, std::pow(draw.Between(0.0, 1.0), power) });
        sum += parts.back().Fraction;
      }
      for (FractionField::Part& part : parts)
      {
        part.Fraction /= sum;
      }
      return parts;
    });
}

/// Returns blocks of materials in turn, whose length differs along each axis.
FractionField DrawCheckerboard(const CartesianGrid& grid, int materials, RandomDraw& draw)
{
  Index3 step;
  for (Index& s : step)
  {
    s = draw.Pick<Index>({ 1, 1, 2, 3, 100 });
  }
  const double share = draw.Pick({ 0.0, 0.0, 0.3, 0.49 });
  return FillCells(grid, materials,
    [&](const Index3& p)
    {
      const int block = static_cast<int>(p[0] / step[0] + p[1] / step[1] + p[2] / step[2]);
      return MixTwo(block % (materials + 1), (block + 1) % (materials + 1), share);
    });
}

/// Returns unresolved material: single cells, isolated or diagonal to each
/// other, in void or a material.
FractionField DrawSpray(const CartesianGrid& grid, int materials, RandomDraw& draw)
{
  const double chance = draw.Scale(0.01, 0.3);
  const int around = draw.Whole(0, 1);
  return FillCells(grid, materials,
    [&](const Index3&)
    {
      return draw.Chance(chance)
        ? MixTwo(around, draw.Whole(1, materials), draw.Pick({ 1e-9, 0.1, 0.5, 0.51, 0.9, 1.0 }))
        : MixTwo(around, around, 0.0);
    });
}

/// Returns labels with a tiny fraction of another material in each cell, and random ties.
FractionField DrawNearlyPure(const CartesianGrid& grid, int materials, RandomDraw& draw)
{
  const double hair = draw.Scale(1e-15, 1e-3), tie = draw.Pick({ 0.0, 0.0, 0.3 });
  return FillCells(grid, materials,
    [&](const Index3&)
    {
      const int label = draw.Whole(0, materials), other = draw.Whole(0, materials);
      return MixTwo(label, other, draw.Chance(tie) ? 0.5 + draw.Pick({ -hair, 0.0, hair }) : hair);
    });
}

/// Returns void, or one material, everywhere or except in one cell.
FractionField DrawNothing(const CartesianGrid& grid, int materials, RandomDraw& draw)
{
  const int label = draw.Whole(0, 1), other = draw.Whole(0, materials);
  Index3 single;
  for (int a = 0; a < 3; ++a)
  {
    single[a] = draw.Whole(0, static_cast<int>(grid.Global().Upper[a]) - 1);
  }
  return FillCells(grid, materials,
    [&](const Index3& p) { return MixTwo(label, p == single ? other : label, 1.0); });
}

} // namespace

FractionField DrawField(
  const CartesianGrid& grid, int materials, RandomDraw& draw, std::string& words)
{
  const int kind = draw.Whole(0, 12);
  static const char* const Names[] = { "shapes", "shapes", "shapes", "plates", "grains", "labels",
    "labels without void", "noise", "patches", "checkerboard", "spray", "nearly pure", "nothing" };
  words = Names[kind];
  switch (kind)
  {
    case 3:
      return DrawPlates(grid, materials, draw);
    case 4:
      return DrawGrains(grid, materials, draw);
    case 5:
      return MakeRandomLabels(grid, materials, 0, draw.Seed());
    case 6:
      return MakeRandomLabels(grid, materials, 1, draw.Seed());
    case 7:
      return DrawNoise(grid, materials, draw);
    case 8:
      return MakePatchyFractions(grid, materials, draw.Seed());
    case 9:
      return DrawCheckerboard(grid, materials, draw);
    case 10:
      return DrawSpray(grid, materials, draw);
    case 11:
      return DrawNearlyPure(grid, materials, draw);
    case 12:
      return DrawNothing(grid, materials, draw);
    default:
      return DrawShapes(grid, materials, draw);
  }
}

} // namespace testing
} // namespace vfm
