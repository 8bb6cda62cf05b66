/**
 * CMLPSculptor.hpp: the calls of CMLPSculptor.c.h as a class, for C++11 and later. Methods have the report's names and arguments,
 * give arrays as vectors, and throw cml::Error instead of returning codes.
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

/// What a call refused; code() is a SculptorCode.
class Error : public std::runtime_error
{
public:
  Error(int code, const std::string& text) : std::runtime_error(text), Code(code) {}
  int code() const noexcept { return this->Code; }

private:
  int Code;
};

struct Totals
{
  int nodes, hexes, tets;
};

/// This rank's part of the mesh, or of a fragment: hexes or tets is empty.
struct Mesh
{
  std::vector<double> coords; ///< 3 a node
  std::vector<int> hexes;     ///< 8 a hexahedron
  std::vector<int> tets;      ///< 4 a tetrahedron
};

/// A sculptor, which is deleted with this. Collective are: to make and to destroy one, to assign, mesh_from_data.
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
  /// The other may only be destroyed or assigned to.
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

  /// For the calls of Sculptor.h: s.check(sculptor_set_option(s.handle(), "IndexBase", "1")).
  int handle() const noexcept { return this->Handle; }
  /// Throws Error unless the code of a call with this sculptor is that of success.
  void check(int code) const
  {
    if (code != SCULPTOR_OK)
    {
      throw Error(code, sculptor_error_text(this->Handle));
    }
  }

  /// Arguments as of c_mesh_from_data. vfrac: xint * yint * zint values, x fastest.
  void mesh_from_data(double xmin, double ymin, double zmin, double xmax, double ymax, double zmax,
    int xint, int yint, int zint, const double* vfrac, int neighbor_plus_i, int neighbor_negative_i,
    int neighbor_plus_j, int neighbor_negative_j, int neighbor_plus_k, int neighbor_negative_k,
    int auto_refine, int stair_step, int smooth, int tet_mesh)
  {
    this->check(c_mesh_from_data(this->Handle, xmin, ymin, zmin, xmax, ymax, zmax, xint, yint, zint,
      const_cast<double*>(vfrac), // is only read
      neighbor_plus_i, neighbor_negative_i, neighbor_plus_j, neighbor_negative_j, neighbor_plus_k,
      neighbor_negative_k, auto_refine, stair_step, smooth, tet_mesh));
  }

  Totals get_free_totals() const
  {
    Totals totals;
    c_get_free_totals(this->Handle, &totals.nodes, &totals.hexes, &totals.tets);
    this->check(sculptor_error_code(this->Handle));
    return totals;
  }
  Mesh get_free_mesh() const
  {
    Mesh mesh = allocate(this->get_free_totals());
    double* coords = mesh.coords.data();
    this->check(mesh.tets.empty() ? c_get_free_hexes(this->Handle, coords, mesh.hexes.data())
                                  : c_get_free_tets(this->Handle, coords, mesh.tets.data()));
    return mesh;
  }

  int get_num_fragments() const
  {
    const int fragments = c_get_num_fragments(this->Handle);
    this->check(sculptor_error_code(this->Handle));
    return fragments;
  }
  /// ifrag: from 1.
  Totals get_fragment_totals(int ifrag) const
  {
    Totals totals;
    this->check(
      c_get_fragment_totals(this->Handle, ifrag, &totals.nodes, &totals.hexes, &totals.tets));
    return totals;
  }
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
