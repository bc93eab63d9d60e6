# The components of ParaView that the plugin needs, and Qt if its widgets can be built.
find_package(ParaView 5.11 REQUIRED COMPONENTS RemotingCore RemotingServerManager RemotingViews
             RemotingClientServerStream WrapClientServer ProcessXML
             OPTIONAL_COMPONENTS pqApplicationComponents)
find_package(Qt5 QUIET COMPONENTS Widgets)

# ParaView's targets for widgets name these libraries, which only ParaView's own libraries need.
foreach(unneeded IN ITEMS Boost::boost LibXml2::LibXml2 NetCDF::NetCDF hdf5::hdf5 hdf5::hdf5_hl)
  if(NOT TARGET ${unneeded})
    add_library(${unneeded} INTERFACE IMPORTED)
  endif()
endforeach()
