# debian_source(FILE SHA256 FOLDER): the sources of a Debian package, unpacked once into the build; FOLDER is
# set to their folder. A copy of the file may lie in TALWEG_DOWNLOADS.
set(TALWEG_DOWNLOADS ${CMAKE_BINARY_DIR}/downloads CACHE PATH "The folder of downloaded sources")
function(debian_source path sha256 folder)
  cmake_path(GET path FILENAME name)
  file(DOWNLOAD https://deb.debian.org/debian/pool/main/${path} ${TALWEG_DOWNLOADS}/${name}
       EXPECTED_HASH SHA256=${sha256} INACTIVITY_TIMEOUT 60)
  set(unpacked ${CMAKE_BINARY_DIR}/sources/${name})
  if(NOT EXISTS ${unpacked})
    file(ARCHIVE_EXTRACT INPUT ${TALWEG_DOWNLOADS}/${name} DESTINATION ${unpacked})
  endif()
  file(GLOB inside ${unpacked}/*)
  set(${folder} ${inside} PARENT_SCOPE)
endfunction()
