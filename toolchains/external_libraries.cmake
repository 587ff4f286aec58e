get_target_property(TARGET_TYPE_OF_BUS tedavis_bus TYPE)
# Libraries that modules use, in one place: what is linked where.
find_package(Threads REQUIRED)
pkg_check_modules(EGL REQUIRED IMPORTED_TARGET egl)
pkg_check_modules(GPIOD IMPORTED_TARGET libgpiod)

# libEGL is linked, libGLESv2 never: all GL goes through our call table.
target_link_libraries(tedavis_platform PUBLIC PkgConfig::EGL Threads::Threads ${CMAKE_DL_LIBS})
if(TEDAVIS_OSMESA)
  find_path(TEDAVIS_OSMESA_INCLUDE GL/osmesa.h)
  if(TEDAVIS_OSMESA_INCLUDE)
    # Loaded with dlopen: libOSMesa exports every gl* name and would shadow EGL's.
    target_compile_definitions(tedavis_platform PUBLIC TEDAVIS_HAVE_OSMESA=1)
  endif()
endif()
if(GPIOD_FOUND AND NOT TARGET_TYPE_OF_BUS STREQUAL INTERFACE_LIBRARY)
  target_link_libraries(tedavis_bus PRIVATE PkgConfig::GPIOD)
  target_compile_definitions(tedavis_bus PUBLIC TEDAVIS_HAVE_GPIOD=1)
  if(GPIOD_VERSION VERSION_GREATER_EQUAL 2)
    target_compile_definitions(tedavis_bus PRIVATE TEDAVIS_GPIOD_V2=1)
  endif()
endif()
