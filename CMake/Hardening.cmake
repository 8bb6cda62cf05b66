# Compiler and linker flags that protect programs, of all targets that are added afterwards.

# Programs are position-independent, and addresses of functions are read-only after the start.
include(CheckPIESupported)
check_pie_supported()
if (UNIX AND NOT APPLE)
  add_link_options(LINKER:-z,relro LINKER:-z,now)
endif ()

# The program ends when a buffer on the stack overflows, or a copy goes beyond the end of an object.
# Sanitizers find both by themselves; without optimisation the second check only warns.
add_compile_options(-fstack-protector-strong)
if (NOT VFM_SANITIZE)
  add_compile_options("$<$<NOT:$<CONFIG:Debug>>:-U_FORTIFY_SOURCE;-D_FORTIFY_SOURCE=2>")
endif ()
