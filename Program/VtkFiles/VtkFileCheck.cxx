#include "VtkFiles/VtkFileCheck.h"

#include "Base/ParseText.h"
#include "FileSuffix.h"
#include "NamedFile.h"
#include "Ranks/Errors.h"
#include "VtkFiles/LegacyCheck.h"
#include "VtkFiles/VtkArrays.h"
#include "VtkFiles/VtkExtents.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <sstream>

namespace vfm
{
namespace
{

constexpr int MostBlocks = 1 << 22; // number of a block in a file of blocks
constexpr int MostLevels = 64;

/// Contents of a format.
enum class Contents
{
  Grid,   ///< pieces of a grid with their arrays
  Pieces, ///< names of files of pieces
  Blocks, ///< names of files of blocks
  Levels, ///< names of files of blocks, with their boxes and levels
  Other   ///< data that are not meshed
};

struct Format
{
  std::string Suffix;
  std::vector<std::string> Types;
  Contents Holds;
};

const Format* FindFormat(const std::string& path)
{
  static const std::vector<std::string> amr{ "vtkOverlappingAMR", "vtkNonOverlappingAMR",
    "vtkHierarchicalBoxDataSet" };
  static const std::vector<Format> formats{ { ".vti", { "ImageData" }, Contents::Grid },
    { ".vtr", { "RectilinearGrid" }, Contents::Grid },
    { ".vts", { "StructuredGrid" }, Contents::Grid },
    { ".vtu", { "UnstructuredGrid" }, Contents::Grid }, { ".vtp", { "PolyData" }, Contents::Grid },
    { ".vtt", { "Table" }, Contents::Other }, { ".pvti", { "PImageData" }, Contents::Pieces },
    { ".pvtr", { "PRectilinearGrid" }, Contents::Pieces },
    { ".pvts", { "PStructuredGrid" }, Contents::Pieces },
    { ".pvtu", { "PUnstructuredGrid" }, Contents::Pieces },
    { ".vtm", { "vtkMultiBlockDataSet" }, Contents::Blocks }, { ".vthb", amr, Contents::Levels },
    { ".vth", amr, Contents::Levels } };
  const auto found = std::find_if(formats.begin(), formats.end(),
    [&path](const Format& format) { return HasSuffix(path, format.Suffix); });
  return found == formats.end() ? nullptr : &*found;
}

/// Returns whether grids of a format have an extent.
bool IsStructured(const Format& format)
{
  return format.Types[0].find("Unstructured") == std::string::npos &&
    format.Types[0].find("PolyData") == std::string::npos;
}

/// Checks a file and the files that it names.
class FileCheck
{
public:
  /// @param isPart  whether a file of pieces names this file, which then need not be complete
  FileCheck(const std::string& path, const Format& format, int part, int parts, bool isPart) :
    Path(path), Kind(format), Part(part), Parts(parts), IsPart(isPart)
  {
  }

  void Run()
  {
    XmlOutline outline = ReadXmlOutline(this->Path);
    this->CheckHead(outline);
    for (const std::string& type : this->Kind.Types)
    {
      if (const OutlineElement* grid = outline.Root.Find(type))
      {
        this->CheckContents(*grid);
        return;
      }
    }
    RejectVtkFile("it has no element " + this->Kind.Types[0]);
  }

private:
  void CheckHead(const XmlOutline& outline);
  void CheckVersion(const OutlineElement& root) const;
  void CheckContents(const OutlineElement& grid);
  void CheckPiece(const OutlineElement& piece, const std::string& type) const;
  void CheckArrays(const OutlineElement& list, std::optional<std::int64_t> tuples) const;
  void CheckCells(const OutlineElement& piece, const VtkPieceSize& size) const;
  void CheckBlocks(const OutlineElement& parent);
  void CheckFieldData(const OutlineElement& parent) const;
  void CheckNamedFile(const std::string& name);

  const std::string& Path;
  const Format& Kind;
  int Part, Parts, Files = 0;
  bool IsPart, HasBoxes = true; // whether blocks of levels have boxes of indices
  VtkStorage Storage;
};

void FileCheck::CheckHead(const XmlOutline& outline)
{
  const OutlineElement& root = outline.Root;
  const std::string type = root.Get("type");
  const auto& types = this->Kind.Types;
  if (root.Name != "VTKFile" || std::find(types.begin(), types.end(), type) == types.end())
  {
    throw InputError("it is not a VTK file of the type that its suffix requires: it begins with <" +
      root.Name + " type=\"" + type + "\">, required is <VTKFile type=\"" + types[0] + "\">.");
  }
  this->CheckVersion(root);
  const std::string order = root.Get("byte_order"), header = root.Get("header_type"),
                    packed = root.Get("compressor");
  static const std::map<std::string, double> ratios{ { "", 1.0 },
    { "vtkZLibDataCompressor", 1100.0 }, { "vtkLZ4DataCompressor", 260.0 },
    { "vtkLZMADataCompressor", 1e5 } };
  const auto ratio = ratios.find(packed);
  if ((!order.empty() && order != "LittleEndian" && order != "BigEndian") ||
    (!header.empty() && header != "UInt32" && header != "UInt64") || ratio == ratios.end())
  {
    RejectVtkFile("its byte_order \"" + order + "\", header_type \"" + header +
      "\" or compressor \"" + packed + "\" is unknown");
  }
  this->Storage = { this->Path, outline.Encoding, outline.Appended, outline.FileSize,
    order == "BigEndian", header == "UInt64" ? 8 : 4, !packed.empty(), ratio->second };
}

/// Checks the version. Files of refined grids before 1.1 end the program in VTK's reader.
void FileCheck::CheckVersion(const OutlineElement& root) const
{
  std::string text = root.Get("version");
  std::istringstream stream(text);
  int major = -1, minor = -1;
  char point = 0;
  if (!text.empty() && !(stream >> major >> point >> minor && point == '.' && major >= 0))
  {
    RejectVtkFile("its version \"" + text + "\" is not a number");
  }
  if (this->Kind.Holds == Contents::Levels && (major < 1 || (major == 1 && minor < 1)))
  {
    throw InputError("its version is " + (text.empty() ? "missing" : text) +
      ", 1.1 is required: convert it in a version of ParaView that reads it "
      "(vtkXMLHierarchicalBoxDataFileConverter of VTK 6 to 9).");
  }
}

void FileCheck::CheckContents(const OutlineElement& grid)
{
  this->CheckFieldData(grid);
  if (this->Kind.Holds == Contents::Other)
  {
    return;
  }
  if (this->Kind.Holds == Contents::Blocks || this->Kind.Holds == Contents::Levels)
  {
    this->HasBoxes = grid.Name != "vtkNonOverlappingAMR";
    this->CheckBlocks(grid);
    return;
  }
  if (IsStructured(this->Kind))
  {
    CheckVtkExtents(grid, this->IsPart);
  }
  for (const OutlineElement& piece : grid.Children)
  {
    if (piece.Name != "Piece")
    {
      continue;
    }
    if (this->Kind.Holds == Contents::Pieces)
    {
      this->CheckNamedFile(piece.Get("Source"));
    }
    else
    {
      this->CheckPiece(piece, grid.Name);
    }
  }
}

void FileCheck::CheckPiece(const OutlineElement& piece, const std::string& type) const
{
  VtkPieceSize size;
  if (type == "UnstructuredGrid")
  {
    size.Points = ReadVtkInts<1>(piece, "NumberOfPoints", 0)[0];
    size.Cells = ReadVtkInts<1>(piece, "NumberOfCells", 0)[0];
  }
  else if (type == "PolyData")
  {
    size.Points = ReadVtkInts<1>(piece, "NumberOfPoints", 0)[0];
  }
  else
  {
    size = SizeOfVtkExtent(ReadVtkExtent(piece, "Extent"));
  }
  for (const OutlineElement& child : piece.Children)
  {
    const bool isOfPoints = child.Name == "PointData" || child.Name == "Points";
    if (isOfPoints || child.Name == "CellData")
    {
      this->CheckArrays(child, isOfPoints ? size.Points : size.Cells);
    }
  }
  this->CheckCells(piece, size);
}

void FileCheck::CheckArrays(const OutlineElement& list, std::optional<std::int64_t> tuples) const
{
  for (const OutlineElement& array : list.Children)
  {
    if (array.Name == "DataArray" && array.Get("type") != "String")
    {
      CheckVtkArray(array, tuples, this->Storage);
    }
  }
}

/// Checks the arrays of the field data, which have their own numbers of tuples.
void FileCheck::CheckFieldData(const OutlineElement& parent) const
{
  const OutlineElement* fields = parent.Find("FieldData");
  for (std::size_t c = 0; fields && c < fields->Children.size(); ++c)
  {
    const OutlineElement& array = fields->Children[c];
    if (array.Name == "DataArray" && array.Get("type") != "String")
    {
      CheckVtkArray(array, ReadVtkInts<1>(array, "NumberOfTuples", 0)[0], this->Storage);
    }
  }
}

/// Checks the coordinates along axes, and the cells of an unstructured grid.
void FileCheck::CheckCells(const OutlineElement& piece, const VtkPieceSize& size) const
{
  if (const OutlineElement* list = piece.Find("Coordinates"))
  {
    if (list->Children.size() < 3)
    {
      RejectVtkFile("it has no coordinates along three axes");
    }
    for (std::size_t a = 0; a < 3; ++a)
    {
      CheckVtkArray(list->Children[a], size.Nodes[a], this->Storage);
    }
  }
  const OutlineElement* cells = piece.Find("Cells");
  for (std::size_t c = 0; cells && c < cells->Children.size(); ++c)
  {
    const OutlineElement& array = cells->Children[c];
    const std::string name = array.Get("Name");
    const bool isPerCell = name == "types" || name == "offsets";
    CheckVtkArray(array, isPerCell ? size.Cells : std::nullopt, this->Storage);
  }
}

void FileCheck::CheckBlocks(const OutlineElement& parent)
{
  const bool areLevels = this->Kind.Holds == Contents::Levels;
  const int files = static_cast<int>(std::min<std::size_t>(parent.Children.size(), MostBlocks));
  for (const OutlineElement& child : parent.Children)
  {
    if (child.Name != "Block" && child.Name != "Piece" && child.Name != "DataSet")
    {
      continue;
    }
    const char* number = areLevels && child.Name == "Block" ? "level" : "index";
    const int most = child.Name == "Block" && areLevels ? MostLevels
      : areLevels                                       ? files
                                                        : MostBlocks;
    if (child.Attributes.count(number) > 0 && ReadVtkInts<1>(child, number, 0)[0] >= most)
    {
      RejectVtkFile("its " + child.Name + " has the " + number + " " + child.Get(number));
    }
    if (child.Name == "DataSet")
    {
      if (areLevels && this->HasBoxes)
      {
        ReadVtkInts<6>(child, "amr_box", -LargestVtkInt);
      }
      this->CheckNamedFile(child.Get("file"));
    }
    else
    {
      this->CheckBlocks(child);
    }
  }
}

/// Checks a file that this file names (FindNamedFile). An empty name means no data.
void FileCheck::CheckNamedFile(const std::string& name)
{
  if (name.empty() || this->Files++ % this->Parts != this->Part)
  {
    return;
  }
  const std::string path = FindNamedFile(this->Path, name);
  PrefixErrors("it names the file " + path + ": ",
    [&]
    {
      const Format* format = FindFormat(path);
      if (!format || (format->Holds != Contents::Grid && format->Holds != Contents::Other))
      {
        throw InputError("only .vti, .vtr, .vts, .vtu, .vtp and .vtt files can be parts.");
      }
      FileCheck(path, *format, 0, 1, this->Kind.Holds == Contents::Pieces).Run();
    });
}

} // namespace

void CheckVtkFile(const std::string& path, int part, int parts)
{
  PrefixErrors("Cannot read the input " + path + ": ",
    [&]
    {
      if (HasSuffix(path, ".vtk"))
      {
        CheckLegacyFile(path);
      }
      else if (const Format* format = FindFormat(path))
      {
        FileCheck(path, *format, part, parts, false).Run();
      }
    });
}

} // namespace vfm
