/**
 * VtuText: elements of VTK's XML files.
 */
#pragma once

#include "Summary/MeshData.h"

#include <string>
#include <string_view>

namespace vfm
{

class OutputFile;

constexpr const char* VtuPointAttributes =
  "type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\"";

/// The first lines of a file. type: such as UnstructuredGrid; version: of files of that type.
std::string VtuHead(const std::string& type, const std::string& version = "0.1");

/// The text for an attribute of XML.
std::string XmlText(const std::string& text);

/// Attributes of a DataArray: type, name, components and their names.
std::string DescribeVtuArray(const MeshArray& array);

/// Adds a DataArray. bytes: of its values, which become base64, compressed by zlib in builds with it.
void AddVtuArray(OutputFile& file, const std::string& attributes, std::string_view bytes);

/// Adds FieldData, the fields and the time.
void AddVtuFields(OutputFile& file, const MeshData& mesh);

/// Adds PointData, CellData and Points.
void AddVtuMesh(OutputFile& file, const MeshData& mesh);

/// Adds the arrays of the points of elements and of where each element ends in it.
void AddVtuElements(OutputFile& file, const MeshData& mesh);

/// The attributes of PointData and CellData: which arrays are ids and scalars.
std::string DescribeVtuRoles(const std::vector<MeshArray>& arrays);

} // namespace vfm
