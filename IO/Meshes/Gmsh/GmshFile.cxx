#include "Meshes/Gmsh/GmshFile.h"

namespace vfm
{

void GmshFile::Begin(const std::string& section)
{
  this->Line("$" + section);
}

void GmshFile::End(const std::string& section)
{
  this->Line((this->IsBinary ? "\n$End" : "$End") + section);
}

void GmshFile::Line(const std::string& text)
{
  this->File.Add(text);
  this->File.Add("\n");
}

void GmshFile::Separate()
{
  if (this->IsInLine)
  {
    this->File.Add(" ");
  }
  this->IsInLine = true;
}

void GmshFile::Int(std::int64_t number)
{
  if (this->IsBinary)
  {
    this->File.AddBytes(static_cast<std::int32_t>(number));
    return;
  }
  this->Separate();
  this->File.Add(number);
}

void GmshFile::Size(std::int64_t number)
{
  if (this->IsBinary)
  {
    this->File.AddBytes(number);
    return;
  }
  this->Int(number);
}

void GmshFile::Real(double number)
{
  if (this->IsBinary)
  {
    this->File.AddBytes(number);
    return;
  }
  this->Separate();
  this->File.AddReal(number);
}

void GmshFile::EndLine()
{
  if (!this->IsBinary)
  {
    this->File.Add("\n");
  }
  this->IsInLine = false;
}

} // namespace vfm
