include(CMakePackageConfigHelpers)
install(TARGETS zona_mpm zona_beam zona_coupling zona_abi EXPORT zona
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
foreach(module mpm beam coupling)
  # hdf5_handle.h and frequency_lanes.h are of no use to others, who need no headers of HDF5 then.
  install(DIRECTORY ${module} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/zona FILES_MATCHING PATTERN "*.h"
          PATTERN hdf5_handle.h EXCLUDE PATTERN frequency_lanes.h EXCLUDE PATTERN elements EXCLUDE)
endforeach()
install(TARGETS zona_beam_elements LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT zona NAMESPACE zona:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/zona)
configure_package_config_file(cmake/zonaConfig.cmake.in ${CMAKE_BINARY_DIR}/zonaConfig.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/zona)
write_basic_package_version_file(${CMAKE_BINARY_DIR}/zonaConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/zonaConfig.cmake ${CMAKE_BINARY_DIR}/zonaConfigVersion.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/zona)
install(DIRECTORY docs/examples DESTINATION ${CMAKE_INSTALL_DATADIR}/zona
        FILES_MATCHING PATTERN "*.cc" PATTERN CMakeLists.txt PATTERN build EXCLUDE)
