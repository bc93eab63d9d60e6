# The plugin against an OpenFlipper that was built elsewhere.
set(OPENFLIPPER_SOURCE_DIR "" CACHE PATH "OpenFlipper's sources")
set(OPENFLIPPER_BUILD_DIR "" CACHE PATH "OpenFlipper's build folder")
set(OPENFLIPPER_QT_VERSION 5 CACHE STRING "5 for OpenFlipper 4.x, 6 for 5.x")
set(OPENFLIPPER_SOURCE_DIR_has OpenFlipper/BasePlugin/BaseInterface.hh)
set(OPENFLIPPER_BUILD_DIR_has Build/lib)
foreach(variable OPENFLIPPER_SOURCE_DIR OPENFLIPPER_BUILD_DIR)
  if(NOT EXISTS "${${variable}}/${${variable}_has}")
    message(FATAL_ERROR "${variable} is '${${variable}}', where no ${${variable}_has} is. "
                        "It names a tree of OpenFlipper (docs/openflipper.md).")
  endif()
endforeach()

if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()
set(CMAKE_AUTOMOC ON)
set(CMAKE_AUTORCC ON)
find_package(talweg REQUIRED)
find_package(OpenMesh REQUIRED)
find_package(OpenGL REQUIRED)
set(qt Qt${OPENFLIPPER_QT_VERSION})
set(parts Core Gui Widgets OpenGL)
if(OPENFLIPPER_QT_VERSION EQUAL 5)
  list(APPEND parts Script)
else()
  list(APPEND parts OpenGLWidgets)
endif()
find_package(${qt} REQUIRED COMPONENTS ${parts})
list(TRANSFORM parts PREPEND ${qt}::)

add_library(Plugin-Talweg MODULE HostMesh.cc Session.cc SessionReport.cc TalwegMouse.cc
                                 TalwegPanel.cc TalwegPanel.hh TalwegPlugin.cc TalwegPlugin.hh
                                 TalwegScripting.cc talweg.qrc)
target_compile_features(Plugin-Talweg PRIVATE cxx_std_20)
target_compile_definitions(Plugin-Talweg PRIVATE ENABLE_TRIANGLEMESH_SUPPORT
                                                 ENABLE_POLYLINE_SUPPORT INCLUDE_TEMPLATES)
set(host ${OPENFLIPPER_SOURCE_DIR})
file(GLOB types ${host}/Type-*)
target_include_directories(Plugin-Talweg SYSTEM PRIVATE
  ${host} ${host}/OpenFlipper/libs_required ${host}/OpenFlipper/libs_required/ACG ${types}
  ${OPENFLIPPER_BUILD_DIR}/OpenFlipper/PluginLib ${OPENMESH_INCLUDE_DIRS})
foreach(library ACG OpenFlipperPluginLib TRIANGLEMESH POLYLINE)
  find_library(OPENFLIPPER_${library} ${library} REQUIRED NO_DEFAULT_PATH
               PATHS ${OPENFLIPPER_BUILD_DIR}/Build/lib)
  target_link_libraries(Plugin-Talweg PRIVATE ${OPENFLIPPER_${library}})
endforeach()
target_link_libraries(Plugin-Talweg PRIVATE talweg::editing ${parts} OpenMeshCore OpenGL::GL)
target_link_options(Plugin-Talweg PRIVATE -Wl,--no-undefined)
