/**
 * XmlTags: the tags of an XML text in memory, one after another, because not every build has Expat.
 */
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vfm
{

/// Begin or end of an element. The views are of the text.
struct XmlTag
{
  std::string_view Name;
  bool IsEnd = false;                                                    ///< the element ends here
  std::size_t Place = 0;                                                 ///< of the tag in the text
  std::vector<std::pair<std::string_view, std::string_view>> Attributes; ///< as in the text

  /// Returns an attribute as in the text; empty if there is none.
  std::string_view Raw(std::string_view name) const;
  /// Returns an attribute, with references such as &amp; replaced.
  std::string Get(std::string_view name) const;
};

/// Returns a text with references such as &amp; and &#65; replaced.
std::string ReplaceReferences(std::string_view text);

/// Reads tags. Each element gives a begin and an end, also one that is empty.
class XmlTags
{
public:
  explicit XmlTags(std::string_view text) : Text(text) {}

  /// Reads the next tag. Returns whether there is one.
  /// @throws InputError  if the text is not XML, its elements do not match, or it has a document
  ///   type definition
  bool Next(XmlTag& tag);

private:
  bool SkipTo(std::string_view end);
  void ReadTag(XmlTag& tag);
  void ReadAttribute(XmlTag& tag);
  void SkipSpaces();
  std::string_view Name();
  void Close(std::string_view name);
  [[noreturn]] void Reject(const char* problem) const;

  std::string_view Text;
  std::size_t Place = 0;
  std::vector<std::string_view> Open; // names of elements, outermost first
  bool IsEmpty = false;               // the last tag was of an empty element
};

} // namespace vfm
