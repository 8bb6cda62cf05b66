#include "GridFiles/ParseOutline.h"

#include "OpenFile.h"
#include "XmlParser.h"

namespace vfm
{
namespace
{

constexpr int ChunkSize = 1 << 16; // bytes

/// State of the parser.
struct Parse
{
  XML_Parser Parser = nullptr;
  OutlineElement Top; ///< parent of the root
  std::vector<OutlineElement*> Open;
  std::string Problem;        ///< reason why the parser stopped
  std::int64_t Appended = -1; ///< place of the element of the appended data
};

void Stop(Parse& parse, const std::string& problem)
{
  parse.Problem = problem;
  XML_StopParser(parse.Parser, XML_FALSE);
}

void Start(void* user, const XML_Char* name, const XML_Char** attributes)
{
  Parse& parse = *static_cast<Parse*>(user);
  OutlineElement& parent = *parse.Open.back();
  parent.Children.emplace_back();
  OutlineElement& element = parent.Children.back();
  element.Name = name;
  element.Place = PlaceOf(parse.Parser).Byte;
  for (; *attributes; attributes += 2)
  {
    element.Attributes[attributes[0]] = attributes[1];
  }
  parse.Open.push_back(&element);
  if (parse.Open.size() > DeepestVtkElement)
  {
    Stop(parse, "its elements are nested too deeply.");
  }
  else if (element.Name == AppendedDataName)
  {
    parse.Appended = element.Place;
    Stop(parse, "");
  }
}

void End(void* user, const XML_Char*)
{
  Parse& parse = *static_cast<Parse*>(user);
  parse.Open.pop_back();
}

void RejectDoctype(void* user, const XML_Char*, const XML_Char*, const XML_Char*, int)
{
  Stop(*static_cast<Parse*>(user), "it has a document type definition, which VTK does not write.");
}

/// Reads the elements; throws InputError if they are not XML.
void ParseElements(std::istream& stream, Parse& parse)
{
  for (bool isLast = false; !isLast && parse.Appended < 0;)
  {
    void* buffer = XML_GetBuffer(parse.Parser, ChunkSize);
    if (!buffer)
    {
      throw std::bad_alloc();
    }
    stream.read(static_cast<char*>(buffer), ChunkSize);
    isLast = stream.gcount() < ChunkSize;
    const bool isGood =
      XML_ParseBuffer(parse.Parser, static_cast<int>(stream.gcount()), isLast) == XML_STATUS_OK;
    if (!isGood && parse.Appended < 0)
    {
      throw InputError(!parse.Problem.empty()
          ? parse.Problem
          : "it is truncated or damaged: it is not XML in line " +
            std::to_string(PlaceOf(parse.Parser).Line) + " (" +
            XML_ErrorString(XML_GetErrorCode(parse.Parser)) + ").");
    }
  }
}

} // namespace

XmlOutline ParseVtkOutline(const std::string& path)
{
  std::ifstream stream = OpenFile(path);
  Parse parse;
  const XmlParser parser = MakeXmlParser(&parse, Start, End);
  parse.Parser = parser.get();
  parse.Open.push_back(&parse.Top);
  XML_SetStartDoctypeDeclHandler(parser.get(), RejectDoctype);
  ParseElements(stream, parse);
  XmlOutline outline;
  const bool isAppended = parse.Appended >= 0;
  FindAppendedData(path, isAppended ? std::optional<std::int64_t>(parse.Appended) : std::nullopt,
    isAppended ? parse.Open.back()->Get("encoding") : "", outline);
  outline.Root = std::move(parse.Top.Children.at(0));
  return outline;
}

} // namespace vfm
