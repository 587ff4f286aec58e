/// Bytes that this process may execute and no file holds: what a graphics driver on the processor has compiled.
#pragma once

#include <cstdint>
#include <cstdio>
#include <fstream>
#include <string>

namespace tedavis::test_support {

inline std::uint64_t compiled_bytes() {
    std::ifstream maps("/proc/self/maps");
    std::uint64_t bytes = 0;
    for (std::string line; std::getline(maps, line);) {
        unsigned long long begin = 0, end = 0, inode = 0;
        char rights[8] = {};
        if (std::sscanf(line.c_str(), "%llx-%llx %7s %*s %*s %llu", &begin, &end, rights, &inode) == 4 && rights[2] == 'x' &&
            inode == 0)
            bytes += end - begin;
    }
    return bytes;
}

}  // namespace tedavis::test_support
