# find_package(rolling_contact): the target rolling_contact::rolling_contact.
# deal.II's own targets are those of the build type the library had.
include(CMakeFindDependencyMacro)
find_dependency(deal.II 9.4 HINTS $ENV{DEAL_II_DIR})
if(NOT DEAL_II_TARGET_CONFIG_INCLUDED)
  include(${DEAL_II_TARGET_CONFIG})
  set(DEAL_II_TARGET_CONFIG_INCLUDED TRUE)
endif()
find_dependency(Boost 1.74 COMPONENTS program_options serialization)
find_dependency(Eigen3 3.4)
find_dependency(fmt 9)
include(${CMAKE_CURRENT_LIST_DIR}/rolling_contact-targets.cmake)
