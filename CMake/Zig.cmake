# Toolchain: compiles by zig (PyPI's ziglang) for Linux with glibc 2.28 or later.
# VFM_ZIG: path of zig; VFM_PROCESSOR: x86_64 or aarch64. Both are environment variables.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR "$ENV{VFM_PROCESSOR}")
set(zig "$ENV{VFM_ZIG}")
set(target -target "${CMAKE_SYSTEM_PROCESSOR}-linux-gnu.2.28")
set(CMAKE_C_COMPILER "${zig}" cc ${target})
set(CMAKE_CXX_COMPILER "${zig}" c++ ${target})
foreach (language C CXX)
  set(CMAKE_${language}_ARCHIVE_CREATE "\"${zig}\" ar qc <TARGET> <OBJECTS>")
  set(CMAKE_${language}_ARCHIVE_FINISH "\"${zig}\" ranlib <TARGET>")
endforeach ()
# A wheel needs nothing but glibc, so optional libraries of this machine are not linked.
foreach (package EXPAT ZLIB)
  set(CMAKE_DISABLE_FIND_PACKAGE_${package} ON)
endforeach ()
