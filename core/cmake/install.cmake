# Installs, besides the libraries, their headers, the CMake package and talweg.pc.
include(${CMAKE_CURRENT_LIST_DIR}/front_headers.cmake)
front_headers(${PROJECT_SOURCE_DIR} headers)
foreach(header IN LISTS headers)
  set(folder talweg)
  if(NOT header MATCHES "^core/front/")
    cmake_path(GET header PARENT_PATH folder)
    set(folder talweg/${folder})
  endif()
  install(FILES ${PROJECT_SOURCE_DIR}/${header} COMPONENT development
          DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/${folder})
  # A change of a header's includes configures again, since included headers are installed, too.
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${header})
endforeach()

include(CMakePackageConfigHelpers)
set(talweg_cmake_dir ${CMAKE_INSTALL_LIBDIR}/cmake/talweg)

get_target_property(talweg_type talweg_core TYPE)
set(TALWEG_IS_SHARED OFF)
if(talweg_type STREQUAL SHARED_LIBRARY)
  set(TALWEG_IS_SHARED ON)
endif()

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/talwegConfig.cmake.in
  ${PROJECT_BINARY_DIR}/talwegConfig.cmake INSTALL_DESTINATION ${talweg_cmake_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/talwegConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(EXPORT talweg NAMESPACE talweg:: FILE talwegTargets.cmake
        DESTINATION ${talweg_cmake_dir} COMPONENT development)
install(FILES ${PROJECT_BINARY_DIR}/talwegConfig.cmake
              ${PROJECT_BINARY_DIR}/talwegConfigVersion.cmake
        DESTINATION ${talweg_cmake_dir} COMPONENT development)

# A static library's users link its dependencies, so these are public there. CHOLMOD has no .pc file
# before SuiteSparse 7.
set(talweg_pc_requires "eigen3 openmesh")
set(talweg_pc_libs "")
if(NOT TALWEG_IS_SHARED)
  string(APPEND talweg_pc_requires " pugixml zlib fmt")
  if(TALWEG_CHOLMOD)
    install(FILES ${PROJECT_SOURCE_DIR}/heat/cmake/FindCHOLMOD.cmake
            DESTINATION ${talweg_cmake_dir} COMPONENT development)
  endif()
  if(TALWEG_CHOLMOD AND CHOLMOD_DIR)
    string(APPEND talweg_pc_requires " CHOLMOD")
  elseif(TALWEG_CHOLMOD)
    cmake_path(GET CHOLMOD_LIBRARY PARENT_PATH folder)
    if(NOT folder IN_LIST CMAKE_CXX_IMPLICIT_LINK_DIRECTORIES)
      string(APPEND talweg_pc_libs " -L${folder}")
    endif()
    string(APPEND talweg_pc_libs " -lcholmod")
  endif()
  string(APPEND talweg_pc_libs " -pthread -ldl")
endif()
# Relative to the file, so that an installed tree can be moved.
file(RELATIVE_PATH talweg_pc_up ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
string(REGEX REPLACE "/$" "" talweg_pc_up "${talweg_pc_up}")
cmake_path(APPEND talweg_pc_includedir "\${prefix}" "${CMAKE_INSTALL_INCLUDEDIR}")
cmake_path(APPEND talweg_pc_libdir "\${prefix}" "${CMAKE_INSTALL_LIBDIR}")
configure_file(${CMAKE_CURRENT_LIST_DIR}/talweg.pc.in ${PROJECT_BINARY_DIR}/talweg.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/talweg.pc
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)

# The manual page, packed as Debian wants it where that can be done.
if(TALWEG_BUILD_DRIVER)
  configure_file(${CMAKE_CURRENT_LIST_DIR}/talweg.1.in ${PROJECT_BINARY_DIR}/talweg.1 @ONLY)
  set(talweg_man_page ${PROJECT_BINARY_DIR}/talweg.1)
  find_program(TALWEG_GZIP gzip)
  mark_as_advanced(TALWEG_GZIP)
  if(TALWEG_GZIP)
    execute_process(COMMAND ${TALWEG_GZIP} -9nkf talweg.1 WORKING_DIRECTORY ${PROJECT_BINARY_DIR})
    string(APPEND talweg_man_page .gz)
  endif()
  install(FILES ${talweg_man_page} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT driver)
endif()
