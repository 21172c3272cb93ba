# SPDX-License-Identifier: MIT
# Debian packages by CPack from a build with the prefix /usr, which `scripts/maintain/package` passes as BUILD: the C interface,
# the development files, and the command.
if(CPACK_TEMPORARY_INSTALL_DIRECTORY)
  # Second call, with the package's files in place: the additional files that Debian requires.
  file(GLOB packages ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/*)
  foreach(package IN LISTS packages)
    get_filename_component(name ${package} NAME)
    file(REMOVE_RECURSE ${package}/usr/share/doc)  # the licence: it is in `copyright`
    file(MAKE_DIRECTORY ${package}/usr/share/doc/${name})
    file(COPY_FILE ${CPACK_RESOURCE_FILE_LICENSE} ${package}/usr/share/doc/${name}/copyright)
    file(COPY_FILE ${CPACK_LIMITCURVE_CHANGES} ${package}/usr/share/doc/${name}/changelog.Debian)
    execute_process(COMMAND gzip -9n ${package}/usr/share/doc/${name}/changelog.Debian COMMAND_ERROR_IS_FATAL ANY)
  endforeach()
  return()
endif()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME limitcurve)
set(CPACK_PACKAGE_VERSION $ENV{VERSION})
set(CPACK_PACKAGE_FILE_NAME limitcurve)
set(CPACK_PACKAGE_DIRECTORY $ENV{BUILD}/cpack)
set(CPACK_CMAKE_GENERATOR Ninja)
set(CPACK_INSTALL_CMAKE_PROJECTS "$ENV{BUILD};limitcurve;ALL;/")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_FILE})
set(CPACK_RESOURCE_FILE_LICENSE $ENV{BUILD}/copyright)
set(CPACK_LIMITCURVE_CHANGES $ENV{BUILD}/changes)

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_COMPONENTS_ALL limitcurve engines godobject fit c c-dev cli)
foreach(component limitcurve engines godobject fit c-dev)
  string(TOUPPER ${component} component)
  set(CPACK_COMPONENT_${component}_GROUP liblimitcurve-dev)
endforeach()
set(CPACK_COMPONENT_C_GROUP liblimitcurve-c0.3)
set(CPACK_COMPONENT_CLI_GROUP limitcurve)

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_MAINTAINER $ENV{MAINTAINER})
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS $ENV{BUILD}/c)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(about "Friction limit curves of soft fingers for any axisymmetric pressure, to a\nstated error: tables for servo loops, approximations, and a god-object that\nobeys them.\n\n")
set(CPACK_PACKAGE_DESCRIPTION ${about})
set(CPACK_DEBIAN_LIBLIMITCURVE-C0.3_PACKAGE_NAME liblimitcurve-c0.3)
set(CPACK_DEBIAN_LIBLIMITCURVE-C0.3_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_LIBLIMITCURVE-C0.3_DESCRIPTION "friction limit curves of soft fingers (C interface)\n${about}This package contains the shared library with the C interface.")
set(CPACK_DEBIAN_LIBLIMITCURVE-C0.3_PACKAGE_CONTROL_EXTRA $ENV{BUILD}/triggers)  # beside it CPack's scripts call ldconfig, too

set(CPACK_DEBIAN_LIBLIMITCURVE-DEV_PACKAGE_NAME liblimitcurve-dev)
set(CPACK_DEBIAN_LIBLIMITCURVE-DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_LIBLIMITCURVE-DEV_PACKAGE_DEPENDS "liblimitcurve-c0.3 (= $ENV{VERSION}), libeigen3-dev")
set(CPACK_DEBIAN_LIBLIMITCURVE-DEV_PACKAGE_RECOMMENDS libceres-dev)
set(CPACK_DEBIAN_LIBLIMITCURVE-DEV_DESCRIPTION "friction limit curves of soft fingers (for development)\n${about}This package contains the header of the C interface, the C++ headers and\nstatic libraries, and what CMake and pkg-config read.")

set(CPACK_DEBIAN_LIMITCURVE_PACKAGE_NAME limitcurve)
set(CPACK_DEBIAN_LIMITCURVE_PACKAGE_SECTION science)
set(CPACK_DEBIAN_LIMITCURVE_DESCRIPTION "friction limit curves of soft fingers (command line)\n${about}This package contains the command, which generates tables, validates\napproximations, fits measurements, and replays motions.")
