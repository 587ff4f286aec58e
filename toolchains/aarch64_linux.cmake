# 64-bit ARM Linux boards, with Debian's cross compiler and the sysroot of toolchains/make_sysroot.
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(TEDAVIS_ARCH aarch64)
set(TEDAVIS_TRIPLET aarch64-linux-gnu)
set(TEDAVIS_EMULATOR qemu-aarch64-static)
include(${CMAKE_CURRENT_LIST_DIR}/arm_linux.cmake)
