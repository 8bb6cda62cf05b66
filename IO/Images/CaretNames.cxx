#include "Images/CaretNames.h"

#include "Base/ParseText.h"
#include "Images/ImageFile.h"
#include "Images/XmlElements.h"
#include "SwapBytes.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>
#include <memory>
#include <zlib.h>

namespace vfm
{
namespace
{

constexpr Index LargestLength = 1 << 28; // bytes of all extensions

/// Returns the bytes of a range of the file, or fewer at its end.
std::string ReadBytes(const std::string& path, Index begin, Index end)
{
  const std::unique_ptr<gzFile_s, int (*)(gzFile)> file(gzopen(path.c_str(), "rb"), gzclose);
  if (!file || gzseek(file.get(), begin, SEEK_SET) != begin)
  {
    return "";
  }
  std::string bytes(static_cast<std::size_t>(end - begin), '\0');
  const int count = gzread(file.get(), bytes.data(), static_cast<unsigned>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(std::max(count, 0)));
  return bytes;
}

Index TakeLength(const std::string& bytes, std::size_t at, bool isSwapped)
{
  std::int32_t length = 0;
  std::memcpy(&length, bytes.data() + at, sizeof(length));
  return isSwapped ? SwapBytes(length) : length;
}

/// Returns the text of the extension of Caret, which is recognised by its root element, because
/// some programs write another code than 30. Returns nothing if there is none.
/// @param bytes  extensions, without the first four bytes
std::string FindCaretText(const std::string& bytes, bool isSwapped, std::string& warning)
{
  constexpr Index head = 8;
  const Index size = static_cast<Index>(bytes.size());
  for (Index at = 0, length = 0; at + head <= size; at += length)
  {
    length = TakeLength(bytes, static_cast<std::size_t>(at), isSwapped);
    if (length == 0)
    {
      return ""; // padding
    }
    if (length <= head || length > size - at)
    {
      warning = "one of its header extensions has a length of " + std::to_string(length) +
        " bytes where there are " + std::to_string(size - at) +
        "; names of labels in it are ignored.";
      return "";
    }
    const std::string text(bytes, static_cast<std::size_t>(at + head), length - head);
    if (text.find("<CaretExtension") != std::string::npos)
    {
      return text.substr(0, text.find('\0'));
    }
  }
  return "";
}

/// Returns the names in the tables of one image.
LabelNames ListNames(const std::vector<XmlElement>& elements, const std::string& image)
{
  LabelNames names;
  bool isOfImage = false;
  for (const XmlElement& element : elements)
  {
    const auto find = [&element](const char* name)
    {
      const auto found = element.Attributes.find(name);
      return found == element.Attributes.end() ? std::string() : found->second;
    };
    isOfImage = element.Name == "VolumeInformation" ? find("Index") == image : isOfImage;
    const std::optional<int> label = element.Name == "Label" && isOfImage
      ? ParseCount(find("Key"), 0, std::numeric_limits<int>::max())
      : std::nullopt;
    if (label)
    {
      AddLabelName(names, *label, element.Text);
    }
  }
  return names;
}

} // namespace

LabelNames ReadCaretNames(const std::string& path, Index begin, Index end, bool isSwapped,
  Index volume, std::string& warning)
{
  constexpr Index flags = 4; // bytes; the first is not 0 if there are extensions
  if (end - begin <= flags || end - begin > LargestLength)
  {
    return {};
  }
  const std::string bytes = ReadBytes(path, begin, end);
  if (bytes.size() <= flags || bytes[0] == 0)
  {
    return {};
  }
  const std::string text = FindCaretText(bytes.substr(flags), isSwapped, warning);
  if (text.empty())
  {
    return {};
  }
  const std::optional<std::vector<XmlElement>> elements = ListElements(text);
  if (!elements)
  {
    warning = "its Caret extension is not valid XML; names of labels in it are ignored.";
    return {};
  }
  const LabelNames names = ListNames(*elements, std::to_string(volume));
  return names.empty() ? ListNames(*elements, "0") : names;
}

} // namespace vfm
