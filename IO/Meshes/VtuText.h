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

/// The first lines of a file. type: such as UnstructuredGrid.
std::string VtuHead(const std::string& type);

/// The text for an attribute of XML.
std::string XmlText(const std::string& text);

/// Attributes of a DataArray: type, name, components and their names.
std::string DescribeVtuArray(const MeshArray& array);

/// Adds a DataArray. bytes: of its values, which become base64, compressed by zlib in builds with it.
void AddVtuArray(OutputFile& file, const std::string& attributes, std::string_view bytes);

/// Adds FieldData, the fields and the time.
void AddVtuFields(OutputFile& file, const MeshData& mesh);

/// The attributes of PointData and CellData: which arrays are ids and scalars.
std::string DescribeVtuRoles(const std::vector<MeshArray>& arrays);

} // namespace vfm
