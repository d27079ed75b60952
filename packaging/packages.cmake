# The Debian packages, one an install component: libskvalp0, libskvalp-dev, skvalp-tools,
# skvalp-play. scripts/package.sh makes them.
set(CPACK_PACKAGE_CONTACT "The Skvalp authors <skvalp@users.noreply.github.com>")
set(CPACK_GENERATOR DEB)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ
    GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

configure_file(debian/changelog.in changelog @ONLY)
configure_file(debian/shlibs.in shlibs @ONLY)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_CONTROL_EXTRA
    ${CMAKE_CURRENT_BINARY_DIR}/shlibs ${CMAKE_CURRENT_SOURCE_DIR}/debian/triggers)
find_program(GZIP gzip REQUIRED)
# Compressed as Debian wants it: as well as possible, and without a date.
function(compress from to)
    add_custom_command(OUTPUT ${to} COMMAND ${GZIP} -9nc ${from} > ${to} DEPENDS ${from} VERBATIM)
    set_property(DIRECTORY APPEND PROPERTY compressed ${CMAKE_CURRENT_BINARY_DIR}/${to})
endfunction()
compress(${CMAKE_CURRENT_BINARY_DIR}/changelog changelog.gz)
compress(${CMAKE_CURRENT_SOURCE_DIR}/skvalp.1 skvalp.1.gz)
compress(${CMAKE_CURRENT_SOURCE_DIR}/play/skvalp-play.1 skvalp-play.1.gz)
get_property(compressed DIRECTORY PROPERTY compressed)
add_custom_target(package_texts ALL DEPENDS ${compressed})

# add_package COMPONENT NAME SECTION SUMMARY DETAILS
function(add_package component name section summary details)
    string(TOUPPER ${component} upper)
    set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${name} PARENT_SCOPE)
    set(CPACK_DEBIAN_${upper}_PACKAGE_SECTION ${section} PARENT_SCOPE)
    set(CPACK_COMPONENT_${upper}_DESCRIPTION "${summary}\n${details}" PARENT_SCOPE)
    list(APPEND CPACK_COMPONENTS_ALL ${component})
    set(CPACK_COMPONENTS_ALL ${CPACK_COMPONENTS_ALL} PARENT_SCOPE)
    install(FILES debian/copyright ${CMAKE_CURRENT_BINARY_DIR}/changelog.gz
            DESTINATION share/doc/${name} COMPONENT ${component})
endfunction()

set(what "Skvalp simulates water and other liquids in two dimensions as particles, fast
enough to be played with, and measured against theory.")
add_package(library libskvalp0 libs "real-time 2D particle fluid - shared library"
    "${what}\n.\nThis package contains the shared library.")
add_package(development libskvalp-dev libdevel "real-time 2D particle fluid - development files"
    "${what}\n.\nThis package contains the headers, the static libraries, and the files for\nCMake and pkg-config.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libskvalp0 (= ${PROJECT_VERSION})")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_RECOMMENDS
    "libjansson-dev, libpng-dev, zlib1g-dev, libegl-dev, libgles-dev, pkg-config")
if(TARGET skvalp-cli)
    add_package(tools skvalp-tools science "real-time 2D particle fluid - command line"
        "${what}\n.\nThis package contains the command line: it runs scenes, renders pictures and\nvideos, and runs experiments.")
    set(CPACK_DEBIAN_TOOLS_PACKAGE_RECOMMENDS "ffmpeg, libgl1-mesa-dri")
    install(FILES ${CMAKE_CURRENT_BINARY_DIR}/skvalp.1.gz DESTINATION share/man/man1
            COMPONENT tools)
endif()
if(TARGET skvalp-play)
    add_package(play skvalp-play science "real-time 2D particle fluid - app"
        "${what}\n.\nThis package contains the app to play with it.")
    set(CPACK_DEBIAN_PLAY_PACKAGE_RECOMMENDS "libgl1-mesa-dri")
    install(FILES ${CMAKE_CURRENT_BINARY_DIR}/skvalp-play.1.gz DESTINATION share/man/man1
            COMPONENT play)
    install(FILES play/org.skvalp.Play.desktop DESTINATION share/applications COMPONENT play)
    install(FILES play/org.skvalp.Play.metainfo.xml DESTINATION share/metainfo COMPONENT play)
    install(FILES play/org.skvalp.Play.mime.xml DESTINATION share/mime/packages COMPONENT play)
    install(FILES ${PROJECT_SOURCE_DIR}/app/resources/icons/org.skvalp.Play.svg
            DESTINATION share/icons/hicolor/scalable/apps COMPONENT play)
endif()
include(CPack)
