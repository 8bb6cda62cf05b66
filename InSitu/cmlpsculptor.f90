!> The calls of CMLPSculptor.c.h, which says what they do, for Fortran 2003. Errors: sculptor_error_code and
!> sculptor_error_message of module sculptor (sculptor.f90), whose calls take the same handles.
module cml_psculptor
  use, intrinsic :: iso_c_binding
  implicit none
  private

  public :: c_create_cml_psculptor, c_delete_cml_psculptor, c_mesh_from_data, c_get_free_totals, &
    c_get_free_hexes, c_get_free_tets, c_get_num_fragments, c_get_fragment_totals, c_get_fragment_hexes, &
    c_get_fragment_tets

  interface
    integer(c_int) function c_create_cml_psculptor() bind(C)
      import
    end function

    subroutine c_delete_cml_psculptor(handle) bind(C)
      import
      integer(c_int), value :: handle
    end subroutine

    integer(c_int) function c_mesh_from_data(handle, xmin, ymin, zmin, xmax, ymax, zmax, xint, yint, zint, vfrac, &
      neighbor_plus_i, neighbor_negative_i, neighbor_plus_j, neighbor_negative_j, neighbor_plus_k, &
      neighbor_negative_k, auto_refine, stair_step, smooth, tet_mesh) bind(C)
      import
      integer(c_int), value :: handle
      real(c_double), value :: xmin, ymin, zmin, xmax, ymax, zmax
      integer(c_int), value :: xint, yint, zint
      real(c_double), intent(in) :: vfrac(*)
      integer(c_int), value :: neighbor_plus_i, neighbor_negative_i, neighbor_plus_j, neighbor_negative_j, &
        neighbor_plus_k, neighbor_negative_k, auto_refine, stair_step, smooth, tet_mesh
    end function

    subroutine c_get_free_totals(handle, num_nodes, num_hexes, num_tets) bind(C)
      import
      integer(c_int), value :: handle
      integer(c_int), intent(out) :: num_nodes, num_hexes, num_tets
    end subroutine

    integer(c_int) function c_get_free_hexes(handle, coords, hexes) bind(C)
      import
      integer(c_int), value :: handle
      real(c_double), intent(out) :: coords(*)
      integer(c_int), intent(out) :: hexes(*)
    end function

    integer(c_int) function c_get_free_tets(handle, coords, tets) bind(C)
      import
      integer(c_int), value :: handle
      real(c_double), intent(out) :: coords(*)
      integer(c_int), intent(out) :: tets(*)
    end function

    integer(c_int) function c_get_num_fragments(handle) bind(C)
      import
      integer(c_int), value :: handle
    end function

    integer(c_int) function c_get_fragment_totals(handle, ifrag, num_nodes, num_hexes, num_tets) bind(C)
      import
      integer(c_int), value :: handle, ifrag
      integer(c_int), intent(out) :: num_nodes, num_hexes, num_tets
    end function

    integer(c_int) function c_get_fragment_hexes(handle, ifrag, coords, hexes) bind(C)
      import
      integer(c_int), value :: handle, ifrag
      real(c_double), intent(out) :: coords(*)
      integer(c_int), intent(out) :: hexes(*)
    end function

    integer(c_int) function c_get_fragment_tets(handle, ifrag, coords, tets) bind(C)
      import
      integer(c_int), value :: handle, ifrag
      real(c_double), intent(out) :: coords(*)
      integer(c_int), intent(out) :: tets(*)
    end function
  end interface

end module cml_psculptor
