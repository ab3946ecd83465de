# Debian packages of the program and of the library: .ci/package

# The manual page is what the program says of itself
find_program(HELP2MAN help2man)
if(HELP2MAN)
  set(MANUAL_PAGE ${PROJECT_BINARY_DIR}/rolling-contact.1)
  add_custom_command(OUTPUT ${MANUAL_PAGE}
    COMMAND ${HELP2MAN} --no-info --section=1
            --name=rolling\ contact\ with\ friction\ of\ wheel\ and\ rail
            --include=${PROJECT_SOURCE_DIR}/cmake/manual.h2m
            --output=${MANUAL_PAGE} $<TARGET_FILE:rolling-contact>
    DEPENDS rolling-contact ${PROJECT_SOURCE_DIR}/cmake/manual.h2m
    VERBATIM)
  add_custom_target(manual_page ALL DEPENDS ${MANUAL_PAGE})
  # not there if nothing but the tests was built
  install(FILES ${MANUAL_PAGE} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1
          OPTIONAL)
endif()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "rolling-contact maintainers <maintainers@rolling-contact.invalid>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY
  "rolling contact with friction of wheel and rail by finite elements")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL program development)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME rolling-contact)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS "gnuplot-nox | gnuplot-x11 | gnuplot-qt")
if(PYTHON)
  math(EXPR NEXT_PYTHON "${Python_VERSION_MINOR} + 1")
  string(APPEND CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS
    ", python3 (>= ${Python_VERSION_MAJOR}.${Python_VERSION_MINOR})"
    ", python3 (<< ${Python_VERSION_MAJOR}.${NEXT_PYTHON})"
    ", python3-numpy")
endif()
# Debian's default is eleven times slower
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "libopenblas0-pthread")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "paraview, openmpi-bin")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME librolling-contact-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
  "libdeal.ii-dev, libsuitesparse-dev, libmetis-dev, libmumps-dev, libopenblas-dev, liblapacke-dev, libeigen3-dev, libfftw3-dev, libboost-program-options-dev, libboost-serialization-dev, libfmt-dev, libhdf5-mpi-dev")
include(CPack)
