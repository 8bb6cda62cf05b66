/**
 * XmlOutline: the elements of an XML file of VTK, without the values of its arrays.
 */
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
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
using ReadVtkOutline = std::function<XmlOutline(const std::string& path)>;

constexpr int DeepestVtkElement = 64;                    ///< levels of elements
constexpr const char* AppendedDataName = "AppendedData"; ///< element behind which no others follow

/// Completes an outline by the length of the file and by the place of the appended data, which
/// begin after an underscore.
/// @param place  of the element of the appended data, bytes; nothing if there is none
/// @throws InputError  if there is no underscore, or if the encoding is unknown
void FindAppendedData(const std::string& path, std::optional<std::int64_t> place,
  const std::string& encoding, XmlOutline& outline);

} // namespace vfm
