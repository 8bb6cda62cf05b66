#include "Transfer/DonorParts.h"

#include <limits>

namespace vfm
{
namespace
{

/// Part of an element in a cell of another rank.
struct SentPart
{
  Index Id, Key; // id of the element, key of the cell
  int Fragment, Material;
  double Volume;
  Vector3 Centroid;
};

void AddPart(double volume, const Vector3& centroid, Donor& donor, DonorShape& shape)
{
  const Vector3 x = centroid - donor.Centroid;
  donor.Overlap += volume;
  shape.First = shape.First + volume * x;
  for (int a = 0; a < 3; ++a)
  {
    shape.Second[a] += volume * x[a] * x[a];
    shape.Lower[a] = std::min(shape.Lower[a], x[a]);
    shape.Upper[a] = std::max(shape.Upper[a], x[a]);
  }
  shape.Second[3] += volume * x[0] * x[1];
  shape.Second[4] += volume * x[0] * x[2];
  shape.Second[5] += volume * x[1] * x[2];
}

constexpr std::size_t ElementsAtOnce = 32768;

/// Finds the donors of parts. Stores recent ones, because consecutive elements are mostly in the
/// same cells.
class DonorFinder
{
public:
  DonorFinder(const CartesianGrid& grid, DonorTable& donors) : Grid(grid), Donors(donors) {}

  int Find(std::size_t place, Index cell, int fragment, int material)
  {
    Last& last = this->Recent[place % this->Recent.size()];
    if (last.Cell != cell || last.Fragment != fragment)
    {
      const Index n = this->Grid.Linear(CellInBox(this->Grid.Local(), cell));
      last = { cell, fragment, this->Donors.Get(n, fragment, material) };
    }
    return last.Donor;
  }

private:
  struct Last
  {
    Index Cell = -1;
    int Fragment = 0, Donor = 0;
  };
  const CartesianGrid& Grid;
  DonorTable& Donors;
  std::array<Last, 8> Recent;
};

/// Cuts some elements and makes the donors of their parts.
DonorParts CutElements(const Mesh& mesh, std::vector<Index> elements, const CartesianGrid& grid,
  Runtime& runtime, DonorFinder& finder)
{
  DonorParts some{ std::move(elements), {}, {} };
  const Overlaps overlaps = FindOverlaps(mesh, some.Elements, grid, runtime);
  some.Offsets.assign(overlaps.Offsets.begin(), overlaps.Offsets.end());
  some.Parts.reserve(overlaps.Parts.size());
  for (std::size_t i = 0; i < some.Elements.size(); ++i)
  {
    const Index e = some.Elements[i];
    for (Index p = overlaps.Offsets[i]; p < overlaps.Offsets[i + 1]; ++p)
    {
      const OverlapPart& part = overlaps.Parts[p];
      const std::size_t place = p - overlaps.Offsets[i];
      some.Parts.push_back({ part.Volume, part.Centroid,
        finder.Find(place, part.Cell, mesh.Fragment[e], mesh.Material[e]) });
    }
  }
  return some;
}

/// Calls body(element, part) for all parts.
template <class Body>
void ForParts(const std::vector<DonorParts>& pieces, const Body& body)
{
  for (const DonorParts& some : pieces)
  {
    for (std::size_t i = 0; i < some.Elements.size(); ++i)
    {
      for (int p = some.Offsets[i]; p < some.Offsets[i + 1]; ++p)
      {
        body(some.Elements[i], some.Parts[p]);
      }
    }
  }
}

/// Sends parts in ghost cells to the owners of the cells. Returns the parts received for owned
/// cells, in the order of element ids.
std::vector<SentPart> ExchangeParts(const Mesh& mesh, const std::vector<DonorParts>& pieces,
  const CartesianGrid& grid, const Partition& partition, const DonorTable& donors)
{
  std::vector<std::vector<SentPart>> sent(partition.Peers().size());
  if (sent.empty())
  {
    return {};
  }
  ForParts(pieces,
    [&](Index e, const DonorPart& part)
    {
      const Donor& donor = donors[part.Donor];
      if (!donor.IsOwned)
      {
        const Index3 cell = grid.Position(donor.Cell);
        sent[partition.PeerOfCell(cell)].push_back({ mesh.ElementIds[e], grid.CellKey(cell),
          donor.Fragment, donor.Material, part.Volume, part.Centroid });
      }
    });
  std::vector<SentPart> received = ExchangeItems(partition.Group(), partition.Peers(), sent);
  std::stable_sort(received.begin(), received.end(),
    [](const SentPart& a, const SentPart& b) { return a.Id < b.Id; });
  return received;
}

/// Adds the parts of other ranks. Donors that receive some are summed again, over the parts of all
/// ranks in the order of element ids.
void AddOthers(const std::vector<SentPart>& others, const std::vector<DonorParts>& pieces,
  const Mesh& mesh, const CartesianGrid& grid, DonorTable& donors, std::vector<DonorShape>& shapes)
{
  std::vector<int> donorOf;
  for (const SentPart& other : others)
  {
    donorOf.push_back(
      donors.Get(grid.Linear(grid.CellOfKey(other.Key)), other.Fragment, other.Material));
  }
  shapes.resize(donors.Count());
  std::vector<unsigned char> isShared(donors.Count(), 0);
  for (int s : donorOf)
  {
    isShared[s] = 1;
    donors[s].Overlap = 0.0;
    shapes[s] = DonorShape();
  }
  std::size_t next = 0;
  const auto addBefore = [&](Index id)
  {
    for (; next < others.size() && others[next].Id < id; ++next)
    {
      const int s = donorOf[next];
      AddPart(others[next].Volume, others[next].Centroid, donors[s], shapes[s]);
    }
  };
  ForParts(pieces,
    [&](Index e, const DonorPart& part)
    {
      if (isShared[part.Donor])
      {
        addBefore(mesh.ElementIds[e]);
        AddPart(part.Volume, part.Centroid, donors[part.Donor], shapes[part.Donor]);
      }
    });
  addBefore(std::numeric_limits<Index>::max());
}

} // namespace

std::vector<DonorParts> FindDonorParts(const Mesh& mesh, const std::vector<Index>& elements,
  const CartesianGrid& grid, const Partition& partition, Runtime& runtime, DonorTable& donors,
  std::vector<DonorShape>& shapes)
{
  std::vector<DonorParts> pieces;
  DonorFinder finder(grid, donors);
  for (std::size_t begin = 0; begin < elements.size(); begin += ElementsAtOnce)
  {
    const std::size_t end = std::min(begin + ElementsAtOnce, elements.size());
    pieces.push_back(CutElements(mesh,
      std::vector<Index>(elements.begin() + begin, elements.begin() + end), grid, runtime, finder));
  }
  shapes.resize(donors.Count());
  ForParts(pieces,
    [&](Index, const DonorPart& part)
    {
      if (donors[part.Donor].IsOwned)
      {
        AddPart(part.Volume, part.Centroid, donors[part.Donor], shapes[part.Donor]);
      }
    });
  AddOthers(
    ExchangeParts(mesh, pieces, grid, partition, donors), pieces, mesh, grid, donors, shapes);
  return pieces;
}

void CentreShapes(DonorTable& donors, std::vector<DonorShape>& shapes)
{
  for (int s = 0; s < donors.Count(); ++s)
  {
    Donor& donor = donors[s];
    if (donor.Overlap > 0.0)
    {
      DonorShape& shape = shapes[s];
      const Vector3 mean = (1.0 / donor.Overlap) * shape.First;
      donor.Centroid = donor.Centroid + mean;
      const double o = donor.Overlap;
      const Vector3& m = mean;
      const std::array<double, 6> moved{ { m[0] * m[0], m[1] * m[1], m[2] * m[2], m[0] * m[1],
        m[0] * m[2], m[1] * m[2] } };
      for (int i = 0; i < 6; ++i)
      {
        shape.Second[i] -= o * moved[i];
      }
      shape.Lower = shape.Lower - mean;
      shape.Upper = shape.Upper - mean;
    }
  }
}

} // namespace vfm
