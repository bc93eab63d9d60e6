# The library uses headers of OpenMesh only.
include(${CMAKE_CURRENT_LIST_DIR}/header_only.cmake)
header_only(OpenMeshCore)
set(OpenMesh_FOUND TRUE)
