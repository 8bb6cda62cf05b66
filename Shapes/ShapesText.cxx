#include "Shapes/ShapesText.h"

#include "Base/ParseText.h"
#include "Base/Runtime.h"
#include "Shapes/ShapesScenes.h"

#include <map>
#include <optional>
#include <sstream>

namespace vfm
{
namespace
{

/// Parameters of one line. Each can be taken once.
class Line
{
public:
  Line(const std::string& text, int number) : Number(number)
  {
    std::istringstream words(text);
    words >> this->Name;
    for (std::string word; words >> word;)
    {
      this->Add(word);
    }
  }

  [[noreturn]] void Fail(const std::string& message) const
  {
    throw InputError("Shapes, line " + std::to_string(this->Number) + ": " + message);
  }

  double TakeNumber(const std::string& name) { return this->Take(name, 1)[0]; }
  double TakeNumber(const std::string& name, double otherwise)
  {
    return this->Has(name) ? this->TakeNumber(name) : otherwise;
  }
  int TakeInteger(const std::string& name, int otherwise)
  {
    const double value = this->TakeNumber(name, otherwise);
    if (!(value >= 0.0 && value <= 1e6) || value != static_cast<int>(value))
    {
      this->Fail("'" + name + "' must be an integer from 0 to 1000000.");
    }
    return static_cast<int>(value);
  }
  Vector3 TakeVector(const std::string& name)
  {
    const std::vector<double> v = this->Take(name, 3);
    return { { v[0], v[1], v[2] } };
  }
  Vector3 TakeVectorOrZero(const std::string& name)
  {
    return this->Has(name) ? this->TakeVector(name) : Vector3{ { 0, 0, 0 } };
  }
  Shape TakeCuts(Shape shape)
  {
    while (this->Has("cut"))
    {
      const std::vector<double> v = this->Take("cut", 6);
      shape = CutShape(shape, { { v[0], v[1], v[2] } }, { { v[3], v[4], v[5] } });
    }
    return shape;
  }
  void RequireEmpty() const
  {
    if (!this->Values.empty())
    {
      this->Fail("a " + this->Name + " has no parameter '" + this->Values.begin()->first + "'.");
    }
  }

  std::string Name;

private:
  bool Has(const std::string& name) const { return this->Values.count(name) > 0; }

  void Add(const std::string& word)
  {
    const std::size_t equals = word.find('=');
    if (equals == std::string::npos || equals == 0)
    {
      this->Fail("'" + word + "' is not of the form name=value (without spaces).");
    }
    const std::string name = word.substr(0, equals);
    if (name != "cut" && this->Has(name))
    {
      this->Fail("'" + name + "' is given twice.");
    }
    std::vector<double> values;
    std::istringstream items(word.substr(equals + 1) + ",");
    for (std::string item; std::getline(items, item, ',');)
    {
      const std::optional<double> value = ParseReal(item);
      if (!value)
      {
        this->Fail("'" + word.substr(0, 80) + "': '" + item.substr(0, 80) + "' is not a number.");
      }
      values.push_back(*value);
    }
    this->Values.emplace(name, values);
  }

  std::vector<double> Take(const std::string& name, std::size_t count)
  {
    const auto it = this->Values.find(name);
    if (it == this->Values.end())
    {
      this->Fail("a " + this->Name + " requires the parameter '" + name + "='.");
    }
    const std::vector<double> values = it->second;
    if (values.size() != count)
    {
      this->Fail("'" + name + "' needs " + std::to_string(count) + " number" +
        (count > 1 ? "s separated by commas" : "") + ", not " + std::to_string(values.size()) +
        ".");
    }
    this->Values.erase(it);
    return values;
  }

  int Number;
  std::multimap<std::string, std::vector<double>> Values;
};

Shape ParseShape(Line& line, int material)
{
  if (line.Name == "sphere")
  {
    return MakeSphere(material, line.TakeVectorOrZero("center"), line.TakeNumber("radius"));
  }
  if (line.Name == "halfspace")
  {
    return MakeHalfSpace(material, line.TakeVector("point"), line.TakeVector("normal"));
  }
  const Vector3 center = line.TakeVectorOrZero("center");
  if (line.Name == "plate")
  {
    return MakePlate(material, center, line.TakeVector("normal"), line.TakeNumber("thickness"));
  }
  const Vector3 rotation = line.TakeVectorOrZero("rotation");
  if (line.Name == "ellipsoid")
  {
    return MakeEllipsoid(material, center, line.TakeVector("radii"), rotation);
  }
  if (line.Name == "box")
  {
    return MakeBox(material, center, line.TakeVector("size"), rotation);
  }
  if (line.Name == "cylinder")
  {
    return MakeCylinder(
      material, center, line.TakeNumber("radius"), line.TakeNumber("height"), rotation);
  }
  if (line.Name == "cone")
  {
    return MakeCone(material, center, line.TakeNumber("bottom"), line.TakeNumber("top"),
      line.TakeNumber("height"), rotation);
  }
  if (line.Name == "torus")
  {
    return MakeTorus(material, center, line.TakeNumber("ring"), line.TakeNumber("tube"), rotation);
  }
  if (line.Name == "gyroid")
  {
    return MakeGyroid(
      material, center, line.TakeNumber("period"), line.TakeNumber("level", 0.0), rotation);
  }
  line.Fail("'" + line.Name +
    "' is not a shape. Shapes are sphere, ellipsoid, box, cylinder, cone, torus, halfspace, "
    "plate, gyroid, polycrystal.");
}

void ParseLine(Line& line, const Vector3& lower, const Vector3& upper, std::vector<Shape>& shapes)
{
  const int material = line.TakeInteger("material", 1);
  std::vector<Shape> parsed;
  try
  {
    if (line.Name == "polycrystal")
    {
      const int grains = line.TakeInteger("grains", 20);
      parsed = MakePolycrystal(material, lower, upper, grains, line.TakeInteger("seed", 1));
    }
    else
    {
      parsed.push_back(ParseShape(line, material));
    }
    const Shape cuts = line.TakeCuts(Shape());
    for (Shape& shape : parsed)
    {
      shape.Planes.insert(shape.Planes.end(), cuts.Planes.begin(), cuts.Planes.end());
    }
  }
  catch (const InputError& error)
  {
    const std::string message = error.what();
    if (message.rfind("Shapes, line", 0) == 0)
    {
      throw;
    }
    line.Fail(message);
  }
  line.RequireEmpty();
  shapes.insert(shapes.end(), parsed.begin(), parsed.end());
}

} // namespace

std::vector<Shape> ParseShapes(const std::string& text, const Vector3& lower, const Vector3& upper)
{
  std::vector<Shape> shapes;
  std::string lines = text;
  for (char& c : lines)
  {
    c = c == ';' ? '\n' : c;
  }
  std::istringstream stream(lines);
  int number = 0;
  for (std::string content; std::getline(stream, content);)
  {
    Line line(content.substr(0, content.find('#')), ++number);
    if (!line.Name.empty())
    {
      ParseLine(line, lower, upper, shapes);
    }
  }
  return shapes;
}

} // namespace vfm
