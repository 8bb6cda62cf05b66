#include "GridFiles/XmlOutline.h"

#include "OpenFile.h"

#include <cctype>

namespace vfm
{

std::string OutlineElement::Get(const std::string& name) const
{
  const auto found = this->Attributes.find(name);
  return found == this->Attributes.end() ? "" : found->second;
}

const OutlineElement* OutlineElement::Find(const std::string& name) const
{
  for (const OutlineElement& child : this->Children)
  {
    if (child.Name == name)
    {
      return &child;
    }
  }
  return nullptr;
}

void FindAppendedData(const std::string& path, std::optional<std::int64_t> place,
  const std::string& encoding, XmlOutline& outline)
{
  outline.FileSize = GetFileLength(path);
  if (!place)
  {
    return;
  }
  std::ifstream stream = OpenFile(path);
  stream.seekg(*place);
  outline.Encoding = encoding;
  outline.Appended = *place;
  int c = 0;
  const auto skip = [&](auto isSkipped)
  {
    do
    {
      c = stream.get();
      ++outline.Appended;
    } while (c != std::istream::traits_type::eof() && isSkipped(c));
  };
  skip([](int byte) { return byte != '>'; });
  skip([](int byte) { return std::isspace(byte) != 0; });
  if (c != '_' || (encoding != "raw" && encoding != "base64"))
  {
    throw InputError("it is truncated or damaged: its appended data have no encoding or no begin.");
  }
}

} // namespace vfm
