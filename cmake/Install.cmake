# cmake --install: programs, the kit that submissions are compiled with, and the data below
# share/ticker, each file at the same place as in the checkout.
include(GNUInstallDirs)
set(CMAKE_INSTALL_LIBDIR lib)
install(TARGETS ticker tick1star-template tick1star-reference
  RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}")
install(TARGETS ticker-jail ticker-decode RUNTIME DESTINATION "${CMAKE_INSTALL_LIBEXECDIR}/ticker")
# Clang reads a precompiled header only where it was made.
install(DIRECTORY "${CMAKE_BINARY_DIR}/kit" DESTINATION "${CMAKE_INSTALL_LIBDIR}/ticker"
  PATTERN "Framework.pch" EXCLUDE)

if(TARGET ticker-candidates)
  install(TARGETS ticker-candidates RUNTIME DESTINATION "${CMAKE_INSTALL_LIBEXECDIR}/ticker")
endif()

set(share "${CMAKE_INSTALL_DATADIR}/ticker")
install(DIRECTORY scenes assets student_template DESTINATION "${share}" USE_SOURCE_PERMISSIONS)
install(DIRECTORY reference_solution/exercise reference_solution/tick1
  DESTINATION "${share}/reference_solution")
install(DIRECTORY grader/exercises DESTINATION "${share}/grader")
install(DIRECTORY grader/integrations grader/corpus/samples DESTINATION "${share}/grader"
  USE_SOURCE_PERMISSIONS
  PATTERN "*.h" EXCLUDE
  PATTERN "CMakeLists.txt" EXCLUDE)
install(FILES grader/report/student-view.json DESTINATION "${share}/grader/report")
install(FILES grader/rubric/rubric.json DESTINATION "${share}/grader/rubric")
install(DIRECTORY docs DESTINATION "${share}"
  PATTERN "make-figures" EXCLUDE PATTERN "plot-cost.awk" EXCLUDE PATTERN "Doxyfile" EXCLUDE)
install(FILES README.md LICENSE CHANGELOG.md DESTINATION "${share}")
