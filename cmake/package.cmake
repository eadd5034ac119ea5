# What other projects see, whether they find what is installed or add this folder as one of theirs: knuckle::simulation,
# worlds and their steps; knuckle::knuckle, models and scene files as well. Their headers are in build/include, which
# stage_headers.cmake makes from ours.
set(headers ${PROJECT_BINARY_DIR}/include)
# While configuring, and again whenever one of them changes: a build tool looks for changed headers before it runs any
# command, so a source that includes them would be linked as it was, against libraries with other structs.
include(cmake/stage_headers.cmake)
stage_headers(${PROJECT_SOURCE_DIR} ${headers} staged)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${staged})

# knuckle_public(NAME library...): knuckle::NAME, for which the libraries are linked and nothing of theirs is compiled with.
function(knuckle_public name)
  add_library(knuckle_public_${name} INTERFACE)
  add_library(knuckle::${name} ALIAS knuckle_public_${name})
  list(TRANSFORM ARGN REPLACE "(.+)" "$<LINK_ONLY:\\1>" OUTPUT_VARIABLE libraries)
  target_link_libraries(knuckle_public_${name} INTERFACE ${libraries} Eigen3::Eigen)
  target_compile_features(knuckle_public_${name} INTERFACE cxx_std_20)
  target_include_directories(knuckle_public_${name} INTERFACE
    $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/include> $<INSTALL_INTERFACE:include>)
  set_target_properties(knuckle_public_${name} PROPERTIES EXPORT_NAME ${name})
endfunction()
knuckle_public(simulation knuckle_simulation)
knuckle_public(knuckle knuckle_simulation knuckle_scene knuckle_rig)

if(NOT KNUCKLE_INSTALL)
  return()
endif()
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(packageFolder ${CMAKE_INSTALL_LIBDIR}/cmake/knuckle)
set(assets ${CMAKE_INSTALL_DATADIR}/knuckle/assets)   # app/files/assets.cpp looks there
# Three components: program, development, python (app/python). Each file is in exactly one.
install(TARGETS knuckle RUNTIME COMPONENT program)
install(TARGETS knuckle_public_knuckle knuckle_public_simulation knuckle_simulation knuckle_scene knuckle_rig
  knuckle_solver knuckle_layout knuckle_gpu knuckle_shaders knuckle_image knuckle_world knuckle_base
  knuckle_precompiled knuckle_flags EXPORT knuckle ARCHIVE COMPONENT development)
install(EXPORT knuckle FILE knuckle-targets.cmake NAMESPACE knuckle:: DESTINATION ${packageFolder}
  COMPONENT development)
install(DIRECTORY ${headers}/knuckle TYPE INCLUDE COMPONENT development)
install(DIRECTORY assets/scenes assets/models assets/schema DESTINATION ${assets} COMPONENT program)
install(FILES LICENSE README.md CHANGELOG.md TYPE DOC COMPONENT program)
# All but the gallery's films, so that links between documents lead somewhere.
install(DIRECTORY docs TYPE DOC COMPONENT program PATTERN gallery EXCLUDE)
# Pages of the manual and completions, which the program prints, while installing. No variable may be named as a component
# is: CMake's conditions before each rule would take its value.
install(CODE "set(printer \"$<TARGET_FILE:knuckle>\")
  set(made \"${PROJECT_BINARY_DIR}/manual\")
  include(\"${PROJECT_SOURCE_DIR}/cmake/print_manual.cmake\")" COMPONENT program)
install(DIRECTORY ${PROJECT_BINARY_DIR}/manual/man1 DESTINATION ${CMAKE_INSTALL_MANDIR} COMPONENT program)
install(FILES ${PROJECT_BINARY_DIR}/manual/knuckle COMPONENT program
  DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
install(FILES ${PROJECT_BINARY_DIR}/manual/_knuckle COMPONENT program
  DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions)
install(FILES ${PROJECT_BINARY_DIR}/manual/knuckle.fish COMPONENT program
  DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)
configure_package_config_file(cmake/knuckle-config.cmake.in ${PROJECT_BINARY_DIR}/knuckle-config.cmake
  INSTALL_DESTINATION ${packageFolder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/knuckle-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/knuckle-config.cmake ${PROJECT_BINARY_DIR}/knuckle-config-version.cmake
  DESTINATION ${packageFolder} COMPONENT development)
if(PROJECT_IS_TOP_LEVEL)
  include(cmake/packages/debian.cmake)
endif()
