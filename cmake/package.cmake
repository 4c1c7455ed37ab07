# The program with its case files, and `cpack -G DEB`, which makes a Debian package of both.
install(TARGETS furnas COMPONENT program)
install(DIRECTORY cases/ DESTINATION ${CMAKE_INSTALL_DATADIR}/furnas/cases COMPONENT program
        FILES_MATCHING PATTERN "*.toml" PATTERN program EXCLUDE)

set(CPACK_PACKAGE_CONTACT "the furnas authors")
set(CPACK_PACKAGE_DESCRIPTION "furnas compresses a dilute gas of spheres of two sizes, with or without friction, at constant
pressure in a periodic cell that may deform, until it jams, and says how dense it is: phi_J, rattlers, contacts, a verdict
with its reasons, and a picture.")
set(CPACK_COMPONENTS_ALL program)  # libraries and headers are for who builds furnas himself
set(CPACK_COMPONENTS_GROUPING ALL_COMPONENTS_IN_ONE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# What dpkg-shlibdeps cannot see, because it is loaded when a picture is drawn: Mesa's drivers and a font.
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libegl-mesa0, libgl1-mesa-dri, fonts-dejavu-core")
include(CPack)
