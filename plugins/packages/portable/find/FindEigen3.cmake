include(${CMAKE_CURRENT_LIST_DIR}/header_only.cmake)
header_only(Eigen3::Eigen)
set(Eigen3_FOUND TRUE)
