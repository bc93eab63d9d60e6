# note_a_slow_blas(): prints a note when CHOLMOD uses the reference BLAS, which is slow. The file of
# the reference BLAS is libblas.so.3.MINOR; for other BLAS libraries, libblas.so.3 is a link to a
# file of another name.
function(note_a_slow_blas)
  if(NOT CHOLMOD_LIBRARY)
    return()
  endif()
  cmake_path(GET CHOLMOD_LIBRARY PARENT_PATH folder)
  find_file(blas libblas.so.3 HINTS ${folder} NO_CACHE)
  if(NOT blas)
    return()
  endif()
  file(REAL_PATH ${blas} blas)
  if(blas MATCHES "/libblas\\.so\\.3\\.[0-9.]+$")
    message(STATUS "Talweg: ${blas} is the reference BLAS. With OpenBLAS the paper's method opens a mesh "
                   "in two thirds of the time (Debian: libopenblas0-serial)")
  endif()
endfunction()
