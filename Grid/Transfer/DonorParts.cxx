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

/// What FindDonorParts works on.
struct Work
{
  const Mesh& TheMesh;
  const CartesianGrid& Grid;
  const RegularTets& Regular;
  const Partition& Parts;
  DonorTable& Donors;
  std::vector<DonorShape>& Shapes;
  OverlapFinder Finder;
  // Parts in cells of other ranks, per peer.
  std::vector<std::vector<SentPart>> Sent{ Parts.Peers().size() };
  RecentDonors Recent{};
};

int GetDonor(Work& work, std::size_t place, Index cell, Index element)
{
  return work.Recent.Find(place, cell, work.TheMesh.Fragment[element],
    [&](Index of, int fragment)
    {
      const Index n = work.Grid.Linear(CellInBox(work.Grid.Local(), of));
      const int donor = work.Donors.Get(n, fragment, work.TheMesh.Material[element]);
      work.Shapes.resize(work.Donors.Count());
      return donor;
    });
}

/// Adds a part to its donor, or to the parts that are sent to the owner of the cell.
void AddOrSend(Work& work, Index element, const DonorPart& part)
{
  Donor& donor = work.Donors[part.Donor];
  if (donor.IsOwned)
  {
    AddPart(part.Volume, part.Centroid, donor, work.Shapes[part.Donor]);
    return;
  }
  donor.HasParts = true;
  const Index3 cell = work.Grid.Position(donor.Cell);
  work.Sent[work.Parts.PeerOfCell(cell)].push_back({ work.TheMesh.ElementIds[element],
    work.Grid.CellKey(cell), donor.Fragment, donor.Material, part.Volume, part.Centroid });
}

/// Cuts some elements, makes the donors of their parts and adds the parts to them.
DonorParts CutElements(Work& work, std::vector<Index> elements)
{
  DonorParts some{ std::move(elements), { 0 }, {} };
  const Overlaps& overlaps = work.Finder.Find(some.Elements);
  some.Offsets.reserve(some.Elements.size() + 1);
  for (std::size_t i = 0; i < some.Elements.size(); ++i)
  {
    const Index e = some.Elements[i], first = overlaps.Offsets[i];
    for (Index p = first; p < overlaps.Offsets[i + 1]; ++p)
    {
      const OverlapPart& overlap = overlaps.Parts[p];
      const DonorPart part{ overlap.Volume, overlap.Centroid,
        GetDonor(work, p - first, overlap.Cell, e) };
      AddOrSend(work, e, part);
      if (!overlaps.IsRegular[i])
      {
        some.Parts.push_back(part);
      }
    }
    some.Offsets.push_back(static_cast<int>(some.Parts.size()));
  }
  some.Parts.shrink_to_fit();
  return some;
}

/// Sends parts in ghost cells to the owners of the cells. Returns the parts received for owned
/// cells, in the order of element ids.
std::vector<SentPart> ExchangeParts(const Work& work)
{
  std::vector<SentPart> received = Joined(work.Parts.Exchange(work.Sent));
  std::stable_sort(received.begin(), received.end(),
    [](const SentPart& a, const SentPart& b) { return a.Id < b.Id; });
  return received;
}

/// Makes the donors of parts of other ranks, without overlaps. Returns the donor of each part.
std::vector<int> GetDonors(Work& work, const std::vector<SentPart>& others)
{
  std::vector<int> donorOf;
  for (const SentPart& other : others)
  {
    donorOf.push_back(work.Donors.Get(
      work.Grid.Linear(work.Grid.CellOfKey(other.Key)), other.Fragment, other.Material));
  }
  work.Shapes.resize(work.Donors.Count());
  for (int s : donorOf)
  {
    work.Donors[s].Overlap = 0.0;
    work.Shapes[s] = DonorShape();
  }
  return donorOf;
}

/// Adds the parts of other ranks. Donors that receive some are summed again, over the parts of all
/// ranks in the order of element ids.
void AddOthers(
  Work& work, const std::vector<SentPart>& others, const std::vector<DonorParts>& pieces)
{
  const std::vector<int> donorOf = GetDonors(work, others);
  std::vector<unsigned char> isShared(work.Donors.Count(), 0);
  for (int s : donorOf)
  {
    isShared[s] = 1;
  }
  std::size_t next = 0;
  const auto addBefore = [&](Index id)
  {
    for (; next < others.size() && others[next].Id < id; ++next)
    {
      const int s = donorOf[next];
      AddPart(others[next].Volume, others[next].Centroid, work.Donors[s], work.Shapes[s]);
    }
  };
  PartReader reader(work.TheMesh, work.Grid, work.Regular, work.Donors);
  for (const DonorParts& some : pieces)
  {
    for (std::size_t i = 0; i < some.Elements.size(); ++i)
    {
      reader.ForParts(some, i,
        [&](const DonorPart& part)
        {
          if (isShared[part.Donor])
          {
            addBefore(work.TheMesh.ElementIds[some.Elements[i]]);
            AddPart(part.Volume, part.Centroid, work.Donors[part.Donor], work.Shapes[part.Donor]);
          }
        });
    }
  }
  addBefore(std::numeric_limits<Index>::max());
}

} // namespace

std::vector<DonorParts> FindDonorParts(const Mesh& mesh, const std::vector<Index>& elements,
  const CartesianGrid& grid, const RegularTets& regular, const Partition& partition,
  Runtime& runtime, DonorTable& donors, std::vector<DonorShape>& shapes)
{
  Work work{ mesh, grid, regular, partition, donors, shapes,
    OverlapFinder(mesh, grid, regular, runtime) };
  shapes.resize(donors.Count());
  std::vector<DonorParts> pieces;
  for (std::size_t begin = 0; begin < elements.size(); begin += ElementsAtOnce)
  {
    const std::size_t end = std::min(begin + ElementsAtOnce, elements.size());
    pieces.push_back(
      CutElements(work, std::vector<Index>(elements.begin() + begin, elements.begin() + end)));
  }
  if (!partition.Peers().empty())
  {
    AddOthers(work, ExchangeParts(work), pieces);
  }
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
