#include "GridFiles/VtkFileCheck.h"

#include "Base/ParseText.h"
#include "FileSuffix.h"
#include "GridFiles/CellLists.h"
#include "GridFiles/LegacyCheck.h"
#include "GridFiles/PieceArrays.h"
#include "GridFiles/VtkArrays.h"
#include "GridFiles/VtkExtents.h"
#include "NamedFile.h"
#include "OpenFile.h"
#include "Ranks/Errors.h"

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

/// Returns whether an element is an array of numbers or texts.
bool IsArray(const OutlineElement& element)
{
  return element.Name == "DataArray" ||
    (element.Name == "Array" && element.Get("type") == "String");
}

/// Elements of a file of pieces that name a file.
struct PartOf
{
  const OutlineElement *Grid = nullptr, *Piece = nullptr;
};

/// Checks a file and the files that it names.
class FileCheck
{
public:
  /// @param part  elements of the file of pieces that names this file, which need not be complete
  FileCheck(const std::string& path, const Format& format, const VtkFileTools& tools,
    const VtkCheckShare& share, const PartOf& part = {}) :
    Path(path), Kind(format), Tools(tools), Share(share), Part(part)
  {
  }

  void Run()
  {
    OpenFile(this->Path); // throws if it cannot be read
    const XmlOutline outline = this->Tools.ReadOutline(this->Path);
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
  void CheckPieces(const OutlineElement& grid);
  void CheckPiece(
    const OutlineElement& piece, const std::string& type, const OutlineElement& first);
  void CheckArray(const OutlineElement& array, std::optional<std::int64_t> tuples);
  void CheckArrays(const OutlineElement& list, std::optional<std::int64_t> tuples);
  void CheckCoordinates(const OutlineElement& list, const VtkPieceSize& size);
  void CheckCells(const OutlineElement& piece, const VtkPieceSize& size);
  void CheckBlocks(const OutlineElement& parent);
  void CheckFieldData(const OutlineElement& parent);
  void CheckNamedFile(const std::string& name, const PartOf& part = {});

  const std::string& Path;
  const Format& Kind;
  const VtkFileTools& Tools;
  VtkCheckShare Share;
  int Files = 0, Arrays = 0; // found
  PartOf Part;
  bool HasBoxes = true; // whether blocks of levels have boxes of indices
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
    order == "BigEndian", header == "UInt64" ? 8 : 4, packed, ratio->second, this->Tools.Unpack };
}

/// Checks the version. Files of refined grids before 1.1 end the program in VTK's reader.
void FileCheck::CheckVersion(const OutlineElement& root) const
{
  std::string text = root.Get("version");
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
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
    CheckVtkExtents(grid, this->Part.Piece);
  }
  this->CheckPieces(grid);
}

void FileCheck::CheckPieces(const OutlineElement& grid)
{
  const OutlineElement* first = nullptr;
  for (const OutlineElement& piece : grid.Children)
  {
    if (piece.Name != "Piece")
    {
      continue;
    }
    if (this->Kind.Holds == Contents::Pieces)
    {
      this->CheckNamedFile(piece.Get("Source"), { &grid, &piece });
    }
    else
    {
      first = first ? first : &piece;
      this->CheckPiece(piece, grid.Name, *first);
    }
  }
  if (!first && this->Kind.Holds == Contents::Grid && !IsStructured(this->Kind))
  {
    this->CheckPiece(grid, grid.Name, grid); // VTK takes the grid itself as its piece
  }
}

/// Checks a piece, which must have the arrays of the first one.
void FileCheck::CheckPiece(
  const OutlineElement& piece, const std::string& type, const OutlineElement& first)
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
    else if (child.Name == "Coordinates")
    {
      this->CheckCoordinates(child, size);
    }
  }
  this->CheckCells(piece, size);
  if (size.Points.value_or(0) > 0)
  {
    CheckPieceArrays(piece, first, "");
  }
  if (size.Points.value_or(0) > 0 && this->Part.Grid)
  {
    CheckPieceArrays(piece, *this->Part.Grid, "P");
  }
}

/// Checks an array of the share of this rank.
void FileCheck::CheckArray(const OutlineElement& array, std::optional<std::int64_t> tuples)
{
  if (IsArray(array) && this->Share.Has(this->Arrays++))
  {
    CheckVtkArray(array, tuples, this->Storage);
  }
}

void FileCheck::CheckArrays(const OutlineElement& list, std::optional<std::int64_t> tuples)
{
  for (const OutlineElement& array : list.Children)
  {
    if (list.Name == "Points" && tuples.value_or(0) > 0 && array.Get("NumberOfComponents") != "3")
    {
      RejectVtkFile("its points have NumberOfComponents=\"" + array.Get("NumberOfComponents") +
        "\", 3 are required");
    }
    this->CheckArray(array, tuples);
  }
}

/// Checks the arrays of the field data, which have their own numbers of tuples.
void FileCheck::CheckFieldData(const OutlineElement& parent)
{
  const OutlineElement* fields = parent.Find("FieldData");
  for (std::size_t c = 0; fields && c < fields->Children.size(); ++c)
  {
    const OutlineElement& array = fields->Children[c];
    if (IsArray(array))
    {
      this->CheckArray(array, ReadVtkInts<1>(array, "NumberOfTuples", 0)[0]);
    }
  }
}

/// Checks the coordinates along axes.
void FileCheck::CheckCoordinates(const OutlineElement& list, const VtkPieceSize& size)
{
  if (list.Children.size() < 3)
  {
    RejectVtkFile("it has no coordinates along three axes");
  }
  for (std::size_t a = 0; a < 3; ++a)
  {
    this->CheckArray(list.Children[a], size.Nodes[a]);
  }
}

/// Checks the cells of an unstructured grid or of polygons.
void FileCheck::CheckCells(const OutlineElement& piece, const VtkPieceSize& size)
{
  for (const char* name : { "Cells", "Verts", "Lines", "Strips", "Polys" })
  {
    const OutlineElement* lists = piece.Find(name);
    const std::string number = std::string("NumberOf") + name;
    if (lists && piece.Attributes.count(number) > 0 && this->Share.Has(this->Arrays++))
    {
      const std::int64_t cells = ReadVtkInts<1>(piece, number, 0)[0];
      CheckCellLists(*lists, cells, size.Points.value_or(0), this->Storage);
    }
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
void FileCheck::CheckNamedFile(const std::string& name, const PartOf& part)
{
  if (name.empty() || !this->Share.Has(this->Files++))
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
      FileCheck(path, *format, this->Tools, {}, part).Run();
    });
}

} // namespace

void CheckVtkFile(const std::string& path, const VtkFileTools& tools, const VtkCheckShare& share)
{
  if (HasSuffix(path, ".vtk"))
  {
    if (share.Has(0))
    {
      CheckLegacyFile(path);
    }
  }
  else if (const Format* format = FindFormat(path))
  {
    FileCheck(path, *format, tools, share).Run();
  }
}

} // namespace vfm
