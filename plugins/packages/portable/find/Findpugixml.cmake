# Debian 12's static library, whose code needs no new symbol of glibc (sysroot.sh links it).
if(NOT TARGET pugixml::pugixml)
  add_library(pugixml::pugixml STATIC IMPORTED GLOBAL)
  set_target_properties(pugixml::pugixml PROPERTIES
    IMPORTED_LOCATION ${TALWEG_SYSROOT}/talweg/libpugixml.a
    INTERFACE_SYSTEM_INCLUDE_DIRECTORIES ${TALWEG_SYSROOT}/talweg/include)
endif()
set(pugixml_FOUND TRUE)
