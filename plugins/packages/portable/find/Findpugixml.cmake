# Debian's pugixml is a static library, whose code needs no new symbol of glibc.
if(NOT TARGET pugixml::pugixml)
  add_library(pugixml::pugixml STATIC IMPORTED GLOBAL)
  set_target_properties(pugixml::pugixml PROPERTIES
    IMPORTED_LOCATION /usr/lib/x86_64-linux-gnu/libpugixml.a
    INTERFACE_SYSTEM_INCLUDE_DIRECTORIES ${TALWEG_SYSROOT}/talweg/include)
endif()
set(pugixml_FOUND TRUE)
