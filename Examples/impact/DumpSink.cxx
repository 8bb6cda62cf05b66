#include "DumpSink.h"

#include "WorkTogether.h"

#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <functional>
#include <sstream>
#include <stdexcept>

namespace impact
{
namespace
{

template <class T>
std::string ToText(const std::array<T, 3>& values)
{
  std::ostringstream text;
  text.precision(17);
  text << values[0] << " " << values[1] << " " << values[2];
  return text.str();
}

/// Returns the extent in VTK's order: lowest and highest point of each axis.
std::array<std::int64_t, 6> ExtentOf(const Index3& lower, const Index3& upper)
{
  return { lower[0], upper[0], lower[1], upper[1], lower[2], upper[2] };
}

std::string ToText(const std::int64_t* extent)
{
  std::ostringstream text;
  for (int i = 0; i < 6; ++i)
  {
    text << (i ? " " : "") << extent[i];
  }
  return text.str();
}

std::string OpenFile(const char* type)
{
  return std::string("<?xml version=\"1.0\"?>\n<VTKFile type=\"") + type +
    "\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n";
}

/// Writes a file beside its name and renames it, so that an interrupted run leaves no part of it
/// under its name.
void Save(const std::string& path, const std::function<void(std::ostream&)>& write)
{
  const std::string unfinished = path + ".part";
  std::ofstream file(unfinished, std::ios::binary);
  write(file);
  file.close();
  if (!file || std::rename(unfinished.c_str(), path.c_str()) != 0)
  {
    std::remove(unfinished.c_str());
    throw std::runtime_error("cannot write " + path);
  }
}

/// Encodes the numbers as VTK's inline binary data: the number of bytes, then the bytes.
std::string ToBase64(const double* values, std::int64_t count)
{
  constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const std::uint64_t size = count * sizeof(double);
  std::vector<unsigned char> bytes(sizeof size + size);
  std::memcpy(bytes.data(), &size, sizeof size);
  std::memcpy(bytes.data() + sizeof size, values, size);
  const std::size_t padding = (3 - bytes.size() % 3) % 3;
  bytes.resize(bytes.size() + padding);
  std::string text;
  text.reserve(bytes.size() / 3 * 4);
  for (std::size_t b = 0; b < bytes.size(); b += 3)
  {
    const unsigned int three = bytes[b] << 16 | bytes[b + 1] << 8 | bytes[b + 2];
    for (int shift = 18; shift >= 0; shift -= 6)
    {
      text += digits[three >> shift & 63];
    }
  }
  text.replace(text.size() - padding, padding, padding, '=');
  return text;
}

} // namespace

DumpSink::DumpSink(
  const Domain& domain, const std::string& folder, const std::string& name, bool withStates) :
  Grid(domain), Folder(folder), Name(name), WithStates(withStates)
{
  MakeFolder(domain.GetCommunicator(), folder);
}

std::vector<StateField> DumpSink::ListArrays(const Fields& f) const
{
  std::vector<StateField> arrays{ { "ball", 1, f.Ball }, { "plate", 1, f.Plate } };
  if (this->WithStates)
  {
    arrays.insert(arrays.end(), f.States.begin(), f.States.end());
    return arrays;
  }
  arrays.insert(arrays.end(),
    { { "velocity", 3, f.Velocity }, { "density", 1, f.Density }, { "damage", 1, f.Damage } });
  return arrays;
}

/// Returns the name of the file of a rank; rank -1 is the .pvti file that lists all of them.
std::string DumpSink::NameFile(std::int64_t step, int rank) const
{
  char number[32];
  std::snprintf(number, sizeof number, "_%04lld", static_cast<long long>(step));
  const std::string name = this->Name + number;
  return rank < 0 ? name + ".pvti" : name + "_" + std::to_string(rank) + ".vti";
}

void DumpSink::Take(const Fields& fields)
{
  const std::array<std::int64_t, 6> extent = ExtentOf(fields.Lower, fields.Upper);
  int ranks = 0;
  MPI_Comm_size(this->Grid.GetCommunicator(), &ranks);
  std::vector<std::int64_t> extents(6 * ranks);
  MPI_Gather(
    extent.data(), 6, MPI_INT64_T, extents.data(), 6, MPI_INT64_T, 0, this->Grid.GetCommunicator());
  WorkTogether(this->Grid.GetCommunicator(),
    [&]
    {
      this->WritePiece(fields);
      if (this->Grid.GetRank() == 0)
      {
        this->WriteIndex(fields, extents);
        this->WriteTimes(fields);
      }
    });
}

void DumpSink::WritePiece(const Fields& fields) const
{
  const std::string extent = ToText(ExtentOf(fields.Lower, fields.Upper).data());
  Save(this->PathOf(this->NameFile(fields.Step, this->Grid.GetRank())),
    [&](std::ostream& file)
    {
      file << OpenFile("ImageData") << "<ImageData WholeExtent=\"" << extent << "\" Origin=\""
           << ToText(fields.Origin) << "\" Spacing=\"" << ToText(fields.Spacing)
           << "\">\n<Piece Extent=\"" << extent << "\">\n<CellData>\n";
      for (const StateField& array : this->ListArrays(fields))
      {
        file << "<DataArray type=\"Float64\" Name=\"" << array.Name << "\" NumberOfComponents=\""
             << array.Components << "\" format=\"binary\">\n"
             << ToBase64(array.Values, array.Components * fields.NumberOfCells())
             << "\n</DataArray>\n";
      }
      file << "</CellData>\n</Piece>\n</ImageData>\n</VTKFile>\n";
    });
}

void DumpSink::WriteIndex(const Fields& fields, const std::vector<std::int64_t>& extents) const
{
  Save(this->PathOf(this->NameFile(fields.Step, -1)),
    [&](std::ostream& file)
    {
      file << OpenFile("PImageData") << "<PImageData GhostLevel=\"0\" WholeExtent=\""
           << ToText(ExtentOf({ 0, 0, 0 }, fields.GlobalCells).data()) << "\" Origin=\""
           << ToText(fields.Origin) << "\" Spacing=\"" << ToText(fields.Spacing)
           << "\">\n<PCellData>\n";
      for (const StateField& array : this->ListArrays(fields))
      {
        file << "<PDataArray type=\"Float64\" Name=\"" << array.Name << "\" NumberOfComponents=\""
             << array.Components << "\"/>\n";
      }
      file << "</PCellData>\n";
      for (std::size_t rank = 0; rank < extents.size() / 6; ++rank)
      {
        file << "<Piece Extent=\"" << ToText(extents.data() + 6 * rank) << "\" Source=\""
             << this->NameFile(fields.Step, static_cast<int>(rank)) << "\"/>\n";
      }
      file << "</PImageData>\n</VTKFile>\n";
    });
}

void DumpSink::WriteTimes(const Fields& fields)
{
  std::ostringstream line;
  line.precision(17);
  line << "<DataSet timestep=\"" << fields.Time << "\" file=\"" << this->NameFile(fields.Step, -1)
       << "\"/>\n";
  this->Times += line.str();
  Save(this->PathOf(this->Name + ".pvd"),
    [&](std::ostream& file)
    {
      file << OpenFile("Collection") << "<Collection>\n"
           << this->Times << "</Collection>\n</VTKFile>\n";
    });
}

} // namespace impact
