#include "Blocks/BlockFile.h"
#include "Blocks/SpyPlotFile.h"
#include "Input/NodeCoordinates.h"
#include "Input/PlainArrays.h"
#include "NamedFile.h"
#include "OpenFile.h"
#include "ReadLine.h"

#include <algorithm>
#include <cctype>
#include <limits>

namespace vfm
{
namespace
{

/// Tests whether a text contains control characters, which would act on a terminal.
bool HasControls(const std::string& text)
{
  return std::any_of(
    text.begin(), text.end(), [](unsigned char c) { return std::iscntrl(c) != 0; });
}

/// Returns the binary files that a case file lists; for a binary file, only this file.
std::vector<std::string> FindFiles(const std::string& path)
{
  std::ifstream stream = OpenFile(path);
  char magic[7] = {};
  stream.read(magic, sizeof(magic));
  std::string line(magic, sizeof(magic));
  if (line == "spydata")
  {
    return { path };
  }
  if (line != "spycase")
  {
    throw InputError("it is not a SpyPlot file: it begins neither with spycase nor with spydata.");
  }
  std::vector<std::string> files;
  ReadLine(stream, line);
  while (ReadLine(stream, line))
  {
    const std::size_t begin = line.find_first_not_of(" \t\r");
    if (begin == std::string::npos || line[begin] == '#')
    {
      continue;
    }
    line = line.substr(begin, line.find_last_not_of(" \t\r") + 1 - begin);
    if (HasControls(line))
    {
      throw InputError("it is truncated or damaged: one of its lines is not a file name.");
    }
    files.push_back(FindNamedFile(path, line));
  }
  if (files.empty())
  {
    throw InputError("it lists no files.");
  }
  return files;
}

/// File of the case and the share of its blocks that this rank reads.
struct SharedFile
{
  SpyPlotFile File;
  int Share = 0, Shares = 1; ///< number of this share, and number of shares
};

/// Checks that two files hold the same times and arrays.
void CheckSame(const SpyPlotFile& first, const SpyPlotFile& other)
{
  const std::string which = ", see " + first.Path() + " and " + other.Path() + ".";
  if (other.Times() != first.Times())
  {
    throw InputError("its files hold different times" + which);
  }
  std::vector<std::string> names = first.Names(), others = other.Names();
  std::sort(names.begin(), names.end());
  std::sort(others.begin(), others.end());
  if (others != names)
  {
    throw InputError("its files hold different arrays" + which);
  }
}

/// Evenly spaced nodes of a block along one axis; node 0 is the outer node of the ghost cell.
struct EvenAxis
{
  double First, Spacing;
  Index Cells; ///< number of cells, ghost cells included

  explicit EvenAxis(const std::vector<float>& nodes) :
    First(nodes.front()),
    Spacing((double(nodes.back()) - nodes.front()) / static_cast<double>(nodes.size() - 1)),
    Cells(static_cast<Index>(nodes.size()) - 1)
  {
  }
  /// Returns the nodes without ghost cells. Spacings are counted from node 0 of the block, or from
  /// node 1 if node 0 is outside the domain. Therefore coordinates at the sides of the domain are
  /// bitwise identical in all blocks.
  std::vector<double> Inner(double domain) const
  {
    const int outside = this->First < domain ? 1 : 0;
    const double start = outside ? this->First + this->Spacing : this->First;
    return EvenNodes(
      start, this->Spacing, 1 - outside, static_cast<int>(this->Cells) - 1 - outside);
  }
};

class SpyPlotCase : public BlockFile
{
public:
  SpyPlotCase(const std::string& path, const Ranks& ranks)
  {
    const std::vector<std::string> files = FindFiles(path);
    const int count = static_cast<int>(files.size());
    const SpyPlotFile first(files[0]);
    this->StepTimes = first.Times();
    this->ArrayNames = first.Names();
    for (int f = ranks.Rank() % count; f < count; f += ranks.Count())
    {
      const int shares = count < ranks.Count() ? (ranks.Count() - 1 - f) / count + 1 : 1;
      this->Files.push_back({ SpyPlotFile(files[f]), ranks.Rank() / count % shares, shares });
      CheckSame(first, this->Files.back().File);
    }
  }

  std::vector<InputBlock> Read(
    std::size_t step, const std::vector<std::string>& names, Ranks& ranks) const override
  {
    std::vector<std::vector<SpyPlotBlock>> blocks;
    for (const SharedFile& shared : this->Files)
    {
      blocks.push_back(shared.File.ReadBlocks(step));
    }
    const std::array<double, 3> domain = this->FindDomain(blocks, ranks);
    std::vector<InputBlock> read;
    for (std::size_t f = 0; f < this->Files.size(); ++f)
    {
      this->ReadShare(this->Files[f], step, names, blocks[f], domain, read);
    }
    for (std::size_t b = 0; b < read.size(); ++b)
    {
      FinishBlock(read[b], static_cast<int>(b), ranks);
    }
    return read;
  }

private:
  /// Returns the lower corner of all evenly spaced blocks, without their ghost cells.
  /// @pre Collective
  std::array<double, 3> FindDomain(
    const std::vector<std::vector<SpyPlotBlock>>& blocks, Ranks& ranks) const
  {
    std::array<double, 3> lower;
    lower.fill(std::numeric_limits<double>::max());
    for (std::size_t f = 0; f < blocks.size(); ++f)
    {
      for (const SpyPlotBlock& block : blocks[f])
      {
        for (int a = 0; a < 3 && !this->Files[f].File.IsFlat(); ++a)
        {
          const EvenAxis axis(block.Nodes[a]);
          lower[a] = std::min(lower[a], axis.First + axis.Spacing);
        }
      }
    }
    for (double& x : lower)
    {
      x = -ranks.Max(-x);
    }
    return lower;
  }

  /// Appends the blocks of this rank's share of a file to `read`.
  void ReadShare(const SharedFile& shared, std::size_t step, const std::vector<std::string>& names,
    const std::vector<SpyPlotBlock>& blocks, const std::array<double, 3>& domain,
    std::vector<InputBlock>& read) const
  {
    const std::size_t first = blocks.size() * shared.Share / shared.Shares;
    const std::size_t last = blocks.size() * (shared.Share + 1) / shared.Shares;
    std::vector<std::shared_ptr<PlainArrays>> arrays;
    for (std::size_t b = first; b < last; ++b)
    {
      InputBlock block;
      Index cells = 1;
      for (int a = 0; a < 3; ++a)
      {
        const std::vector<float>& x = blocks[b].Nodes[a];
        block.Coordinates[a] = shared.File.IsFlat()
          ? std::vector<double>(x.begin() + 1, x.end() - 1)
          : EvenAxis(x).Inner(domain[a]);
        cells *= blocks[b].Size[a] - 2;
      }
      arrays.push_back(std::make_shared<PlainArrays>(cells));
      block.Arrays = arrays.back();
      read.push_back(std::move(block));
    }
    for (const std::string& name : names)
    {
      auto values = shared.File.ReadArray(step, name, blocks, first, last);
      for (std::size_t b = 0; b < values.size(); ++b)
      {
        arrays[b]->Store(name, ValueType::Float, std::move(values[b]));
      }
    }
  }

  std::vector<SharedFile> Files; // files that this rank reads
};

} // namespace

std::unique_ptr<BlockFile> OpenSpyPlot(const std::string& path, const Ranks& ranks)
{
  return std::make_unique<SpyPlotCase>(path, ranks);
}

} // namespace vfm
