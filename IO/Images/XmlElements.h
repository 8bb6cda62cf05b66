/**
 * XmlElements: lists elements of an XML text that an image file contains.
 */
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace vfm
{

/// Element of an XML text.
struct XmlElement
{
  std::string Name; ///< without the prefix of a namespace
  std::map<std::string, std::string> Attributes;
  std::string Text; ///< text of the element, without the text of inner elements
};

/// Returns all elements in the order of their start tags; nothing if the text is not well-formed.
std::optional<std::vector<XmlElement>> ListElements(const std::string& text);

} // namespace vfm
