# cpack -G DEB: one package with the programs, the kit and the data. What submissions are compiled
# with has to be the compiler of the kit, so that is a dependency; the libraries are found by
# dpkg-shlibdeps.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME ticker)
set(TICKER_CONTACT "The ticker contributors <noreply@github.com>" CACHE STRING "Maintainer of the package")
set(CPACK_PACKAGE_CONTACT "${TICKER_CONTACT}")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "autograder for a ray-tracing exercise")
set(CPACK_PACKAGE_DESCRIPTION "Compiles each submission in a sandbox, asks it questions whose answers
an independent renderer knows, and writes a page for each student.")
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION education)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
file(REAL_PATH "${TICKER_KIT_COMPILER}" kit_compiler)
string(REGEX MATCH "[0-9]+$" compiler_version "${kit_compiler}")
set(CPACK_DEBIAN_PACKAGE_DEPENDS "g++-${compiler_version}, lld, bubblewrap")
if(TICKER_LIBCLANG)  # the headers that Clang's parser brings itself
  file(REAL_PATH "${TICKER_LIBCLANG}" libclang)
  if(libclang MATCHES "(clang|llvm)-([0-9]+)")
    string(APPEND CPACK_DEBIAN_PACKAGE_DEPENDS ", libclang-common-${CMAKE_MATCH_2}-dev")
  endif()
endif()
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "similarity-tester")  # for ticker similar
set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA "${PROJECT_SOURCE_DIR}/cmake/debian/postrm")
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

# The texts that Debian asks of every package, and what the shells and man read.
set(texts "${CMAKE_BINARY_DIR}/package-texts")
add_custom_target(package-texts
  COMMAND "${CMAKE_COMMAND}" -DTICKER=$<TARGET_FILE:ticker> -DTEXTS=${texts}
    "-DRENDERERS=$<TARGET_FILE:tick1star-reference>|$<TARGET_FILE:tick1star-template>"
    -DSOURCE=${PROJECT_SOURCE_DIR} -DVERSION=${PROJECT_VERSION} "-DCONTACT=${TICKER_CONTACT}"
    -P "${PROJECT_SOURCE_DIR}/cmake/PackageTexts.cmake"
  VERBATIM)
install(DIRECTORY "${texts}/" DESTINATION "${CMAKE_INSTALL_DATADIR}" OPTIONAL)
include(CPack)
