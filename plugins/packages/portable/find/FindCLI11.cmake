include(${CMAKE_CURRENT_LIST_DIR}/header_only.cmake)
header_only(CLI11::CLI11)
set(CLI11_FOUND TRUE)
