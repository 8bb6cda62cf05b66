#include "Surfaces/ThreeMfModel.h"

#include "Ranks/Errors.h"
#include "Surfaces/TextScan.h"
#include "Surfaces/XmlTags.h"

#include <limits>
#include <utility>

namespace vfm
{
namespace
{

[[noreturn]] void RejectModel(const std::string& problem)
{
  throw InputError("it is truncated or damaged: " + problem + ".");
}

double NumberOf(const XmlTag& tag, std::string_view name)
{
  double number = 0.0;
  if (!ReadReal(tag.Raw(name), number))
  {
    RejectModel("the attribute " + std::string(name) + " of an element " + std::string(tag.Name) +
      " is " + QuoteText(tag.Raw(name)) + ", where a number is required");
  }
  return number;
}

Index IndexOf(const XmlTag& tag, std::string_view name, Index count)
{
  Index number = -1;
  if (!ReadInteger(tag.Raw(name), number) || number < 0 || number >= count)
  {
    RejectModel("the attribute " + std::string(name) + " of an element " + std::string(tag.Name) +
      " is " + QuoteText(tag.Raw(name)) + ", where an integer from 0 to " +
      std::to_string(count - 1) + " is required");
  }
  return number;
}

ThreeMfTransform TransformOf(const XmlTag& tag)
{
  const std::string text = tag.Get("transform");
  if (text.empty())
  {
    return NoTransform;
  }
  ThreeMfTransform transform{};
  TextScan scan(text);
  for (double& number : transform)
  {
    number = scan.Number("number of a transform");
  }
  return transform;
}

ThreeMfUse UseOf(const XmlTag& tag)
{
  ThreeMfUse use{ "", tag.Get("objectid"), TransformOf(tag), tag.Get("partnumber") };
  for (const auto& [name, value] : tag.Attributes)
  {
    if (name.size() > 5 && name.substr(name.size() - 5) == ":path")
    {
      use.Path = ReplaceReferences(value);
    }
  }
  return use;
}

/// Reads the elements of a model.
class ModelReader
{
public:
  explicit ModelReader(std::string_view text) : Tags(text) {}

  ThreeMfModel Read()
  {
    XmlTag tag;
    while (this->Tags.Next(tag))
    {
      this->Take(tag);
    }
    this->SetProperties();
    return std::move(this->Model);
  }

private:
  static constexpr Index MostNumbers = std::numeric_limits<int>::max();

  void Take(const XmlTag& tag);
  void TakeTriangle(const XmlTag& tag);
  void TakeProperty(const XmlTag& tag, std::string_view local);
  void SetProperties();
  int FindProperty(const ThreeMfProperty& property) const;

  XmlTags Tags;
  ThreeMfModel Model;
  ThreeMfObject* Object = nullptr;
  std::vector<ThreeMfProperty> OfTriangles;       // of all objects
  std::vector<ThreeMfObject*> Owners;             // of OfTriangles
  std::string Group;                              // that is read
  std::map<std::string, std::vector<int>> Groups; // numbers in PropertyNames
};

void ModelReader::TakeTriangle(const XmlTag& tag)
{
  const Index points = static_cast<Index>(this->Object->Points.size());
  this->Object->Triangles.push_back(
    { { IndexOf(tag, "v1", points), IndexOf(tag, "v2", points), IndexOf(tag, "v3", points) } });
  ThreeMfProperty property = this->Object->Property;
  if (!tag.Raw("pid").empty())
  {
    property.Group = tag.Get("pid");
  }
  if (!tag.Raw("p1").empty())
  {
    property.Number = IndexOf(tag, "p1", MostNumbers);
  }
  this->OfTriangles.push_back(std::move(property));
  this->Owners.push_back(this->Object);
}

/// Adds a material or a colour to the group that is read.
void ModelReader::TakeProperty(const XmlTag& tag, std::string_view local)
{
  const bool isColour = local == "color";
  const std::string colour = tag.Get("color");
  this->Groups[this->Group].push_back(static_cast<int>(this->Model.PropertyNames.size()));
  this->Model.PropertyNames.push_back(
    isColour ? "colour_" + colour.substr(colour.empty() ? 0 : 1) : tag.Get("name"));
}

void ModelReader::Take(const XmlTag& tag)
{
  const std::string_view local = tag.Name.substr(tag.Name.find(':') + 1);
  if (tag.IsEnd)
  {
    this->Object = local == "object" ? nullptr : this->Object;
    return;
  }
  if (local == "object")
  {
    this->Object = &this->Model.Objects[tag.Get("id")];
    const Index first = tag.Raw("pindex").empty() ? 0 : IndexOf(tag, "pindex", MostNumbers);
    *this->Object = { tag.Get("name"), tag.Get("type"), { tag.Get("pid"), first }, {}, {}, {}, {} };
  }
  else if (local == "vertex" && this->Object)
  {
    this->Object->Points.push_back(
      { { NumberOf(tag, "x"), NumberOf(tag, "y"), NumberOf(tag, "z") } });
  }
  else if (local == "triangle" && this->Object)
  {
    this->TakeTriangle(tag);
  }
  else if (local == "component" && this->Object)
  {
    this->Object->Components.push_back(UseOf(tag));
  }
  else if (local == "item")
  {
    this->Model.Items.push_back(UseOf(tag));
  }
  else if (local == "basematerials" || local == "colorgroup")
  {
    this->Group = tag.Get("id");
  }
  else if (local == "base" || local == "color")
  {
    this->TakeProperty(tag, local);
  }
}

int ModelReader::FindProperty(const ThreeMfProperty& property) const
{
  const auto group = this->Groups.find(property.Group);
  const bool isThere =
    group != this->Groups.end() && property.Number < static_cast<Index>(group->second.size());
  return isThere ? group->second[property.Number] : -1;
}

/// Sets the properties of the triangles, when all groups are known.
void ModelReader::SetProperties()
{
  for (std::size_t t = 0; t < this->Owners.size(); ++t)
  {
    this->Owners[t]->Properties.push_back(this->FindProperty(this->OfTriangles[t]));
  }
}

} // namespace

ThreeMfModel ReadThreeMfModel(std::string_view text)
{
  return ModelReader(text).Read();
}

} // namespace vfm
