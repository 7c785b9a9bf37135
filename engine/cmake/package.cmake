# `cpack` makes a Debian package: programs, scripts, studies, library and headers, which runs without a compiler.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME stiction)
set(CPACK_PACKAGE_CONTACT "The Stiction developers")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "workbench for adhesive frictional contact of soft bodies")
set(CPACK_PACKAGE_DESCRIPTION "Lua studies answered by large-strain finite elements with contact, friction and bonds.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "fonts-dejavu-core, libegl-mesa0, libgl1-mesa-dri") # figures open them while they run
set(CPACK_STRIP_FILES ON)
include(CPack)
