# 32-bit ARM Linux boards with hardware floating point, with Debian's cross compiler and the sysroot of toolchains/make_sysroot.
set(CMAKE_SYSTEM_PROCESSOR armv7l)
set(TEDAVIS_ARCH armhf)
set(TEDAVIS_TRIPLET arm-linux-gnueabihf)
set(TEDAVIS_EMULATOR qemu-arm-static)
include(${CMAKE_CURRENT_LIST_DIR}/arm_linux.cmake)
