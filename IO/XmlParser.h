/**
 * XmlParser: a parser of expat that frees itself, and the place that a parser has reached.
 */
#pragma once

#include <cstdint>
#include <expat.h>
#include <memory>

namespace vfm
{

using XmlParser = std::unique_ptr<XML_ParserStruct, void (*)(XML_Parser)>;

/// @param user  first argument of the handlers
inline XmlParser MakeXmlParser(void* user, XML_StartElementHandler start, XML_EndElementHandler end)
{
  XmlParser parser(XML_ParserCreate(nullptr), XML_ParserFree);
  XML_SetUserData(parser.get(), user);
  XML_SetElementHandler(parser.get(), start, end);
  return parser;
}

struct XmlPlace
{
  std::int64_t Byte; ///< from 0
  std::int64_t Line; ///< from 1
};

/// Returns the place of the element that is parsed, or of the error.
inline XmlPlace PlaceOf(XML_Parser parser)
{
#if XML_MAJOR_VERSION > 2 || XML_MINOR_VERSION >= 9 // which deprecates the other functions
  return { XML_GetCurrentByteIndex64(parser),
    static_cast<std::int64_t>(XML_GetCurrentLineNumber64(parser)) };
#else
  return { XML_GetCurrentByteIndex(parser),
    static_cast<std::int64_t>(XML_GetCurrentLineNumber(parser)) };
#endif
}

} // namespace vfm
