/// What a function writes to a stream of the C library, as a string.
#pragma once

#include <cstdio>
#include <functional>
#include <string>

namespace tedavis::target {

inline std::string printed(const std::function<void(std::FILE*)>& print) {
    std::FILE* file = std::tmpfile();
    print(file);
    std::string text(static_cast<std::size_t>(std::ftell(file)), '\0');
    std::rewind(file);
    text.resize(std::fread(text.data(), 1, text.size(), file));
    std::fclose(file);
    return text;
}

}  // namespace tedavis::target
