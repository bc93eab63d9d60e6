# The CHOLMOD that ../../portable/cholmod built in TALWEG_CHOLMOD_BUILD, from the sources in TALWEG_SUITESPARSE.
set(CHOLMOD_LIBRARY ${TALWEG_CHOLMOD_BUILD}/libtalweg-cholmod.dll.a CACHE FILEPATH "")
if(NOT TARGET SuiteSparse::CHOLMOD)
  add_library(SuiteSparse::CHOLMOD UNKNOWN IMPORTED GLOBAL)
  set_target_properties(SuiteSparse::CHOLMOD PROPERTIES IMPORTED_LOCATION ${CHOLMOD_LIBRARY})
  target_include_directories(SuiteSparse::CHOLMOD SYSTEM INTERFACE
    ${TALWEG_SUITESPARSE}/CHOLMOD/Include ${TALWEG_SUITESPARSE}/SuiteSparse_config)
endif()
set(CHOLMOD_FOUND TRUE)
