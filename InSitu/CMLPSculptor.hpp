/**
 * CMLPSculptor.hpp: the calls of CMLPSculptor.c.h as a class, for C++11 and later. Methods have the
 * names and arguments of the report, return arrays as vectors, and throw cml::Error instead of
 * returning codes.
 */
#ifndef CMLPSculptor_hpp
#define CMLPSculptor_hpp

#include "CMLPSculptor.c.h"

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace cml
{

/// Error of a call.
class Error : public std::runtime_error
{
public:
  Error(int code, const std::string& text) : std::runtime_error(text), Code(code) {}
  /// Returns the SculptorCode.
  int code() const noexcept { return this->Code; }

private:
  int Code;
};

/// Sizes of the mesh, or of a fragment, on this rank.
struct Totals
{
  int nodes, hexes, tets;
};

/// The mesh, or a fragment, on this rank. hexes or tets is empty.
struct Mesh
{
  std::vector<double> coords; ///< (nodes, 3)
  std::vector<int> hexes;     ///< node numbers, (hexahedra, 8)
  std::vector<int> tets;      ///< node numbers, (tetrahedra, 4)
};

/// Owner of a sculptor, which it creates and deletes. All methods except handle(), move
/// construction and destruction throw Error. One thread at a time may use an object.
/// @pre Destruction, move assignment and mesh_from_data are collective.
class PSculptor
{
public:
  PSculptor() : Handle(c_create_cml_psculptor())
  {
    if (this->Handle == 0)
    {
      this->check(sculptor_error_code(0));
    }
  }
  ~PSculptor() { this->free(); }
  PSculptor(const PSculptor&) = delete;
  PSculptor& operator=(const PSculptor&) = delete;
  /// Takes over the sculptor of `other`, which may then only be destroyed or assigned to.
  PSculptor(PSculptor&& other) noexcept : Handle(other.Handle) { other.Handle = 0; }
  PSculptor& operator=(PSculptor&& other) noexcept
  {
    if (this != &other)
    {
      this->free();
      this->Handle = other.Handle;
      other.Handle = 0;
    }
    return *this;
  }

  /// Returns the handle for the calls of Sculptor.h, for example
  /// s.check(sculptor_set_option(s.handle(), "IndexBase", "1")).
  int handle() const noexcept { return this->Handle; }
  /// Throws Error with the message of the sculptor unless the code of a call is SCULPTOR_OK.
  void check(int code) const
  {
    if (code != SCULPTOR_OK)
    {
      throw Error(code, sculptor_error_text(this->Handle));
    }
  }

  /// Makes the mesh of one material; c_mesh_from_data documents the arguments.
  /// @param vfrac  xint * yint * zint volume fractions, x fastest
  /// @pre Collective
  void mesh_from_data(double xmin, double ymin, double zmin, double xmax, double ymax, double zmax,
    int xint, int yint, int zint, const double* vfrac, int neighbor_plus_i, int neighbor_negative_i,
    int neighbor_plus_j, int neighbor_negative_j, int neighbor_plus_k, int neighbor_negative_k,
    int auto_refine, int stair_step, int smooth, int tet_mesh)
  {
    this->check(c_mesh_from_data(this->Handle, xmin, ymin, zmin, xmax, ymax, zmax, xint, yint, zint,
      const_cast<double*>(vfrac), // only read
      neighbor_plus_i, neighbor_negative_i, neighbor_plus_j, neighbor_negative_j, neighbor_plus_k,
      neighbor_negative_k, auto_refine, stair_step, smooth, tet_mesh));
  }

  /// Returns the size of this rank's mesh.
  Totals get_free_totals() const
  {
    Totals totals;
    c_get_free_totals(this->Handle, &totals.nodes, &totals.hexes, &totals.tets);
    this->check(sculptor_error_code(this->Handle));
    return totals;
  }
  /// Returns this rank's mesh.
  Mesh get_free_mesh() const
  {
    Mesh mesh = allocate(this->get_free_totals());
    double* coords = mesh.coords.data();
    this->check(mesh.tets.empty() ? c_get_free_hexes(this->Handle, coords, mesh.hexes.data())
                                  : c_get_free_tets(this->Handle, coords, mesh.tets.data()));
    return mesh;
  }

  /// Returns the number of fragments over all ranks.
  int get_num_fragments() const
  {
    const int fragments = c_get_num_fragments(this->Handle);
    this->check(sculptor_error_code(this->Handle));
    return fragments;
  }
  /// Returns the size of a fragment on this rank.
  /// @param ifrag  fragment, from 1
  Totals get_fragment_totals(int ifrag) const
  {
    Totals totals;
    this->check(
      c_get_fragment_totals(this->Handle, ifrag, &totals.nodes, &totals.hexes, &totals.tets));
    return totals;
  }
  /// Returns the elements of a fragment on this rank. Its nodes have their own numbers, in the
  /// order of the nodes of the mesh.
  /// @param ifrag  fragment, from 1
  Mesh get_fragment_mesh(int ifrag) const
  {
    Mesh mesh = allocate(this->get_fragment_totals(ifrag));
    double* coords = mesh.coords.data();
    this->check(mesh.tets.empty()
        ? c_get_fragment_hexes(this->Handle, ifrag, coords, mesh.hexes.data())
        : c_get_fragment_tets(this->Handle, ifrag, coords, mesh.tets.data()));
    return mesh;
  }

private:
  static Mesh allocate(const Totals& totals)
  {
    Mesh mesh;
    mesh.coords.resize(3 * static_cast<std::size_t>(totals.nodes));
    mesh.hexes.resize(8 * static_cast<std::size_t>(totals.hexes));
    mesh.tets.resize(4 * static_cast<std::size_t>(totals.tets));
    return mesh;
  }
  void free() noexcept
  {
    if (this->Handle != 0)
    {
      c_delete_cml_psculptor(this->Handle);
    }
  }

  int Handle;
};

} // namespace cml

#endif
