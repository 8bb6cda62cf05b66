#include "Meshes/Decks/WriteEquations.h"

#include "Meshes/Decks/DeckCards.h"
#include "Report/DomainSides.h"
#include "Report/Sets/PeriodicPairs.h"

namespace vfm
{
namespace
{

constexpr std::size_t NumberLength = 20; // characters of a number that CalculiX reads
constexpr const char* Names[3] = { "REF_X", "REF_Y", "REF_Z" };

/// A node with a coefficient.
struct Term
{
  Index Node;
  Index Factor;
};

/// Returns the numbers of the reference nodes; 0 along axes that do not repeat.
Index3 NumberReferences(const MeshData& mesh, const std::vector<double>& lengths)
{
  Index3 nodes{ { 0, 0, 0 } };
  Index last = mesh.NumberOfPoints;
  for (int a = 0; a < 3; ++a)
  {
    nodes[a] = lengths[a] > 0.0 ? ++last : 0;
  }
  return nodes;
}

/// Writes the reference nodes, one period from the lower corner of the domain.
void WriteReferences(OutputFile& file, const MeshData& mesh, const std::vector<double>& lengths)
{
  const std::vector<double> bounds = NumbersOfField(mesh.Fields, "DomainBounds");
  const ImageFrame frame = FrameOfDomain(mesh);
  const Index3 nodes = NumberReferences(mesh, lengths);
  for (int a = 0; a < 3; ++a)
  {
    if (nodes[a] == 0)
    {
      continue;
    }
    Vector3 place{ { bounds[0], bounds[2], bounds[4] } };
    place[a] += lengths[a];
    place = frame.ToSpace(place);
    file.Add(std::string("*NODE, NSET=") + Names[a] + "\n");
    file.Add(nodes[a]);
    for (double x : place)
    {
      file.Add(",");
      file.Add(DeckReal(x, NumberLength, RealForm::Plain).Text());
    }
    file.Add("\n");
  }
}

/// Writes an equation per direction. The first node is eliminated.
void WriteEquation(OutputFile& file, const std::vector<Term>& terms, int directions)
{
  constexpr std::size_t termsInLine = 4; // Abaqus and CalculiX read at most four
  for (int direction = 1; direction <= directions; ++direction)
  {
    file.Add("*EQUATION\n");
    file.Add(static_cast<Index>(terms.size()));
    file.Add("\n");
    for (std::size_t t = 0; t < terms.size(); ++t)
    {
      file.Add(terms[t].Node);
      file.Add(",");
      file.Add(direction);
      file.Add(",");
      file.Add(terms[t].Factor);
      file.Add((t + 1) % termsInLine == 0 || t + 1 == terms.size() ? "\n" : ",");
    }
  }
}

} // namespace

bool WriteEquations(const MeshData& mesh, const std::string& path, OutputSet& files)
{
  const std::vector<PeriodicPair> pairs = FindPeriodicPairs(mesh);
  if (pairs.empty())
  {
    return false;
  }
  const std::vector<double> lengths = NumbersOfField(mesh.Fields, "PeriodLengths");
  const Index3 references = NumberReferences(mesh, lengths);
  OutputFile file(path, files);
  file.Add("** u(copy) = u(partner) + periods x u(REF_X) + ..\n");
  WriteReferences(file, mesh, lengths);
  std::vector<Term> terms;
  for (const PeriodicPair& pair : pairs)
  {
    terms = { { pair.Point + 1, 1 }, { pair.Partner + 1, -1 } };
    for (int a = 0; a < 3; ++a)
    {
      if (pair.Periods[a] != 0)
      {
        terms.push_back({ references[a], -pair.Periods[a] });
      }
    }
    WriteEquation(file, terms, NumberOfAxes(mesh));
  }
  file.Close();
  return true;
}

} // namespace vfm
