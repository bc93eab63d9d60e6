# Debian's g++-mingw-w64-x86-64-posix, with this machine's header-only libraries, and the compiled libraries of
# libraries/ in TALWEG_WINDOWS. The programs need nothing but Windows.
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES TALWEG_WINDOWS)
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR AMD64)
set(CMAKE_C_COMPILER x86_64-w64-mingw32-gcc-posix)
set(CMAKE_CXX_COMPILER x86_64-w64-mingw32-g++-posix)
set(CMAKE_RC_COMPILER x86_64-w64-mingw32-windres)
# Windows 10 or newer. The C library's printf lacks formats of C99; libstdc++'s headers select mingw-w64's printf instead.
set(flags "-D_WIN32_WINNT=0x0A00 -DWIN32_LEAN_AND_MEAN -DNOMINMAX -ffile-prefix-map=${CMAKE_SOURCE_DIR}=.")
set(CMAKE_C_FLAGS_INIT "${flags}")
set(CMAKE_CXX_FLAGS_INIT "${flags} -include ${CMAKE_CURRENT_LIST_DIR}/utf8_paths.hpp")
foreach(kind EXE SHARED MODULE)  # a time stamp would make the bytes of every build differ
  set(CMAKE_${kind}_LINKER_FLAGS_INIT "-static -Wl,--no-insert-timestamp")
endforeach()
find_program(CMAKE_CROSSCOMPILING_EMULATOR NAMES wine64 wine PATHS /usr/lib/wine)

# The headers are linked one by one, because /usr/include also has headers of Linux.
set(TALWEG_SYSROOT ${TALWEG_WINDOWS})
file(MAKE_DIRECTORY ${TALWEG_SYSROOT}/talweg/include)
foreach(part CLI OpenMesh eigen3 fmt nlohmann xxhash.h)
  file(CREATE_LINK /usr/include/${part} ${TALWEG_SYSROOT}/talweg/include/${part} SYMBOLIC)
endforeach()
list(PREPEND CMAKE_MODULE_PATH ${CMAKE_CURRENT_LIST_DIR}/find ${CMAKE_CURRENT_LIST_DIR}/../portable/find)
set(Eigen3_DIR /usr/share/eigen3/cmake CACHE PATH "")
set(ZLIB_LIBRARY ${TALWEG_WINDOWS}/lib/libz.a CACHE FILEPATH "")
set(ZLIB_INCLUDE_DIR ${TALWEG_WINDOWS}/include CACHE PATH "")
set(PNG_LIBRARY ${TALWEG_WINDOWS}/lib/libpng.a CACHE FILEPATH "")
set(PNG_PNG_INCLUDE_DIR ${TALWEG_WINDOWS}/include CACHE PATH "")
