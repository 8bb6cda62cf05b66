/**
 * XmlOutline: reads the elements of an XML file of VTK, without the values of its arrays.
 */
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace vfm
{

/// Element of an XML file.
struct OutlineElement
{
  std::string Name;
  std::map<std::string, std::string> Attributes;
  std::vector<OutlineElement> Children;
  std::int64_t Place = 0; ///< of its start tag in the file, bytes

  /// Returns an attribute; an empty text if the element has none of this name.
  std::string Get(const std::string& name) const;
  /// Returns the first child of a name, or null.
  const OutlineElement* Find(const std::string& name) const;
};

/// Elements of a file, and the place of the values that are stored behind them.
struct XmlOutline
{
  OutlineElement Root;
  std::string Encoding;      ///< encoding of the appended data: "raw" or "base64"; or empty
  std::int64_t Appended = 0; ///< place of the appended data, after the underscore; bytes
  std::int64_t FileSize = 0; ///< length of the file, bytes
};

/// Reads a file up to its appended data.
/// @throws InputError  if the file cannot be read, is not XML, has a document type definition, or
///   nests elements too deeply; the message does not contain the path
XmlOutline ReadXmlOutline(const std::string& path);

} // namespace vfm
