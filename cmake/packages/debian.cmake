# Debian packages of the three components: cpack -G DEB in the build folder, or the target `package`. docs/packages.md.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME knuckle)
set(CPACK_PACKAGE_CONTACT "the Knuckle authors <noreply@knuckle.invalid>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")   # each has its own
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
cmake_path(GET PROJECT_BINARY_DIR PARENT_PATH builds)
set(CPACK_OUTPUT_FILE_PREFIX ${builds}/packages)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ
  WORLD_EXECUTE)
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/packages/finish.cmake)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_COMPONENTS_ALL program development)
set(CPACK_KNUCKLE_SOURCE ${PROJECT_SOURCE_DIR})

# The driver is not linked with but loaded, so shlibdeps does not see it.
set(driver "libegl1, libopengl0 | libgl1")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME knuckle)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS ${driver})
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "ffmpeg, fonts-dejavu-core, libgl1-mesa-dri")
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION "films of ragdolls and fluids that consist of particles
Knuckle fills a rigged model with small spheres, cuts them into one rigid
body per bone, and joins neighbouring bodies by particles that they share.
Water, sand, ropes, cloth and jelly are particles too, and meet the ragdolls
in the same solver. It simulates and draws in OpenGL 4.3 compute shaders
without a window, on a GPU or on the CPU by Mesa's llvmpipe.
.
This package has the program, its scenes and models, and its documentation.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libknuckle-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
# What its CMake package looks for (cmake/knuckle-config.cmake.in).
string(CONCAT CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libassimp-dev, libdeflate-dev, libegl-dev, libeigen3-dev, "
  "libepoxy-dev, libfmt-dev, libmeshoptimizer-dev, libminizip-dev, libstb-dev, libwebp-dev, nlohmann-json3-dev, pkgconf, zlib1g-dev, "
  ${driver})
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_RECOMMENDS libgl1-mesa-dri)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SUGGESTS "knuckle, cmake")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "worlds of particles stepped from C++ - headers and static libraries
Knuckle simulates ragdolls and fluids as particles in OpenGL 4.3 compute
shaders. This package lets C++ programs make a world, step it, read where
everything is, and load models and scene files.
.
find_package(knuckle) in CMake gives knuckle::simulation and
knuckle::knuckle.")

if(TARGET knuckle_python)
  list(APPEND CPACK_COMPONENTS_ALL python)
  get_directory_property(minor DIRECTORY ${PROJECT_SOURCE_DIR}/app/python DEFINITION Python3_VERSION_MINOR)
  math(EXPR next "${minor} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-knuckle)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  string(CONCAT CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3 (>= 3.${minor}), python3 (<< 3.${next}), "
    "python3-numpy, ${driver}")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS libgl1-mesa-dri)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "knuckle, ffmpeg")
  set(CPACK_COMPONENT_PYTHON_DESCRIPTION "worlds of particles stepped from Python, with NumPy
Knuckle simulates ragdolls and fluids as particles in OpenGL 4.3 compute
shaders. This package is its Python module: scenes from files or dicts,
steps, NumPy arrays of particles and bodies, pictures, states to return to,
actors from models, and pictures compared.")
endif()
include(CPack)
