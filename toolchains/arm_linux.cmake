# Shared by the ARM toolchain files, which set TEDAVIS_ARCH (name of the sysroot), TEDAVIS_TRIPLET and TEDAVIS_EMULATOR.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_C_COMPILER ${TEDAVIS_TRIPLET}-gcc)
set(CMAKE_CXX_COMPILER ${TEDAVIS_TRIPLET}-g++)

set(CMAKE_SYSROOT ${CMAKE_CURRENT_LIST_DIR}/../build/sysroots/${TEDAVIS_ARCH})
cmake_path(NORMAL_PATH CMAKE_SYSROOT)
if(NOT IS_DIRECTORY ${CMAKE_SYSROOT}/usr)
  message(FATAL_ERROR "There is no sysroot at ${CMAKE_SYSROOT}; run toolchains/make_sysroot ${TEDAVIS_ARCH}.")
endif()

# Programs come from this machine, everything else from the sysroot.
set(CMAKE_FIND_ROOT_PATH ${CMAKE_SYSROOT})
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
set(CMAKE_LIBRARY_ARCHITECTURE ${TEDAVIS_TRIPLET})
set(ENV{PKG_CONFIG_SYSROOT_DIR} ${CMAKE_SYSROOT})
set(ENV{PKG_CONFIG_LIBDIR} ${CMAKE_SYSROOT}/usr/lib/${TEDAVIS_TRIPLET}/pkgconfig:${CMAKE_SYSROOT}/usr/share/pkgconfig)

# User-mode emulation runs what was built, for self-tests on this machine.
set(CMAKE_CROSSCOMPILING_EMULATOR ${TEDAVIS_EMULATOR} -L ${CMAKE_SYSROOT})
