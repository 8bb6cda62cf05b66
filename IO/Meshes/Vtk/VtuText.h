/**
 * VtuText: writes elements of VTK's XML files.
 */
#pragma once

#include "Meshes/Files/RunValues.h"

#include <string>
#include <string_view>

namespace vfm
{

class OutputFile;

constexpr const char* VtuPointAttributes =
  "type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\"";

/// Returns the first lines of a file.
/// @param type  type of the data, for instance UnstructuredGrid
/// @param version  version of the format of this type
std::string VtuHead(const std::string& type, const std::string& version = "0.1");

/// Returns a text in UTF-8 (ToUtf8) with the escapes that an attribute of XML requires. Control
/// characters that XML does not allow become UnknownCharacter.
std::string XmlText(const std::string& text);

/// Returns the attributes of a DataArray: type, name, number and names of components.
std::string DescribeVtuArray(const MeshArray& array);

/// Adds a DataArray. Values are encoded as base64, after compression if the build has zlib.
/// @param attributes  result of DescribeVtuArray
/// @param bytes  memory of the values
void AddVtuArray(OutputFile& file, const std::string& attributes, std::string_view bytes);
/// Adds a DataArray of which no more than a part is in memory.
/// @param size  number of bytes of all values
/// @param addValues  called once; adds the values part by part
void AddVtuArray(OutputFile& file, const std::string& attributes, std::size_t size,
  const std::function<void(const AddBytes& add)>& addValues);

/// Adds FieldData with the fields and the time.
void AddVtuFields(OutputFile& file, const MeshData& mesh);

///@{ Add PointData, CellData and Points.
/// @param whole  the mesh with the hexes that it leaves out
void AddVtuMesh(OutputFile& file, const MeshData& mesh);
void AddVtuMesh(OutputFile& file, const MeshData& mesh, const MeshWithRuns& whole);
///@}

///@{ Add the arrays of connectivity and offsets.
void AddVtuElements(OutputFile& file, const MeshData& mesh);
void AddVtuElements(OutputFile& file, const MeshData& mesh, const MeshWithRuns& whole);
///@}

/// Returns the attributes of PointData or CellData that mark arrays as global ids or scalars.
std::string DescribeVtuRoles(const std::vector<MeshArray>& arrays);

} // namespace vfm
