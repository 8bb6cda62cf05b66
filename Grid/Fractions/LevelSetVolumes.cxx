#include "Fractions/LevelSetVolumes.h"

#include <algorithm>

namespace vfm
{
namespace
{

using Four = std::array<double, 4>;

/// The corners of the tetrahedra around the diagonal of a box.
constexpr int TetCorners[6][4] = { { 0, 1, 3, 7 }, { 0, 1, 5, 7 }, { 0, 2, 3, 7 }, { 0, 2, 6, 7 },
  { 0, 4, 5, 7 }, { 0, 4, 6, 7 } };

/// A part of a tetrahedron, itself a tetrahedron.
struct TetPart
{
  std::array<Four, 4> Corners; ///< each as weights of the corners of the whole
  double Volume;
};

int CountNegative(const Four& values)
{
  int count = 0;
  for (double value : values)
  {
    count += value < 0.0;
  }
  return count;
}

/// Returns the four positions, those of negative values first.
std::array<int, 4> NegativeFirst(const Four& values)
{
  std::array<int, 4> order{};
  int next = 0;
  for (int pass = 0; pass < 2; ++pass)
  {
    for (int i = 0; i < 4; ++i)
    {
      if ((values[i] < 0.0) == (pass == 0))
      {
        order[next++] = i;
      }
    }
  }
  return order;
}

/// Returns where a linear function is zero between two corners of different sign, from a on.
double ZeroBetween(double a, double b)
{
  return a / (a - b);
}

/// Returns the share of a tetrahedron where a linear function is negative.
double NegativeShare(const Four& values)
{
  const std::array<int, 4> order = NegativeFirst(values);
  const Four f{ { values[order[0]], values[order[1]], values[order[2]], values[order[3]] } };
  switch (CountNegative(values))
  {
    case 0:
      return 0.0;
    case 1:
      return ZeroBetween(f[0], f[1]) * ZeroBetween(f[0], f[2]) * ZeroBetween(f[0], f[3]);
    case 2:
    {
      const double ac = ZeroBetween(f[0], f[2]), ad = ZeroBetween(f[0], f[3]);
      const double bc = ZeroBetween(f[1], f[2]), bd = ZeroBetween(f[1], f[3]);
      return bc * bd + ac * (1.0 - bc) * bd + ac * ad * (1.0 - bd);
    }
    case 3:
      return 1.0 - ZeroBetween(f[3], f[0]) * ZeroBetween(f[3], f[1]) * ZeroBetween(f[3], f[2]);
    default:
      return 1.0;
  }
}

Four Between(const Four& a, const Four& b, double share)
{
  Four point{};
  for (int i = 0; i < 4; ++i)
  {
    point[i] = (1.0 - share) * a[i] + share * b[i];
  }
  return point;
}

/// Calls visit(part) for tetrahedra that fill the part where a linear function is negative.
/// @param values  of the function at the corners of the part
template <class Visit>
void VisitNegative(const TetPart& part, const Four& values, const Visit& visit)
{
  const std::array<int, 4> order = NegativeFirst(values);
  const auto corner = [&](int i) -> const Four& { return part.Corners[order[i]]; };
  const auto zero = [&](int i, int j) { return ZeroBetween(values[order[i]], values[order[j]]); };
  const auto cut = [&](int i, int j) { return Between(corner(i), corner(j), zero(i, j)); };
  const double all = part.Volume;
  switch (CountNegative(values))
  {
    case 0:
      return;
    case 1:
      visit(TetPart{ { { corner(0), cut(0, 1), cut(0, 2), cut(0, 3) } },
        all * zero(0, 1) * zero(0, 2) * zero(0, 3) });
      return;
    case 2: // a wedge of the triangles (a, ac, ad) and (b, bc, bd)
    {
      const double ac = zero(0, 2), ad = zero(0, 3), bc = zero(1, 2), bd = zero(1, 3);
      const Four pac = cut(0, 2), pad = cut(0, 3), pbc = cut(1, 2), pbd = cut(1, 3);
      visit(TetPart{ { { corner(0), corner(1), pbc, pbd } }, all * bc * bd });
      visit(TetPart{ { { corner(0), pac, pbc, pbd } }, all * ac * (1.0 - bc) * bd });
      visit(TetPart{ { { corner(0), pac, pad, pbd } }, all * ac * ad * (1.0 - bd) });
      return;
    }
    case 3: // a wedge of the triangles (da, db, dc) and (a, b, c)
    {
      const double da = zero(3, 0), db = zero(3, 1), dc = zero(3, 2);
      const Four pda = cut(3, 0), pdb = cut(3, 1), pdc = cut(3, 2);
      visit(TetPart{ { { pda, corner(0), corner(1), corner(2) } }, all * (1.0 - da) });
      visit(TetPart{ { { pda, pdb, corner(1), corner(2) } }, all * da * (1.0 - db) });
      visit(TetPart{ { { pda, pdb, pdc, corner(2) } }, all * da * db * (1.0 - dc) });
      return;
    }
    default:
      visit(part);
  }
}

/// The materials in one tetrahedron of a box.
class TetMaterials
{
public:
  /// @param active  positions of the functions that count, ascending
  /// @param corners  corners of the tetrahedron in the box
  TetMaterials(const std::vector<CornerValues>& functions, const std::vector<int>& active,
    const int* corners, LevelSetRule rule, std::vector<double>& volumes) :
    Functions(functions), Active(active), Corners(corners), Rule(rule), Volumes(volumes)
  {
  }

  void Add(double volume)
  {
    TetPart whole{ {}, volume };
    for (int i = 0; i < 4; ++i)
    {
      whole.Corners[i][i] = 1.0;
    }
    this->Rule == LevelSetRule::Priority ? this->AddFirst(whole, 0) : this->AddLowest(whole, 0, 1);
  }

private:
  Four ValuesOf(std::size_t a, const TetPart& part) const
  {
    const CornerValues& f = this->Functions[this->Active[a]];
    Four values{};
    for (int i = 0; i < 4; ++i)
    {
      for (int c = 0; c < 4; ++c)
      {
        values[i] += part.Corners[i][c] * f[this->Corners[c]];
      }
    }
    return values;
  }
  double& VolumeOf(std::size_t a) { return this->Volumes[this->Active[a] + 1]; }

  /// Gives each point of a part to the first negative function from position a on.
  void AddFirst(const TetPart& part, std::size_t a)
  {
    if (a == this->Active.size())
    {
      this->Volumes[0] += part.Volume;
      return;
    }
    Four values = this->ValuesOf(a, part);
    const double inside = part.Volume * NegativeShare(values);
    this->VolumeOf(a) += inside;
    if (a + 1 == this->Active.size())
    {
      this->Volumes[0] += part.Volume - inside;
      return;
    }
    VisitPositive(part, values, [&](const TetPart& outside) { this->AddFirst(outside, a + 1); });
  }

  /// Gives each point of a part to the lowest function: `best`, or one from position a on.
  void AddLowest(const TetPart& part, std::size_t best, std::size_t a)
  {
    const Four lowest = this->ValuesOf(best, part);
    if (a == this->Active.size())
    {
      const double inside =
        part.Volume * (this->Rule == LevelSetRule::Fill ? 1.0 : NegativeShare(lowest));
      this->VolumeOf(best) += inside;
      this->Volumes[0] += part.Volume - inside;
      return;
    }
    Four differences = this->ValuesOf(a, part);
    for (int i = 0; i < 4; ++i)
    {
      differences[i] -= lowest[i];
    }
    VisitNegative(
      part, differences, [&](const TetPart& lower) { this->AddLowest(lower, a, a + 1); });
    VisitPositive(
      part, differences, [&](const TetPart& higher) { this->AddLowest(higher, best, a + 1); });
  }

  /// As VisitNegative, for the part where a function is not negative.
  template <class Visit>
  static void VisitPositive(const TetPart& part, const Four& values, const Visit& visit)
  {
    if (CountNegative(values) == 0)
    {
      visit(part);
      return;
    }
    Four opposite{};
    std::transform(
      values.begin(), values.end(), opposite.begin(), [](double value) { return -value; });
    VisitNegative(part, opposite, visit);
  }

  const std::vector<CornerValues>& Functions;
  const std::vector<int>& Active;
  const int* Corners;
  LevelSetRule Rule;
  std::vector<double>& Volumes;
};

double LowestOf(const CornerValues& f)
{
  return *std::min_element(f.begin(), f.end());
}

double HighestOf(const CornerValues& f)
{
  return *std::max_element(f.begin(), f.end());
}

/// Returns the functions that can be the first negative one at a point of the box.
std::vector<int> FindFirst(const std::vector<CornerValues>& functions)
{
  std::vector<int> active;
  for (std::size_t m = 0; m < functions.size(); ++m)
  {
    if (LowestOf(functions[m]) < 0.0)
    {
      active.push_back(static_cast<int>(m));
      if (HighestOf(functions[m]) < 0.0)
      {
        break;
      }
    }
  }
  return active;
}

/// Returns the functions that can be the lowest one at a point of the box; without void at least
/// one.
std::vector<int> FindLowest(const std::vector<CornerValues>& functions, LevelSetRule rule)
{
  double limit = rule == LevelSetRule::Fill ? HighestOf(functions[0]) : 0.0;
  for (const CornerValues& f : functions)
  {
    limit = std::min(limit, HighestOf(f)); // the lowest function is nowhere above it
  }
  std::vector<int> active;
  for (std::size_t m = 0; m < functions.size(); ++m)
  {
    const double lowest = LowestOf(functions[m]);
    if (rule == LevelSetRule::Fill ? lowest <= limit : lowest < 0.0 && lowest <= limit)
    {
      active.push_back(static_cast<int>(m));
    }
  }
  return active;
}

} // namespace

void AddVolumesInBox(const std::vector<CornerValues>& functions, LevelSetRule rule, double volume,
  std::vector<double>& volumes)
{
  const std::vector<int> active =
    rule == LevelSetRule::Priority ? FindFirst(functions) : FindLowest(functions, rule);
  const bool isWhole =
    active.size() == 1 && (rule == LevelSetRule::Fill || HighestOf(functions[active[0]]) < 0.0);
  if (active.empty() || isWhole)
  {
    volumes[active.empty() ? 0 : active[0] + 1] += volume;
    return;
  }
  for (const auto& corners : TetCorners)
  {
    TetMaterials(functions, active, corners, rule, volumes).Add(volume / 6.0);
  }
}

} // namespace vfm
