#include "Meshes/OpenFoam/FoamFile.h"

#include "Ranks/Errors.h"

namespace vfm
{
namespace
{

bool IsLittleEndian()
{
  const std::uint16_t one = 1;
  return *reinterpret_cast<const unsigned char*>(&one) == 1;
}

} // namespace

FoamFile::FoamFile(
  const std::string& folder, const FoamHeader& header, bool isBinary, OutputSet& files) :
  File(folder + "/" + header.Location + "/" + header.Object, files), IsBinary(isBinary)
{
  this->Text("FoamFile\n{\n    version     2.0;\n");
  this->Text(std::string("    format      ") + (isBinary ? "binary" : "ascii") + ";\n");
  this->Text("    class       " + header.Class + ";\n");
  this->Text(std::string("    arch        \"") + (IsLittleEndian() ? "LSB" : "MSB") +
    ";label=32;scalar=64\";\n");
  if (!header.Note.empty())
  {
    this->Text("    note        \"" + header.Note + "\";\n");
  }
  this->Text("    location    \"" + header.Location + "\";\n");
  this->Text("    object      " + header.Object + ";\n}\n\n");
}

void FoamFile::Begin(Index count)
{
  this->File.Add(count);
  this->Text("\n");
  if (!this->IsBinary || count > 0) // OpenFOAM reads no parentheses of empty binary lists
  {
    this->Text(this->IsBinary ? "(" : "(\n");
  }
}

void FoamFile::End(Index count)
{
  if (!this->IsBinary || count > 0)
  {
    this->Text(")\n");
  }
}

void FoamFile::EndLine()
{
  if (!this->IsBinary)
  {
    this->Text("\n");
  }
}

void FoamFile::Label(Index label)
{
  if (this->IsBinary)
  {
    this->File.AddBytes(static_cast<std::int32_t>(label));
    return;
  }
  this->File.Add(label);
}

void FoamFile::Points(const double* points, Index count)
{
  this->Begin(count);
  for (Index i = 0; i < 3 * count; ++i)
  {
    if (this->IsBinary)
    {
      this->File.AddBytes(points[i]);
      continue;
    }
    this->Text(i % 3 == 0 ? "(" : " ");
    this->File.AddReal(points[i]);
    this->Text(i % 3 == 2 ? ")\n" : "");
  }
  this->End(count);
}

void FoamFile::Face(std::span<const Index> points)
{
  this->File.Add(static_cast<std::int64_t>(points.size()));
  const char* before = "(";
  for (const Index point : points)
  {
    this->Text(before);
    this->File.Add(point);
    before = " ";
  }
  this->Text(")\n");
}

} // namespace vfm
