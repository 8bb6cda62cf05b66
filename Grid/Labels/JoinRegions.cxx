#include "Labels/JoinRegions.h"

#include "Base/DisjointSets.h"

#include <map>
#include <set>

namespace vfm
{
namespace
{

/// Decides which regions join. Regions are numbered from 1 by their lowest cell.
class RegionGraph
{
public:
  /// @param materials,cells  one per region; [0] is unused
  /// @param shared  may contain a pair several times
  RegionGraph(std::vector<int> materials, std::vector<Index> cells, Index minimumCells,
    const std::vector<SharedFaces>& shared);

  /// Returns the final material of each region; [0] is unused.
  std::vector<int> Merge();

private:
  int ChooseMaterial(Index region, std::set<Index>& joined);
  void Join(Index region, Index other);

  std::vector<int> Material; // one per root
  std::vector<Index> Cells;  // one per root
  std::vector<Index> Parent; // sets of regions
  Index MinimumCells;
  // Number of faces of small roots, by region; regions need not be roots.
  std::map<Index, std::map<Index, Index>> Faces;
};

RegionGraph::RegionGraph(std::vector<int> materials, std::vector<Index> cells, Index minimumCells,
  const std::vector<SharedFaces>& shared) :
  Material(std::move(materials)),
  Cells(std::move(cells)),
  Parent(MakeSets(this->Material.size())),
  MinimumCells(minimumCells)
{
  for (const SharedFaces& faces : shared)
  {
    this->Faces[faces.Region][faces.Other] += faces.Count;
  }
}

/// Returns the material with the most faces around a region, or -1 if nothing is around. joined:
/// adds the adjacent regions of that material.
int RegionGraph::ChooseMaterial(Index region, std::set<Index>& joined)
{
  std::map<int, Index> faces; // one count per material
  for (const auto& shared : this->Faces[region])
  {
    const Index other = FindRoot(this->Parent, shared.first);
    if (other != region)
    {
      faces[this->Material[other]] += shared.second;
    }
  }
  int best = -1;
  for (const auto& count : faces)
  {
    best = best < 0 || count.second > faces[best] ? count.first : best;
  }
  for (const auto& shared : this->Faces[region])
  {
    const Index other = FindRoot(this->Parent, shared.first);
    if (other != region && this->Material[other] == best)
    {
      joined.insert(other);
    }
  }
  return best;
}

/// Joins two regions. The one with the lower number, hence the lower cell, stays the root.
void RegionGraph::Join(Index region, Index other)
{
  const Index root = std::min(region, other), child = std::max(region, other);
  vfm::Join(this->Parent, root, child);
  this->Cells[root] += this->Cells[child];
  const auto old = this->Faces.find(child);
  if (old != this->Faces.end())
  {
    for (const auto& shared : old->second)
    {
      this->Faces[root][shared.first] += shared.second;
    }
    this->Faces.erase(child);
  }
}

std::vector<int> RegionGraph::Merge()
{
  std::set<std::pair<Index, Index>> small; // cells, root
  for (std::size_t r = 1; r < this->Cells.size(); ++r)
  {
    if (this->Cells[r] < this->MinimumCells)
    {
      small.insert({ this->Cells[r], static_cast<Index>(r) });
    }
  }
  while (!small.empty())
  {
    Index region = small.begin()->second;
    small.erase(small.begin());
    std::set<Index> joined;
    const int material = this->ChooseMaterial(region, joined);
    if (material < 0)
    {
      continue;
    }
    for (Index other : joined)
    {
      small.erase({ this->Cells[other], other });
      this->Join(region, other);
      region = std::min(region, other);
    }
    this->Material[region] = material;
    if (this->Cells[region] < this->MinimumCells)
    {
      small.insert({ this->Cells[region], region });
    }
  }
  std::vector<int> materials;
  for (std::size_t r = 0; r < this->Material.size(); ++r)
  {
    materials.push_back(this->Material[FindRoot(this->Parent, static_cast<Index>(r))]);
  }
  return materials;
}

/// A small region: the lowest number of a region of its island, and its own number, both over all
/// ranks.
using RegionKey = std::array<Index, 2>;
/// A small region and another one: the number of a small one, or -1 - material.
using FacesKey = std::array<Index, 3>;

struct RegionSize
{
  Index Cells, Material;
};

/// Small regions of islands, and faces between them.
struct Islands
{
  std::vector<RegionKey> Regions; ///< ascending
  std::vector<RegionSize> Sizes;  ///< one per region
  std::vector<FacesKey> Faces;    ///< ascending
  std::vector<Index> Counts;      ///< numbers of faces
};

/// Returns the final material of each small region of whole islands. Regions that are not small
/// differ by their materials only, so those of one material are one region here.
std::vector<int> ChooseMaterials(const Islands& islands, Index minimumCells)
{
  std::vector<int> materials{ 0 };
  std::vector<Index> cells{ 0 };
  for (const RegionSize& size : islands.Sizes)
  {
    materials.push_back(static_cast<int>(size.Material));
    cells.push_back(size.Cells);
  }
  std::map<Index, int> large; // by material
  std::vector<SharedFaces> shared;
  for (std::size_t f = 0; f < islands.Faces.size(); ++f)
  {
    const FacesKey& faces = islands.Faces[f];
    const auto find = [&](Index region) {
      return static_cast<int>(FindSorted(islands.Regions, RegionKey{ { faces[0], region } })) + 1;
    };
    int other = 0;
    if (faces[2] >= 0)
    {
      other = find(faces[2]);
    }
    else
    {
      other = large.try_emplace(faces[2], static_cast<int>(cells.size())).first->second;
      if (other == static_cast<int>(cells.size()))
      {
        materials.push_back(static_cast<int>(-1 - faces[2]));
        cells.push_back(minimumCells);
      }
    }
    shared.push_back({ find(faces[1]), other, islands.Counts[f] });
  }
  std::vector<int> chosen =
    RegionGraph(std::move(materials), std::move(cells), minimumCells, shared).Merge();
  return { chosen.begin() + 1,
    chosen.begin() + 1 + static_cast<std::ptrdiff_t>(islands.Regions.size()) };
}

/// Small regions of this rank by islands.
class IslandsOfRank
{
public:
  /// Collective.
  IslandsOfRank(const FragmentShare& regions, const std::vector<Index>& cells, Index minimumCells,
    const std::vector<SharedFaces>& shared, Ranks& ranks) :
    Regions(regions), Cells(cells), MinimumCells(minimumCells), Parts(MakeSets(regions.Size()))
  {
    for (const SharedFaces& faces : shared)
    {
      if (this->IsSmall(faces.Other))
      {
        vfm::Join(this->Parts, faces.Region, faces.Other);
      }
    }
    this->IsSpread.resize(regions.Size(), 0);
    for (int region : regions.Shared)
    {
      unsigned char& isSpread = this->IsSpread[this->PartOf(region)];
      isSpread = isSpread || this->IsSmall(region);
    }
    this->SpreadNumbers(ranks);
  }

  /// Returns the islands of one rank, or the parts here of islands of several ranks.
  /// @param places  gets the number of each region as numbered on this rank
  Islands List(bool isSpread, const std::vector<SharedFaces>& shared, std::vector<int>& places)
  {
    std::vector<std::pair<RegionKey, int>> regions;
    for (int r = 1; r < static_cast<int>(this->Regions.Size()); ++r)
    {
      if (this->IsSmall(r) && this->IsOfSpread(r) == isSpread)
      {
        regions.push_back({ this->KeyOf(r), r });
      }
    }
    std::sort(regions.begin(), regions.end());
    Islands islands;
    for (const auto& [key, r] : regions)
    {
      islands.Regions.push_back(key);
      islands.Sizes.push_back({ this->Cells[r], this->Regions.Materials[r] });
      places.push_back(r);
    }
    this->AddFaces(isSpread, shared, islands);
    return islands;
  }

private:
  bool IsSmall(int region) const { return this->Cells[region] < this->MinimumCells; }
  Index PartOf(int region) { return FindRoot(this->Parts, region); }
  bool IsOfSpread(int region) { return this->IsSpread[this->PartOf(region)] != 0; }
  RegionKey KeyOf(int region)
  {
    return { { this->Lowest[this->PartOf(region)], this->Regions.Ids[region] } };
  }

  /// Adds the faces, merged by key: regions of one material that are not small are one.
  void AddFaces(bool isSpread, const std::vector<SharedFaces>& shared, Islands& islands)
  {
    std::map<FacesKey, Index> counts;
    for (const SharedFaces& faces : shared)
    {
      if (this->IsOfSpread(faces.Region) == isSpread)
      {
        const RegionKey key = this->KeyOf(faces.Region);
        const Index other = this->IsSmall(faces.Other) ? this->Regions.Ids[faces.Other]
                                                       : -1 - this->Regions.Materials[faces.Other];
        counts[{ { key[0], key[1], other } }] += faces.Count;
      }
    }
    for (const auto& [key, count] : counts)
    {
      islands.Faces.push_back(key);
      islands.Counts.push_back(count);
    }
  }

  /// Lowers the number of each part to the lowest one of its island. Collective.
  void SpreadNumbers(Ranks& ranks)
  {
    this->Lowest.assign(this->Regions.Ids.begin(), this->Regions.Ids.end());
    for (bool isNew = true; ranks.Any(isNew);)
    {
      std::vector<Index> numbers(this->Regions.Size());
      for (std::size_t r = 1; r < numbers.size(); ++r)
      {
        numbers[r] = this->Lowest[this->PartOf(static_cast<int>(r))];
      }
      this->Regions.Merge(numbers, 1, [](Index& a, Index b) { a = std::min(a, b); });
      isNew = false;
      for (std::size_t r = 1; r < numbers.size(); ++r)
      {
        Index& lowest = this->Lowest[this->PartOf(static_cast<int>(r))];
        isNew = isNew || numbers[r] < lowest;
        lowest = std::min(lowest, numbers[r]);
      }
    }
  }

  const FragmentShare& Regions;
  const std::vector<Index>& Cells;
  const Index MinimumCells;
  std::vector<Index> Parts; // sets of small regions of this rank in contact
  // By root of a part: whether other ranks have small regions of its island, and the lowest number
  // of these, over all ranks.
  std::vector<unsigned char> IsSpread;
  std::vector<Index> Lowest;
};

/// Returns the final materials of regions of islands of several ranks. Collective.
std::vector<int> ChooseAtHomes(const Islands& mine, Index minimumCells, Ranks& ranks)
{
  const HomeOfFirst homeOf(ranks);
  const KeyMerge<RegionKey> ways(mine.Regions, homeOf, ranks);
  const KeyMerge<FacesKey> faceWays(mine.Faces, homeOf, ranks);
  const Islands islands{ ways.HomeKeys(),
    ways.ToHome(mine.Sizes, 1, [](RegionSize&, const RegionSize&) {}), faceWays.HomeKeys(),
    faceWays.ToHome(mine.Counts, 1, [](Index& a, Index b) { a += b; }) };
  return ways.FromHome(ChooseMaterials(islands, minimumCells), 1);
}

} // namespace

std::vector<int> JoinRegions(const FragmentShare& regions, const std::vector<Index>& cells,
  Index minimumCells, const std::vector<SharedFaces>& shared, Ranks& ranks)
{
  std::vector<int> materials = regions.Materials;
  IslandsOfRank islands(regions, cells, minimumCells, shared, ranks);
  for (bool isSpread : { false, true })
  {
    std::vector<int> places;
    const Islands mine = islands.List(isSpread, shared, places);
    const std::vector<int> chosen =
      isSpread ? ChooseAtHomes(mine, minimumCells, ranks) : ChooseMaterials(mine, minimumCells);
    for (std::size_t r = 0; r < places.size(); ++r)
    {
      materials[places[r]] = chosen[r];
    }
  }
  return materials;
}

} // namespace vfm
