!> The calls of Sculptor.h, which says what they do, for Fortran 2003. Texts are ordinary Fortran strings here; pointers
!> come as type(c_ptr): call c_f_pointer(pointer, array, shape). Arrays of fractions and states are not copied: declare
!> them target and leave them as they are until the mesh is made.
module sculptor
  use, intrinsic :: iso_c_binding
  implicit none
  private

  integer(c_int), parameter, public :: sculptor_ok = 0, sculptor_error_handle = 1, sculptor_error_argument = 2, &
    sculptor_error_input = 3, sculptor_error_no_mesh = 4, sculptor_error_size = 5, sculptor_error_file = 6, &
    sculptor_error_memory = 7, sculptor_error_internal = 8
  public :: sculptor_create, sculptor_delete, sculptor_set_communicator, sculptor_set_option, &
    sculptor_set_box, sculptor_add_block, sculptor_clear_blocks, sculptor_set_neighbours, &
    sculptor_add_material, sculptor_set_material_ids, sculptor_add_state, sculptor_set_refinement, sculptor_clear_fields, &
    sculptor_make_mesh, sculptor_get_counts, sculptor_get_points, sculptor_get_elements, sculptor_get_point_ids, &
    sculptor_get_element_ids, sculptor_get_materials, sculptor_get_fragments, sculptor_get_state, &
    sculptor_get_point_state, sculptor_get_number, sculptor_get_geometry, sculptor_get_surfaces, sculptor_get_curves, &
    sculptor_get_vertices, sculptor_get_bounds, sculptor_write, sculptor_error_code, sculptor_error_message, &
    sculptor_warning_message

  interface
    integer(c_int) function sculptor_create(sculptor) bind(C)
      import
      integer(c_int), intent(out) :: sculptor
    end function

    integer(c_int) function sculptor_delete(sculptor) bind(C)
      import
      integer(c_int), value :: sculptor
    end function

    integer(c_int) function sculptor_set_communicator(sculptor, communicator) bind(C)
      import
      integer(c_int), value :: sculptor
      integer(c_int), value :: communicator
    end function

    integer(c_int) function c_sculptor_set_option(sculptor, name, value) bind(C, name="sculptor_set_option")
      import
      integer(c_int), value :: sculptor
      character(kind=c_char), intent(in) :: name(*)
      character(kind=c_char), intent(in) :: value(*)
    end function

    integer(c_int) function sculptor_set_box(sculptor, bounding_box, intervals) bind(C)
      import
      integer(c_int), value :: sculptor
      real(c_double), intent(in) :: bounding_box(6)
      integer(c_int), intent(in) :: intervals(3)
    end function

    integer(c_int) function sculptor_add_block(sculptor, level, bounding_box, intervals) bind(C)
      import
      integer(c_int), value :: sculptor
      integer(c_int), value :: level
      real(c_double), intent(in) :: bounding_box(6)
      integer(c_int), intent(in) :: intervals(3)
    end function

    integer(c_int) function sculptor_clear_blocks(sculptor) bind(C)
      import
      integer(c_int), value :: sculptor
    end function

    integer(c_int) function sculptor_set_neighbours(sculptor, neighbours) bind(C)
      import
      integer(c_int), value :: sculptor
      integer(c_int), intent(in) :: neighbours(6)
    end function

    integer(c_int) function c_sculptor_add_material(sculptor, name, vfrac) bind(C, name="sculptor_add_material")
      import
      integer(c_int), value :: sculptor
      character(kind=c_char), intent(in) :: name(*)
      real(c_double), intent(in) :: vfrac(*)
    end function

    integer(c_int) function sculptor_set_material_ids(sculptor, ids) bind(C)
      import
      integer(c_int), value :: sculptor
      integer(c_int), intent(in) :: ids(*)
    end function

    integer(c_int) function sculptor_set_refinement(sculptor, halvings) bind(C)
      import
      integer(c_int), value :: sculptor
      integer(c_int), intent(in) :: halvings(*)
    end function

    integer(c_int) function c_sculptor_add_state(sculptor, name, components, values) bind(C, name="sculptor_add_state")
      import
      integer(c_int), value :: sculptor
      character(kind=c_char), intent(in) :: name(*)
      integer(c_int), value :: components
      real(c_double), intent(in) :: values(*)
    end function

    integer(c_int) function sculptor_clear_fields(sculptor) bind(C)
      import
      integer(c_int), value :: sculptor
    end function

    integer(c_int) function sculptor_make_mesh(sculptor, tet_mesh) bind(C)
      import
      integer(c_int), value :: sculptor
      integer(c_int), value :: tet_mesh
    end function

    integer(c_int) function sculptor_get_counts(sculptor, points, elements, corners) bind(C)
      import
      integer(c_int), value :: sculptor
      integer(c_int64_t), intent(out) :: points
      integer(c_int64_t), intent(out) :: elements
      integer(c_int), intent(out) :: corners
    end function

    integer(c_int) function sculptor_get_points(sculptor, coordinates) bind(C)
      import
      integer(c_int), value :: sculptor
      type(c_ptr), intent(out) :: coordinates
    end function

    integer(c_int) function sculptor_get_elements(sculptor, connectivity) bind(C)
      import
      integer(c_int), value :: sculptor
      type(c_ptr), intent(out) :: connectivity
    end function

    integer(c_int) function sculptor_get_point_ids(sculptor, ids) bind(C)
      import
      integer(c_int), value :: sculptor
      type(c_ptr), intent(out) :: ids
    end function

    integer(c_int) function sculptor_get_element_ids(sculptor, ids) bind(C)
      import
      integer(c_int), value :: sculptor
      type(c_ptr), intent(out) :: ids
    end function

    integer(c_int) function sculptor_get_materials(sculptor, ids) bind(C)
      import
      integer(c_int), value :: sculptor
      type(c_ptr), intent(out) :: ids
    end function

    integer(c_int) function sculptor_get_fragments(sculptor, ids) bind(C)
      import
      integer(c_int), value :: sculptor
      type(c_ptr), intent(out) :: ids
    end function

    integer(c_int) function c_sculptor_get_state(sculptor, name, components, values) bind(C, name="sculptor_get_state")
      import
      integer(c_int), value :: sculptor
      character(kind=c_char), intent(in) :: name(*)
      integer(c_int), intent(out) :: components
      type(c_ptr), intent(out) :: values
    end function

    integer(c_int) function c_sculptor_get_point_state(sculptor, name, components, values) &
      bind(C, name="sculptor_get_point_state")
      import
      integer(c_int), value :: sculptor
      character(kind=c_char), intent(in) :: name(*)
      integer(c_int), intent(out) :: components
      type(c_ptr), intent(out) :: values
    end function

    integer(c_int) function c_sculptor_get_number(sculptor, name, index, value) bind(C, name="sculptor_get_number")
      import
      integer(c_int), value :: sculptor
      character(kind=c_char), intent(in) :: name(*)
      integer(c_int), value :: index
      real(c_double), intent(out) :: value
    end function

    integer(c_int) function sculptor_get_geometry(sculptor, dimensions, ids) bind(C)
      import
      integer(c_int), value :: sculptor
      type(c_ptr), intent(out) :: dimensions
      type(c_ptr), intent(out) :: ids
    end function

    integer(c_int) function sculptor_get_surfaces(sculptor, facets, corners, connectivity, ids) bind(C)
      import
      integer(c_int), value :: sculptor
      integer(c_int64_t), intent(out) :: facets
      integer(c_int), intent(out) :: corners
      type(c_ptr), intent(out) :: connectivity
      type(c_ptr), intent(out) :: ids
    end function

    integer(c_int) function sculptor_get_curves(sculptor, edges, connectivity, ids) bind(C)
      import
      integer(c_int), value :: sculptor
      integer(c_int64_t), intent(out) :: edges
      type(c_ptr), intent(out) :: connectivity
      type(c_ptr), intent(out) :: ids
    end function

    integer(c_int) function sculptor_get_vertices(sculptor, vertices, points, ids) bind(C)
      import
      integer(c_int), value :: sculptor
      integer(c_int64_t), intent(out) :: vertices
      type(c_ptr), intent(out) :: points
      type(c_ptr), intent(out) :: ids
    end function

    integer(c_int) function c_sculptor_get_bounds(sculptor, table, rows, columns, values) &
        bind(C, name="sculptor_get_bounds")
      import
      integer(c_int), value :: sculptor
      character(kind=c_char), intent(in) :: table(*)
      integer(c_int), intent(out) :: rows
      integer(c_int), intent(out) :: columns
      type(c_ptr), intent(out) :: values
    end function

    integer(c_int) function c_sculptor_write(sculptor, path) bind(C, name="sculptor_write")
      import
      integer(c_int), value :: sculptor
      character(kind=c_char), intent(in) :: path(*)
    end function

    integer(c_int) function sculptor_error_code(sculptor) bind(C)
      import
      integer(c_int), value :: sculptor
    end function

    type(c_ptr) function c_error_text(sculptor) bind(C, name="sculptor_error_text")
      import
      integer(c_int), value :: sculptor
    end function

    type(c_ptr) function c_warning_text(sculptor) bind(C, name="sculptor_warning_text")
      import
      integer(c_int), value :: sculptor
    end function

    integer(c_size_t) function strlen(text) bind(C)
      import
      type(c_ptr), value :: text
    end function
  end interface

contains

  integer(c_int) function sculptor_set_option(sculptor, name, value)
    integer(c_int), intent(in) :: sculptor
    character(*), intent(in) :: name
    character(*), intent(in) :: value
    sculptor_set_option = c_sculptor_set_option(sculptor, trim(name) // c_null_char, trim(value) // c_null_char)
  end function

  integer(c_int) function sculptor_add_material(sculptor, name, vfrac)
    integer(c_int), intent(in) :: sculptor
    character(*), intent(in) :: name
    real(c_double), intent(in), target :: vfrac(*)
    sculptor_add_material = c_sculptor_add_material(sculptor, trim(name) // c_null_char, vfrac)
  end function

  integer(c_int) function sculptor_add_state(sculptor, name, components, values)
    integer(c_int), intent(in) :: sculptor
    character(*), intent(in) :: name
    integer(c_int), intent(in) :: components
    real(c_double), intent(in), target :: values(*)
    sculptor_add_state = c_sculptor_add_state(sculptor, trim(name) // c_null_char, components, values)
  end function

  integer(c_int) function sculptor_get_state(sculptor, name, components, values)
    integer(c_int), intent(in) :: sculptor
    character(*), intent(in) :: name
    integer(c_int), intent(out) :: components
    type(c_ptr), intent(out) :: values
    sculptor_get_state = c_sculptor_get_state(sculptor, trim(name) // c_null_char, components, values)
  end function

  integer(c_int) function sculptor_get_point_state(sculptor, name, components, values)
    integer(c_int), intent(in) :: sculptor
    character(*), intent(in) :: name
    integer(c_int), intent(out) :: components
    type(c_ptr), intent(out) :: values
    sculptor_get_point_state = c_sculptor_get_point_state(sculptor, trim(name) // c_null_char, components, values)
  end function

  integer(c_int) function sculptor_get_number(sculptor, name, index, value)
    integer(c_int), intent(in) :: sculptor
    character(*), intent(in) :: name
    integer(c_int), intent(in) :: index
    real(c_double), intent(out) :: value
    sculptor_get_number = c_sculptor_get_number(sculptor, trim(name) // c_null_char, index, value)
  end function

  !> values: array(columns, rows).
  integer(c_int) function sculptor_get_bounds(sculptor, table, rows, columns, values)
    integer(c_int), intent(in) :: sculptor
    character(*), intent(in) :: table
    integer(c_int), intent(out) :: rows
    integer(c_int), intent(out) :: columns
    type(c_ptr), intent(out) :: values
    sculptor_get_bounds = c_sculptor_get_bounds(sculptor, trim(table) // c_null_char, rows, columns, values)
  end function

  integer(c_int) function sculptor_write(sculptor, path)
    integer(c_int), intent(in) :: sculptor
    character(*), intent(in) :: path
    sculptor_write = c_sculptor_write(sculptor, trim(path) // c_null_char)
  end function

  !> What the last call that failed tells; of a wrong handle, of the last such call.
  function sculptor_error_message(sculptor) result(message)
    integer(c_int), intent(in) :: sculptor
    character(:), allocatable :: message
    message = to_string(c_error_text(sculptor))
  end function

  !> The warnings of the last mesh, a line each.
  function sculptor_warning_message(sculptor) result(message)
    integer(c_int), intent(in) :: sculptor
    character(:), allocatable :: message
    message = to_string(c_warning_text(sculptor))
  end function

  function to_string(text) result(string)
    type(c_ptr), intent(in) :: text
    character(:), allocatable :: string
    character(kind=c_char), pointer :: characters(:)
    integer :: i
    call c_f_pointer(text, characters, [strlen(text)])
    allocate(character(size(characters)) :: string)
    do i = 1, size(characters)
      string(i:i) = characters(i)
    end do
  end function

end module sculptor
