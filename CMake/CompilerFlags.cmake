# Flags of all our code: vfm_flags is linked privately by every target.
option(VFM_WERROR "Warnings of the compiler are errors" OFF)
set(VFM_SANITIZE "" CACHE STRING "Sanitizers of GCC and Clang: address,undefined or thread")

# -ffp-contract=off: the mesh is the same bit for bit on every machine of one architecture, but for exp, of which glibc has one for
# processors with fused multiply-add and another for those without.
add_library(vfm_flags INTERFACE)
target_compile_options(vfm_flags INTERFACE -Wall -Wextra -ffp-contract=off)
if (VFM_WERROR)
  target_compile_options(vfm_flags INTERFACE -Werror)
endif ()

# What is instrumented must be so as a whole. The first report ends the program.
if (VFM_SANITIZE)
  add_compile_options("-fsanitize=${VFM_SANITIZE}" -fno-sanitize-recover=all -fno-omit-frame-pointer
    $<$<COMPILE_LANGUAGE:CXX>:-D_GLIBCXX_ASSERTIONS>)
  add_link_options("-fsanitize=${VFM_SANITIZE}")
endif ()
