if(NOT TARGET pugixml::pugixml)
  add_library(pugixml::pugixml STATIC IMPORTED GLOBAL)
  set_target_properties(pugixml::pugixml PROPERTIES
    IMPORTED_LOCATION ${TALWEG_WINDOWS}/lib/libpugixml.a
    INTERFACE_SYSTEM_INCLUDE_DIRECTORIES ${TALWEG_WINDOWS}/include)
endif()
set(pugixml_FOUND TRUE)
