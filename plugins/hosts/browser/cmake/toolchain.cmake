# Debian's emscripten, with this machine's header-only libraries, and two small libraries that are compiled
# from Debian's sources.
include(/usr/share/emscripten/cmake/Modules/Platform/Emscripten.cmake)
# Native WebAssembly exceptions: exceptions by JavaScript make all code several times slower.
set(CMAKE_CXX_FLAGS_INIT "-fwasm-exceptions")
set(CMAKE_EXE_LINKER_FLAGS_INIT "-fwasm-exceptions")
# There are no threads, but the functions of threads are declared, which is enough here.
set(CMAKE_HAVE_LIBC_PTHREAD TRUE CACHE INTERNAL "")

# A folder of its own, since /usr/include has headers of this machine's system, too.
set(TALWEG_SYSROOT ${CMAKE_BINARY_DIR}/host)
file(MAKE_DIRECTORY ${TALWEG_SYSROOT}/talweg/include)
foreach(part OpenMesh eigen3 fmt nlohmann fast_float)
  file(CREATE_LINK /usr/include/${part} ${TALWEG_SYSROOT}/talweg/include/${part} SYMBOLIC)
endforeach()
set(FAST_FLOAT_INCLUDE_DIR ${TALWEG_SYSROOT}/talweg/include CACHE PATH "")
list(PREPEND CMAKE_MODULE_PATH ${CMAKE_CURRENT_LIST_DIR}
     ${CMAKE_CURRENT_LIST_DIR}/../../../packages/portable/find)
set(Eigen3_DIR /usr/share/eigen3/cmake CACHE PATH "")
