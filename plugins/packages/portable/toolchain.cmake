# g++ 12 with its static C++ library, and the glibc of a sysroot that sysroot.sh made (TALWEG_SYSROOT) for a kind
# of machine (TALWEG_MACHINE). Programs run wherever glibc is as old as the sysroot's, or newer.
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES TALWEG_SYSROOT TALWEG_MACHINE)
set(machine ${TALWEG_MACHINE}-linux-gnu)
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR ${TALWEG_MACHINE})
set(CMAKE_C_COMPILER ${machine}-gcc-12)
set(CMAKE_CXX_COMPILER ${machine}-g++-12)
set(CMAKE_SYSROOT ${TALWEG_SYSROOT})
set(CMAKE_LIBRARY_ARCHITECTURE ${machine})

# By default the compiler would look for its own headers inside the root, and for libraries outside of it.
set(libraries ${TALWEG_SYSROOT}/usr/lib/${machine})
set(search "-B${libraries} -ffile-prefix-map=${CMAKE_SOURCE_DIR}=.")
# Unused functions are left out: copies in several sources, and parts of the core.
string(APPEND search " -ffunction-sections -fdata-sections")
set(CMAKE_C_FLAGS_INIT "${search}")
set(CMAKE_CXX_FLAGS_INIT "${search} -nostdinc++")
foreach(folder c++ c++machine c++/backward)
  string(APPEND CMAKE_CXX_FLAGS_INIT " -isystem ${TALWEG_SYSROOT}/talweg/include/${folder}")
endforeach()
# Code that refers to a symbol of a newer glibc does not link. The static libstdc++ must be followed by the
# library of threads, which was separate before glibc 2.34.
set(link "-static-libgcc -static-libstdc++ -pthread -L${TALWEG_SYSROOT}/talweg -L${libraries} -Wl,-z,defs -Wl,--gc-sections")
foreach(kind EXE SHARED MODULE)
  set(CMAKE_${kind}_LINKER_FLAGS_INIT "${link}")
endforeach()
set(CMAKE_CXX_STANDARD_LIBRARIES ${TALWEG_SYSROOT}/talweg/newer_glibc.o)

# Header-only libraries come from the host (sysroot.sh links them into one folder); zlib and libpng are static
# libraries of the root.
list(PREPEND CMAKE_MODULE_PATH ${CMAKE_CURRENT_LIST_DIR}/find)
set(ZLIB_LIBRARY ${libraries}/libz.a CACHE FILEPATH "")
set(PNG_LIBRARY ${libraries}/libpng16.a CACHE FILEPATH "")
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE NEVER)
