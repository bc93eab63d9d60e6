# Debian packages by cpack: libtalweg0.2, libtalweg-dev, talweg, python3-talweg (docs/packaging.md).
set(CPACK_PACKAGE_NAME talweg)
set(CPACK_PACKAGE_VENDOR "The Talweg authors")
set(CPACK_PACKAGE_CONTACT "The Talweg authors <talweg@example.org>")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_GENERATOR DEB)
set(CPACK_STRIP_FILES ON)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_PACKAGING_INSTALL_PREFIX ${CMAKE_INSTALL_PREFIX})
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

set(CPACK_COMPONENTS_ALL development)
if(TALWEG_IS_SHARED)
  list(APPEND CPACK_COMPONENTS_ALL runtime)
endif()
if(TALWEG_BUILD_DRIVER)
  list(APPEND CPACK_COMPONENTS_ALL driver)
endif()
if(TALWEG_BUILD_DRIVER AND TALWEG_PYTHON)
  list(APPEND CPACK_COMPONENTS_ALL python)
  include(${CMAKE_CURRENT_LIST_DIR}/python_package.cmake)
endif()
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(talweg_soversion ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME libtalweg${talweg_soversion})
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libtalweg-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DRIVER_PACKAGE_NAME talweg)
set(CPACK_DEBIAN_DRIVER_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-talweg)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3:any (>= 3.9), python3-numpy")  # and on the driver's package
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA ${PROJECT_BINARY_DIR}/python/postinst
                                              ${PROJECT_BINARY_DIR}/python/prerm)

# Dependencies of the binaries are read from the binaries; dependencies of the headers are listed here.
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_DRIVER_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
# Debian wants a trigger for the linker's cache; the scripts that CPack writes beside it do no harm.
file(WRITE ${PROJECT_BINARY_DIR}/triggers "activate-noawait ldconfig\n")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_CONTROL_EXTRA ${PROJECT_BINARY_DIR}/triggers)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS
    ${PROJECT_BINARY_DIR}/intrinsic ${PROJECT_BINARY_DIR}/heat ${PROJECT_BINARY_DIR}/core
    ${PROJECT_BINARY_DIR}/plugins/loader)
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS ON)
# Any BLAS works; this one is fast, and starts no threads (docs/development/decisions.md).
set(CPACK_DEBIAN_RUNTIME_PACKAGE_RECOMMENDS "libopenblas0-serial | libopenblas0")
if(NOT TALWEG_IS_SHARED)
  set(CPACK_DEBIAN_DRIVER_PACKAGE_RECOMMENDS "${CPACK_DEBIAN_RUNTIME_PACKAGE_RECOMMENDS}")
endif()
set(CPACK_COMPONENT_PYTHON_DEPENDS driver)  # the driver's package has the plugins
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libeigen3-dev, libopenmesh-dev")
if(TALWEG_IS_SHARED)
  set(CPACK_COMPONENT_DEVELOPMENT_DEPENDS runtime)
  set(CPACK_COMPONENT_DRIVER_DEPENDS runtime)
else()
  string(APPEND CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
         ", libsuitesparse-dev, libpugixml-dev, zlib1g-dev, libfmt-dev")
endif()

# Each package's description begins with its own synopsis, so there is no common synopsis.
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")
set(about "Talweg draws curves on triangle meshes, smooths them while they keep
close to the drawing, and measures them.")
set(CPACK_DEBIAN_RUNTIME_DESCRIPTION "curves on surface meshes (shared libraries)
${about}
.
This package holds the shared libraries.")
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "curves on surface meshes (development files)
${about}
.
This package holds the C++20 headers, a CMake package and a pkg-config file.")
set(CPACK_DEBIAN_DRIVER_DESCRIPTION "curves on surface meshes (command line)
${about}
.
This package holds the program talweg.")
set(CPACK_DEBIAN_PYTHON_DESCRIPTION "curves on surface meshes (Python 3)
${about}
.
This package holds the Python package, which uses the plugins of talweg.")

# Debian wants the licence and a changelog in every package; a plain installation needs no copies.
string(TIMESTAMP now "%a, %d %b %Y %H:%M:%S +0000" UTC)
file(WRITE ${PROJECT_BINARY_DIR}/changelog.Debian
"talweg (${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}) unstable; urgency=medium

  * Version ${PROJECT_VERSION}; changelog.gz says what is new.

 -- ${CPACK_PACKAGE_CONTACT}  ${now}
")
file(COPY_FILE ${PROJECT_SOURCE_DIR}/CHANGELOG.md ${PROJECT_BINARY_DIR}/changelog)
find_program(TALWEG_GZIP gzip)
mark_as_advanced(TALWEG_GZIP)
if(TALWEG_GZIP)
  execute_process(COMMAND ${TALWEG_GZIP} -9nf changelog changelog.Debian
                  WORKING_DIRECTORY ${PROJECT_BINARY_DIR})
endif()
foreach(component IN LISTS CPACK_COMPONENTS_ALL)
  string(TOUPPER ${component} upper)
  set(folder ${CMAKE_INSTALL_DATAROOTDIR}/doc/${CPACK_DEBIAN_${upper}_PACKAGE_NAME})
  install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${folder} RENAME copyright
          COMPONENT ${component} EXCLUDE_FROM_ALL)
  install(FILES ${PROJECT_BINARY_DIR}/changelog.gz ${PROJECT_BINARY_DIR}/changelog.Debian.gz
          DESTINATION ${folder} OPTIONAL COMPONENT ${component} EXCLUDE_FROM_ALL)
endforeach()
include(CPack)
